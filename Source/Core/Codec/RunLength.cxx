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

void DecodeRunLength(
  const std::uint8_t* stream, std::size_t length, std::uint8_t* codes, std::size_t count)
{
  RunLengthDecoder decoder(codes, count);
  decoder.Feed(stream, length);
  decoder.Finish();
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
    const std::uint32_t length = run[1] | static_cast<std::uint32_t>(run[2]) << 8 |
                                 static_cast<std::uint32_t>(run[3]) << 16 |
                                 static_cast<std::uint32_t>(run[4]) << 24;
    this->Append(run[0], length);
  }
}

void RunLengthDecoder::Append(std::uint8_t code, std::uint32_t length)
{
  const std::uint64_t begin = offset + 1 - run.size();
  if (length == 0)
  {
    Refuse(begin, "a run of no voxels; its length must be 1 or more");
  }
  if (length > count - decoded)
  {
    Refuse(begin, "a run of " + std::to_string(length) + " where " +
                    std::to_string(count - decoded) + " voxels are left");
  }
  std::fill_n(codes + decoded, length, code);
  decoded += length;
}

void RunLengthDecoder::Finish() const
{
  if (runBytes != 0)
  {
    Refuse(offset, "the stream ends within a run");
  }
  if (decoded != count)
  {
    Refuse(offset, "the stream ends after " + std::to_string(decoded) + " of " +
                     std::to_string(count) + " voxels");
  }
}

} // namespace nexrad
