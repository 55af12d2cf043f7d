// SPDX-License-Identifier: BSD-3-Clause
#include "StateNames.h"
#include "nexrad/Products/VerticalSection.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace nexrad;
using namespace nexrad::testing;

namespace
{

// dBZ of a field that is linear in all three coordinates.
double Plane(double x, double y, double z)
{
  return 20.0 + 0.001 * x - 0.0005 * y + 0.002 * z;
}

// 10 × 8 × 6 voxels of 1 km × 1 km × 500 m with that field.
GriddedVolume LinearVolume()
{
  GriddedVolume volume;
  volume.grid.dimensions = {10, 8, 6};
  volume.grid.origin = {-4'500.0, -3'500.0, 250.0};
  volume.grid.spacing = {1'000.0, 1'000.0, 500.0};
  for (int k = 0; k < 6; ++k)
  {
    for (int j = 0; j < 8; ++j)
    {
      for (int i = 0; i < 10; ++i)
      {
        volume.values.push_back(static_cast<float>(Plane(volume.grid.Coordinate(0, i),
          volume.grid.Coordinate(1, j), volume.grid.Coordinate(2, k))));
      }
    }
  }
  volume.states.assign(volume.values.size(), echo);
  return volume;
}

VerticalSection Cut(const GriddedVolume& volume, const SectionSampling& sampling)
{
  const VoxelSource source = {[&](std::size_t voxel) { return volume.states[voxel]; },
    [&](std::size_t voxel) { return volume.values[voxel]; }};
  return MakeVerticalSection(volume.grid, source, sampling);
}

// Two voxels side by side, and a section from the centre of the one to that of the other in ten
// samples.
VerticalSection Between(VoxelState left, VoxelState right)
{
  GriddedVolume volume;
  volume.grid.dimensions = {2, 1, 1};
  volume.grid.spacing = {1'000.0, 1'000.0, 500.0};
  volume.values = {40.0F, -33.0F};
  volume.states = {left, right};
  return Cut(volume, {{{0.0, 0.0}, {1'000.0, 0.0}}, {10, 1}});
}

} // namespace

TEST(VerticalSection, ReturnsALinearFieldExactly)
{
  const SectionLine line = {{-3'300.0, 2'700.0}, {4'100.0, -2'900.0}};
  const VerticalSection section = Cut(LinearVolume(), {line, {64, 40}});
  EXPECT_DOUBLE_EQ(section.length, std::hypot(7'400.0, 5'600.0));
  EXPECT_EQ(section.bottom, 0.0);
  EXPECT_EQ(section.top, 3'000.0);
  double worst = 0.0;
  for (int k = 4; k < 36; ++k) // between the lowest and the highest centres of voxels
  {
    for (int i = 0; i < 64; ++i)
    {
      const double share = (i + 0.5) / 64.0;
      const double wanted = Plane(line.from[0] + share * (line.to[0] - line.from[0]),
        line.from[1] + share * (line.to[1] - line.from[1]), (k + 0.5) / 40.0 * 3'000.0);
      const auto got = static_cast<double>(section.values[static_cast<std::size_t>(k * 64 + i)]);
      worst = std::max(worst, std::abs(got - wanted));
    }
  }
  EXPECT_NEAR(worst, 0.0, 1e-5);
}

TEST(VerticalSection, NoEchoIsNotMixedIntoValues)
{
  const VerticalSection section = Between(echo, none);
  for (std::size_t i = 0; i < 10; ++i)
  {
    EXPECT_EQ(section.states[i], i < 5 ? echo : none) << i;
    EXPECT_TRUE(i < 5 ? section.values[i] == 40.0F : std::isnan(section.values[i])) << i;
  }
}

TEST(VerticalSection, WhatWasNotScannedEndsHalfWay)
{
  for (const VoxelState missing : {open, folded, VoxelState::Filtered})
  {
    const VerticalSection section = Between(echo, missing);
    EXPECT_EQ(section.states[4], echo);
    EXPECT_EQ(section.values[4], 40.0F);
    EXPECT_EQ(section.states[5], missing);
    EXPECT_TRUE(std::isnan(section.values[5]));
  }
}

TEST(VerticalSection, VelocitiesAndPhasesAreThoseOfWholeVoxels)
{
  for (const MomentName moment : {MomentName::VEL, MomentName::PHI})
  {
    const VerticalSection section =
      Cut(LinearVolume(), {{{-5'000.0, 0.5}, {5'000.0, 0.5}}, {20, 6}, moment});
    for (std::size_t i = 0; i < 20; ++i)
    {
      EXPECT_FLOAT_EQ(
        section.values[i], static_cast<float>(Plane(-4'500.0 + 1'000.0 * (i / 2), 500.0, 250.0)));
    }
  }
}

TEST(VerticalSection, OutsideOfTheGridNothingIsScanned)
{
  const VerticalSection section =
    Cut(LinearVolume(), {{{-15'000.0, 0.0}, {5'000.0, 0.0}}, {20, 1}});
  for (std::size_t i = 0; i < 20; ++i)
  {
    EXPECT_EQ(section.states[i], i < 10 ? open : echo) << i;
  }
}

TEST(VerticalSection, ALineOfNoLengthIsAColumn)
{
  const VerticalSection section = Cut(LinearVolume(), {{{500.0, 500.0}, {500.0, 500.0}}, {3, 6}});
  EXPECT_EQ(section.length, 0.0);
  EXPECT_FLOAT_EQ(section.values[0], static_cast<float>(Plane(500.0, 500.0, 250.0)));
  EXPECT_EQ(section.values[0], section.values[2]);
}

TEST(VerticalSection, OnGeographicAxesTheLengthIsThatOfTheGeodesic)
{
  GriddedVolume volume = LinearVolume();
  volume.grid.axes = GridAxes::Geographic;
  // A degree of a meridian of WGS84 from 40° N on.
  EXPECT_NEAR(Cut(volume, {{{-90.0, 40.0}, {-90.0, 41.0}}}).length, 111'044.26, 0.1);
}
