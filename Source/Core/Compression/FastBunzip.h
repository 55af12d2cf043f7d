// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Compression/BigEndian.h"
#include "nexrad/Compression/OffsetMap.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>

namespace nexrad
{

/// Decompresses whole bzip2 streams of radar data in less than half of libbz2's time: what has to
/// be guessed is left out of its loops, runs come out as pieces, and checksums take sixteen bytes
/// at a time. Anything unusual or wrong is left to libbz2, which can say what it is. Which bytes
/// come out does not depend on who decompresses: the checksums of the stream vouch for them.
///
/// ```
///   bits ──Huffman──▶ symbols ──move to front, runs──▶ column ──links──▶ text ──runs──▶ bytes
/// ```
///
/// The memory is kept between streams: 7 bytes for each of a block, which has at most 900 000.
class FastBunzip
{
public:
  FastBunzip();
  ~FastBunzip();
  FastBunzip(const FastBunzip&) = delete;
  FastBunzip& operator=(const FastBunzip&) = delete;

  /// Decompresses one stream to at most `maximumBytes`. Empty when the stream is not whole and
  /// correct, is longer than that, or has what no compressor writes: randomised blocks (none has
  /// for long), and lengths of codes that cannot all be.
  std::optional<Unpacked> Run(ByteView stored, std::size_t maximumBytes);

private:
  struct Memory;
  const std::unique_ptr<Memory> memory;
};

} // namespace nexrad
