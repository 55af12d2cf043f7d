// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Compression/BigEndian.h"
#include "nexrad/Compression/Container.h"
#include "nexrad/Compression/DecodingBudget.h"
#include "nexrad/Compression/LdmRecords.h"
#include "nexrad/Level2/Messages/DecodedRay.h"
#include "nexrad/Level2/Messages/MessageStream.h"
#include "nexrad/Level2/VolumeAssembler.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace nexrad
{

/// What the damage list says of a file that reaches the cap of Level2Options::maximumFileBytes.
std::string FileCapText(const Level2Options& options);

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
  void DecodeRecord(Bunzipped&& content, std::uint64_t storedOffset);
  void DecodeMessages(
    MessageStream& stream, const Buffer& buffer, const OffsetFinder& storedOffset);
  void DecodeMessage(const Message& message, std::size_t newBytes, std::uint64_t storedOffset);
  void DecodeRay(const Message& message, std::size_t newBytes, std::uint64_t storedOffset);
  void AddDamage(std::uint64_t storedOffset, const std::string& what);
  void Spend(std::size_t cost, std::uint64_t storedOffset);

  VolumeAssembler& assembler;
  std::size_t maximumRecordBytes;
  unsigned threads; ///< that decompress records
  DecodingBudget budget;
  RayCosts rayCosts;
};

} // namespace nexrad
