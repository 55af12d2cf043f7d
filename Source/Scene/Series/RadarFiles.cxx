// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/Series/RadarFiles.h"

#include "nexrad/Merging/ScannedSteps.h"
#include "nexrad/System/Error.h"
#include "vtkNexradImageConversion.h"
#include "vtkNexradSmpLoop.h"

#include <vtkImageData.h>

#include <algorithm>
#include <iterator>

namespace nexrad::scene
{
namespace
{

class RadarFiles : public VolumeSeries
{
public:
  RadarFiles(const std::vector<std::filesystem::path>& inputs, const MergeOptions& options,
    const Progress& progress)
    : steps(inputs, options, vtkNexradSmpLoop(), {}, progress)
  {
    steps.Plan();
  }

  const std::vector<Time>& Times() const override { return steps.Times(); }
  bool CanLoadAhead() const override { return true; }

  vtkSmartPointer<vtkImageData> Load(std::size_t index, const Progress& progress) override
  {
    const std::optional<GriddedVolume> volume = steps.Merge(steps.Times()[index], progress);
    if (!volume)
    {
      return nullptr;
    }
    auto image = vtkSmartPointer<vtkImageData>::New();
    vtkNexradVolumeToImage(*volume, image);
    return image;
  }

  std::vector<std::string> Problems() const override
  {
    std::vector<std::string> lines;
    std::transform(steps.Problems().begin(), steps.Problems().end(), std::back_inserter(lines),
      [](const InputProblem& problem) { return problem.Line(); });
    return lines;
  }

private:
  ScannedSteps steps;
};

} // namespace

std::unique_ptr<VolumeSeries> OpenRadarFiles(const std::vector<std::filesystem::path>& inputs,
  const MergeOptions& options, const Progress& progress)
{
  return std::make_unique<RadarFiles>(inputs, options, progress);
}

} // namespace nexrad::scene
