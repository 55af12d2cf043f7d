// SPDX-License-Identifier: BSD-3-Clause
#include "Sheets/Sheet.h"

#include "Scene/Series/RadarFiles.h"
#include "nexrad/Series/ScanInputs.h"
#include "nexrad/Series/VolumeSelection.h"
#include "nexrad/System/Error.h"
#include "nexrad/System/Progress.h"

#include <vtkImageData.h>

#include <algorithm>

namespace nexrad::scene
{
namespace
{

// Throws Error for a time when no radar was seen.
void CheckTime(const SheetSource& source)
{
  const Duration gap = source.request.grid.maximumGap;
  const Time first = *source.scan.First();
  const Time last = *source.scan.Last();
  if (source.time < first - gap || source.time > last + gap)
  {
    throw Error("no ray about " + FormatIso8601(source.time) + "; the files reach from " +
                FormatIso8601(first) + " to " + FormatIso8601(last));
  }
}

std::unique_ptr<VolumeSeries> Merge(
  const SheetSource& source, const std::array<int, 3>& dimensions, MergeOptions options)
{
  options.grid.dimensions = dimensions;
  return OpenRadarFiles(source.request.files, options);
}

} // namespace

SheetSource MakeSheetSource(const SheetRequest& request)
{
  SeriesOptions options;
  options.moment = request.grid.moment;
  options.requirePosition = true;
  SheetSource source{request, ScanInputs(request.files, options).value_or(SeriesScan())};
  const SeriesScan& scan = source.scan;
  if (scan.sites.empty())
  {
    throw Error("no file holds a ray of " + std::string(ToString(request.grid.moment)));
  }
  source.synthetic = std::any_of(scan.sites.begin(), scan.sites.end(),
    [](const SiteSeries& site) { return site.volumes.front().synthetic; });
  const Duration step = request.grid.step.value_or(DefaultStep);
  const std::vector<Time> steps = TimeSteps(*scan.First(), *scan.Last(), step);
  const Time middle = *scan.First() + (*scan.Last() - *scan.First()) / 2;
  source.time = request.time.value_or(steps.empty() ? middle : steps[steps.size() / 2]);
  CheckTime(source);
  return source;
}

std::unique_ptr<VolumeSeries> SheetSource::MergeAtTime(const std::array<int, 3>& dimensions) const
{
  MergeOptions options = request.grid;
  options.begin = options.end = time;
  options.step = Duration(1); // every millisecond is a step, so that the time itself is one
  return Merge(*this, dimensions, options);
}

std::unique_ptr<VolumeSeries> SheetSource::MergeAllSteps(const std::array<int, 3>& dimensions) const
{
  return Merge(*this, dimensions, request.grid);
}

const std::array<int, 3>& SheetSource::MiddleSize() const
{
  return request.dimensions[request.dimensions.size() / 2];
}

std::string SheetSource::Title(const std::string& what) const
{
  return what + (synthetic ? ", SYNTHETIC" : "");
}

} // namespace nexrad::scene
