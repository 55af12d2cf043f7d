// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Compression/Deflate.h"

#include "nexrad/System/Error.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <new>
#include <string>
#include <utility>

namespace nexrad
{

namespace
{

// zlib counts in 32 bits.
constexpr std::size_t largestPiece = std::size_t(1) << 30;
constexpr std::size_t outputSize = 64 * 1024;
// Bits of the window, as zlib takes them: with its own header and check sum, with those of gzip,
// and without.
constexpr int zlibStream = 15;
constexpr int gzipStream = 15 + 16;
constexpr int bareStream = -15;

struct Deflater
{
  z_stream state{};

  explicit Deflater(DeflateSearch search, int windowBits = zlibStream)
  {
    constexpr int memoryLevel = 8;
    const int strategy = search == DeflateSearch::Runs ? Z_RLE : Z_DEFAULT_STRATEGY;
    if (deflateInit2(
          &state, Z_DEFAULT_COMPRESSION, Z_DEFLATED, windowBits, memoryLevel, strategy) != Z_OK)
    {
      throw std::bad_alloc();
    }
  }
  ~Deflater() { deflateEnd(&state); }
  Deflater(const Deflater&) = delete;
  Deflater& operator=(const Deflater&) = delete;
};

// Compresses `size` bytes more, and appends what comes of it. Z_FINISH ends the stream,
// Z_FULL_FLUSH a piece.
void Deflate(Deflater& deflater, const std::uint8_t* data, std::size_t size, int flush,
  std::vector<std::uint8_t>& compressed)
{
  z_stream& state = deflater.state;
  std::array<std::uint8_t, outputSize> output{};
  bool done = false;
  while (!done)
  {
    if (state.avail_in == 0)
    {
      const std::size_t piece = std::min(size, largestPiece);
      state.next_in = data;
      state.avail_in = static_cast<uInt>(piece);
      data += piece;
      size -= piece;
    }
    state.next_out = output.data();
    state.avail_out = static_cast<uInt>(output.size());
    const int status = deflate(&state, size == 0 ? flush : Z_NO_FLUSH);
    compressed.insert(
      compressed.end(), output.data(), output.data() + output.size() - state.avail_out);
    // A flush is complete when it leaves room in the output.
    done = flush == Z_FINISH ? status == Z_STREAM_END
                             : size == 0 && state.avail_in == 0 && state.avail_out > 0;
  }
}

struct Inflating
{
  z_stream state{};

