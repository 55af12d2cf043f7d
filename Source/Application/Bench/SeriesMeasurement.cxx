// SPDX-License-Identifier: BSD-3-Clause
#include "Bench/SeriesMeasurement.h"

#include "Bench/BareDecompression.h"
#include "Codec/NxvFile.h"
#include "Model/Error.h"
#include "Volumes/WriteVolumes.h"

#include <memory>

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

// Bare decompression of all files, one after another. Empty when one of them has no such time.
std::function<void()> MakeBareWork(const std::vector<fs::path>& files, double& storedBytes)
{
  auto streams = std::make_shared<std::vector<BareDecompression>>();
  try
  {
    for (const fs::path& file : files)
    {
      streams->emplace_back(file);
    }
  }
  catch (const Error&)
  {
    return {}; // the table of decoding names the file
  }
  for (const BareDecompression& stream : *streams)
  {
    storedBytes += static_cast<double>(stream.StoredBytes());
  }
  return [streams]
  {
    for (BareDecompression& stream : *streams)
    {
      stream.Run();
    }
  };
}

double MeanThesisBytes(const GridReport& report, const fs::path& folder)
{
  const fs::path raw = folder / "thesis.raw";
  NxvWriteOptions options;
  options.thesisRuns = true;
  double sum = 0.0;
  for (const fs::path& file : report.files)
  {
    WriteRaw(raw, ReadNxv(file), options);
    sum += static_cast<double>(fs::file_size(raw));
  }
  fs::remove(raw);
  return sum / static_cast<double>(report.files.size());
}

SeriesOfSize Describe(const GridReport& report, const GridJob& job, const Measurement& seconds)
{
  SeriesOfSize size;
  size.dimensions = job.options.grid.dimensions;
  size.seconds = seconds;
  size.volumes = report.files.size();
  size.bytes = static_cast<double>(report.bytes) / static_cast<double>(report.files.size());
  size.thesisBytes = MeanThesisBytes(report, job.folder);
  return size;
}

} // namespace

SeriesMeasurement MeasureSeries(const BenchRequest& request, const fs::path& folder)
{
  SeriesMeasurement series;
  series.files = request.files.size();
  std::vector<std::function<void()>> pieces;
  std::vector<GridReport> reports(request.dimensions.size());
  for (std::size_t index = 0; index < request.dimensions.size(); ++index)
  {
    const GridJob job = MakeJob(request, request.dimensions[index], folder);
    pieces.push_back([job, &report = reports[index]] { report = WriteVolumes(job); });
  }
  const std::function<void()> bare = MakeBareWork(request.files, series.storedBytes);
  if (bare)
  {
    pieces.push_back(bare);
  }
  // Each run is many files long: a run before them would warm nothing that lasts.
  const std::vector<Measurement> times = MeasureInTurn(pieces, request.runs, false);
  for (std::size_t index = 0; index < reports.size(); ++index)
  {
    const GridJob job = MakeJob(request, request.dimensions[index], folder);
    series.sizes.push_back(Describe(reports[index], job, times[index]));
    fs::remove_all(job.folder);
  }
  if (bare)
  {
    series.bare = times.back();
  }
  return series;
}

} // namespace nexrad::application
