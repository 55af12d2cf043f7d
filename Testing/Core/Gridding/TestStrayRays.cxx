// SPDX-License-Identifier: BSD-3-Clause
// Rays that the antenna sent while it was not at its cut (Formulas Q7).
#include "BeamScene.h"
#include "HandMadeVolume.h"
#include "Level2/Level2Encoder.h"
#include "Level2/Level2File.h"
#include "TestData.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace nexrad;
using namespace nexrad::testing;

namespace
{

constexpr double pi = 3.14159265358979323846;
constexpr double echoTop = 5'000.0; // m above the antenna

// The angle of a ray of the cut at 0.9°, as the antenna of a real file of 2008 swung.
double SwungElevation(int ray)
{
  const double up = ray >= 100 && ray < 200 ? 37.1 * std::sin(pi * (ray - 100) / 100.0) : 0.0;
  const double down = ray >= 200 && ray < 220 ? -4.9 * std::sin(pi * (ray - 200) / 20.0) : 0.0;
  return 0.9 + up + down;
}

// Echo of 30 dBZ everywhere up to 5 km; `swings`: the antenna does so in the cut at 0.9°.
RadarVolume MakeVolume(bool swings)
{
  HandMadeVolume plan;
  plan.site = {"KTST", centralSite};
  plan.start = sceneTime;
  for (const double tilt : {0.5, 0.9, 1.3, 1.8, 2.4, 3.1, 4.0, 5.1, 6.4, 8.0, 10.0})
  {
    const bool swinging = swings && tilt == 0.9;
    HandMadeSweep sweep;
    sweep.elevation = static_cast<float>(tilt);
    sweep.moments = {{MomentName::REF, 230, 1000, 1000,
      [tilt, swinging](int ray, int gate)
      {
        const double elevation = swinging ? SwungElevation(ray) : tilt;
        const double height = BeamModel().Locate(1000.0 * (gate + 1), elevation).height;
        return height < echoTop ? ReflectivityWord(30.0) : std::uint8_t{0};
      }}};
    plan.sweeps.push_back(sweep);
  }
  RadarVolume volume = MakeRadarVolume(plan);
  for (std::size_t ray = 0; swings && ray < volume.sweeps[1].rays.size(); ++ray)
  {
    volume.sweeps[1].rays[ray].elevation =
      static_cast<float>(SwungElevation(static_cast<int>(ray)));
  }
  Level2EncoderOptions options;
  options.messageType = 31;
  return DecodeLevel2(EncodeLevel2(volume, options), "KTST20060312_180000");
}

GriddedVolume Merge(const RadarVolume& volume)
{
  const PolarVolume polar = MakePolarVolume(volume, MomentName::REF);
  return MergeAt({polar}, 60.0, AsMeasured());
}

} // namespace

TEST(StrayRays, AreKeptByTheDecoderAndNamed)
{
  const RadarVolume volume = MakeVolume(true);
  EXPECT_TRUE(volume.damage.empty()) << volume.damage.front().what;
  const Sweep& sweep = volume.sweeps.at(1);
  EXPECT_EQ(sweep.rays.size(), 360U);
  EXPECT_NEAR(sweep.MedianElevation(), 0.9, 1e-6);
  EXPECT_GT(sweep.MeanElevation(), 6.6);
  const auto named = std::find_if(volume.notes.begin(), volume.notes.end(),
    [](const std::string& note) { return note.find("sweep 1 ") != std::string::npos; });
  ASSERT_NE(named, volume.notes.end());
  EXPECT_EQ(*named,
    "sweep 1 (elevation number 2) has its elevation at 0.90 degrees, and 118 of its "
    "360 rays farther from it than half a beam width, from -4.00 to 38.00 degrees; "
    "the merge leaves them out");
}

