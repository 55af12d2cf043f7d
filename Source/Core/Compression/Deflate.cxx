// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Compression/Deflate.h"

#include "nexrad/System/Error.h"

#define ZLIB_CONST // zlib's input pointer is then const
#include <zlib.h>

#include <algorithm>
#include <array>
#include <new>
#include <utility>

namespace nexrad
{

namespace
{

// zlib counts in 32 bits.
constexpr std::size_t largestPiece = std::size_t(1) << 30;
constexpr std::size_t outputSize = 64 * 1024;

struct Deflater
{
  z_stream state{};

  explicit Deflater(DeflateSearch search)
  {
    constexpr int windowBits = 15;
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

} // namespace

std::vector<std::uint8_t> DeflateBytes(
  const std::uint8_t* data, std::size_t size, DeflateSearch search)
{
  Deflater deflater(search);
  z_stream& state = deflater.state;
  std::vector<std::uint8_t> compressed;
  std::array<std::uint8_t, outputSize> output{};
  int status = Z_OK;
  while (status != Z_STREAM_END)
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
    status = deflate(&state, size == 0 ? Z_FINISH : Z_NO_FLUSH);
    compressed.insert(
      compressed.end(), output.data(), output.data() + output.size() - state.avail_out);
  }
  return compressed;
}

struct Inflater::Stream
{
  z_stream state{};
  std::array<std::uint8_t, outputSize> output{};
  bool ended = false;
};

Inflater::Inflater(Receiver receiver)
  : stream(std::make_unique<Stream>())
  , receive(std::move(receiver))
{
  if (inflateInit(&stream->state) != Z_OK)
  {
    throw std::bad_alloc();
  }
}

Inflater::~Inflater()
{
  inflateEnd(&stream->state);
}

void Inflater::Feed(const std::uint8_t* data, std::size_t size)
{
  z_stream& state = stream->state;
  while (size > 0)
  {
    if (stream->ended)
    {
      throw Error("bytes after the end of the deflated stream");
    }
    const std::size_t piece = std::min(size, largestPiece);
    state.next_in = data;
    state.avail_in = static_cast<uInt>(piece);
    // Until the input is used up and no full buffer of output hints at more.
    do
    {
      state.next_out = stream->output.data();
      state.avail_out = static_cast<uInt>(outputSize);
      const int status = inflate(&state, Z_NO_FLUSH);
      if (status != Z_OK && status != Z_STREAM_END && status != Z_BUF_ERROR)
      {
        throw Error("the deflated stream is damaged");
      }
      receive(stream->output.data(), outputSize - state.avail_out);
      stream->ended = status == Z_STREAM_END;
    } while (!stream->ended && (state.avail_in > 0 || state.avail_out == 0));
    const std::size_t used = piece - state.avail_in;
    data += used;
    size -= used;
  }
}

void Inflater::Finish() const
{
  if (!stream->ended)
  {
    throw Error("the deflated stream ends too early");
  }
}

std::uint32_t Crc32(const std::uint8_t* data, std::size_t size, std::uint32_t before)
{
  return static_cast<std::uint32_t>(crc32_z(before, data, size));
}

} // namespace nexrad
