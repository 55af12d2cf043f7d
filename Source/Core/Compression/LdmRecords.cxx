// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Compression/LdmRecords.h"

#include "nexrad/Compression/DecodingBudget.h"
#include "nexrad/System/RangeLoop.h"

#include <algorithm>
#include <array>
#include <condition_variable>
#include <cstdlib>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>

namespace nexrad
{

namespace
{

constexpr std::size_t lengthBytes = 4;
// "BZh", the block size as a digit, and the six bytes that begin a block.
constexpr std::size_t signatureBytes = 10;
constexpr std::string_view blockMagic = "1AY&SY";

// The bytes without the zeros at their end.
std::size_t SizeWithoutPadding(ByteView bytes)
{
  std::size_t size = bytes.Size();
  while (size > 0 && bytes.Data()[size - 1] == 0)
  {
    --size;
  }
  return size;
}

// Bytes of the stream of the record at `position`. `used`: bytes before the padding at the end.
std::size_t LengthAt(
  ByteView bytes, std::size_t position, std::size_t used, const DamageReceiver& report)
{
  const auto stated = static_cast<std::size_t>(std::abs(std::int64_t(bytes.I32(position))));
  const std::size_t stream = position + lengthBytes;
  // A record follows, or nothing, or padding.
  const bool isRight = stated > 0 && bytes.Has(stream, stated) &&
                       (IsLdmRecord(bytes, stream + stated) || stream + stated >= used);
  if (isRight)
  {
    return stated;
  }
  // The stream knows its own end; all bytes up to the next record may belong to it.
  const std::size_t length = FindLdmRecord(bytes, stream) - stream;
  report(position, "the record says that it is " + std::to_string(stated) + " bytes long, but " +
                     std::to_string(length) + " bytes are there");
  return length;
}

} // namespace

bool IsLdmRecord(ByteView bytes, std::size_t offset)
{
  const std::size_t stream = offset + lengthBytes;
  return bytes.Has(offset, lengthBytes + signatureBytes) && bytes.StartsWith("BZh", stream) &&
         bytes.U8(stream + 3) >= '1' && bytes.U8(stream + 3) <= '9' &&
         bytes.StartsWith(blockMagic.data(), stream + 4);
}

std::size_t FindLdmRecord(ByteView bytes, std::size_t from)
{
  // A whole file may be searched in vain, so the search leaps.
  constexpr std::size_t magicPlace = lengthBytes + 4;
  static const std::boyer_moore_horspool_searcher searcher(blockMagic.begin(), blockMagic.end());
  const std::uint8_t* const end = bytes.Data() + bytes.Size();
  const ByteView rest = bytes.Sub(from).Sub(magicPlace);
  for (const std::uint8_t* place = rest.Data();; ++place)
  {
    place = std::search(place, end, searcher);
    if (place == end)
    {
      return bytes.Size();
    }
    const auto offset = static_cast<std::size_t>(place - bytes.Data()) - magicPlace;
    if (IsLdmRecord(bytes, offset))
    {
      return offset;
    }
  }
}

std::vector<LdmRecord> FindLdmRecords(
  ByteView bytes, std::size_t start, const DamageReceiver& report)
{
  // Each step costs no more than the bytes that it passes.
  const std::size_t used = SizeWithoutPadding(bytes);
  std::vector<LdmRecord> records;
  for (std::size_t position = start; position < used;)
  {
    if (!IsLdmRecord(bytes, position))
    {
      const std::size_t next = FindLdmRecord(bytes, position + 1);
      report(position, std::to_string(next - position) + " bytes that are no compressed record");
      position = next;
      continue;
    }
    if (records.size() == MostLdmRecords)
    {
      report(position,
        "more than " + std::to_string(MostLdmRecords) + " compressed records; the rest is left");
      break;
    }
    const std::size_t length = LengthAt(bytes, position, used, report);
    records.push_back({position, bytes.Sub(position + lengthBytes, length)});
    position += lengthBytes + length;
  }
  return records;
}

namespace
{

// So many records decompress ahead of the one to be received: the receiver may end the work because
// the file is larger than its cap, and until then no more than these take memory.
constexpr std::size_t recordsAhead = 16;
// So much may come out of any record, and of a longer one as much as its stored bytes pay for:
// those ahead take no more than a file may. Radars send records of 0.3 to 1.5 MB.
constexpr std::size_t freeRecordBytes = std::size_t(4) << 20;

std::size_t MostBytesOf(const LdmRecord& record, std::size_t maximumBytes)
{
  DecodingBudget budget(maximumBytes, freeRecordBytes);
  budget.AddStored(record.compressed.Size());
  return budget.Left();
}

class RecordQueue
{
public:
  RecordQueue(const std::vector<LdmRecord>& all, std::size_t maximumBytes)
    : records(all)
    , maximumRecordBytes(maximumBytes)
  {
  }
  ~RecordQueue()
  {
    {
      const std::lock_guard<std::mutex> lock(mutex);
      stopped = true;
      changed.notify_all();
    }
    threads.Join();
  }
  RecordQueue(const RecordQueue&) = delete;
  RecordQueue& operator=(const RecordQueue&) = delete;

