// SPDX-License-Identifier: BSD-3-Clause
#include "Tables/BareDecompression.h"

#include "nexrad/Compression/Container.h"
#include "nexrad/Compression/LdmRecords.h"
#include "nexrad/Level2/Messages/VolumeHeader.h"
#include "nexrad/System/Error.h"

#include <bzlib.h>
#include <zlib.h>

#include <algorithm>
#include <atomic>
#include <fstream>
#include <functional>
#include <future>
#include <optional>
#include <thread>

namespace nexrad::application
{
namespace
{

constexpr std::size_t largestFile = std::size_t(1) << 30; // decompressed bytes

ByteView View(const std::vector<std::uint8_t>& bytes)
{
  return {bytes.data(), bytes.size()};
}

// The libraries take input that they do not change as non-const.
char* InputOf(const std::uint8_t* bytes)
{
  return reinterpret_cast<char*>(const_cast<std::uint8_t*>(bytes));
}

void Bunzip(const std::uint8_t* from, std::size_t length, std::vector<std::uint8_t>& room)
{
  auto size = static_cast<unsigned>(room.size());
  if (BZ2_bzBuffToBuffDecompress(reinterpret_cast<char*>(room.data()), &size, InputOf(from),
        static_cast<unsigned>(length), 0, 0) != BZ_OK)
  {
    throw Error("a bzip2 stream decompressed to another size than before");
  }
}

std::vector<std::uint8_t> ReadBytes(const std::filesystem::path& path)
{
  std::error_code failure;
  const std::uintmax_t size = std::filesystem::file_size(path, failure);
  std::vector<std::uint8_t> bytes(failure ? 0 : size);
  std::ifstream file(path, std::ios::binary);
  file.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  if (!file || bytes.empty())
  {
    throw Error(path.string() + ": cannot be read, or is empty");
  }
  return bytes;
}

// Works through [0, count) on some threads. Throws what the work threw first.
void ForEach(std::size_t count, unsigned threads, const std::function<void(std::size_t)>& work)
{
  std::atomic<std::size_t> next{0};
  const auto run = [&]
  {
    for (std::size_t index = next++; index < count; index = next++)
    {
      work(index);
    }
  };
  std::vector<std::future<void>> running;
  for (unsigned thread = 0; thread < std::max(1U, threads); ++thread)
  {
    running.push_back(std::async(std::launch::async, run));
  }
  for (std::future<void>& each : running)
  {
    each.wait();
  }
  for (std::future<void>& each : running)
  {
    each.get();
  }
}

} // namespace

BareDecompression::BareDecompression(const std::filesystem::path& file)
  : path(file)
  , stored(ReadBytes(file))
{
  storedBytes = stored.size();
  try
  {
    this->OpenWrapper();
    this->FindRecords();
  }
  catch (const Error& error)
  {
    throw Error(path.string() + ": " + error.what());
  }
}

void BareDecompression::Unload()
{
  unwrappedBytes = unwrapped.size();
  Bytes().swap(stored);
  Bytes().swap(unwrapped);
}

void BareDecompression::Load()
{
  stored = ReadBytes(path);
  unwrapped.resize(unwrappedBytes);
  if (stored.size() != storedBytes)
  {
    throw Error(path.string() + ": the file changed since it was first read");
  }
}

void BareDecompression::OpenWrapper()
{
  const StreamFormat format = DetectStream(View(stored));
  if (format == StreamFormat::None)
  {
    return;
  }
  if (format == StreamFormat::Compress)
  {
    throw Error("is compressed with compress, which no library here decompresses");
  }
  std::vector<Damage> damage;
  DecodingBudget budget(largestFile, largestFile);
  unwrapped = OpenContainer(stored, budget, damage).bytes;
  if (!damage.empty())
  {
    throw Error("offset " + std::to_string(damage.front().offset) + ": " + damage.front().what);
  }
  wrapper = format == StreamFormat::Gzip ? Wrapper::Gzip : Wrapper::Bzip2;
}

void BareDecompression::FindRecords()
{
  const ByteView plain = View(wrapper == Wrapper::None ? stored : unwrapped);
  const std::size_t start = ParseVolumeHeader(plain) ? VolumeHeader::bytes : 0;
  if (!IsLdmRecord(plain, start))
  {
    return;
  }
  const auto refuse = [](std::size_t offset, const std::string& what)
  { throw Error("offset " + std::to_string(offset) + ": " + what); };
  for (const LdmRecord& record : FindLdmRecords(plain, start, refuse))
  {
    const Unpacked content = Bzip2Reader().Run(record.compressed, largestFile);
    if (!content.problem.empty())
    {
      refuse(record.offset, content.problem);
    }
    largestRecord = std::max(largestRecord, content.bytes.size());
    records.push_back({static_cast<std::size_t>(record.compressed.Data() - plain.Data()),
      record.compressed.Size()});
  }
}

void BareDecompression::Run(unsigned threads)
{
  if (wrapper == Wrapper::Gzip)
  {
    this->InflateWrapper();
  }
  else if (wrapper == Wrapper::Bzip2)
  {
    Bunzip(stored.data(), stored.size(), unwrapped);
  }
  this->RunRecords(threads);
}

void BareDecompression::InflateWrapper()
{
  constexpr int gzipHeaderAndLargestWindow = 16 + MAX_WBITS;
  z_stream stream{};
  inflateInit2(&stream, gzipHeaderAndLargestWindow);
  stream.next_in = stored.data();
  stream.avail_in = static_cast<unsigned>(stored.size());
  stream.next_out = unwrapped.data();
  stream.avail_out = static_cast<unsigned>(unwrapped.size());
  // Members may stand end to end; the room is exactly what all of them need.
  while (stream.avail_out > 0 && inflate(&stream, Z_FINISH) == Z_STREAM_END)
  {
    inflateReset(&stream);
  }
  const bool whole = stream.avail_out == 0;
  inflateEnd(&stream);
  if (!whole)
  {
    throw Error("a gzip stream decompressed to another size than before");
  }
}

void BareDecompression::RunRecords(unsigned threads) const
{
  std::atomic<std::size_t> next{0};
  const auto work = [this, &next]
  {
    Bytes room(largestRecord);
    for (std::size_t index = next++; index < records.size(); index = next++)
    {
      const std::uint8_t* plain = wrapper == Wrapper::None ? stored.data() : unwrapped.data();
      Bunzip(plain + records[index].offset, records[index].length, room);
    }
  };
  const std::size_t wanted =
    threads != 0 ? threads : std::max(1U, std::thread::hardware_concurrency());
  std::vector<std::thread> helpers;
  for (std::size_t count = 1; count < std::min(wanted, records.size()); ++count)
  {
    helpers.emplace_back(work);
  }
  work();
  for (std::thread& helper : helpers)
  {
    helper.join();
  }
}

std::string BareDecompression::Describe() const
{
  const std::string wrapped = wrapper == Wrapper::None   ? ""
                              : wrapper == Wrapper::Gzip ? "gzip"
                                                         : "bzip2";
  if (records.empty())
  {
    return wrapped.empty() ? "none" : wrapped;
  }
  return (wrapped.empty() ? "" : wrapped + ", ") + std::to_string(records.size()) +
         (records.size() == 1 ? " record" : " records");
}

BareSeries::BareSeries(const std::vector<std::filesystem::path>& files, unsigned threadCount)
  : threads(threadCount)
{
  std::vector<std::optional<BareDecompression>> opened(files.size());
  ForEach(files.size(), threads,
    [&](std::size_t index)
    {
      opened[index].emplace(files[index]);
      opened[index]->Unload();
    });
  for (std::optional<BareDecompression>& stream : opened)
  {
    streams.push_back(std::move(*stream));
  }
}

void BareSeries::Run()
{
  ForEach(streams.size(), threads,
    [this](std::size_t index)
    {
      streams[index].Load();
      streams[index].Run(1);
      streams[index].Unload();
    });
}

double BareSeries::StoredBytes() const
{
  double bytes = 0.0;
  for (const BareDecompression& stream : streams)
  {
    bytes += static_cast<double>(stream.StoredBytes());
  }
  return bytes;
}

} // namespace nexrad::application
