// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNexradVolumeSteps.h"

#include "nexrad/Codec/NxvSeries.h"
#include "nexrad/System/Error.h"

#include <algorithm>
#include <tuple>

bool vtkNexradIsIndex(const std::filesystem::path& path)
{
  return path.extension() == ".series";
}

std::vector<vtkNexradVolumeStep> vtkNexradListedSteps(const std::filesystem::path& path)
{
  if (!vtkNexradIsIndex(path))
  {
    return {{0.0, path}};
  }
  std::vector<vtkNexradVolumeStep> steps;
  for (const auto& [name, time] : nexrad::ReadNxvSeries(path))
  {
    steps.push_back({time, path.parent_path() / name});
  }
  if (steps.empty())
  {
    throw nexrad::Error(path.string() + ": the index names no file");
  }
  std::sort(steps.begin(), steps.end(),
    [](const auto& a, const auto& b)
    { return std::tie(a.Time, a.File) < std::tie(b.Time, b.File); });
  return steps;
}
