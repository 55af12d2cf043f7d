// SPDX-License-Identifier: BSD-3-Clause
#include "Tables/SeriesMeasurement.h"

#include "Tables/BareSeries.h"
#include "Tables/PeakMemory.h"
#include "Volumes/WriteVolumes.h"
#include "nexrad/Codec/NxvFile.h"
#include "nexrad/Codec/ThesisStream.h"
#include "nexrad/System/Error.h"
#include "vtkNexradThreads.h"

#include <algorithm>
#include <memory>
#include <numeric>

namespace fs = std::filesystem;

namespace nexrad::application
{
namespace
{

GridJob MakeJob(
  const BenchRequest& request, const std::array<int, 3>& dimensions, const fs::path& folder)
{
  GridJob job;
  job.inputs = request.files;
  job.folder = folder / FormatDimensions(dimensions);
  job.options = request.options;
  job.options.grid.dimensions = dimensions;
  return job;
}

// Bare decompression of all files on the threads that merging has. Empty when one of them has no
// such time.
std::function<void()> MakeBareWork(const std::vector<fs::path>& files, double& storedBytes)
{
  try
  {
    const auto series = std::make_shared<BareSeries>(files, vtkNexradThreadCount());
    storedBytes = series->StoredBytes();
    return [series] { series->Run(); };
  }
  catch (const Error&)
  {
    return {}; // the table of decoding names the file
  }
}

// What one size came to in all runs.
struct Outcome
{
  GridReport report;
  std::optional<double> peakBytes;

  void Run(const GridJob& job)
  {
    RestartPeakMemory();
    report = WriteVolumes(job);
    const std::optional<double> peak = PeakMemory();
    peakBytes = peak ? std::max(*peak, peakBytes.value_or(0.0)) : peak;
  }
};

// Of a long series some tell enough, each reading and writing again.
double MeanThesisBytes(const GridReport& report)
{
  constexpr std::size_t enough = 48;
  const std::size_t stride = (report.files.size() + enough - 1) / enough;
  std::vector<double> sizes;
  for (std::size_t i = 0; i < report.files.size(); i += stride)
  {
    const GriddedVolume volume = ReadNxv(report.files[i]);
    sizes.push_back(static_cast<double>(EncodeRunLength(ThesisCode::EncodeAll(volume)).size()));
  }
  return std::accumulate(sizes.begin(), sizes.end(), 0.0) / static_cast<double>(sizes.size());
}

SeriesOfSize Describe(const Outcome& outcome, const GridJob& job, const Measurement& seconds)
{
  const GridReport& report = outcome.report;
  SeriesOfSize size;
  size.peakBytes = outcome.peakBytes;
  size.dimensions = job.options.grid.dimensions;
  size.seconds = seconds;
  size.volumes = report.files.size();
  size.bytes = static_cast<double>(report.bytes) / static_cast<double>(report.files.size());
  size.thesisBytes = MeanThesisBytes(report);
  return size;
}

} // namespace

SeriesMeasurement MeasureSeries(const BenchRequest& request, const fs::path& folder)
{
  SeriesMeasurement series;
  series.files = request.files.size();
  std::vector<std::function<void()>> pieces;
  std::vector<Outcome> outcomes(request.dimensions.size());
  for (std::size_t index = 0; index < request.dimensions.size(); ++index)
  {
    const GridJob job = MakeJob(request, request.dimensions[index], folder);
    pieces.push_back([job, &outcome = outcomes[index]] { outcome.Run(job); });
  }
  const std::function<void()> bare = MakeBareWork(request.files, series.storedBytes);
  if (bare)
  {
    pieces.push_back(bare);
  }
  // Each run is many files long: a run before them would warm nothing that lasts.
  const std::vector<Measurement> times = MeasureInTurn(pieces, request.runs, false);
  for (std::size_t index = 0; index < outcomes.size(); ++index)
  {
    const GridJob job = MakeJob(request, request.dimensions[index], folder);
    series.sizes.push_back(Describe(outcomes[index], job, times[index]));
    fs::remove_all(job.folder);
  }
  if (bare)
  {
    series.bare = times.back();
  }
  return series;
}

} // namespace nexrad::application
