// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Compression/ParallelBunzip.h"

#include "nexrad/Compression/DecodingBudget.h"
#include "nexrad/System/ThreadGroup.h"

#include <algorithm>
#include <array>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <optional>

namespace nexrad
{

namespace
{

// So many records decompress ahead of the one to be received: the receiver may stop because the
// file is larger than its cap, and until then no more than these take memory.
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
  ~RecordQueue() { this->Stop(); }
  RecordQueue(const RecordQueue&) = delete;
  RecordQueue& operator=(const RecordQueue&) = delete;

  void Start(std::size_t helpers)
  {
    threads.Start(helpers, [this] { this->Help(); });
  }
  // The content of the next record in order. While it is being made elsewhere, this thread makes
  // others.
  Bunzipped Take()
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
    std::optional<Bunzipped>& place = this->Place(received++);
    Bunzipped content = std::move(*place);
    place.reset();
    changed.notify_all();
    return content;
  }

private:
  // No more than those ahead are in memory, so their places are used in turn.
  std::optional<Bunzipped>& Place(std::size_t index) { return contents[index % recordsAhead]; }
  bool MayBegin() const { return next < std::min(records.size(), received + recordsAhead); }

  // Decompresses the next record without the lock.
  void MakeOne(std::unique_lock<std::mutex>& lock, Bzip2Reader& reader)
  {
    const std::size_t index = next++;
    lock.unlock();
    Bunzipped content =
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
  void Stop()
  {
    {
      const std::lock_guard<std::mutex> lock(mutex);
      stopped = true;
      changed.notify_all();
    }
    threads.Join();
  }

  const std::vector<LdmRecord>& records;
  const std::size_t maximumRecordBytes;
  Bzip2Reader ownReader; // of the thread that receives

  std::mutex mutex; // guards all that follows but the threads
  std::condition_variable changed;
  std::array<std::optional<Bunzipped>, recordsAhead> contents;
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
    if (!receive(index, queue.Take()))
    {
      return;
    }
  }
}

} // namespace nexrad
