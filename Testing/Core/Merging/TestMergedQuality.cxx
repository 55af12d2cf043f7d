// SPDX-License-Identifier: BSD-3-Clause
// Merged reflectivity after quality control, against the truth of SYNTHETIC scans: radar A has
// ground clutter, radar B sees the same places from 45 km away without any.
#include "DirectMerge.h"
#include "Tolerance.h"
#include "nexrad/Grid/MakeGrid.h"
#include "nexrad/Merging/MergeOptions.h"
#include "nexrad/Merging/TimeMerge.h"
#include "nexrad/Model/SiteTable.h"
#include "nexrad/Moments/MomentMaker.h"
#include "nexrad/Simulation/RadarSimulator.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace nexrad
{
namespace
{

const Time start = *ParseIso8601("2006-03-12T18:30Z");

Site SiteA()
{
  return {"KLSX", FindSite("KLSX")->position};
}

Site SiteB()
{
  Site site = {"KILX", FindSite("KLSX")->position};
  site.position->latitude += 0.4;
  return site;
}

RadarVolume Scan(const Site& site, const std::set<EchoKind>& kinds)
{
  SimulatorOptions options;
  options.notWeather = kinds;
  return ScanVolume(StormField(), site, 12, start, options);
}

PolarVolume Reflectivity(const RadarVolume& volume, QualityLevel level)
{
  MomentOptions options;
  options.quality.level = level;
  return MomentMaker(volume, options).Make(MomentName::REF);
}

GriddedVolume Merge(const std::vector<const PolarVolume*>& volumes)
{
  MergeRequest request;
  GridRequest grid;
  grid.dimensions = {120, 120, 20};
  grid.range = 60'000.0;
  grid.top = 5'000.0;
  request.grid = MakeGrid(grid, {*SiteA().position});
  request.time = start + std::chrono::minutes(2);
  return *testing::MergeDirectly(volumes, request);
}

struct Merges
{
  GriddedVolume clean;    // of A without clutter
  GriddedVolume raw;      // of A as it measures
  GriddedVolume a;        // of A after quality control
  GriddedVolume b;        // of B after quality control
  GriddedVolume both;     // of both after quality control
  GriddedVolume bothAsIs; // of both as they measure
};

const Merges& Made()
{
  static const Merges merges = []
  {
    const RadarVolume still = Scan(SiteA(), {});
    const RadarVolume cluttered = Scan(SiteA(), {EchoKind::Clutter});
    const RadarVolume other = Scan(SiteB(), {});
    const PolarVolume clean = Reflectivity(still, QualityLevel::Off);
    const PolarVolume raw = Reflectivity(cluttered, QualityLevel::Off);
    const PolarVolume a = Reflectivity(cluttered, QualityLevel::Standard);
    const PolarVolume b = Reflectivity(other, QualityLevel::Standard);
    const PolarVolume bRaw = Reflectivity(other, QualityLevel::Off);
    return Merges{Merge({&clean}), Merge({&raw}), Merge({&a}), Merge({&b}), Merge({&a, &b}),
      Merge({&raw, &bRaw})};
  }();
  return merges;
}

// Voxels about which a test holds.
struct Share
{
  std::size_t held = 0;
  std::size_t all = 0;

  void Add(bool holds)
  {
    ++all;
    held += holds ? 1 : 0;
  }
  double Percent() const { return 100.0 * static_cast<double>(held) / static_cast<double>(all); }
};

bool IsEcho(const GriddedVolume& volume, std::size_t voxel)
{
  return volume.states[voxel] == VoxelState::Echo;
}

// Clutter makes the voxel 10 dB stronger than it is.
bool IsCluttered(std::size_t voxel)
{
  const Merges& made = Made();
  const float truth = IsEcho(made.clean, voxel) ? made.clean.values[voxel] : 0.0F;
  return IsEcho(made.raw, voxel) && made.raw.values[voxel] > truth + 10.0F;
}

} // namespace

// B has a good view of the places at which A sees nothing but clutter: A counts no more there.
TEST(MergedQuality, TheOtherRadarFillsWhatIsTakenOut)
{
  const Merges& made = Made();
  Share like;
  Share before;
  for (std::size_t i = 0; i < made.a.states.size(); ++i)
  {
    if (made.a.states[i] == VoxelState::Filtered && IsEcho(made.b, i))
    {
      like.Add(IsEcho(made.both, i) && std::abs(made.both.values[i] - made.b.values[i]) < 1.0F);
      before.Add(std::abs(made.bothAsIs.values[i] - made.b.values[i]) < 1.0F);
    }
  }
  EXPECT_AT_LEAST(like.all, 300, "voxels that A filters and B sees");
  EXPECT_EQ(like.held, like.all);
  EXPECT_AT_MOST(before.Percent(), 25.0, "of them within 1 dB of B without quality control, %");
}

// Also where a part of A's gates about a voxel is kept.
TEST(MergedQuality, ClutterUnderAGoodViewIsGone)
{
  const Merges& made = Made();
  Share gone;
  Share before;
  for (std::size_t i = 0; i < made.a.states.size(); ++i)
  {
    if (IsCluttered(i) && IsEcho(made.b, i))
    {
      gone.Add(IsEcho(made.both, i) && std::abs(made.both.values[i] - made.b.values[i]) < 5.0F);
      before.Add(std::abs(made.bothAsIs.values[i] - made.b.values[i]) < 5.0F);
    }
  }
  EXPECT_AT_LEAST(gone.all, 600, "voxels with clutter at A and echo at B");
  EXPECT_AT_LEAST(gone.Percent(), 80.0, "of them within 5 dB of B, %");
  EXPECT_AT_MOST(before.Percent(), 1.8, "the same without quality control, %");
}

// A filtered gate does not say that there is no echo: rain over clutter gets no hole.
TEST(MergedQuality, NoEchoIsNotMadeOfWhatIsTakenOut)
{
  const Merges& made = Made();
  Share holes;
  Share filtered;
  for (std::size_t i = 0; i < made.a.states.size(); ++i)
  {
    if (IsEcho(made.clean, i) && made.clean.values[i] >= 10.0F)
    {
      holes.Add(made.a.states[i] == VoxelState::NoEcho);
      filtered.Add(made.a.states[i] == VoxelState::Filtered);
      if (made.a.states[i] == VoxelState::Filtered)
      {
        EXPECT_NE(made.both.states[i], VoxelState::NotScanned) << i;
      }
    }
  }
  EXPECT_AT_LEAST(filtered.held, 7, "voxels of rain that A filters");
  EXPECT_AT_MOST(holes.held, 5, "voxels of rain that A takes for no echo",
    "none is measured; one at the edge of echo would be no hole");
}

// Where B measures nothing the place stays filtered; where it measures no echo there is none.
TEST(MergedQuality, FilteredIsWhatNoRadarMeasured)
{
  const Merges& made = Made();
  std::size_t left = 0;
  for (std::size_t i = 0; i < made.a.states.size(); ++i)
  {
    if (made.a.states[i] == VoxelState::Filtered)
    {
      const VoxelState expected =
        IsMeasured(made.b.states[i]) ? made.b.states[i] : VoxelState::Filtered;
      ASSERT_EQ(made.both.states[i], expected) << i;
      left += expected == VoxelState::Filtered ? 1 : 0;
      ASSERT_EQ(made.a.values[i], made.a.fill);
    }
    else
    {
      ASSERT_NE(made.both.states[i], VoxelState::Filtered) << i;
    }
  }
  EXPECT_AT_LEAST(left, 60, "voxels that stay filtered");
}

// The choice of the method decides, whatever the options of quality say.
TEST(MergedQuality, TheThesisTakesGatesAsTheyAre)
{
  MergeOptions options;
  EXPECT_EQ(MomentOptionsOf(options).quality.level, QualityLevel::Standard);
  options.quality.level = QualityLevel::Strict;
  EXPECT_EQ(MomentOptionsOf(options).quality.level, QualityLevel::Strict);
  options.method = MergeMethod::Thesis;
  EXPECT_EQ(MomentOptionsOf(options).quality.level, QualityLevel::Off);
  EXPECT_EQ(SeriesOptionsOf(options).quality.level, QualityLevel::Off);
}

} // namespace nexrad
