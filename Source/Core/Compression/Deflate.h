// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/System/RangeLoop.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace nexrad
{

/// What DeflateBytes looks for in the bytes.
enum class DeflateSearch
{
  Repeats, ///< any that come again; level 6
  Runs     ///< runs of one byte alone: for codes of voxels in half the time, and no larger
};

/// Compresses bytes into one zlib stream (RFC 1950).
std::vector<std::uint8_t> DeflateBytes(
  const std::uint8_t* data, std::size_t size, DeflateSearch search = DeflateSearch::Repeats);

/// Compresses bytes into one gzip stream (RFC 1952).
std::vector<std::uint8_t> GzipBytes(const std::uint8_t* data, std::size_t size);

/// A zlib stream in pieces that can be decompressed each for itself.
struct DeflatedPieces
{
  std::vector<std::uint8_t> stream;
  std::vector<std::uint64_t> lengths; ///< bytes of the stream that belong to each piece
};

/// Writes the bytes [first, first + count) of what is compressed to `to`.
using ByteSource = std::function<void(std::size_t first, std::size_t count, std::uint8_t* to)>;

/// Compresses `size` bytes into one zlib stream of pieces. Each piece holds `pieceSize` of the
/// bytes, the last one what is left, and ends at a full flush (RFC 1951: an empty stored block,
/// after which nothing refers to what came before). The source is asked for one piece after the
/// other. The stream of a single piece is that of DeflateBytes.
DeflatedPieces DeflateInPieces(const ByteSource& source, std::size_t size, std::size_t pieceSize,
  DeflateSearch search = DeflateSearch::Repeats);

/// Decompresses a zlib stream that must give exactly `size` bytes into `target`. Throws Error when
/// it is damaged or gives more or fewer.
void InflateBytes(
  const std::uint8_t* stream, std::size_t length, std::uint8_t* target, std::size_t size);

/// The same for a stream that DeflateInPieces made; the loop decompresses several pieces at a time.
/// `lengths` add up to the length of the stream. The check sum at its end is not looked at: the
/// caller has one of the stream.
void InflatePieces(const std::uint8_t* stream, const std::vector<std::uint64_t>& lengths,
  std::size_t pieceSize, std::uint8_t* target, std::size_t size, const RangeLoop& loop = {});

/// CRC-32 (that of zlib and PNG) of bytes, or of more bytes after those that gave `before`.
std::uint32_t Crc32(const std::uint8_t* data, std::size_t size, std::uint32_t before = 0);

} // namespace nexrad
