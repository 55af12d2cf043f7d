// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/EchoSearch.h"

#include "nexrad/Grid/GridSpecification.h"
#include "nexrad/Model/Moment.h"
#include "nexrad/Model/SiteTable.h"
#include "vtkNexradTransferFunction.h"
#include "vtkNexradVoxels.h"

#include <vtkCamera.h>
#include <vtkDataArray.h>
#include <vtkDataSetAttributes.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkMath.h>
#include <vtkPointData.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace nexrad::scene
{
namespace
{

// Half the height of the picture: as a tangent, or in scene units under parallel projection.
double HalfHeight(vtkCamera* camera)
{
  return camera->GetParallelProjection() != 0
           ? camera->GetParallelScale()
           : std::tan(vtkMath::RadiansFromDegrees(camera->GetViewAngle()) / 2.0);
}

} // namespace

ScenePoint ViewRay::At(double distance) const
{
  return {origin[0] + distance * direction[0], origin[1] + distance * direction[1],
    origin[2] + distance * direction[2]};
}

ViewRay RayThrough(
  vtkCamera* camera, const std::array<int, 2>& size, const std::array<double, 2>& pixel)
{
  ScenePoint forward{};
  ScenePoint up{};
  ScenePoint right{};
  camera->GetDirectionOfProjection(forward.data());
  camera->GetViewUp(up.data());
  vtkMath::Cross(forward.data(), up.data(), right.data());
  vtkMath::Normalize(right.data());
  vtkMath::Cross(right.data(), forward.data(), up.data());
  const double perPixel = 2.0 * HalfHeight(camera) / size[1];
  const double across = (pixel[0] - 0.5 * size[0]) * perPixel;
  const double upward = (pixel[1] - 0.5 * size[1]) * perPixel;
  ViewRay ray;
  camera->GetPosition(ray.origin.data());
  ray.direction = forward;
  ScenePoint& moved = camera->GetParallelProjection() != 0 ? ray.origin : ray.direction;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    moved[axis] += across * right[axis] + upward * up[axis];
  }
  vtkMath::Normalize(ray.direction.data());
  return ray;
}

std::optional<double> DistanceToHeight(const ViewRay& ray, double z)
{
  const double distance = (z - ray.origin[2]) / ray.direction[2];
  return std::isfinite(distance) && distance >= 0.0 ? std::optional(distance) : std::nullopt;
}

VoxelReader::VoxelReader(vtkImageData* image)
  : volume(image)
  , scalars(image->GetPointData()->GetScalars())
  , hidden(image->GetPointData()->GetArray(vtkDataSetAttributes::GhostArrayName()))
{
  volume->GetDimensions(dimensions.data());
  name = vtkNexradScalarsName(volume);
  const std::optional<MomentName> moment = ParseMomentName(name);
  unit = moment ? UnitOf(*moment) : "";
  codeValues = vtkNexradFindCodeValues(volume, name);
  if (codeValues != nullptr)
  {
    hidden = volume->GetFieldData()->GetArray((name + "_code_ghosts").c_str());
  }
}

VoxelReader::Index VoxelReader::IndexAt(const std::array<double, 3>& place) const
{
  Index index{};
  const double* origin = volume->GetOrigin();
  const double* spacing = volume->GetSpacing();
  const int* extent = volume->GetExtent();
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    index[axis] = (place[axis] - origin[axis]) / spacing[axis] - extent[2 * axis];
  }
  return index;
}

bool VoxelReader::Holds(const std::array<double, 3>& place) const
{
  const Index index = this->IndexAt(place);
  bool within = true;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    within = within && index[axis] >= 0.0 && index[axis] <= dimensions[axis] - 1.0;
  }
  return within;
}

std::array<int, 3> VoxelReader::Nearest(const Index& index) const
{
  std::array<int, 3> voxel{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    voxel[axis] =
      static_cast<int>(std::clamp(std::round(index[axis]), 0.0, dimensions[axis] - 1.0));
  }
  return voxel;
}

long long VoxelReader::Number(const std::array<int, 3>& voxel) const
{
  return voxel[0] + static_cast<long long>(dimensions[0]) *
                      (voxel[1] + static_cast<long long>(dimensions[1]) * voxel[2]);
}

