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

// `failure` is why nothing was found in this process, of which the others must be told.
std::optional<SeriesScan> ScanFound(const InputFiles& found, const std::exception_ptr& failure,
  const SeriesOptions& options, const VolumeVisitor& visitor, const Progress& progress)
{
  const auto scan = [&](const std::vector<std::filesystem::path>& paths)
  {
    if (failure)
    {
      std::rethrow_exception(failure);
    }
    return FileScan(paths, options, visitor).Run(progress);
  };
  const std::optional<std::vector<ScannedFile>> files =
    options.processes.Count() > 1
      ? ScanTogether(found.paths, options.processes, options.order, scan)
      : scan(found.paths);
  if (!files)
  {
    return std::nullopt;
  }
  return CollectSeries(found.problems, *files);
}

} // namespace

std::optional<SeriesScan> ScanFiles(const InputFiles& found, const SeriesOptions& options,
  const VolumeVisitor& visitor, const Progress& progress)
{
  return ScanFound(found, nullptr, options, visitor, progress);
}

std::optional<SeriesScan> ScanInputs(const std::vector<std::filesystem::path>& inputs,
  const SeriesOptions& options, const VolumeVisitor& visitor, const Progress& progress)
{
  InputFiles found;
  std::exception_ptr failure;
  try
  {
    found = FindInputFiles(inputs);
  }
  catch (const std::exception&)
  {
    failure = std::current_exception();
  }
  return ScanFound(found, failure, options, visitor, progress);
}

} // namespace nexrad
