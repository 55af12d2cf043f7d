// SPDX-License-Identifier: BSD-3-Clause
#include "Drawing/VolumeOutputs.h"

#include "Drawing/MovieWriter.h"
#include "Scene/Series/InputSeries.h"
#include "Scene/Series/VolumeSeries.h"
#include "Scene/VolumeAppearance.h"
#include "nexrad/Merging/SeriesMerger.h"
#include "nexrad/System/Error.h"

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace nexrad::scene
{

namespace
{

// Whether the user leaves the times to the program.
bool HasFreeTime(const InputRequest& input)
{
  return !input.time && !input.grid.begin && !input.grid.end && !input.grid.step;
}

} // namespace

std::unique_ptr<VolumeSeries> OpenForPictures(RenderRequest& request, RenderReport& report)
{
  constexpr Duration longestLook = std::chrono::hours(1);
  auto series = OpenInputs(request.input, request.progress);
  const std::optional<TimeSpan> look = series->OneLook();
  if (!look || series->Times().size() < 2 || !HasFreeTime(request.input) ||
      look->last - look->first > longestLook)
  {
    return series;
  }
  series.reset(); // its memory is needed once
  request.input.time = MiddleTime(look->first, look->last);
  MergeOptions& merging = request.input.grid;
  const Duration half = look->last - *request.input.time;
  if (!request.maxGapGiven)
  {
    merging.maximumGap = std::max(merging.maximumGap, half + std::chrono::seconds(1));
  }
  report.notes.push_back(request.output.string() + ": one picture of all radars, at " +
                         FormatIso8601(*request.input.time) + "; their rays are up to " +
                         std::to_string(std::chrono::ceil<std::chrono::minutes>(half).count()) +
                         " min older or newer; --time or --step chooses other times");
  return OpenInputs(request.input, request.progress);
}

void SayThatThereAreSeveral(const RenderRequest& request, RenderReport& report)
{
  if (report.outputs.size() > 1)
  {
    report.notes.push_back(request.output.string() + ": " + std::to_string(report.outputs.size()) +
                           " times make as many pictures, each with its time in its name; --time "
                           "draws one, and a name in .ogv or .mp4 makes a movie");
  }
}

RenderReport WriteEachVolume(const RenderRequest& asked,
  const std::function<void(const std::filesystem::path&, vtkImageData*)>& write)
{
  RenderRequest request = asked;
  RenderReport report;
  report.notes = LinesPassedOver(request.scene);
  auto series = OpenForPictures(request, report);
  const std::vector<std::size_t> chosen = ChooseTimes(*series, request.input);
  const Progress writing = ShareOf(request.progress, ScanShare, 1.0);
  for (std::size_t i = 0; i < chosen.size(); ++i)
  {
    const Progress part = ShareOf(writing, i, chosen.size());
    const vtkSmartPointer<vtkImageData> volume = series->Load(chosen[i], part);
    if (!volume || (part && !part(1.0)))
    {
      throw Error("stopped before all files were written");
    }
    const Time time = series->Times()[chosen[i]];
    report.outputs.push_back(PictureName(request.output, time, chosen.size() > 1));
    write(report.outputs.back(), volume);
  }
  SayThatThereAreSeveral(request, report);
  report.problems = series->Problems();
  return report;
}

} // namespace nexrad::scene