std::optional<double> VoxelReader::Value(long long voxel) const
{
  const double scalar = scalars->GetComponent(voxel, 0);
  const long long flagged = codeValues != nullptr ? static_cast<long long>(scalar) : voxel;
  if (hidden != nullptr &&
      (static_cast<int>(hidden->GetComponent(flagged, 0)) & vtkDataSetAttributes::HIDDENPOINT) != 0)
  {
    return std::nullopt;
  }
  const double value = codeValues != nullptr ? codeValues->GetComponent(flagged, 0) : scalar;
  return std::isnan(value) ? std::nullopt : std::optional(value);
}

std::optional<double> VoxelReader::ValueAt(const Index& index) const
{
  const std::optional<double> nearest = this->Value(this->Number(this->Nearest(index)));
  if (!nearest)
  {
    return std::nullopt;
  }
  std::array<int, 3> first{};
  std::array<int, 3> second{};
  std::array<double, 3> share{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const double place = std::clamp(index[axis], 0.0, dimensions[axis] - 1.0);
    first[axis] = static_cast<int>(place);
    second[axis] = std::min(first[axis] + 1, dimensions[axis] - 1);
    share[axis] = place - first[axis];
  }
  double sum = 0.0;
  for (int corner = 0; corner < 8; ++corner)
  {
    std::array<int, 3> voxel{};
    double weight = 1.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      const bool upper = (corner >> axis & 1) != 0;
      voxel[axis] = upper ? second[axis] : first[axis];
      weight *= upper ? share[axis] : 1.0 - share[axis];
    }
    sum += weight > 0.0 ? weight * this->Value(this->Number(voxel)).value_or(*nearest) : 0.0;
  }
  return sum;
}

std::optional<double> VoxelReader::NearestOf(const std::string& array, const Index& index) const
{
  vtkDataArray* values = volume->GetPointData()->GetArray(array.c_str());
  const long long voxel = this->Number(this->Nearest(index));
  return values != nullptr && voxel < values->GetNumberOfTuples()
           ? std::optional(values->GetComponent(voxel, 0))
           : std::nullopt;
}

namespace
{

// The part of the ray within a box (west, east, south, north, bottom, top), as distances; nothing
// where it misses the box.
std::optional<std::array<double, 2>> ClipToBox(const ViewRay& ray, const std::array<double, 6>& box)
{
  double enters = 0.0;
  double leaves = std::numeric_limits<double>::max();
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const double lower = box[2 * axis] - ray.origin[axis];
    const double upper = box[2 * axis + 1] - ray.origin[axis];
    if (ray.direction[axis] == 0.0)
    {
      if (lower > 0.0 || upper < 0.0)
      {
        return std::nullopt;
      }
      continue;
    }
    const double first = lower / ray.direction[axis];
    const double second = upper / ray.direction[axis];
    enters = std::max(enters, std::min(first, second));
    leaves = std::min(leaves, std::max(first, second));
  }
  return enters <= leaves ? std::optional(std::array<double, 2>{enters, leaves}) : std::nullopt;
}

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

std::optional<RadarPlace> FindNearestRadar(
  const std::vector<std::string>& sites, double latitude, double longitude)
{
  constexpr double degrees = 180.0 / 3.14159265358979323846;
  std::optional<RadarPlace> nearest;
  for (const std::string& name : sites)
  {
    const KnownSite* site = FindSite(name);
    if (site == nullptr)
    {
      continue;
    }
    GridSpecification about; // whose projection keeps distances and directions from the radar
    about.centreLatitude = site->position.latitude;
    about.centreLongitude = site->position.longitude;
    const auto [east, north] = about.FromGeographic(longitude, latitude);
    const double distance = std::hypot(east, north);
    if (!nearest || distance < nearest->distance)
    {
      const double azimuth = std::atan2(east, north) * degrees;
      nearest = RadarPlace{name, distance, azimuth < 0.0 ? azimuth + 360.0 : azimuth};
    }
  }
  return nearest;
}

} // namespace nexrad::scene
