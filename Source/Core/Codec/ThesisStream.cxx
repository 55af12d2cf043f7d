// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Codec/ThesisStream.h"

#include "nexrad/Codec/LittleEndian.h"
#include "nexrad/Grid/MomentCode.h"
#include "nexrad/System/Error.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>

namespace nexrad
{

namespace
{

constexpr std::uint8_t literalBit = 0x80;
constexpr std::size_t runSize = 5; // bytes of a run in the stream

inline std::uint8_t CodeOf(float value)
{
  if (std::isnan(value))
  {
    return ThesisCode::NotScannedCode;
  }
  const double code =
    std::clamp(static_cast<double>(value), 0.0, static_cast<double>(ThesisCode::LargestCode));
  // std::round, which costs a call, for what is not negative.
  const auto below = static_cast<std::uint8_t>(code);
  return code - below < 0.5 ? below : static_cast<std::uint8_t>(below + 1);
}

[[noreturn]] void Refuse(std::uint64_t offset, const std::string& what)
{
  throw Error("byte " + std::to_string(offset) + " of the run-length stream: " + what);
}

// How many codes are equal to the first. Most runs are long: eight are looked at in one word.
std::size_t RunLengthAt(const std::uint8_t* codes, std::size_t longest)
{
  std::uint64_t word = 0;
  constexpr std::size_t wordBytes = sizeof(word);
  const std::uint64_t equal = codes[0] * std::uint64_t(0x0101010101010101);
  std::size_t length = 1;
  while (length + wordBytes <= longest)
  {
    std::memcpy(&word, codes + length, wordBytes);
    if (word != equal)
    {
      break;
    }
    length += wordBytes;
  }
  while (length < longest && codes[length] == codes[0])
  {
    ++length;
  }
  return length;
}

} // namespace

VoxelState ThesisCode::StateOf(std::uint8_t code)
{
  if (code == NotScannedCode)
  {
    return VoxelState::NotScanned;
  }
  return code == NoEchoCode ? VoxelState::NoEcho : VoxelState::Echo;
}

std::vector<std::uint8_t> ThesisCode::EncodeAll(const GriddedVolume& volume)
{
  CheckVoxelCount(volume);
  std::vector<std::uint8_t> codes(volume.states.size());
  std::transform(volume.states.begin(), volume.states.end(), codes.begin(),
    [](VoxelState state) { return state == VoxelState::NotScanned ? NotScannedCode : NoEchoCode; });
  ForEachEcho(volume.states.data(), codes.size(),
    [&](std::size_t i) { codes[i] = CodeOf(volume.values[i]); });
  return codes;
}

std::vector<std::uint8_t> EncodeRunLength(const std::vector<std::uint8_t>& codes)
{
  constexpr std::size_t longest = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint8_t> stream;
  for (std::size_t begin = 0; begin < codes.size();)
  {
    const std::uint8_t code = codes[begin];
    if (code >= literalBit)
    {
      throw Error("code " + std::to_string(code) + " of voxel " + std::to_string(begin) +
                  ": the run-length code holds 0 to 127");
    }
    const std::size_t length =
      RunLengthAt(codes.data() + begin, std::min(codes.size() - begin, longest));
    if (length > 1)
    {
      stream.push_back(code);
      AppendLittleEndian(static_cast<std::uint32_t>(length), stream);
    }
    else
    {
      stream.push_back(literalBit | code);
    }
    begin += length;
  }
  return stream;
}

namespace
{

void CheckRun(std::uint64_t offset, std::uint32_t length, std::size_t codesLeft)
{
  if (length == 0)
  {
    Refuse(offset, "a run of no voxels; its length must be 1 or more");
  }
  if (length > codesLeft)
  {
    Refuse(offset, "a run of " + std::to_string(length) + " where " + std::to_string(codesLeft) +
                     " voxels are left");
  }
}

void CheckEnd(std::uint64_t offset, std::size_t decoded, std::size_t count)
{
  if (decoded != count)
  {
    Refuse(offset, "the stream ends after " + std::to_string(decoded) + " of " +
                     std::to_string(count) + " voxels");
  }
}

// How many bytes from the first on are literals; eight are looked at in one word.
std::size_t CountLiterals(const std::uint8_t* bytes, std::size_t most)
{
  constexpr std::uint64_t allLiteral = 0x8080808080808080;
  std::uint64_t word = 0;
  std::size_t literals = 0;
  while (literals + sizeof(word) <= most)
  {
    std::memcpy(&word, bytes + literals, sizeof(word));
    if ((word & allLiteral) != allLiteral)
    {
      break;
    }
    literals += sizeof(word);
  }
  while (literals < most && (bytes[literals] & literalBit) != 0)
  {
    ++literals;
  }
  return literals;
}

// A place in a stream where a literal or a run begins, and the codes before it.
struct StreamPlace
{
  std::size_t byte = 0;
  std::size_t code = 0;
};

// Checks a stream, and finds places in it about `partBytes` or `partCodes` apart: its begin, its
// end, and others between them.
std::vector<StreamPlace> DivideStream(
  const std::uint8_t* stream, std::size_t length, std::size_t count)
{
  constexpr std::size_t partBytes = std::size_t(1) << 16;
  constexpr std::size_t partCodes = std::size_t(1) << 20;
  std::vector<StreamPlace> places{{}};
  StreamPlace at;
  while (at.byte < length)
  {
    if (at.byte - places.back().byte >= partBytes || at.code - places.back().code >= partCodes)
    {
      places.push_back(at);
    }
    const std::size_t literals =
      CountLiterals(stream + at.byte, std::min(partBytes, length - at.byte));
    if (literals > count - at.code || count == at.code)
    {
      Refuse(at.byte + (count - at.code),
        "more bytes after the last of " + std::to_string(count) + " voxels");
    }
    at.byte += literals;
    at.code += literals;
    if (literals > 0)
    {
      continue;
    }
    if (length - at.byte < runSize)
    {
      Refuse(length, "the stream ends within a run");
    }
    const std::uint32_t run = LittleEndian(stream + at.byte + 1);
    CheckRun(at.byte, run, count - at.code);
    at.byte += runSize;
    at.code += run;
  }
  CheckEnd(length, at.code, count);
  places.push_back(at);
  return places;
}

// Decodes a part of a stream that was found good.
void DecodePart(const std::uint8_t* part, std::size_t length, std::uint8_t* codes)
{
  for (std::size_t at = 0; at < length;)
  {
    const std::size_t literals = CountLiterals(part + at, length - at);
    for (std::size_t i = 0; i < literals; ++i)
    {
      codes[i] = part[at + i] & 0x7F;
    }
    at += literals;
    codes += literals;
    if (at < length)
    {
      const std::uint32_t run = LittleEndian(part + at + 1);
      std::memset(codes, part[at], run);
      at += runSize;
      codes += run;
    }
  }
}

} // namespace

void DecodeRunLength(const std::uint8_t* stream, std::size_t length, std::uint8_t* codes,
  std::size_t count, const RangeLoop& loop)
{
  const std::vector<StreamPlace> places = DivideStream(stream, length, count);
  RunLoop(loop, static_cast<int>(places.size() - 1),
    [&](int first, int end)
    {
      for (auto i = static_cast<std::size_t>(first); i < static_cast<std::size_t>(end); ++i)
      {
        DecodePart(
          stream + places[i].byte, places[i + 1].byte - places[i].byte, codes + places[i].code);
      }
    });
}

} // namespace nexrad
