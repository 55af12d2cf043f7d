// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/Series/InputSeries.h"

#include "Scene/Series/RadarFiles.h"
#include "Scene/Series/VolumeFiles.h"
#include "nexrad/Merging/SeriesMerger.h"
#include "nexrad/System/Error.h"
#include "nexrad/System/Progress.h"

#include <algorithm>

namespace nexrad::scene
{

std::unique_ptr<VolumeSeries> OpenInputs(const InputRequest& request, const Progress& progress)
{
  // An ancillary array, as REF_age, is made beside its moment.
  const std::size_t end = request.colourBy.find('_');
  const std::optional<MomentName> colours = ParseMomentName(request.colourBy.substr(0, end));
  const std::vector<MomentName> moments = request.grid.Moments();
  if (AreVolumes(request.inputs))
  {
    return OpenVolumeFiles(
      request.inputs, {request.momentNamed ? moments : std::vector<MomentName>(), colours, false});
  }
  if (request.box)
  {
    CheckPlaceUnit(request.boxUnit, PlaceUnitOf(request.grid.grid.axes), "the box is");
  }
  MergeOptions grid = request.grid;
  grid.time = request.time;
  if (colours && std::find(moments.begin(), moments.end(), *colours) == moments.end())
  {
    grid.furtherMoments.push_back(*colours);
  }
  grid.beam.ancillary = grid.beam.ancillary || end != std::string::npos;
  return OpenRadarFiles(request.inputs, grid, ShareOf(progress, 0.0, ScanShare));
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