  void Start(std::size_t helpers)
  {
    threads.Start(helpers, [this] { this->Help(); });
  }
  // The content of the next record in order. While it is being made elsewhere, this thread makes
  // others.
  Unpacked Take()
  {
    std::unique_lock<std::mutex> lock(mutex);
    while (!this->Place(received) && !failure)
    {
      if (this->MayBegin())
      {
        this->MakeOne(lock, ownReader);
      }
      else
      {
        changed.wait(lock);
      }
    }
    if (failure)
    {
      std::rethrow_exception(failure);
    }
    std::optional<Unpacked>& place = this->Place(received++);
    Unpacked content = std::move(*place);
    place.reset();
    changed.notify_all();
    return content;
  }

private:
  // No more than those ahead are in memory, so their places are used in turn.
  std::optional<Unpacked>& Place(std::size_t index) { return contents[index % recordsAhead]; }
  bool MayBegin() const { return next < std::min(records.size(), received + recordsAhead); }

  // Decompresses the next record without the lock.
  void MakeOne(std::unique_lock<std::mutex>& lock, Bzip2Reader& reader)
  {
    const std::size_t index = next++;
    lock.unlock();
    Unpacked content =
      reader.Run(records[index].compressed, MostBytesOf(records[index], maximumRecordBytes));
    lock.lock();
    this->Place(index) = std::move(content);
    changed.notify_all();
  }
  void Help()
  {
    std::unique_lock<std::mutex> lock(mutex);
    try
    {
      Bzip2Reader reader;
      while (!stopped && next < records.size())
      {
        if (this->MayBegin())
        {
          this->MakeOne(lock, reader);
        }
        else
        {
          changed.wait(lock);
        }
      }
    }
    catch (...)
    {
      if (!lock.owns_lock())
      {
        lock.lock();
      }
      failure = std::current_exception();
      changed.notify_all();
    }
  }

  const std::vector<LdmRecord>& records;
  const std::size_t maximumRecordBytes;
  Bzip2Reader ownReader; // of the thread that receives

  std::mutex mutex; // guards all that follows but the threads
  std::condition_variable changed;
  std::array<std::optional<Unpacked>, recordsAhead> contents;
  std::size_t next = 0;     // to be decompressed
  std::size_t received = 0; // all before have been handed over
  bool stopped = false;
  std::exception_ptr failure;
  ThreadGroup threads;
};

} // namespace

void BunzipInParallel(const std::vector<LdmRecord>& records, std::size_t maximumRecordBytes,
  const RecordReceiver& receive, unsigned threads)
{
  RecordQueue queue(records, maximumRecordBytes);
  const std::size_t wanted = threads != 0 ? threads : CoreCount();
  queue.Start(std::min({wanted, records.size(), recordsAhead}) - (records.empty() ? 0 : 1));
  for (std::size_t index = 0; index < records.size(); ++index)
  {
    receive(index, queue.Take());
  }
}

} // namespace nexrad
