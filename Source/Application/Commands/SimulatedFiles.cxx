// SPDX-License-Identifier: BSD-3-Clause
#include "Commands/SimulatedFiles.h"

#include "Output/OutputFile.h"
#include "nexrad/System/Error.h"
#include "nexrad/System/RangeLoop.h"

#include <algorithm>
#include <atomic>
#include <mutex>

namespace fs = std::filesystem;

namespace nexrad::application
{

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
  const StormField field(options.seed);
  const std::vector<SimulatedVolume> volumes = PlanSimulatedDay(options);
  MakeFolder(folder);
  SimulationReport report;
  std::mutex mutex; // guards the report, `done` and the calls of `progress`
  std::size_t done = 0;
  const auto write = [&](const SimulatedVolume& volume)
  {
    const std::vector<std::uint8_t> bytes = SimulateFile(field, volume, options);
    WriteFile(folder / volume.fileName, bytes.data(), bytes.size());
    const std::lock_guard<std::mutex> lock(mutex);
    report.bytes += bytes.size();
    ++done;
    if (progress && !progress(static_cast<double>(done) / static_cast<double>(volumes.size())) &&
        done < volumes.size())
    {
      throw Error("stopped before all files were written");
    }
  };
  std::atomic<bool> failed = false;
  const auto writeUnlessFailed = [&](int begin, int end)
  {
    for (int i = begin; i < end && !failed; ++i)
    {
      try
      {
        write(volumes[static_cast<std::size_t>(i)]);
      }
      catch (...)
      {
        failed = true;
        throw;
      }
    }
  };
  const int count = static_cast<int>(volumes.size());
  ThreadLoop(std::clamp(static_cast<unsigned>(count), 1U, CoreCount()))(count, writeUnlessFailed);
  report.begin = volumes.empty() ? options.begin : volumes.front().start;
  for (const SimulatedVolume& volume : volumes)
  {
    report.files.push_back(folder / volume.fileName);
    report.end = std::max(report.end, volume.start + VolumePeriod(volume.coveragePattern));
  }
  return report;
}

} // namespace nexrad::application
