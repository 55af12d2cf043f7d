// SPDX-License-Identifier: BSD-3-Clause
#include "StormVolume.h"

#include "nexrad/Codec/NxvFile.h"
#include "vtkNexradImageConversion.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace nexrad::testing
{

// A tower with an anvil that leans to the north east.
double Storm(double x, double y, double height)
{
  const double core = std::hypot(x + 70.0, y + 70.0) / 30.0;
  const double anvil = std::hypot(x + 70.0 - 6.0 * height, y + 70.0 - 6.0 * height) / 90.0;
  const double fall = std::max(0.0, height - 4.0) * 2.0;
  const double tower = 62.0 - 22.0 * core * core - fall;
  const double veil = 34.0 - 20.0 * anvil * anvil - 1.5 * std::abs(height - 8.0);
  return height > 15.0 ? -33.0 : std::max({tower, veil, -33.0});
}

namespace
{

// The storm after it has moved so many km to the east, in voxels that are so many in a domain of
// 480 × 480 × 20 km.
GriddedVolume MakeStorm(
  bool synthetic, double east, const std::array<int, 3>& dimensions = {48, 48, 16})
{
  constexpr std::array<double, 3> lengths = {480'000.0, 480'000.0, 20'000.0};
  GriddedVolume volume;
  volume.grid.dimensions = dimensions;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    volume.grid.spacing[axis] = lengths[axis] / dimensions[axis];
    volume.grid.origin[axis] = 0.5 * (volume.grid.spacing[axis] - (axis < 2 ? lengths[axis] : 0.0));
  }
  volume.grid.centreLatitude = 39.0;
  volume.grid.centreLongitude = -90.0;
  volume.time = *ParseIso8601("2006-03-12T18:30");
  volume.method = "thesis";
  volume.sites = {"KLSX", "KILX"};
  volume.synthetic = synthetic;
  for (std::size_t i = 0; i < volume.grid.VoxelCount(); ++i)
  {
    const auto coordinate = [&](int axis, std::size_t index)
    { return volume.grid.Coordinate(axis, static_cast<int>(index)) / 1000.0; };
    const auto columns = static_cast<std::size_t>(dimensions[0]);
    const auto rows = static_cast<std::size_t>(dimensions[1]);
    const double dBZ = Storm(coordinate(0, i % columns) - east, coordinate(1, i / columns % rows),
      coordinate(2, i / (columns * rows)));
    const bool echo = dBZ > 0.0;
    volume.values.push_back(echo ? static_cast<float>(dBZ) : volume.fill);
    volume.states.push_back(echo ? VoxelState::Echo : VoxelState::NoEcho);
  }
  return volume;
}

} // namespace

GriddedVolume MakeStorm(bool synthetic)
{
  return MakeStorm(synthetic, 0.0);
}

vtkSmartPointer<vtkImageData> MakeStormVolume(bool synthetic)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  vtkNexradVolumeToImage(MakeStorm(synthetic), image);
  return image;
}

std::filesystem::path WriteStormFiles(const std::filesystem::path& folder, int steps)
{
  NxvSeries series;
  for (int step = 0; step < steps; ++step)
  {
    GriddedVolume volume = MakeStorm(true, 20.0 * step);
    volume.time += std::chrono::minutes(5 * step);
    const std::string name = FormatForFileName(volume.time) + ".nxv";
    WriteNxv(folder / name, volume);
    series.emplace_back(name, ToSeconds(volume.time));
  }
  WriteNxvSeries(folder / "volumes.nxv.series", series);
  return folder / "volumes.nxv.series";
}

GriddedVolume MakeLargeStorm()
{
  GriddedVolume volume = MakeStorm(true, 0.0, {2100, NxvBandWriter::Rows, 16});
  volume.method = "beam";
  return volume;
}

std::filesystem::path WriteLargeStorm(const std::filesystem::path& folder)
{
  const GriddedVolume volume = MakeLargeStorm();
  const std::filesystem::path path = folder / "large.nxv";
  NxvBandWriter writer(path, volume.grid);
  writer.Add(volume);
  writer.Commit();
  return path;
}

std::filesystem::path WriteTwoMoments(const std::filesystem::path& folder)
{
  GriddedVolume reflectivity = MakeStorm(true);
  reflectivity.method = "beam";
  GriddedVolume velocity = reflectivity;
  velocity.moment = MomentName::VEL;
  for (std::size_t i = 0; i < velocity.values.size(); ++i)
  {
    velocity.values[i] = static_cast<float>(i % 48) - 24.0F;
  }
  const std::filesystem::path path = folder / "two.nxv";
  WriteNxv(path, JoinMoments({std::move(reflectivity), std::move(velocity)}));
  return path;
}

} // namespace nexrad::testing
