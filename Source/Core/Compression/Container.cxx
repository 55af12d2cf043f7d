// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Compression/Container.h"

#include "nexrad/Compression/Unlzw.h"

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
    constexpr int gzipHeaderAndLargestWindow = 16 + MAX_WBITS;
    inflateInit2(&stream, gzipHeaderAndLargestWindow);
  }
  ~GzipReader() { inflateEnd(&stream); }
  GzipReader(const GzipReader&) = delete;
  GzipReader& operator=(const GzipReader&) = delete;

  Unpacked Run()
  {
    result.offsets.Add(0, 0);
    while (result.problem.empty() && this->Step())
    {
    }
    result.problemOffset = position;
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
    stream.next_in = stored.Data() + position;
    stream.avail_in = SmallCount(stored.Size() - position);
    stream.next_out = window.data();
    stream.avail_out = static_cast<unsigned>(room);
    const unsigned offered = stream.avail_in;
    const int status = inflate(&stream, Z_NO_FLUSH);
    position += offered - stream.avail_in;
    result.bytes.insert(result.bytes.end(), window.data(), stream.next_out);
    result.offsets.Add(result.bytes.size(), position);
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
    if (DetectStream(stored.Sub(position)) == StreamFormat::Gzip)
    {
      const bool paid = budget.Spend(DecodingBudget::StreamCost);
      result.problem = paid ? result.problem : budget.Explain();
      return paid && inflateReset(&stream) == Z_OK;
    }
    const ByteView rest = stored.Sub(position);
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
  z_stream stream{};
  std::size_t position = 0;
  Unpacked result;
};

// A file of several bzip2 streams end to end, as parallel compressors write it.
Unpacked UnpackBzip2(ByteView stored, std::size_t maximumBytes)
{
  Unpacked result;
  Bzip2Reader reader; // one for all: a file may hold a stream every fourteen bytes
  std::size_t position = 0;
  while (result.problem.empty() && stored.StartsWith("BZh", position))
  {
    Bunzipped part = reader.Run(stored.Sub(position), maximumBytes - result.bytes.size());
    result.offsets.Append(part.offsets, result.bytes.size(), position);
    position += part.used;
    result.problem = part.problem;
    result.problemOffset = position;
    if (result.bytes.empty())
    {
      result.bytes = std::move(part.bytes);
    }
    else
    {
      result.bytes.insert(result.bytes.end(), part.bytes.begin(), part.bytes.end());
    }
  }
  if (result.problem.empty() && position < stored.Size())
  {
    result.problem =
      std::to_string(stored.Size() - position) + " bytes after the end of the bzip2 stream";
    result.problemOffset = position;
  }
  return result;
}

Unpacked Unpack(
  StreamFormat format, ByteView stored, std::size_t maximumBytes, DecodingBudget& budget)
{
  switch (format)
  {
  case StreamFormat::Gzip:
    return GzipReader(stored, maximumBytes, budget).Run();
  case StreamFormat::Bzip2:
    return UnpackBzip2(stored, maximumBytes);
  default:
    return Unlzw(stored, maximumBytes);
  }
}

// The same, paid from the budget. A third of it stays for what is made of the bytes.
Unpacked UnpackWithin(StreamFormat format, ByteView stored, DecodingBudget& budget)
{
  Unpacked result;
  if (!budget.Spend(DecodingBudget::CompressedByteCost * stored.Size()))
  {
    result.problem = budget.Explain();
    return result;
  }
  result = Unpack(format, stored, budget.Left() - budget.Left() / 3, budget);
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

std::string TooLarge(std::uint64_t maximumBytes)
{
  return "more than " + std::to_string(maximumBytes) + " bytes when decompressed; the rest is left";
}

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

Bunzipped Bzip2Reader::Run(ByteView stored, std::size_t maximumBytes)
{
  Bunzipped result;
  if (const std::optional<std::size_t> used = fast.Run(stored, maximumBytes))
  {
    result.bytes.assign(fast.Output().begin(), fast.Output().end());
    result.offsets = fast.Offsets();
    result.used = *used;
    return result;
  }
  return this->RunSlowly(stored, maximumBytes);
}

// By libbz2: gets out what can be had of a damaged stream, and says what is wrong with it.
Bunzipped Bzip2Reader::RunSlowly(ByteView stored, std::size_t maximumBytes)
{
  Bunzipped result;
  bz_stream stream{};
  BZ2_bzDecompressInit(&stream, 0, 0);
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
  BZ2_bzDecompressEnd(&stream);
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
      damage.push_back({file.offsets.ToStored(inner.problemOffset), inner.problem});
    }
    inner.offsets.ComposeWith(file.offsets);
    file.offsets = std::move(inner.offsets);
    file.bytes = std::move(inner.bytes);
  }
  return file;
}

} // namespace nexrad
