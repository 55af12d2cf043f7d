// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Compression/BigEndian.h"
#include "nexrad/Compression/DecodingBudget.h"
#include "nexrad/Compression/FastBunzip.h"
#include "nexrad/Compression/OffsetMap.h"
#include "nexrad/Model/RadarVolume.h"

#include <cstddef>
#include <cstdint>
#include <functional>
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

/// Decompresses bzip2 streams one after another. The memory for that is kept between them, and each
/// result is allocated in its size.
class Bzip2Reader
{
public:
  /// Decompresses one stream, step by step, to at most `maximumBytes`.
  Unpacked Run(ByteView stored, std::size_t maximumBytes);

private:
  Unpacked RunSlowly(ByteView stored, std::size_t maximumBytes);
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

/// Fills the target with the next stored bytes, at most `size`, and returns their number: 0 at the
/// end.
using PieceReader = std::function<std::size_t(std::uint8_t* target, std::size_t size)>;

/// Takes the next decompressed bytes.
using PieceReceiver = std::function<void(const std::uint8_t* data, std::size_t size)>;

/// Decompresses a stream, or streams of one format end to end, in pieces of 64 KiB: for files that
/// are too large for memory. Only a stream of compress is read as a whole first. Stops after
/// `maximumBytes`. Returns what is wrong with the stream in one line; "" when it is whole.
std::string UnpackInPieces(StreamFormat format, const PieceReader& read,
  const PieceReceiver& receive, std::uint64_t maximumBytes);

} // namespace nexrad
