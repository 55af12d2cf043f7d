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

namespace
{

// Decodes files, a few at a time.
class FileScan
{
public:
  FileScan(const std::vector<std::filesystem::path>& thePaths, const SeriesOptions& theOptions,
    const VolumeVisitor& theVisitor)
    : paths(thePaths)
    , options(theOptions)
    , visitor(theVisitor)
    , files(paths.size())
  {
  }

  // Empty when `progress` asked to stop.
  std::optional<std::vector<ScannedFile>> Run(const Progress& progress)
  {
    // Each decoding holds a whole volume in memory, so their number is bounded; the other cores
    // help to decompress.
    constexpr std::size_t mostAtOnce = 8;
    const unsigned wanted = options.threads > 0 ? options.threads : CoreCount();
    const std::size_t atOnce = std::min<std::size_t>({wanted, mostAtOnce, paths.size()});
    if (options.level2.threads == 0 && atOnce > 0)
    {
      options.level2.threads = std::max(1U, wanted / static_cast<unsigned>(atOnce));
    }
    {
      const ThreadGroup threads(
        atOnce, [this] { this->Work(); }, 1);
      this->Watch(progress);
    }
    if (failure)
    {
      std::rethrow_exception(failure);
    }
    return stopped ? std::nullopt : std::optional(std::move(files));
  }

private:
  void Work()
  {
    for (std::size_t index = next++; index < paths.size() && !stopped; index = next++)
    {
      std::exception_ptr thrown;
      try
      {
        files[index] = ScanFile(paths[index], options, visitor);
      }
      catch (...)
      {
        thrown = std::current_exception();
      }
      const std::lock_guard<std::mutex> lock(mutex);
      ++done;
      failure = failure ? failure : thrown;
      stopped = stopped || thrown;
      changed.notify_all();
    }
  }

  void Watch(const Progress& progress)
  {
    std::unique_lock<std::mutex> lock(mutex);
    for (std::size_t told = 0; told < paths.size() && !stopped; told = done)
    {
      lock.unlock();
      const bool goOn =
        !progress || progress(static_cast<double>(told) / static_cast<double>(paths.size()));
      lock.lock();
      stopped = stopped || !goOn;
      changed.wait(lock, [&] { return stopped || done > told; });
    }
  }

  const std::vector<std::filesystem::path>& paths;
  SeriesOptions options;
  const VolumeVisitor& visitor;
  std::vector<ScannedFile> files; // each written by the thread that scans it
  std::atomic<std::size_t> next{0};
  std::atomic<bool> stopped{false};
  std::mutex mutex; // guards what follows
  std::condition_variable changed;
  std::size_t done = 0;
  std::exception_ptr failure;
};

} // namespace

std::optional<std::vector<ScannedFile>> ScanEach(const std::vector<std::filesystem::path>& paths,
  const SeriesOptions& options, const VolumeVisitor& visitor, const Progress& progress)
{
  return FileScan(paths, options, visitor).Run(progress);
}

std::optional<SeriesScan> ScanInputs(const std::vector<std::filesystem::path>& inputs,
  const SeriesOptions& options, const VolumeVisitor& visitor, const Progress& progress)
{
  const InputFiles found = FindInputFiles(inputs);
  const auto files = ScanEach(found.paths, options, visitor, progress);
  return files ? std::optional(CollectSeries(found.problems, *files)) : std::nullopt;
}

} // namespace nexrad
