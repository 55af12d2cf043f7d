// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/Series/RadarFiles.h"

#include "nexrad/Merging/SeriesMerger.h"
#include "nexrad/System/Error.h"
#include "vtkNexradImageConversion.h"
#include "vtkNexradThreads.h"

#include <vtkImageData.h>

#include <algorithm>
#include <iterator>

namespace nexrad::scene
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

  std::vector<std::string> Problems() const override
  {
    std::vector<std::string> lines;
    for (const InputProblem& problem : merger.Problems())
    {
      lines.push_back(problem.Line());
    }
    return lines;
  }

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

} // namespace nexrad::scene
