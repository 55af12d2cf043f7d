// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/Pointing/EchoSearch.h"

#include "vtkNexradTransferFunction.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace nexrad::scene
{
namespace
{

constexpr double samplesPerVoxel = 2.0;
constexpr double opaque = 0.99; // what lies behind is not seen

// What the transfer function makes of a stretch of the ray.
class Opacity
{
public:
  Opacity(vtkNexradTransferFunction* theFunction, double unitDistance)
    : function(theFunction)
    , distance(unitDistance)
  {
    for (int i = 0; i < function->GetNumberOfIsoValues(); ++i)
    {
      isoValues.push_back(function->GetIsoValue(i));
    }
  }

  // Of a stretch from one value to another, `length` scene units long.
  double Between(double from, double to, double length) const
  {
    return isoValues.empty() ? this->OfVolume(0.5 * (from + to), length)
                             : this->OfSurfaces(std::min(from, to), std::max(from, to));
  }

private:
  double Of(double value) const
  {
    return function->Evaluate(vtkNexradTransferFunction::OPACITY, value);
  }

  double OfVolume(double value, double length) const
  {
    return 1.0 - std::pow(1.0 - this->Of(value), length / distance);
  }

  double OfSurfaces(double lower, double upper) const
  {
    double transparency = 1.0;
    for (const double isoValue : isoValues)
    {
      const bool crossed = lower < isoValue && isoValue <= upper;
      transparency *= crossed ? 1.0 - this->Of(isoValue) : 1.0;
    }
    return 1.0 - transparency;
  }

  vtkNexradTransferFunction* function;
  double distance; // to which its opacities belong
  std::vector<double> isoValues;
};

// Samples for a part of the ray that begins and ends at these voxels.
int SamplesOf(const VoxelReader::Index& begin, const VoxelReader::Index& end)
{
  double most = 0.0;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    most = std::max(most, std::abs(end[axis] - begin[axis]));
  }
  return 1 + static_cast<int>(std::ceil(samplesPerVoxel * most));
}

std::array<double, 3> Between(
  const std::array<double, 3>& begin, const std::array<double, 3>& end, double share)
{
  std::array<double, 3> place{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    place[axis] = begin[axis] + share * (end[axis] - begin[axis]);
  }
  return place;
}

// What is seen along a ray, from the camera on.
class SeenAlong
{
public:
  bool IsOpaque() const { return opacity >= opaque; }

  void Add(const SeenEcho& echo, double taken)
  {
    if (taken > 0.0)
    {
      opacity += (1.0 - opacity) * taken;
      places.emplace_back(opacity, echo);
    }
  }

  std::optional<SeenEcho> Middle() const
  {
    if (opacity < leastVisible)
    {
      return std::nullopt;
    }
    return std::find_if(places.begin(), places.end(),
      [this](const auto& place) { return place.first >= 0.5 * opacity; })
      ->second;
  }

private:
  double opacity = 0.0;
  std::vector<std::pair<double, SeenEcho>> places; // with the opacity up to and with each
};

} // namespace

std::optional<SeenEcho> FindEcho(const VoxelReader& voxels, const VoxelReader* detail,
  const SceneFrame& frame, vtkNexradTransferFunction* transferFunction, const ViewRay& ray)
{
  const auto within = ClipToBox(ray, frame.Bounds());
  if (!within)
  {
    return std::nullopt;
  }
  const auto [begin, end] = *within;
  const std::array<double, 3> first = frame.ToVolume(ray.At(begin));
  const std::array<double, 3> last = frame.ToVolume(ray.At(end));
  const int samples = SamplesOf(voxels.IndexAt(first), voxels.IndexAt(last));
  const double length = (end - begin) / samples;
  const Opacity opacity(transferFunction, frame.OpacityDistance());
  SeenAlong seen;
  std::optional<double> before;
  for (int i = 0; i <= samples && !seen.IsOpaque(); ++i)
  {
    const double share = static_cast<double>(i) / samples;
    const std::array<double, 3> place = Between(first, last, share);
    const VoxelReader& drawn = detail != nullptr && detail->Holds(place) ? *detail : voxels;
    const std::optional<double> value = drawn.ValueAt(drawn.IndexAt(place));
    if (before && value)
    {
      seen.Add({begin + i * length, *value}, opacity.Between(*before, *value, length));
    }
    before = value;
  }
  return seen.Middle();
}

} // namespace nexrad::scene
