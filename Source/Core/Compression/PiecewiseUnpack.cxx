// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Compression/PiecewiseUnpack.h"

#include "nexrad/Compression/Unlzw.h"

#include <bzlib.h>
#include <zlib.h>

#include <algorithm>
#include <vector>

namespace nexrad
{

namespace
{

constexpr std::size_t pieceBytes = std::size_t(1) << 16;

enum class StepResult
{
  More,
  End,
  Corrupt
};

// The stored bytes in hand, and the room for decompressed ones.
struct Pieces
{
  std::vector<std::uint8_t> stored = std::vector<std::uint8_t>(pieceBytes);
  std::vector<std::uint8_t> plain = std::vector<std::uint8_t>(pieceBytes);
  std::size_t begin = 0; // of what is left in `stored`
  std::size_t end = 0;
};

class GzipSteps
{
public:
  static constexpr const char* name = "gzip";
  static constexpr std::uint8_t firstByte = 0x1F;

  GzipSteps()
  {
    constexpr int gzipHeaderAndLargestWindow = 16 + MAX_WBITS;
    inflateInit2(&stream, gzipHeaderAndLargestWindow);
  }
  ~GzipSteps() { inflateEnd(&stream); }
  GzipSteps(const GzipSteps&) = delete;
  GzipSteps& operator=(const GzipSteps&) = delete;

  void Restart() { inflateReset(&stream); }
  // One step; `made` becomes the number of decompressed bytes.
  StepResult Step(Pieces& pieces, std::size_t& made)
  {
    stream.next_in = pieces.stored.data() + pieces.begin;
    stream.avail_in = static_cast<unsigned>(pieces.end - pieces.begin);
    stream.next_out = pieces.plain.data();
    stream.avail_out = static_cast<unsigned>(pieces.plain.size());
    const int status = inflate(&stream, Z_NO_FLUSH);
    pieces.begin = pieces.end - stream.avail_in;
    made = pieces.plain.size() - stream.avail_out;
    return status == Z_STREAM_END                    ? StepResult::End
           : status == Z_OK || status == Z_BUF_ERROR ? StepResult::More
                                                     : StepResult::Corrupt;
  }

private:
  z_stream stream{};
};

class Bzip2Steps
{
public:
  static constexpr const char* name = "bzip2";
  static constexpr std::uint8_t firstByte = 'B';

  Bzip2Steps() { BZ2_bzDecompressInit(&stream, 0, 0); }
  ~Bzip2Steps() { BZ2_bzDecompressEnd(&stream); }
  Bzip2Steps(const Bzip2Steps&) = delete;
  Bzip2Steps& operator=(const Bzip2Steps&) = delete;

  void Restart()
  {
    BZ2_bzDecompressEnd(&stream);
    stream = {};
    BZ2_bzDecompressInit(&stream, 0, 0);
  }
  StepResult Step(Pieces& pieces, std::size_t& made)
  {
    stream.next_in = reinterpret_cast<char*>(pieces.stored.data() + pieces.begin);
    stream.avail_in = static_cast<unsigned>(pieces.end - pieces.begin);
    stream.next_out = reinterpret_cast<char*>(pieces.plain.data());
    stream.avail_out = static_cast<unsigned>(pieces.plain.size());
    const int status = BZ2_bzDecompress(&stream);
    pieces.begin = pieces.end - stream.avail_in;
    made = pieces.plain.size() - stream.avail_out;
    return status == BZ_STREAM_END ? StepResult::End
           : status == BZ_OK       ? StepResult::More
                                   : StepResult::Corrupt;
  }

private:
  bz_stream stream{};
};

template <typename Steps>
std::string Unpack(
  const PieceReader& read, const PieceReceiver& receive, std::uint64_t maximumBytes)
{
  const std::string stream = std::string("the ") + Steps::name + " stream ";
  Steps steps;
  Pieces pieces;
  std::uint64_t room = maximumBytes;
  bool ended = false; // the stream in hand; another may follow
  while (true)
  {
    if (pieces.begin == pieces.end)
    {
      pieces.begin = 0;
      pieces.end = read(pieces.stored.data(), pieces.stored.size());
    }
    const bool isAtEnd = pieces.begin == pieces.end;
    if (ended)
    {
      if (isAtEnd || pieces.stored[pieces.begin] != Steps::firstByte)
      {
        return {}; // what fills up a tape after the last stream is no data
      }
      steps.Restart();
      ended = false;
    }
    std::size_t made = 0;
    const StepResult result = steps.Step(pieces, made);
    receive(pieces.plain.data(), std::min<std::uint64_t>(made, room));
    if (made > room)
    {
      return TooLarge(maximumBytes);
    }
    room -= made;
    if (result == StepResult::Corrupt)
    {
      return stream + "is corrupt";
    }
    ended = result == StepResult::End;
    if (!ended && isAtEnd && made == 0)
    {
      return stream + "ends early";
    }
  }
}

std::string UnpackCompress(
  const PieceReader& read, const PieceReceiver& receive, std::uint64_t maximumBytes)
{
  std::vector<std::uint8_t> stored;
  std::vector<std::uint8_t> piece(pieceBytes);
  while (const std::size_t count = read(piece.data(), piece.size()))
  {
    stored.insert(stored.end(), piece.begin(), piece.begin() + static_cast<std::ptrdiff_t>(count));
  }
  const Unpacked plain = Unlzw(ByteView(stored.data(), stored.size()), maximumBytes);
  receive(plain.bytes.data(), plain.bytes.size());
  return plain.problem;
}

} // namespace

std::string UnpackInPieces(StreamFormat format, const PieceReader& read,
  const PieceReceiver& receive, std::uint64_t maximumBytes)
{
  switch (format)
  {
  case StreamFormat::Gzip:
    return Unpack<GzipSteps>(read, receive, maximumBytes);
  case StreamFormat::Bzip2:
    return Unpack<Bzip2Steps>(read, receive, maximumBytes);
  case StreamFormat::Compress:
    return UnpackCompress(read, receive, maximumBytes);
  case StreamFormat::None:
    break;
  }
  return "the file is not compressed";
}

} // namespace nexrad
