// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Compression/BigEndian.h"
#include "nexrad/Compression/Container.h"
#include "nexrad/Compression/DecodingBudget.h"
#include "nexrad/Compression/LdmRecords.h"
#include "nexrad/Level2/Level2Options.h"
#include "nexrad/Level2/Messages/MessageBodies.h"
#include "nexrad/Level2/Messages/MessageStream.h"
#include "nexrad/Level2/VolumeAssembler.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace nexrad
{

/// What rays cost of a DecodingBudget beside RayCost, told from a ray and the one decoded before.
class RayCosts
{
public:
  /// The cost of the next ray: that of a sweep where it can begin one; of its gates
  /// that quality control or dealiasing judges; of its damage; and the bytes of its words that
  /// exceed the `newBytes` of its message, because moments share them, or because they belong to
  /// another message too.
  std::size_t Of(const DecodedRay& decoded, std::size_t newBytes);

private:
  bool MayBeginSweep(const Ray& ray);

  unsigned elevationNumber = 0; ///< of the ray before
  double azimuth = 0.0;         ///< degrees, of the ray before
  double turned = 0.0;          ///< degrees to and fro since the last sweep began, at least
};

/// Decodes files into an assembler: takes their containers off, cuts them into records and
/// messages, and hands over what these hold. One decoder for all files of a folder: they share a
/// budget.
class FileDecoder
{
public:
  FileDecoder(VolumeAssembler& target, const Level2Options& options);

  /// Decodes one stored file.
  void Decode(std::vector<std::uint8_t> stored);

private:
  using OffsetFinder = std::function<std::uint64_t(std::size_t)>; ///< of bytes of a stream
  using Buffer = std::shared_ptr<const std::vector<std::uint8_t>>;

  void DecodePlain(const Buffer& buffer, const OffsetMap& offsets);
  void DecodeRecords(ByteView plain, std::size_t start, const OffsetMap& offsets);
  void DecodeRecord(Unpacked&& content, std::uint64_t storedOffset);
  void DecodeMessages(
    MessageStream& stream, const Buffer& buffer, const OffsetFinder& storedOffset);
  void DecodeMessage(const Message& message, std::size_t newBytes, std::uint64_t storedOffset);
  void DecodeRay(const Message& message, std::size_t newBytes, std::uint64_t storedOffset);
  void AddDamage(std::uint64_t storedOffset, const std::string& what);
  void Spend(std::size_t cost, std::uint64_t storedOffset);

  VolumeAssembler& assembler;
  Level2Options options;
  DecodingBudget budget;
  RayCosts rayCosts;
};

/// Makes a volume of the chunks of the real-time feed that belong to it, in the order of their
/// numbers.
class ChunkDecoder
{
public:
  explicit ChunkDecoder(const Level2Options& theOptions);

  /// The next chunk, by its number and its file's name. Numbers that lie between it and the chunk
  /// before are damage.
  void Begin(int number, const std::string& name);
  /// The stored bytes of the chunk that began.
  void Decode(std::vector<std::uint8_t> stored);
  /// A chunk in the same folder that belongs to another volume.
  void AddOther(const std::string& name);
  /// Something that is wrong with the chunk that began.
  void AddDamage(const std::string& what) { assembler.AddDamage(0, what); }

  /// The volume of the chunks so far; more may follow. `name` is the path of their folder.
  RadarVolume VolumeSoFar(const std::string& name) const;

private:
  VolumeAssembler assembler;
  FileDecoder decoder;
  int expected = 1;       ///< number of the next chunk
  std::uint64_t size = 0; ///< bytes of the last chunk
};

} // namespace nexrad
