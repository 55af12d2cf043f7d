// SPDX-License-Identifier: BSD-3-Clause
#include "InputSeries.h"

#include "ProgressShare.h"
#include "nexrad/System/Error.h"

#include <algorithm>

namespace nexrad::scene
{

using application::VolumeSeries;

std::unique_ptr<VolumeSeries> OpenInputs(const InputRequest& request, const Progress& progress)
{
  const auto holdsVolumes = [](const std::filesystem::path& path)
  { return application::HoldsVolumes(path); };
  const auto count = std::count_if(request.inputs.begin(), request.inputs.end(), holdsVolumes);
  if (count == 0)
  {
    MergeOptions grid = request.grid;
    grid.time = request.time;
    return application::OpenRadarFiles(
      request.inputs, grid, application::ShareOf(progress, 0.0, application::scanShare));
  }
  if (count != static_cast<std::ptrdiff_t>(request.inputs.size()))
  {
    throw Error("the inputs are volumes and radar files; draw one or the other");
  }
  return application::OpenVolumeFiles(request.inputs);
}

std::vector<std::size_t> ChooseTimes(const VolumeSeries& series, const InputRequest& request)
{
  const std::vector<Time>& times = series.Times();
  std::vector<std::size_t> chosen;
  for (std::size_t i = 0; i < times.size(); ++i)
  {
    const bool wanted = request.time ? times[i] == *request.time
                                     : (!request.grid.begin || times[i] >= *request.grid.begin) &&
                                         (!request.grid.end || times[i] <= *request.grid.end);
    if (wanted)
    {
      chosen.push_back(i);
    }
  }
  if (chosen.empty())
  {
    throw Error("no volume at the time asked for; there are " + std::to_string(times.size()) +
                " from " + FormatIso8601(times.front()) + " to " + FormatIso8601(times.back()));
  }
  return chosen;
}

} // namespace nexrad::scene
