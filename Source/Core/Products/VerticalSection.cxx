// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Products/VerticalSection.h"

#include <GeographicLib/Geodesic.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace nexrad
{
namespace
{

// The two voxels along an axis between whose centres a place lies, and the share of the upper one.
// In the outer half of the first and the last voxel, that voxel alone.
struct AxisPlace
{
  bool inside = false;
  std::array<std::size_t, 2> voxels = {0, 0};
  double upper = 0.0;
};

AxisPlace PlaceOn(const GridSpecification& grid, int axis, double coordinate)
{
  const int count = grid.dimensions[axis];
  const double place = (coordinate - grid.origin[axis]) / grid.spacing[axis];
  AxisPlace found;
  found.inside = place >= -0.5 && place <= count - 0.5;
  const double within = std::clamp(place, 0.0, static_cast<double>(count - 1));
  const auto below = static_cast<std::size_t>(within);
  found.voxels = {below, std::min(below + 1, static_cast<std::size_t>(count - 1))};
  found.upper = within - static_cast<double>(below);
  return found;
}

struct Sample
{
  VoxelState state = VoxelState::NotScanned;
  float value = std::numeric_limits<float>::quiet_NaN();
};

// Samples a grid at points, each given by its places on the three axes.
class Sampler
{
public:
  Sampler(const GridSpecification& grid, const VoxelSource& theVoxels)
    : voxels(theVoxels)
    , row(static_cast<std::size_t>(grid.dimensions[0]))
    , layer(row * static_cast<std::size_t>(grid.dimensions[1]))
  {
  }

  Sample Nearest(const AxisPlace& x, const AxisPlace& y, const AxisPlace& z) const
  {
    const auto nearest = [](const AxisPlace& place)
    { return place.voxels[place.upper < 0.5 ? 0 : 1]; };
    const std::size_t voxel = nearest(x) + row * nearest(y) + layer * nearest(z);
    Sample sample;
    sample.state = voxels.state(voxel);
    sample.value = sample.state == VoxelState::Echo ? voxels.value(voxel) : sample.value;
    return sample;
  }

  Sample Linear(const AxisPlace& x, const AxisPlace& y, const AxisPlace& z) const
  {
    std::array<double, VoxelStateCount> weights{}; // of each state
    double sum = 0.0;
    for (unsigned corner = 0; corner < 8; ++corner)
    {
      const auto part = [corner](const AxisPlace& place, unsigned axis)
      { return (corner >> axis & 1U) != 0 ? place.upper : 1.0 - place.upper; };
      const double weight = part(x, 0) * part(y, 1) * part(z, 2);
      if (weight > 0.0)
      {
        const std::size_t voxel = x.voxels[corner & 1U] + row * y.voxels[corner >> 1 & 1U] +
                                  layer * z.voxels[corner >> 2 & 1U];
        const VoxelState state = voxels.state(voxel);
        weights[static_cast<std::size_t>(state)] += weight;
        sum += state == VoxelState::Echo ? weight * static_cast<double>(voxels.value(voxel)) : 0.0;
      }
    }
    return Decide(weights, sum);
  }

private:
  static Sample Decide(const std::array<double, VoxelStateCount>& weights, double sum)
  {
    const auto of = [&](VoxelState state) { return weights[static_cast<std::size_t>(state)]; };
    const double scanned = of(VoxelState::Echo) + of(VoxelState::NoEcho);
    Sample sample;
    if (scanned <= 0.5)
    {
      const auto more = [&of](VoxelState a, VoxelState b) { return of(a) > of(b) ? a : b; };
      const VoxelState known = more(VoxelState::RangeFolded, VoxelState::Filtered);
      sample.state = more(known, VoxelState::NotScanned);
    }
    else if (of(VoxelState::NoEcho) >= 0.5 * scanned)
    {
      sample.state = VoxelState::NoEcho;
    }
    else
    {
      sample.state = VoxelState::Echo;
      sample.value = static_cast<float>(sum / of(VoxelState::Echo));
    }
    return sample;
  }

  const VoxelSource& voxels;
  std::size_t row;
  std::size_t layer;
};

// The centre of a rectangle of `count` between two ends.
double CentreOf(int index, int count, double from, double to)
{
  return from + (index + 0.5) / count * (to - from);
}

// m along the ground.
double LengthOf(const SectionLine& line, const GridSpecification& grid)
{
  if (grid.axes == GridAxes::Projected)
  {
    return std::hypot(line.to[0] - line.from[0], line.to[1] - line.from[1]);
  }
  double length = 0.0;
  GeographicLib::Geodesic::WGS84().Inverse(
    line.from[1], line.from[0], line.to[1], line.to[0], length);
  return length;
}

} // namespace

VerticalSection MakeVerticalSection(
  const GridSpecification& grid, const VoxelSource& voxels, const SectionSampling& sampling)
{
  VerticalSection section;
  section.dimensions = sampling.dimensions;
  section.length = LengthOf(sampling.line, grid);
  section.bottom = grid.origin[2] - 0.5 * grid.spacing[2];
  section.top = section.bottom + grid.spacing[2] * grid.dimensions[2];
  const Sampler sampler(grid, voxels);
  const bool nearest = IsRadialVelocity(sampling.moment) || sampling.moment == MomentName::PHI;
  const auto [along, upward] = sampling.dimensions;
  const SectionLine& line = sampling.line;
  for (int k = 0; k < upward; ++k)
  {
    const AxisPlace z = PlaceOn(grid, 2, CentreOf(k, upward, section.bottom, section.top));
    for (int i = 0; i < along; ++i)
    {
      const AxisPlace x = PlaceOn(grid, 0, CentreOf(i, along, line.from[0], line.to[0]));
      const AxisPlace y = PlaceOn(grid, 1, CentreOf(i, along, line.from[1], line.to[1]));
      Sample sample;
      if (x.inside && y.inside)
      {
        sample = nearest ? sampler.Nearest(x, y, z) : sampler.Linear(x, y, z);
      }
      section.values.push_back(sample.value);
      section.states.push_back(sample.state);
    }
  }
  return section;
}

} // namespace nexrad
