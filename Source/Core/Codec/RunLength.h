// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/System/RangeLoop.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace nexrad
{

/// The thesis's modified run-length code (Formulas T8). A literal v (0…127) is the byte 0x80 | v. A
/// run of n equal v is the byte v and n as a 32-bit little-endian unsigned integer.

/// Shortest run written as a run. The thesis writes every run of two or more; six is the first
/// length at which the five bytes of a run are fewer than its literals.
enum class RunLengthThreshold : std::uint32_t
{
  Thesis = 2,
  Compact = 6
};

/// Encodes `count` codes. Throws Error when a code is above 127.
std::vector<std::uint8_t> EncodeRunLength(
  const std::uint8_t* codes, std::size_t count, RunLengthThreshold threshold);

/// The same for codes that come in pieces of any size; runs cross the pieces.
class RunLengthEncoder
{
public:
  explicit RunLengthEncoder(RunLengthThreshold threshold);

  /// Encodes the next codes. Throws Error when one is above 127.
  void Feed(const std::uint8_t* codes, std::size_t count);
  /// The stream; nothing is fed after it.
  std::vector<std::uint8_t> Finish();

private:
  void PutRun();

  const std::size_t shortest;
  std::vector<std::uint8_t> stream;
  std::uint8_t code = 0;  // of the run that has begun
  std::size_t length = 0; // of it so far
  std::size_t fed = 0;    // codes before it
};

/// Decodes exactly `count` codes into `codes`. Throws Error, with the offset in the stream, for a
/// run of 0, a stream that ends within a run or too early, a run beyond `count`, or bytes after the
/// last code. The loop decodes several parts of a long stream at a time.
void DecodeRunLength(const std::uint8_t* stream, std::size_t length, std::uint8_t* codes,
  std::size_t count, const RangeLoop& loop = {});

/// The same for a stream that comes in pieces of any size.
class RunLengthDecoder
{
public:
  /// Decodes into `codes`, which has room for `count` and must outlive the decoder.
  RunLengthDecoder(std::uint8_t* codes, std::size_t count);

  /// Decodes the next bytes of the stream. Throws as DecodeRunLength does.
  void Feed(const std::uint8_t* bytes, std::size_t size);
  /// Throws Error when the stream ended too early.
  void Finish() const;

private:
  void TakeByte(std::uint8_t byte);

  std::uint8_t* codes;
  std::size_t count;
  std::size_t decoded = 0;
  std::uint64_t offset = 0;          // in the stream, of the byte to come
  std::array<std::uint8_t, 5> run{}; // the bytes of a run that has begun
  std::size_t runBytes = 0;          // how many of them are there
};

} // namespace nexrad
