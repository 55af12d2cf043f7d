// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Codec/RunLength.h"

#include "nexrad/System/Error.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <string>
#include <utility>

namespace nexrad
{

namespace
{

constexpr std::uint8_t literalBit = 0x80;

[[noreturn]] void Refuse(std::uint64_t offset, const std::string& what)
{
  throw Error("byte " + std::to_string(offset) + " of the run-length stream: " + what);
}

void AppendRun(std::vector<std::uint8_t>& stream, std::uint8_t code, std::uint32_t length)
{
  stream.push_back(code);
  for (unsigned shift = 0; shift < 32; shift += 8)
  {
    stream.push_back(static_cast<std::uint8_t>(length >> shift));
  }
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

std::vector<std::uint8_t> EncodeRunLength(
  const std::uint8_t* codes, std::size_t count, RunLengthThreshold threshold)
{
  RunLengthEncoder encoder(threshold);
  encoder.Feed(codes, count);
  return encoder.Finish();
}

RunLengthEncoder::RunLengthEncoder(RunLengthThreshold threshold)
  : shortest(static_cast<std::size_t>(threshold))
{
}

void RunLengthEncoder::Feed(const std::uint8_t* codes, std::size_t count)
{
  for (std::size_t begin = 0; begin < count;)
  {
    const std::size_t more = RunLengthAt(codes + begin, count - begin);
    if (codes[begin] != code)
    {
      this->PutRun();
      code = codes[begin];
      if (code >= literalBit)
      {
        throw Error("code " + std::to_string(code) + " of voxel " + std::to_string(fed) +
                    ": the run-length code holds 0 to 127");
      }
    }
    length += more;
    begin += more;
  }
}

void RunLengthEncoder::PutRun()
{
  constexpr std::size_t longest = std::numeric_limits<std::uint32_t>::max();
  fed += length;
  while (length > 0)
  {
    const std::size_t piece = std::min(length, longest);
    if (piece >= shortest)
    {
      AppendRun(stream, code, static_cast<std::uint32_t>(piece));
    }
    else
    {
      stream.insert(stream.end(), piece, static_cast<std::uint8_t>(literalBit | code));
    }
    length -= piece;
  }
}

std::vector<std::uint8_t> RunLengthEncoder::Finish()
{
  this->PutRun();
  return std::move(stream);
}

namespace
{

constexpr std::size_t runSize = 5; // bytes of a run in the stream

std::uint32_t LengthOfRun(const std::uint8_t* run)
{
  return run[1] | static_cast<std::uint32_t>(run[2]) << 8 |
         static_cast<std::uint32_t>(run[3]) << 16 | static_cast<std::uint32_t>(run[4]) << 24;
}

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
    const std::uint32_t run = LengthOfRun(stream + at.byte);
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
      const std::uint32_t run = LengthOfRun(part + at);
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

RunLengthDecoder::RunLengthDecoder(std::uint8_t* target, std::size_t size)
  : codes(target)
  , count(size)
{
}

void RunLengthDecoder::Feed(const std::uint8_t* bytes, std::size_t size)
{
  for (std::size_t i = 0; i < size; ++i)
  {
    this->TakeByte(bytes[i]);
    ++offset;
  }
}

void RunLengthDecoder::TakeByte(std::uint8_t byte)
{
  if (decoded == count)
  {
    Refuse(offset, "more bytes after the last of " + std::to_string(count) + " voxels");
  }
  if (runBytes == 0 && (byte & literalBit) != 0)
  {
    codes[decoded++] = byte & 0x7F;
    return;
  }
  run[runBytes++] = byte;
  if (runBytes == run.size())
  {
    runBytes = 0;
    const std::uint32_t length = LengthOfRun(run.data());
    CheckRun(offset + 1 - run.size(), length, count - decoded);
    std::fill_n(codes + decoded, length, run[0]);
    decoded += length;
  }
}

void RunLengthDecoder::Finish() const
{
  if (runBytes != 0)
  {
    Refuse(offset, "the stream ends within a run");
  }
  CheckEnd(offset, decoded, count);
}

} // namespace nexrad
