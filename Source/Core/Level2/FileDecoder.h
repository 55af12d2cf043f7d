// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Compression/BigEndian.h"
#include "nexrad/Compression/Container.h"
#include "nexrad/Compression/LdmRecords.h"
#include "nexrad/Level2/Messages/MessageStream.h"
#include "nexrad/Level2/VolumeAssembler.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace nexrad
{

/// What the damage list says of a file that reaches the cap of Level2Options::maximumFileBytes.
std::string FileCapText(const Level2Options& options);

/// Decodes files into an assembler: takes their containers off, cuts them into records and
/// messages, and hands over what these hold. One decoder for all files of a folder: they share the
/// cap on decompressed bytes.
class FileDecoder
{
public:
  FileDecoder(VolumeAssembler& target, const Level2Options& options);

  /// Decodes one stored file.
  void Decode(std::vector<std::uint8_t> stored);

private:
  void DecodeRecords(ByteView plain, std::size_t start, const OffsetMap& offsets);
  void DecodeRecord(Bunzipped&& content, std::uint64_t storedOffset);
  void DecodeMessage(const Message& message, std::uint64_t storedOffset);
  void DecodeRay(const Message& message, std::uint64_t storedOffset);
  bool Spend(std::size_t bytes);

  VolumeAssembler& assembler;
  std::size_t maximumRecordBytes;
  unsigned threads;   ///< that decompress records
  std::size_t budget; ///< decompressed bytes that the files may still take
};

} // namespace nexrad