// False arcs stood at 12 to 19 km, where a mean of 6.6° placed the whole cut, and columns under the
// swing were not scanned from the ground to the top.
TEST(StrayRays, NeitherMoveTheirCutNorHideTheOthers)
{
  const GriddedVolume swung = Merge(MakeVolume(true));
  const GriddedVolume steady = Merge(MakeVolume(false));
  std::size_t high = 0;
  std::size_t hidden = 0;
  std::size_t scanned = 0;
  std::size_t different = 0;
  const auto visit = [&](const SeenVoxel& voxel)
  {
    const VoxelState state = swung.states[voxel.index];
    const VoxelState truth = steady.states[voxel.index];
    // Where neighbouring tilts' echo ends between them, its top may lie half a degree too high.
    const double top = echoTop + 1'000.0 + voxel.slantRange * 0.7 * pi / 180.0;
    high += state == VoxelState::Echo &&
            BeamModel().HeightOver(voxel.groundDistance, voxel.elevation) > top;
    scanned += truth != VoxelState::NotScanned;
    hidden += truth != VoxelState::NotScanned && state == VoxelState::NotScanned;
    different += truth != state;
  };
  ForEachVoxel(steady.grid, centralSite, visit);
  EXPECT_EQ(high, 0U);
  EXPECT_EQ(hidden, 0U);
  EXPECT_GT(scanned, 60'000U);
  EXPECT_LT(different, scanned / 200); // at the top of the echo, between 0.5° and 1.3°
}

// The picture in which motion is looked for has no echo of them either.
TEST(StrayRays, AreNotInTheComposite)
{
  RadarVolume volume = MakeVolume(false);
  Sweep& sweep = volume.sweeps.back(); // 10°: up to 28 km in range
  const BeamVolume before = PrepareBeamVolume(MakePolarVolume(volume, MomentName::REF));
  for (std::size_t ray = 90; ray < 120; ++ray)
  {
    sweep.rays[ray] = volume.sweeps.front().rays[ray]; // echo to 200 km
    sweep.rays[ray].elevationNumber = volume.sweeps[10].rays[0].elevationNumber;
  }
  const BeamVolume after = PrepareBeamVolume(MakePolarVolume(volume, MomentName::REF));
  EXPECT_TRUE(after.sweeps.back().strays);
  EXPECT_FALSE(before.sweeps.back().strays);
  EXPECT_EQ(after.sweeps.back().azimuths.size(), before.sweeps.back().azimuths.size() - 30);
  EXPECT_EQ(after.composite.values, before.composite.values);
}

// A scan up and down at one azimuth keeps the rays about its median, and a sector is a cut like
// others.
TEST(StrayRays, SectorsAndScansInElevationMakeNoFalseTilts)
{
  PolarSweep vertical = UniformSweep(1, 0.0, 30.0F);
  PolarSweep sector = UniformSweep(2, 3.0, 30.0F);
  sector.rays.resize(60);
  sector.values.resize(60 * sector.gates);
  sector.states.resize(60 * sector.gates);
  for (std::size_t ray = 0; ray < vertical.rays.size(); ++ray)
  {
    vertical.rays[ray].azimuth = 90.0 + 0.001 * static_cast<double>(ray);
    vertical.rays[ray].elevation = 0.1 * static_cast<double>(ray);
  }
  const BeamVolume prepared = PrepareBeamVolume(VolumeOf({vertical, sector}));
  ASSERT_EQ(prepared.sweeps.size(), 2U);
  EXPECT_FLOAT_EQ(prepared.sweeps[0].elevation, 18.0F);
  for (const float elevation : prepared.sweeps[0].elevations)
  {
    EXPECT_NEAR(elevation, 18.0F, 0.476F);
  }
  EXPECT_FALSE(prepared.sweeps[1].strays);
  EXPECT_EQ(prepared.sweeps[1].azimuths.size(), 62U);
}

// The antenna settles late in the cut at 14.5°: 16 rays lie up to 0.85° above it. Between its
// neighbours nothing may be hidden for that.
TEST(StrayRays, LeaveNoWedgeAtKBGM)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  const RadarVolume file = ReadLevel2(data / "level2/run-kbgm-20050821/KBGM20050821_024323.gz");
  const PolarVolume volume = MakePolarVolume(file, MomentName::REF);
  GridSpecification grid = SceneGrid();
  grid.spacing = {2'000.0, 2'000.0, 250.0};
  grid.origin = {-60'000.0, -60'000.0, 500.0};
  grid.centreLatitude = volume.site.position->latitude;
  grid.centreLongitude = volume.site.position->longitude;
  BeamMerger merger(grid);
  const auto merged = merger.Merge({&volume}, volume.end, ThreadLoop(2));
  std::size_t seen = 0;
  const auto visit = [&](const SeenVoxel& voxel)
  {
    if (voxel.elevation > 10.3 && voxel.elevation < 18.9 && voxel.slantRange < 55'000.0)
    {
      ++seen;
      ASSERT_NE(merged->states[voxel.index], VoxelState::NotScanned)
        << voxel.azimuth << ' ' << voxel.elevation;
    }
  };
  ForEachVoxel(grid, *volume.site.position, visit);
  EXPECT_GT(seen, 20'000U);
}
