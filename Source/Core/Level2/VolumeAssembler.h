// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Compression/DamageList.h"
#include "nexrad/Level2/Assembly/ArrivedRay.h"
#include "nexrad/Level2/Assembly/SweepBuilder.h"
#include "nexrad/Level2/Level2Options.h"
#include "nexrad/Level2/Messages/VolumeHeader.h"
#include "nexrad/Model/RadarVolume.h"

#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace nexrad
{

/// Makes a volume of the parts of a file, or of the files of a folder. It gathers them as they
/// come, and puts the rays of one radar in order and into sweeps when all are there.
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
  void AddStatus(const RadarStatus& status);
  /// The type of a message that is no ray.
  void AddMetadata(unsigned messageType) { metadata.insert(messageType); }
  /// The file says that it was simulated.
  void AddSyntheticMark() { volume.synthetic = true; }
  /// The bytes that rays point into.
  void AddBuffer(const std::shared_ptr<const std::vector<std::uint8_t>>& buffer)
  {
    volume.buffers.push_back(buffer);
  }
  void AddDamage(std::uint64_t offset, const std::string& what);

  std::size_t RayCount() const { return arrived.size(); }

  /// The volume. `name` is the path as the user gave it, `size` the bytes of the (last) stored
  /// file.
  RadarVolume Finish(const std::string& name, std::uint64_t size);

private:
  void AddSweeps(const std::vector<ArrivedSweep>& sweeps);
  void ChoosePattern();
  void CheckMetadata(std::uint64_t size);
  void CheckEnd(std::uint64_t size);
  void NoteTimes();
  void NoteCuts();
  void Report(const ArrivedRay& at, const std::string& what);

  Level2Options options;
  RadarVolume volume;
  bool hasHeader = false;
  std::set<unsigned> metadata; ///< types of messages
  std::string headerName;
  DamageList damage;
  std::vector<std::string> pieces = {""}; ///< "name: " of each file; "" when there is one
  std::deque<ArrivedRay> arrived;         ///< in the order of the file; they do not move
  std::vector<CoveragePattern> patterns;  ///< of messages 5
  std::vector<RadarStatus> statuses;      ///< of messages 2
};

} // namespace nexrad
