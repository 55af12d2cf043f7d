// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Compression/Container.h"

#include "nexrad/Compression/Unlzw.h"
#include "nexrad/System/MachineMemory.h"

#include <bzlib.h>
#include <zlib.h>

#include <algorithm>
#include <limits>

namespace nexrad
{

namespace
{

constexpr int deepestNesting = 3;
// Decompressors write into a small window that stays in the processor's cache; from there the bytes
// go to fresh memory once, which a vector that grows would fill with zeros first.
constexpr std::size_t windowBytes = std::size_t(1) << 16;
constexpr std::size_t largestStepBytes = std::size_t(1) << 20;

unsigned SmallCount(std::size_t count)
{
  return static_cast<unsigned>(std::min<std::size_t>(count, std::numeric_limits<int>::max()));
}

// The problem of a stream that holds more than it may.
std::string TooLarge(std::uint64_t maximumBytes)
{
  return "more than " + std::to_string(maximumBytes) + " bytes when decompressed; the rest is left";
}

enum class StepResult
{
  More,
  End,
  Corrupt
};

struct GzipStream : z_stream
{
  static constexpr const char* name = "gzip";
  static constexpr std::uint8_t firstByte = 0x1F;

  GzipStream()
    : z_stream{}
  {
    constexpr int gzipHeaderAndLargestWindow = 16 + MAX_WBITS;
    inflateInit2(this, gzipHeaderAndLargestWindow);
  }
  ~GzipStream() { inflateEnd(this); }
  GzipStream(const GzipStream&) = delete;
  GzipStream& operator=(const GzipStream&) = delete;

  void Restart() { inflateReset(this); }
  StepResult Step()
  {
    const int status = inflate(this, Z_NO_FLUSH);
    return status == Z_STREAM_END                    ? StepResult::End
           : status == Z_OK || status == Z_BUF_ERROR ? StepResult::More
                                                     : StepResult::Corrupt;
  }
};

struct Bzip2Stream : bz_stream
{
  static constexpr const char* name = "bzip2";
  static constexpr std::uint8_t firstByte = 'B';

  Bzip2Stream()
    : bz_stream{}
  {
    BZ2_bzDecompressInit(this, 0, 0);
  }
  ~Bzip2Stream() { BZ2_bzDecompressEnd(this); }
  Bzip2Stream(const Bzip2Stream&) = delete;
  Bzip2Stream& operator=(const Bzip2Stream&) = delete;

  void Restart()
  {
    BZ2_bzDecompressEnd(this);
    BZ2_bzDecompressInit(this, 0, 0);
  }
  StepResult Step()
  {
    const int status = BZ2_bzDecompress(this);
    return status == BZ_STREAM_END ? StepResult::End
           : status == BZ_OK       ? StepResult::More
                                   : StepResult::Corrupt;
  }
};

class GzipReader
{
public:
  GzipReader(ByteView storedBytes, std::size_t maximumBytes, DecodingBudget& theBudget)
    : stored(storedBytes)
    , maximum(maximumBytes)
    , budget(theBudget)
    , window(windowBytes)
  {
    result.bytes.reserve(std::min(this->LikelySize(), maximum));
    UseHugePages(result.bytes.data(), result.bytes.capacity());
  }

  Unpacked Run()
  {
    result.offsets.Add(0, 0);
    while (result.problem.empty() && this->Step())
    {
    }
    return std::move(result);
  }

private:
  // The end of the file states the size of the last member. It is believed only as far as radar
  // data compress.
  std::size_t LikelySize() const
  {
    constexpr std::size_t sizeBytes = 4;
    constexpr std::size_t strongestCompression = 40;
    if (stored.Size() < sizeBytes)
    {
      return 0;
    }
    const std::uint8_t* end = stored.Data() + stored.Size();
    const std::size_t stated = std::size_t(end[-1]) << 24 | std::size_t(end[-2]) << 16 |
                               std::size_t(end[-3]) << 8 | std::size_t(end[-4]);
    return std::min(stated, strongestCompression * stored.Size());
  }
  // One step of output. False at the end.
  bool Step()
  {
    const std::size_t room = std::min(maximum - result.bytes.size(), windowBytes);
    if (room == 0)
    {
      result.problem = TooLarge(maximum);
      return false;
    }
    stream.next_in = stored.Data() + result.used;
    stream.avail_in = SmallCount(stored.Size() - result.used);
    stream.next_out = window.data();
    stream.avail_out = static_cast<unsigned>(room);
    const unsigned offered = stream.avail_in;
    const int status = inflate(&stream, Z_NO_FLUSH);
    result.used += offered - stream.avail_in;
    result.bytes.insert(result.bytes.end(), window.data(), stream.next_out);
    result.offsets.Add(result.bytes.size(), result.used);
    if (status == Z_STREAM_END)
    {
      return this->NextMember();
    }
    if (status != Z_OK)
    {
      result.problem = status == Z_BUF_ERROR
                         ? "the gzip stream ends early"
                         : std::string("the gzip stream is corrupt: ") +
                             (stream.msg != nullptr ? stream.msg : "no reason given");
    }
    return status == Z_OK;
  }
  // Gzip files may be joined end to end.
  bool NextMember()
  {
    if (DetectStream(stored.Sub(result.used)) == StreamFormat::Gzip)
    {
      const bool paid = budget.Spend(DecodingBudget::StreamCost);
      result.problem = paid ? result.problem : budget.Explain();
      stream.Restart();
      return paid;
    }
    const ByteView rest = stored.Sub(result.used);
    if (std::any_of(rest.Data(), rest.Data() + rest.Size(), [](auto byte) { return byte != 0; }))
    {
      result.problem = std::to_string(rest.Size()) + " bytes after the end of the gzip stream";
    }
    return false;
  }

