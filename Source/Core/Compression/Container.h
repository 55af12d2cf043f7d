// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Compression/BigEndian.h"
#include "nexrad/Compression/DecodingBudget.h"
#include "nexrad/Compression/FastBunzip.h"
#include "nexrad/Compression/OffsetMap.h"
#include "nexrad/Model/RadarVolume.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace nexrad
{

/// Compressed streams that hold a whole file.
enum class StreamFormat
{
  None,
  Gzip,
  Bzip2,
  Compress ///< the Unix program compress, .Z
};

/// The format that the first bytes announce.
StreamFormat DetectStream(ByteView bytes);

/// The problem of a stream that holds more than it may.
std::string TooLarge(std::uint64_t maximumBytes);

/// What bzip2 made of some compressed bytes.
struct Bunzipped
{
  std::vector<std::uint8_t> bytes; ///< what came out before the problem, if there was one
  OffsetMap offsets;               ///< from `bytes` to the compressed stream
  std::string problem;             ///< one line; empty when the stream was whole
  std::size_t used = 0;            ///< bytes of the input that belong to the stream
};

/// Decompresses bzip2 streams one after another. The memory that they come out into is kept between
/// them, so that each result is allocated once, in its size.
class Bzip2Reader
{
public:
  /// Decompresses one stream, step by step, to at most `maximumBytes`.
  Bunzipped Run(ByteView stored, std::size_t maximumBytes);

private:
  Bunzipped RunSlowly(ByteView stored, std::size_t maximumBytes);
  std::size_t Room(std::size_t used, std::size_t maximumBytes);

  FastBunzip fast;
  std::vector<std::uint8_t> output; // of what `fast` refuses
};

/// A file out of its compressed streams.
struct PlainFile
{
  std::vector<std::uint8_t> bytes;
  OffsetMap offsets; ///< from `bytes` to the stored file
};

/// Takes off the streams round a file (gzip round bzip2 and the like, three deep at most). What was
/// readable of a broken stream is the result, and the break goes to `damage`. Memory is taken as
/// bytes come out; they, and the bytes that they come out of, are paid from the budget.
PlainFile OpenContainer(
  std::vector<std::uint8_t> stored, DecodingBudget& budget, std::vector<Damage>& damage);

} // namespace nexrad
