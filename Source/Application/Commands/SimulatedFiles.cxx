// SPDX-License-Identifier: BSD-3-Clause
#include "Commands/SimulatedFiles.h"

#include "nexrad/System/Error.h"
#include "nexrad/System/RangeLoop.h"

#include "Output/OutputFile.h"

#include <algorithm>
#include <exception>
#include <mutex>

namespace fs = std::filesystem;

namespace nexrad::application
{
namespace
{

// Hands the volumes of a day to threads, one after another.
class FileFactory
{
public:
  FileFactory(const SimulatedDayOptions& dayOptions, const fs::path& target,
    const Progress& listener, SimulationReport& result)
    : options(dayOptions)
    , folder(target)
    , progress(listener)
    , report(result)
    , field(dayOptions.seed)
    , volumes(PlanSimulatedDay(dayOptions))
  {
  }

  void Run();

private:
  const SimulatedDayOptions& options;
  const fs::path& folder;
  const Progress& progress;
  SimulationReport& report;
  StormField field;
  std::vector<SimulatedVolume> volumes;

  std::mutex mutex; // guards all that follows, `report` and the calls of `progress`
  std::size_t next = 0;
  std::size_t done = 0;
  std::exception_ptr failure;

  void Work();
  const SimulatedVolume* Take();
  void Finish(std::uint64_t bytes);
};

void FileFactory::Run()
{
  {
    const std::size_t wanted =
      std::min<std::size_t>(CoreCount(), std::max<std::size_t>(1, volumes.size()));
    const ThreadGroup helpers(wanted - 1, [this] { this->Work(); });
    this->Work();
  }
  if (failure)
  {
    std::rethrow_exception(failure);
  }
  for (std::size_t index = 0; index < done; ++index)
  {
    const SimulatedVolume& volume = volumes[index];
    report.files.push_back(folder / volume.fileName);
    report.end = std::max(report.end, volume.start + VolumePeriod(volume.coveragePattern));
  }
  report.begin = volumes.empty() ? options.begin : volumes.front().start;
}

void FileFactory::Work()
{
  try
  {
    while (const SimulatedVolume* volume = this->Take())
    {
      const std::vector<std::uint8_t> bytes = SimulateFile(field, *volume, options);
      WriteFile(folder / volume->fileName, bytes.data(), bytes.size());
      this->Finish(bytes.size());
    }
  }
  catch (...)
  {
    const std::lock_guard<std::mutex> lock(mutex);
    failure = failure ? failure : std::current_exception();
    next = volumes.size();
  }
}

const SimulatedVolume* FileFactory::Take()
{
  const std::lock_guard<std::mutex> lock(mutex);
  return next < volumes.size() ? &volumes[next++] : nullptr;
}

void FileFactory::Finish(std::uint64_t bytes)
{
  const std::lock_guard<std::mutex> lock(mutex);
  report.bytes += bytes;
  ++done;
  if (progress && !progress(static_cast<double>(done) / static_cast<double>(volumes.size())) &&
      done < volumes.size())
  {
    throw Error("stopped before all files were written");
  }
}

} // namespace

SimulatedDayOptions DemoDay(Duration length)
{
  SimulatedDayOptions day;
  day.begin = *ParseIso8601("2006-03-12T18:00");
  day.length = length;
  return day;
}

SimulationReport WriteSimulatedFiles(
  const SimulatedDayOptions& options, const fs::path& folder, const Progress& progress)
{
  SimulationReport report;
  FileFactory factory(options, folder, progress, report);
  MakeFolder(folder);
  factory.Run();
  return report;
}

} // namespace nexrad::application
