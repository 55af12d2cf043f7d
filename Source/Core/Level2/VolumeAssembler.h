// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Compression/DamageList.h"
#include "nexrad/Level2/Level2File.h"
#include "nexrad/Level2/Messages/DecodedRay.h"
#include "nexrad/Level2/Messages/VolumeHeader.h"
#include "nexrad/Level2/PositionVote.h"
#include "nexrad/Level2/SweepWatch.h"
#include "nexrad/Model/RadarVolume.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace nexrad
{

/// Makes a volume of the parts of a file, or of the files of a folder, as they come: rays into
/// sweeps, damage into one list, and at the end what can only be known then.
class VolumeAssembler
{
public:
  explicit VolumeAssembler(Level2Options readOptions);

  /// Damage is named with this in front from here on: the file's name in a folder of chunks.
  void BeginPiece(const std::string& name);
  void AddHeader(const VolumeHeader& header);
  /// `offset` is that of the message in the stored file.
  void AddRay(DecodedRay&& decoded, int messageType, std::uint64_t offset);
  void AddPattern(CoveragePattern pattern);
  void AddStatus(const RadarStatus& status) { volume.status = status; }
  /// The type of a message that is no ray.
  void AddMetadata(unsigned messageType) { metadata.insert(messageType); }
  /// The file says that it was simulated.
  void AddSyntheticMark() { volume.synthetic = true; }
  /// The bytes that rays point into.
  void AddBuffer(std::shared_ptr<const std::vector<std::uint8_t>> buffer);
  void AddDamage(std::uint64_t offset, const std::string& what);

  std::size_t RayCount() const { return rayCount; }

  /// The volume. `name` is the path as the user gave it, `size` the bytes of the (last) stored
  /// file.
  RadarVolume Finish(const std::string& name, std::uint64_t size);

private:
  /// Where a ray's message stands.
  struct RayPlace
  {
    std::uint64_t offset;
    std::size_t piece; ///< of `pieces`
  };

  bool BeginsSweep(const Ray& ray);
  void FinishSweep(const Ray* next);
  void CheckRays();
  void ChoosePattern();
  void CheckPosition();
  void CheckEnd(std::uint64_t size);
  void NoteTimes();

  Level2Options options;
  RadarVolume volume;
  std::string piece;        ///< "name: " of the file in hand; "" when it is the only one
  std::string missingPiece; ///< the piece where the sweep's first missing ray should be
  std::string lastRayPiece;
  bool hasHeader = false;
  std::set<unsigned> metadata; ///< types of messages
  std::string headerName;
  std::string rayName;
  PositionVote position;
  DamageList damage;
  SweepWatch watch;
  std::size_t rayCount = 0;
  std::vector<std::string> pieces = {""};    ///< all that `piece` was
  std::vector<std::vector<RayPlace>> places; ///< of the rays, by sweep
};

} // namespace nexrad
