// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Series/ScanInputs.h"

#include "nexrad/Series/SharedScan.h"
#include "nexrad/System/RangeLoop.h"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <exception>
#include <mutex>

namespace nexrad
{

std::optional<std::vector<ScannedFile>> ScanEach(const std::vector<std::filesystem::path>& paths,
  const SeriesOptions& options, const VolumeVisitor& visitor, const Progress& progress)
{
  // Each decoding holds a whole volume in memory, so their number is bounded; the other cores help
  // to decompress.
  constexpr std::size_t mostAtOnce = 8;
  const unsigned wanted = options.threads > 0 ? options.threads : CoreCount();
  const std::size_t atOnce = std::min<std::size_t>({wanted, mostAtOnce, paths.size()});
  SeriesOptions own = options;
  const unsigned each = atOnce > 0 ? std::max(1U, wanted / static_cast<unsigned>(atOnce)) : 0U;
  own.level2.threads = own.level2.threads > 0 ? own.level2.threads : each;
  std::vector<ScannedFile> files(paths.size()); // each written by the thread that scans it
  std::atomic<std::size_t> next{0};
  std::mutex mutex; // guards what follows
  std::condition_variable changed;
  std::size_t done = 0;
  bool stopped = false;
  std::exception_ptr failure;
  const auto work = [&]
  {
    for (std::size_t index = next++; index < paths.size(); index = next++)
    {
      std::exception_ptr thrown;
      try
      {
        files[index] = ScanFile(paths[index], own, visitor);
      }
      catch (...)
      {
        thrown = std::current_exception();
      }
      const std::lock_guard<std::mutex> lock(mutex);
      ++done;
      failure = failure ? failure : thrown;
      changed.notify_all();
      if (failure || stopped)
      {
        return;
      }
    }
  };
  ThreadGroup threads(atOnce, work, 1);
  std::unique_lock<std::mutex> lock(mutex);
  for (std::size_t told = 0; told < paths.size() && !stopped && !failure; told = done)
  {
    lock.unlock();
    const bool goOn =
      !progress || progress(static_cast<double>(told) / static_cast<double>(paths.size()));
    lock.lock();
    stopped = !goOn;
    changed.wait(lock, [&] { return stopped || failure || done > told; });
  }
  lock.unlock();
  threads.Join();
  if (failure)
  {
    std::rethrow_exception(failure);
  }
  return stopped ? std::nullopt : std::optional(std::move(files));
}

std::optional<SeriesScan> ScanInputs(const std::vector<std::filesystem::path>& inputs,
  const SeriesOptions& options, const VolumeVisitor& visitor, const Progress& progress)
{
  const InputFiles found = FindInputFiles(inputs);
  const auto files = ScanEach(found.paths, options, visitor, progress);
  return files ? std::optional(CollectSeries(found.problems, *files)) : std::nullopt;
}

} // namespace nexrad