  ByteView stored;
  std::size_t maximum;
  DecodingBudget& budget;
  std::vector<std::uint8_t> window;
  GzipStream stream;
  Unpacked result;
};

// A file of several bzip2 streams end to end, as parallel compressors write it.
Unpacked UnpackBzip2(ByteView stored, std::size_t maximumBytes)
{
  Unpacked result;
  Bzip2Reader reader; // one for all: a file may hold a stream every fourteen bytes
  while (result.problem.empty() && stored.StartsWith("BZh", result.used))
  {
    Unpacked part = reader.Run(stored.Sub(result.used), maximumBytes - result.bytes.size());
    result.offsets.Append(part.offsets, result.bytes.size(), result.used);
    result.used += part.used;
    result.problem = part.problem;
    if (result.bytes.empty())
    {
      result.bytes = std::move(part.bytes);
    }
    else
    {
      result.bytes.insert(result.bytes.end(), part.bytes.begin(), part.bytes.end());
    }
  }
  if (result.problem.empty() && result.used < stored.Size())
  {
    result.problem =
      std::to_string(stored.Size() - result.used) + " bytes after the end of the bzip2 stream";
  }
  return result;
}

// Decompresses what the budget pays for. A third of it stays for what is made of the bytes.
Unpacked UnpackWithin(StreamFormat format, ByteView stored, DecodingBudget& budget)
{
  Unpacked result;
  if (!budget.Spend(DecodingBudget::CompressedByteCost * stored.Size()))
  {
    result.problem = budget.Explain();
    return result;
  }
  const std::size_t most = budget.Left() - budget.Left() / 3;
  result = format == StreamFormat::Gzip    ? GzipReader(stored, most, budget).Run()
           : format == StreamFormat::Bzip2 ? UnpackBzip2(stored, most)
                                           : Unlzw(stored, most);
  budget.Spend(result.bytes.size());
  return result;
}

std::string ExplainBzip2(int status)
{
  switch (status)
  {
  case BZ_OK:
    return "the bzip2 stream ends early";
  case BZ_DATA_ERROR_MAGIC:
    return "no bzip2 stream";
  case BZ_MEM_ERROR:
    return "not enough memory for bzip2";
  default:
    return "the bzip2 stream is corrupt";
  }
}

} // namespace

StreamFormat DetectStream(ByteView bytes)
{
  if (bytes.StartsWith("\x1F\x8B"))
  {
    return StreamFormat::Gzip;
  }
  if (bytes.StartsWith("\x1F\x9D"))
  {
    return StreamFormat::Compress;
  }
  return bytes.StartsWith("BZh") ? StreamFormat::Bzip2 : StreamFormat::None;
}

std::size_t Bzip2Reader::Room(std::size_t used, std::size_t maximumBytes)
{
  if (output.size() == used && used < maximumBytes)
  {
    output.resize(std::min(std::max(windowBytes, used * 2), maximumBytes));
  }
  return std::min({output.size(), maximumBytes, used + largestStepBytes}) - used;
}

Unpacked Bzip2Reader::Run(ByteView stored, std::size_t maximumBytes)
{
  std::optional<Unpacked> whole = fast.Run(stored, maximumBytes);
  return whole ? std::move(*whole) : this->RunSlowly(stored, maximumBytes);
}

// By libbz2: gets out what can be had of a damaged stream, and says what is wrong with it.
Unpacked Bzip2Reader::RunSlowly(ByteView stored, std::size_t maximumBytes)
{
  Unpacked result;
  Bzip2Stream stream;
  result.offsets.Add(0, 0);
  std::size_t used = 0;
  int status = BZ_OK;
  bool starved = false;
  while (status == BZ_OK && !starved)
  {
    const auto room = static_cast<unsigned>(this->Room(used, maximumBytes));
    if (room == 0)
    {
      result.problem = TooLarge(maximumBytes);
      break;
    }
    // The interface takes input that it does not change as non-const chars.
    stream.next_in = const_cast<char*>(reinterpret_cast<const char*>(stored.Data() + result.used));
    stream.avail_in = SmallCount(stored.Size() - result.used);
    stream.next_out = reinterpret_cast<char*>(output.data() + used);
    stream.avail_out = room;
    const unsigned offered = stream.avail_in;
    status = BZ2_bzDecompress(&stream);
    result.used += offered - stream.avail_in;
    used += room - stream.avail_out;
    result.offsets.Add(used, result.used);
    starved = stream.avail_in == 0 && stream.avail_out != 0;
  }
  if (status != BZ_STREAM_END && result.problem.empty())
  {
    result.problem = ExplainBzip2(status);
  }
  result.bytes.assign(output.data(), output.data() + used);
  return result;
}

PlainFile OpenContainer(
  std::vector<std::uint8_t> stored, DecodingBudget& budget, std::vector<Damage>& damage)
{
  PlainFile file;
  file.bytes = std::move(stored);
  for (int depth = 0; depth < deepestNesting; ++depth)
  {
    const ByteView view(file.bytes.data(), file.bytes.size());
    const StreamFormat format = DetectStream(view);
    if (format == StreamFormat::None)
    {
      break;
    }
    Unpacked inner = UnpackWithin(format, view, budget);
    if (!inner.problem.empty())
    {
      damage.push_back({file.offsets.ToStored(inner.used), inner.problem});
    }
    inner.offsets.ComposeWith(file.offsets);
    file.offsets = std::move(inner.offsets);
    file.bytes = std::move(inner.bytes);
  }
  return file;
}

namespace
{

template <typename Stream>
std::string UnpackStreams(
  const PieceReader& read, const PieceReceiver& receive, std::uint64_t maximumBytes)
{
  const std::string name = std::string("the ") + Stream::name + " stream ";
  Stream stream;
  std::vector<std::uint8_t> stored(windowBytes);
  std::vector<std::uint8_t> plain(windowBytes);
  std::size_t begin = 0; // of what is left in `stored`
  std::size_t end = 0;
  std::uint64_t room = maximumBytes;
  bool ended = false; // the stream in hand; another may follow
  while (true)
  {
    if (begin == end)
    {
      begin = 0;
      end = read(stored.data(), stored.size());
    }
    const bool isAtEnd = begin == end;
    if (ended)
    {
      if (isAtEnd || stored[begin] != Stream::firstByte)
      {
        return {}; // what fills up a tape after the last stream is no data
      }
      stream.Restart();
    }
    stream.next_in = reinterpret_cast<decltype(stream.next_in)>(stored.data() + begin);
    stream.avail_in = static_cast<unsigned>(end - begin);
    stream.next_out = reinterpret_cast<decltype(stream.next_out)>(plain.data());
    stream.avail_out = static_cast<unsigned>(plain.size());
    const StepResult result = stream.Step();
    begin = end - stream.avail_in;
    const std::size_t made = plain.size() - stream.avail_out;
    receive(plain.data(), std::min<std::uint64_t>(made, room));
    if (made > room)
    {
      return TooLarge(maximumBytes);
    }
    room -= made;
    if (result == StepResult::Corrupt)
    {
      return name + "is corrupt";
    }
    ended = result == StepResult::End;
    if (!ended && isAtEnd && made == 0)
    {
      return name + "ends early";
    }
  }
}

std::string UnpackCompress(
  const PieceReader& read, const PieceReceiver& receive, std::uint64_t maximumBytes)
{
  std::vector<std::uint8_t> stored;
  std::vector<std::uint8_t> piece(windowBytes);
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
    return UnpackStreams<GzipStream>(read, receive, maximumBytes);
  case StreamFormat::Bzip2:
    return UnpackStreams<Bzip2Stream>(read, receive, maximumBytes);
  case StreamFormat::Compress:
    return UnpackCompress(read, receive, maximumBytes);
  case StreamFormat::None:
    break;
  }
  return "the file is not compressed";
}

} // namespace nexrad
