// SPDX-License-Identifier: BSD-3-Clause
// Rays that the antenna sent while it was not at its cut (Formulas Q7).
#include "BeamScene.h"
#include "HandMadeVolume.h"
#include "TestData.h"
#include "Tolerance.h"
#include "nexrad/Level2/Encoding/Level2Encoder.h"
#include "nexrad/Level2/Level2File.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace nexrad;
using namespace nexrad::testing;

namespace
{

constexpr double pi = 3.14159265358979323846;
constexpr double echoTop = 5'000.0; // m above the antenna

// The angle of a ray of a cut, as the antenna of a real file of 2008 swung.
double SwungElevation(double cut, int ray)
{
  const double up = ray >= 100 && ray < 200 ? 37.1 * std::sin(pi * (ray - 100) / 100.0) : 0.0;
  const double down = ray >= 200 && ray < 220 ? -4.9 * std::sin(pi * (ray - 200) / 20.0) : 0.0;
  return cut + up + down;
}

constexpr int none = -1;

// Echo of 30 dBZ everywhere up to 5 km; the antenna swings in the cut of index `swinging`.
RadarVolume MakeVolume(int swinging)
{
  HandMadeVolume plan;
  plan.site = {"KTST", centralSite};
  plan.start = sceneTime;
  for (const double tilt : {0.5, 0.9, 1.3, 1.8, 2.4, 3.1, 4.0, 5.1, 6.4, 8.0, 10.0})
  {
    const bool swings = static_cast<int>(plan.sweeps.size()) == swinging;
    HandMadeSweep sweep;
    sweep.elevation = static_cast<float>(tilt);
    sweep.moments = {{MomentName::REF, 230, 1000, 1000,
      [tilt, swings](int ray, int gate)
      {
        const double elevation = swings ? SwungElevation(tilt, ray) : tilt;
        const double height = BeamModel().Locate(1000.0 * (gate + 1), elevation).height;
        return height < echoTop ? ReflectivityWord(30.0) : std::uint8_t{0};
      }}};
    plan.sweeps.push_back(sweep);
  }
  RadarVolume volume = MakeRadarVolume(plan);
  for (int ray = 0; swinging != none && ray < 360; ++ray)
  {
    Ray& swung =
      volume.sweeps[static_cast<std::size_t>(swinging)].rays[static_cast<std::size_t>(ray)];
    swung.elevation = static_cast<float>(SwungElevation(static_cast<double>(swung.elevation), ray));
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
  const RadarVolume volume = MakeVolume(1);
  EXPECT_TRUE(volume.damage.empty()) << volume.damage.front().what;
  const Sweep& sweep = volume.sweeps.at(1);
  EXPECT_EQ(sweep.rays.size(), 360U);
  EXPECT_NEAR(sweep.MedianElevation(), 0.9, 1e-6);
  EXPECT_AT_LEAST(sweep.MeanElevation(), 6.6, "mean elevation that the stray rays move, degrees");
  const auto named = std::find_if(volume.notes.begin(), volume.notes.end(),
    [](const std::string& note) { return note.find("sweep 1 ") != std::string::npos; });
  ASSERT_NE(named, volume.notes.end());
  EXPECT_EQ(*named,
    "sweep 1 (elevation number 2) has its elevation at 0.90 degrees, and 118 of its "
    "360 rays farther from it than half a beam width, from -4.00 to 38.00 degrees; "
    "the merge leaves them out");
}

// False arcs stood at 12 to 19 km, where a mean of 6.6° placed the whole cut; and where the lowest
// cut swung, its rays' own elevations hid all that was above.
TEST(StrayRays, NeitherMoveTheirCutNorHideTheOthers)
{
  const GriddedVolume steady = Merge(MakeVolume(none));
  for (const int swinging : {0, 1})
  {
    const GriddedVolume swung = Merge(MakeVolume(swinging));
    std::size_t high = 0;
    std::size_t hidden = 0;
    std::size_t scanned = 0;
    std::size_t different = 0;
    const auto visit = [&](const SeenVoxel& voxel)
    {
      const VoxelState state = swung.states[voxel.index];
      const VoxelState truth = steady.states[voxel.index];
      // Between two tilts the echo may end half a degree and more above its top.
      const double top = echoTop + 1'000.0 + voxel.slantRange * 0.7 * pi / 180.0;
      high += state == VoxelState::Echo &&
              BeamModel().HeightOver(voxel.groundDistance, voxel.elevation) > top;
      // Below the lowest tilt nobody looked where its own rays are left out.
      const bool seen = swinging == 1 || voxel.elevation > 0.51;
      scanned += seen && truth != VoxelState::NotScanned;
      hidden += seen && truth != VoxelState::NotScanned && state == VoxelState::NotScanned;
      different += seen && truth != state;
    };
    ForEachVoxel(steady.grid, centralSite, visit);
    EXPECT_EQ(high, 0U) << swinging;
    EXPECT_EQ(hidden, 0U) << swinging;
    EXPECT_AT_LEAST(scanned, 200'000U, "voxels scanned") << swinging;
    // At the echo's top, between other tilts.
    EXPECT_AT_MOST(different, swinging == 0 ? 140U : 1'600U, "voxels that differ") << swinging;
  }
}

// The picture in which motion is looked for has no echo of them either.
TEST(StrayRays, AreNotInTheComposite)
{
  RadarVolume volume = MakeVolume(none);
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

// A scan up and down at one azimuth has no elevation and is left out; a sector is a cut like
// others.
TEST(StrayRays, SectorsAndScansInElevationMakeNoFalseTilts)
{
  NumberSweep vertical = UniformSweep(1, 0.0, 30.0F);
  NumberSweep sector = UniformSweep(2, 3.0, 30.0F);
  sector.rays.resize(60);
  sector.values.resize(60 * sector.gates);
  sector.states.resize(60 * sector.gates);
  for (std::size_t ray = 0; ray < vertical.rays.size(); ++ray)
  {
    vertical.rays[ray].azimuth = 90.0 + 0.001 * static_cast<double>(ray);
    vertical.rays[ray].elevation = 0.1 * static_cast<double>(ray);
  }
  const BeamVolume prepared = PrepareBeamVolume(VolumeOf({vertical, sector}));
  ASSERT_EQ(prepared.sweeps.size(), 1U);
  EXPECT_FLOAT_EQ(prepared.sweeps[0].elevation, 3.0F);
  EXPECT_FALSE(prepared.sweeps[0].strays);
  EXPECT_EQ(prepared.sweeps[0].azimuths.size(), 62U);
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
  const auto merged = MergePolar(merger, {&volume}, volume.end, ThreadLoop(2));
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
  EXPECT_AT_LEAST(seen, 50'000U, "voxels seen");
}
