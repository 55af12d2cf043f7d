// SPDX-License-Identifier: BSD-3-Clause
#include "Sheets/TimesSheet.h"

#include "Sheets/PictureSheet.h"
#include "Sheets/ScenePictures.h"

#include "Tables/BenchRequest.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>

#include <algorithm>
#include <chrono>

namespace nexrad::scene
{
namespace
{

using application::NameColumn;
using std::chrono::hours;
using std::chrono::minutes;

constexpr std::size_t pictureCount = 4;
constexpr minutes timesOfDay[pictureCount] = {
  minutes(10), hours(6) + minutes(10), hours(18) + minutes(10), hours(23) + minutes(10)};
constexpr double cores = 40.0; // dBZ and more: cores of storms

// 20° from the vertical, north up.
CameraView ThesisView()
{
  CameraView view;
  view.azimuth = 180.0;
  view.tilt = 70.0;
  return view;
}

std::size_t Nearest(const std::vector<Time>& times, Time wanted)
{
  const auto distance = [wanted](Time time) { return std::chrono::abs(time - wanted); };
  return static_cast<std::size_t>(std::min_element(times.begin(), times.end(),
                                    [&](Time a, Time b) { return distance(a) < distance(b); }) -
                                  times.begin());
}

// "18:10 UTC"
std::string ClockTime(Time time)
{
  return FormatIso8601(time).substr(11, 5) + " UTC";
}

// Share of the voxels with that reflectivity or more, in per cent.
double PercentAbove(vtkImageData* volume, double dBZ)
{
  vtkDataArray* values = volume->GetPointData()->GetScalars();
  vtkIdType count = 0;
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    count += values->GetComponent(i, 0) >= dBZ ? 1 : 0;
  }
  return 100.0 * static_cast<double>(count) / static_cast<double>(values->GetNumberOfTuples());
}

double Largest(vtkImageData* volume)
{
  double range[2];
  volume->GetPointData()->GetScalars()->GetFiniteRange(range);
  return range[1];
}

} // namespace

std::vector<std::size_t> ChooseTimesOfDay(const std::vector<Time>& times, Duration step)
{
  const Time middle = times.front() + (times.back() - times.front()) / 2;
  const Time day = std::chrono::floor<std::chrono::duration<int, std::ratio<86400>>>(middle);
  std::vector<std::size_t> chosen;
  for (const minutes timeOfDay : timesOfDay)
  {
    const Time wanted = day + timeOfDay;
    if (wanted >= times.front() - step && wanted <= times.back() + step)
    {
      chosen.push_back(Nearest(times, wanted));
    }
  }
  if (chosen.size() < pictureCount)
  {
    chosen.clear();
    const std::size_t count = std::min(pictureCount, times.size());
    for (std::size_t i = 0; i < count; ++i)
    {
      chosen.push_back(count == 1 ? 0 : i * (times.size() - 1) / (count - 1));
    }
  }
  return chosen;
}

Sheet DrawTimesSheet(const SheetSource& source)
{
  const auto series = source.MergeAllSteps(source.MiddleSize());
  ScenePictures pictures(ThesisView(), source.request.size);
  Sheet sheet;
  sheet.table = {"times",
    source.Title("Seen 20 degrees from the vertical, " +
                 application::FormatDimensions(source.MiddleSize()) +
                 " voxels (as figure 4.1 of the thesis)"),
    {NameColumn("time", "time"), {"largest_dbz", "largest, dBZ", 1},
      {"echo_percent", "voxels of 5 dBZ or more, %", 2},
      {"cores_percent", "of 40 dBZ or more, %", 3}},
    {}};
  std::vector<SheetPanel> panels;
  const Duration step = source.request.grid.step.value_or(DefaultStep);
  const std::vector<std::size_t> chosen = ChooseTimesOfDay(series->Times(), step);
  pictures.HoldEchoOf(*series, chosen);
  for (const std::size_t index : chosen)
  {
    const Time time = series->Times()[index];
    const vtkSmartPointer<vtkImageData> volume = series->Load(index, {});
    pictures.Scene().SetVolume(volume);
    panels.push_back({pictures.Draw(), ClockTime(time)});
    sheet.table.rows.push_back({FormatIso8601(time), Largest(volume), PercentAbove(volume, 5.0),
      PercentAbove(volume, cores)});
  }
  sheet.picture = MakeSheet(sheet.table.title, panels, 2);
  return sheet;
}

} // namespace nexrad::scene
