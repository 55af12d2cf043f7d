// SPDX-License-Identifier: BSD-3-Clause
#include "Filters/Series/InputSeries.h"

#include "Filters/Series/VolumeFiles.h"
#include "nexrad/Merging/SeriesMerger.h"
#include "nexrad/System/Error.h"
#include "nexrad/System/Progress.h"
#include "vtkNexradImageConversion.h"
#include "vtkNexradThreads.h"

#include <vtkImageData.h>

#include <algorithm>

namespace nexrad
{
namespace
{

// Of each voxel that is shown: the image, and the texels of the mapper.
constexpr std::size_t bytesOfScene = 12;

MergerSetup SetupForAnyOrder()
{
  MergerSetup setup;
  setup.loop = vtkNexradRangeLoop();
  setup.threads = vtkNexradThreadCount();
  setup.anyOrder = true;
  setup.use = {0, bytesOfScene};
  return setup;
}

vtkSmartPointer<vtkImageData> ImageOf(const std::optional<GriddedVolume>& volume)
{
  if (!volume)
  {
    return nullptr;
  }
  auto image = vtkSmartPointer<vtkImageData>::New();
  vtkNexradVolumeToImage(*volume, image);
  return image;
}

class RadarFiles : public VolumeSeries
{
public:
  RadarFiles(const std::vector<std::filesystem::path>& inputs, const MergeOptions& options,
    const Progress& progress)
    : beam(options.method == MergeMethod::Beam)
    , merger(inputs, options, SetupForAnyOrder())
  {
    if (!merger.Open(progress))
    {
      throw Error("stopped before the inputs were read");
    }
  }

  const std::vector<Time>& Times() const override { return merger.Times(); }
  std::vector<MomentName> Moments() const override { return merger.Moments(); }
  bool MakesAncillaryArrays() const override { return beam; }

  vtkSmartPointer<vtkImageData> Load(std::size_t index, const Progress& progress) override
  {
    return ImageOf(merger.Merge(merger.Times()[index], progress));
  }

  vtkSmartPointer<vtkImageData> LoadCoarse(std::size_t index) override
  {
    return beam ? this->LoadBox(index, CoarseDomain(merger.Grid()), {}) : this->Load(index, {});
  }

  vtkSmartPointer<vtkImageData> LoadBox(
    std::size_t index, const BoxRequest& box, const Progress& progress) override
  {
    return ImageOf(merger.MergeBox(merger.Times()[index], box, progress));
  }

  std::optional<TimeSpan> OneLook() const override
  {
    const bool oneEach =
      merger.Sites().size() > 1 && merger.Files().size() == merger.Sites().size();
    return oneEach ? std::optional(merger.Rays()) : std::nullopt;
  }

  std::vector<std::string> Problems() const override { return ProblemLines(merger.Problems()); }

private:
  const bool beam; // the method, which alone makes ancillary arrays
  SeriesMerger merger;
};

} // namespace

std::unique_ptr<VolumeSeries> OpenRadarFiles(const std::vector<std::filesystem::path>& inputs,
  const MergeOptions& options, const Progress& progress)
{
  return std::make_unique<RadarFiles>(inputs, options, progress);
}

std::unique_ptr<VolumeSeries> OpenInputs(const InputRequest& request, const Progress& progress)
{
  // An ancillary array, as REF_age, is made beside its moment.
  const std::size_t end = request.colourBy.find('_');
  const std::optional<MomentName> colours = ParseMomentName(request.colourBy.substr(0, end));
  const std::vector<MomentName>& moments = request.grid.moments;
  if (AreVolumes(request.inputs))
  {
    return OpenVolumeFiles(request.inputs,
      {request.momentNamed ? moments : std::vector<MomentName>(), colours, false, request.boxUnit,
        request.allVoxels, request.fewVoxels, request.textureMemory});
  }
  if (request.box)
  {
    CheckPlaceUnit(request.boxUnit, PlaceUnitOf(request.grid.grid.axes), "the box is");
  }
  MergeOptions grid = request.grid;
  grid.time = request.time;
  if (colours && std::find(moments.begin(), moments.end(), *colours) == moments.end())
  {
    grid.moments.push_back(*colours);
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

} // namespace nexrad