  explicit Inflating(int windowBits)
  {
    if (inflateInit2(&state, windowBits) != Z_OK)
    {
      throw std::bad_alloc();
    }
  }
  ~Inflating() { inflateEnd(&state); }
  Inflating(const Inflating&) = delete;
  Inflating& operator=(const Inflating&) = delete;
};

constexpr std::size_t zlibHeaderSize = 2;
constexpr std::size_t zlibCheckSumSize = 4;

// What came of a stream.
struct Inflated
{
  std::size_t bytes = 0;  // in the target
  std::size_t unread = 0; // bytes after its end
  bool ended = false;
};

// Decompresses until the stream ends or has no more bytes. Throws Error when it is damaged or gives
// more than `size` bytes.
Inflated InflateInto(const std::uint8_t* stream, std::size_t length, int windowBits,
  std::uint8_t* target, std::size_t size)
{
  Inflating inflating(windowBits);
  z_stream& state = inflating.state;
  std::uint8_t beyond = 0; // takes what is too much
  std::size_t room = size;
  int status = Z_OK;
  while (status == Z_OK)
  {
    if (state.avail_in == 0)
    {
      state.next_in = stream;
      state.avail_in = static_cast<uInt>(std::min(length, largestPiece));
      stream += state.avail_in;
      length -= state.avail_in;
    }
    if (state.avail_out == 0)
    {
      state.next_out = room > 0 ? target + (size - room) : &beyond;
      state.avail_out = room > 0 ? static_cast<uInt>(std::min(room, largestPiece)) : 1;
      room -= room > 0 ? state.avail_out : 0;
    }
    status = inflate(&state, Z_NO_FLUSH);
    if (state.next_out == &beyond + 1)
    {
      throw Error("it holds more than " + std::to_string(size) + " bytes");
    }
  }
  if (status != Z_STREAM_END && status != Z_BUF_ERROR)
  {
    throw Error("the deflated stream is damaged");
  }
  const std::size_t unused = state.next_out == &beyond ? 0 : state.avail_out;
  return {size - room - unused, state.avail_in + length, status == Z_STREAM_END};
}

void CheckSize(const Inflated& inflated, std::size_t size)
{
  if (inflated.bytes != size)
  {
    throw Error(
      "it holds " + std::to_string(inflated.bytes) + " bytes in place of " + std::to_string(size));
  }
}

// One piece of a stream, without zlib's header.
void InflatePiece(
  const std::uint8_t* piece, std::size_t length, bool last, std::uint8_t* target, std::size_t size)
{
  const Inflated inflated = InflateInto(piece, length, bareStream, target, size);
  if (inflated.ended != last || inflated.unread != (last ? zlibCheckSumSize : 0))
  {
    throw Error("a piece of the deflated stream does not end where the header says");
  }
  CheckSize(inflated, size);
}

} // namespace

std::vector<std::uint8_t> DeflateBytes(
  const std::uint8_t* data, std::size_t size, DeflateSearch search)
{
  Deflater deflater(search);
  std::vector<std::uint8_t> stream;
  Deflate(deflater, data, size, Z_FINISH, stream);
  return stream;
}

std::vector<std::uint8_t> GzipBytes(const std::uint8_t* data, std::size_t size)
{
  Deflater deflater(DeflateSearch::Repeats, gzipStream);
  std::vector<std::uint8_t> stream;
  Deflate(deflater, data, size, Z_FINISH, stream);
  return stream;
}

DeflatedPieces DeflateInPieces(
  const ByteSource& source, std::size_t size, std::size_t pieceSize, DeflateSearch search)
{
  Deflater deflater(search);
  DeflatedPieces pieces;
  std::vector<std::uint8_t> bytes(std::min(pieceSize, size));
  std::size_t begin = 0;
  do
  {
    const std::size_t piece = std::min(pieceSize, size - begin);
    source(begin, piece, bytes.data());
    const std::size_t before = pieces.stream.size();
    Deflate(deflater, bytes.data(), piece, begin + piece == size ? Z_FINISH : Z_FULL_FLUSH,
      pieces.stream);
    pieces.lengths.push_back(pieces.stream.size() - before);
    begin += piece;
  } while (begin < size);
  return pieces;
}

void InflateBytes(
  const std::uint8_t* stream, std::size_t length, std::uint8_t* target, std::size_t size)
{
  const Inflated inflated = InflateInto(stream, length, zlibStream, target, size);
  if (!inflated.ended)
  {
    throw Error("the deflated stream ends too early");
  }
  if (inflated.unread > 0)
  {
    throw Error("bytes after the end of the deflated stream");
  }
  CheckSize(inflated, size);
}

void InflatePieces(const std::uint8_t* stream, const std::vector<std::uint64_t>& lengths,
  std::size_t pieceSize, std::uint8_t* target, std::size_t size, const RangeLoop& loop)
{
  if (lengths.size() != (size + pieceSize - 1) / pieceSize || lengths.front() < zlibHeaderSize)
  {
    throw Error("it has " + std::to_string(lengths.size()) + " pieces of " +
                std::to_string(pieceSize) + " bytes for " + std::to_string(size) + " bytes");
  }
  std::vector<std::uint64_t> begins{0};
  for (const std::uint64_t length : lengths)
  {
    begins.push_back(begins.back() + length);
  }
  begins.front() = zlibHeaderSize;
  RunEach(loop, lengths.size(),
    [&](std::size_t i)
    {
      const std::size_t begin = i * pieceSize;
      InflatePiece(stream + begins[i], begins[i + 1] - begins[i], i + 1 == lengths.size(),
        target + begin, std::min(pieceSize, size - begin));
    });
}

std::uint32_t Crc32(const std::uint8_t* data, std::size_t size, std::uint32_t before)
{
  // Of no bytes, zlib would give that of the beginning.
  return size > 0 ? static_cast<std::uint32_t>(crc32_z(before, data, size)) : before;
}

} // namespace nexrad
