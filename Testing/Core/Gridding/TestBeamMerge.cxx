// SPDX-License-Identifier: BSD-3-Clause
// One radar at one time: what becomes of the gates.
#include "BeamScene.h"
#include "Coverage.h"
#include "Tolerance.h"
#include "nexrad/Geometry/Angles.h"
#include "nexrad/System/Error.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

using namespace nexrad;
using namespace nexrad::testing;

namespace
{

constexpr double halfWidth = 0.475; // degrees
constexpr double edge = 0.002;      // degrees about a limit in which either side is right

// Voxels of the scene over which every ray of its uniform sweeps has gates.
bool IsInReach(const SeenVoxel& voxel)
{
  return voxel.groundDistance > 2'000.0 && voxel.groundDistance < 200'000.0;
}

std::size_t Count(const GriddedVolume& volume, VoxelState state)
{
  return static_cast<std::size_t>(std::count(volume.states.begin(), volume.states.end(), state));
}

void TakeLastGates(NumberSweep& sweep)
{
  for (std::size_t ray = 0; ray < sweep.rays.size(); ++ray)
  {
    for (std::size_t gate = sweep.gates - 8; gate < sweep.gates; ++gate)
    {
      sweep.states[sweep.Index(ray, gate)] = GateState::NotSampled;
    }
  }
}

// A quarter of the rays each holds no echo, folded gates, gates that were not sampled, and 25 dBZ,
// from 30° on, so that the borders pass voxels at all distances. A voxel farther from a border than
// half the rays' spacing and than `border`, in m, is what its quarter is; a nearer one is like
// either side.
void ExpectFourQuarters(const BeamMergeOptions& options, double border)
{
  constexpr std::array<GateState, 4> gates = {
    GateState::BelowThreshold, GateState::RangeFolded, GateState::NotSampled, GateState::Valid};
  constexpr std::array<VoxelState, 4> voxels = {
    VoxelState::NoEcho, VoxelState::RangeFolded, VoxelState::NotScanned, VoxelState::Echo};
  NumberSweep sweep = UniformSweep(1, 1.0, 25.0F);
  for (std::size_t ray = 0; ray < 360; ++ray)
  {
    const auto row = sweep.states.begin() + static_cast<std::ptrdiff_t>(sweep.Index(ray, 0));
    std::fill_n(row, sweep.gates, gates[(ray + 330) % 360 / 90]);
  }
  const GriddedVolume volume = MergeAt({VolumeOf({sweep})}, 0.0, options);
  std::size_t inside = 0;
  const auto check = [&](const SeenVoxel& voxel)
  {
    // Nearer to the radar a ring of means has few cells.
    if (!IsInReach(voxel) || voxel.groundDistance < 6'000.0 ||
        std::abs(voxel.elevation - 1.0) > halfWidth - edge)
    {
      return;
    }
    const double turned = std::fmod(voxel.azimuth + 330.5, 360.0); // a border lies between two rays
    const auto quarter = static_cast<std::size_t>(turned / 90.0);
    const double after = turned - 90.0 * static_cast<double>(quarter);
    const double angle = std::min(after, 90.0 - after);
    const VoxelState state = volume.states[voxel.index];
    const bool isNear = angle < 0.5 || voxel.groundDistance * angle * RadiansPerDegree < border;
    const std::size_t beside = (quarter + (after < 45.0 ? 3 : 1)) % 4;
    ASSERT_TRUE(state == voxels[quarter] || (isNear && state == voxels[beside]))
      << voxel.azimuth << " " << voxel.groundDistance;
    if (!isNear)
    {
      const float value = state == VoxelState::Echo ? 25.0F : volume.fill;
      ASSERT_FLOAT_EQ(volume.values[voxel.index], value);
      ++inside;
    }
  };
  ForEachVoxel(volume.grid, centralSite, check);
  EXPECT_AT_LEAST(inside, 26'000u, "voxels inside");
}

} // namespace

TEST(BeamMerge, LinearInElevationBetweenTheTiltsAndNotBeyondHalfABeam)
{
  const std::vector<double> tilts = {0.5, 1.5, 6.0, 14.0};
  const std::vector<float> values = {20.0F, 40.0F, 30.0F, 55.0F};
  std::vector<NumberSweep> sweeps;
  for (std::size_t i = 0; i < tilts.size(); ++i)
  {
    sweeps.push_back(UniformSweep(static_cast<int>(i) + 1, tilts[i], values[i]));
  }
  const GriddedVolume volume = MergeAt({VolumeOf(sweeps)}, 0.0, AsMeasured());
  std::size_t between = 0;
  const auto check = [&](const SeenVoxel& voxel)
  {
    if (!IsInReach(voxel))
    {
      return;
    }
    const VoxelState state = volume.states[voxel.index];
    const double below = tilts.front() - halfWidth - voxel.elevation;
    const double above = voxel.elevation - tilts.back() - halfWidth;
    if (std::max(below, above) > edge)
    {
      ASSERT_EQ(state, VoxelState::NotScanned) << voxel.elevation; // the cone of silence too
      ASSERT_EQ(volume.values[voxel.index], volume.fill);
      return;
    }
    if (std::max(below, above) > -edge)
    {
      return;
    }
    ASSERT_EQ(state, VoxelState::Echo) << voxel.elevation;
    double expected = static_cast<double>(values.back());
    for (std::size_t i = tilts.size(); i-- > 0;)
    {
      const double next = i + 1 < tilts.size() ? tilts[i + 1] : 90.0;
      const double step =
        i + 1 < tilts.size() ? static_cast<double>(values[i + 1] - values[i]) : 0.0;
      if (voxel.elevation < next)
      {
        const double share = std::max((voxel.elevation - tilts[i]) / (next - tilts[i]), 0.0);
        expected = static_cast<double>(values[i]) + share * step;
      }
    }
    ASSERT_WITHIN(volume.values[voxel.index], expected, 0.014, "interpolation in elevation, dBZ")
      << voxel.elevation;
    ++between;
  };
  ForEachVoxel(volume.grid, centralSite, check);
  EXPECT_AT_LEAST(between, 120'000u, "voxels between tilts");
  EXPECT_EQ(volume.sites, std::vector<std::string>{"KTST"});
  EXPECT_EQ(volume.method, "beam");
}

// Rays stray from their tilt, most of all where a cut begins. What one of them saw counts, and what
// none of them saw does not.
TEST(BeamMerge, BeamsReachHalfABeamFromTheirOwnRaysElevations)
{
  NumberSweep sweep = UniformSweep(1, 1.0, 20.0F);
  for (std::size_t ray = 0; ray < sweep.rays.size(); ++ray)
  {
    sweep.rays[ray].elevation += 0.15 * std::sin(0.7 * static_cast<double>(ray));
  }
  const PolarVolume source = VolumeOf({sweep});
  const GriddedVolume volume = MergeAt({source}, 0.0);
  CoverageOptions narrower;
  narrower.beamWidth = 0.95 - edge;
  CoverageOptions wider;
  wider.beamWidth = 0.95 + edge;
  const auto seen = BeamCoverage({&source}, volume.grid, narrower);
  const auto touched = BeamCoverage({&source}, volume.grid, wider);
  const auto check = [&](const SeenVoxel& voxel)
  {
    const double fromRay = std::fmod(voxel.azimuth, 1.0) - 0.5; // of the change from ray to ray
    if (IsInReach(voxel) && std::abs(fromRay) > 0.01)
    {
      const bool scanned = volume.states[voxel.index] != VoxelState::NotScanned;
      ASSERT_TRUE(scanned || seen[voxel.index] == 0) << voxel.azimuth << " " << voxel.elevation;
      ASSERT_TRUE(!scanned || touched[voxel.index] == 1) << voxel.azimuth << " " << voxel.elevation;
    }
  };
  ForEachVoxel(volume.grid, centralSite, check);
}

// A value that is linear in azimuth and in range comes out as such, with rays as uneven as 0.5° to
// 1.4° apart.
TEST(BeamMerge, BilinearInAzimuthAndRangeWithUnevenRays)
{
  NumberSweep sweep = UniformSweep(1, 1.0, 0.0F);
  double azimuth = 0.3;
  for (std::size_t ray = 0; ray < sweep.rays.size(); ++ray)
  {
    sweep.rays[ray].azimuth = azimuth;
    azimuth += ray % 3 == 0 ? 1.4 : ray % 3 == 1 ? 0.5 : 1.1;
    for (std::size_t gate = 0; gate < sweep.gates; ++gate)
    {
      const double range = 1'000.0 * static_cast<double>(gate + 1);
      SetGate(sweep, ray, gate,
        static_cast<float>(10.0 + sweep.rays[ray].azimuth / 20.0 + range / 10'000.0));
    }
  }
  ASSERT_LT(azimuth, 361.0);
  const GriddedVolume volume = MergeAt({VolumeOf({sweep})}, 0.0);
  const BeamModel beam;
  const auto check = [&](const SeenVoxel& voxel)
  {
    const bool near = std::abs(voxel.elevation - 1.0) < halfWidth - edge;
    if (IsInReach(voxel) && near && voxel.azimuth > 1.0 && voxel.azimuth < 359.0)
    {
      const double height = beam.HeightOver(voxel.groundDistance, 1.0);
      const double range = beam.Look({height, voxel.groundDistance}).slantRange;
      ASSERT_WITHIN(volume.values[voxel.index], 10.0 + voxel.azimuth / 20.0 + range / 10'000.0,
        0.018, "interpolation in azimuth and range, dBZ");
    }
  };
  ForEachVoxel(volume.grid, centralSite, check);
}

// No rings, no stripes, no gaps, whatever the rays: every voxel that some beam saw has the value.
TEST(BeamMerge, AConstantFieldComesOutConstantFromLegacyAndSuperResolutionTogether)
{
  const Position other = {39.6, -91.2, 350.0};
  std::vector<NumberSweep> legacy;
  std::vector<NumberSweep> fine;
  int number = 0;
  for (const double elevation : {0.5, 1.45, 2.4, 4.3, 9.9, 19.5})
  {
    ++number;
    legacy.push_back(UniformSweep(number, elevation, 33.5F));
    for (std::size_t i = 0; i < legacy.back().rays.size(); ++i)
    {
      legacy.back().rays[i].azimuth += 0.4F * std::sin(static_cast<float>(7 * i));
    }
    NumberSweep sweep = MakeSweep(number, elevation, 720, 920, 250.0);
    SetAll(sweep, 33.5F);
    for (PolarRay& ray : sweep.rays)
    {
      ray.time = sceneTime;
    }
    fine.push_back(sweep);
  }
  std::vector<PolarVolume> volumes = {VolumeOf(legacy), VolumeOf(fine, other)};
  volumes[1].site.name = "KFIN";
  GridSpecification grid = SceneGrid();
  grid.dimensions[2] = 44; // 11 km: a field that is constant to 18 km and beyond is none (G4)
  const GriddedVolume volume = MergeAt(volumes, 0.0, {}, grid);
  // Beams a little narrower and shorter than they are: their very edges depend on rounding.
  CoverageOptions options;
  options.beamWidth = 0.94;
  std::vector<PolarVolume> shorter = volumes;
  for (PolarVolume& each : shorter)
  {
    for (PolarSweep& sweep : each.sweeps)
    {
      ChangeGates(sweep, TakeLastGates);
    }
  }
  const auto seen = BeamCoverage({&shorter[0], &shorter[1]}, volume.grid, options);
  std::size_t covered = 0;
  for (std::size_t i = 0; i < seen.size(); ++i)
  {
    ASSERT_TRUE(seen[i] == 0 || volume.states[i] == VoxelState::Echo) << i;
    if (volume.states[i] == VoxelState::Echo)
    {
      ASSERT_FLOAT_EQ(volume.values[i], 33.5F);
    }
    covered += seen[i];
  }
  EXPECT_AT_LEAST(covered, 100'000u, "voxels covered");
}

TEST(BeamMerge, ARayThatIsMissingLeavesAGapOfItsOwnWidth)
{
  NumberSweep sweep = UniformSweep(1, 1.0, 20.0F);
  sweep.rays.resize(350); // 350° to 359° are missing
  sweep.values.resize(350 * sweep.gates);
  sweep.states.resize(350 * sweep.gates);
  const GriddedVolume volume = MergeAt({VolumeOf({sweep})}, 0.0);
  const auto check = [&](const SeenVoxel& voxel)
  {
    if (IsInReach(voxel) && std::abs(voxel.elevation - 1.0) < halfWidth - edge)
    {
      const bool missing = voxel.azimuth > 349.6 && voxel.azimuth < 359.4;
      const bool atEdge = (voxel.azimuth > 349.4 && voxel.azimuth <= 349.6) ||
                          (voxel.azimuth >= 359.4 && voxel.azimuth < 359.6);
      const VoxelState expected = missing ? VoxelState::NotScanned : VoxelState::Echo;
      ASSERT_TRUE(atEdge || volume.states[voxel.index] == expected) << voxel.azimuth;
    }
  };
  ForEachVoxel(volume.grid, centralSite, check);
}

// Formulas G6: folded and unsampled gates carry no weight, and their states survive alone.
TEST(BeamMerge, ThreeKindsOfNothingStayApart)
{
  BeamMergeOptions options;
  options.means = false;
  ExpectFourQuarters(options, 0.0);
}

// The same of voxels of 5 km that are means. Between two cells, each up to 2.83 km across, a mean
// has parts of both.
TEST(BeamMerge, ThreeKindsOfNothingStayApartInMeans)
{
  ExpectFourQuarters({}, 1.5 * std::sqrt((25.0 - 1.0) / 3.0) * 1000.0);
}

// Formulas G8: from 40 dBZ at 1° to no echo at 3°, zero is reached half a beam before 3°.
TEST(BeamMerge, AnEchoFallsToNoEchoBelowATiltWithoutOne)
{
  NumberSweep none = UniformSweep(2, 3.0, 0.0F);
  none.states.assign(none.states.size(), GateState::BelowThreshold);
  const auto sweeps = [&none](double echo)
  {
    std::vector<NumberSweep> both = {UniformSweep(1, echo, 40.0F), none};
    return std::vector<PolarVolume>{VolumeOf(both)};
  };
  for (const double echo : {1.0, 5.0})
  {
    const GriddedVolume volume = MergeAt(sweeps(echo), 0.0, AsMeasured());
    const double end = 2.0 - halfWidth;
    const auto check = [&](const SeenVoxel& voxel)
    {
      const double away = std::abs(voxel.elevation - echo);
      const bool between = (voxel.elevation - echo) * (voxel.elevation - 3.0) < 0.0;
      if (!IsInReach(voxel) || !between || std::abs(away - end) < edge)
      {
        return;
      }
      ASSERT_EQ(volume.states[voxel.index] == VoxelState::Echo, away < end) << voxel.elevation;
      if (away < end)
      {
        ASSERT_WITHIN(
          volume.values[voxel.index], 40.0 * (1.0 - away / end), 0.002, "fall to no echo, dBZ");
      }
    };
    ForEachVoxel(volume.grid, centralSite, check);
  }
}

// Formulas G4: the steep cuts end early, above the weather.
TEST(BeamMerge, BeyondTheLastGateThereIsNothingAbove18Kilometres)
{
  NumberSweep sweep = MakeSweep(1, 19.5, 360, 40); // 40 km, where the beam is 14 km high
  for (PolarRay& ray : sweep.rays)
  {
    ray.time = sceneTime;
  }
  GridSpecification grid = SceneGrid();
  grid.dimensions[2] = 120;
  NumberSweep far = UniformSweep(2, 0.5, 20.0F); // the site reaches farther than this sweep
  const GriddedVolume volume = MergeAt({VolumeOf({sweep, far})}, 0.0, AsMeasured(), grid);
  const BeamModel beam;
  std::size_t high = 0;
  const auto check = [&](const SeenVoxel& voxel)
  {
    const double height = beam.HeightOver(voxel.groundDistance, 19.5) + centralSite.altitude;
    if (voxel.groundDistance > 42'000.0 && std::abs(voxel.elevation - 19.5) < halfWidth - edge)
    {
      const VoxelState expected = height > 18'000.0 ? VoxelState::NoEcho : VoxelState::NotScanned;
      ASSERT_EQ(volume.states[voxel.index], expected) << height;
      high += height > 18'000.0;
    }
  };
  ForEachVoxel(grid, centralSite, check);
  EXPECT_AT_LEAST(high, 1'500u, "voxels above 18 km");
}

TEST(BeamMerge, VelocityIsNeverMixedAndPhaseIsMixedOnTheCircle)
{
  const auto alternate = [](MomentName moment, float even, float odd)
  {
    NumberSweep sweep = UniformSweep(1, 1.0, even);
    for (std::size_t ray = 1; ray < sweep.rays.size(); ray += 2)
    {
      for (std::size_t gate = 0; gate < sweep.gates; ++gate)
      {
        SetGate(sweep, ray, gate, odd);
      }
    }
    PolarVolume volume = VolumeOf({sweep});
    volume.moment = moment;
    return MergeAt({volume}, 0.0);
  };
  const GriddedVolume velocity = alternate(MomentName::VEL, -24.0F, 24.0F);
  for (std::size_t i = 0; i < velocity.values.size(); ++i)
  {
    ASSERT_TRUE(velocity.states[i] != VoxelState::Echo || std::abs(velocity.values[i]) > 23.99F);
  }
  const GriddedVolume phase = alternate(MomentName::PHI, 350.0F, 10.0F);
  for (std::size_t i = 0; i < phase.values.size(); ++i)
  {
    const float turned = std::remainder(phase.values[i], 360.0F);
    ASSERT_TRUE(phase.states[i] != VoxelState::Echo || std::abs(turned) < 10.01F);
    ASSERT_TRUE(
      phase.states[i] != VoxelState::Echo || (phase.values[i] >= 0.0F && phase.values[i] < 360.0F));
  }
}

TEST(BeamMerge, LinearReflectivityIsAnOption)
{
  const std::vector<PolarVolume> volumes = {
    VolumeOf({UniformSweep(1, 1.0, 20.0F), UniformSweep(2, 3.0, 40.0F)})};
  BeamMergeOptions options;
  options.linearReflectivity = true;
  const GriddedVolume volume = MergeAt(volumes, 0.0, options);
  const auto check = [&](const SeenVoxel& voxel)
  {
    if (IsInReach(voxel) && voxel.elevation > 1.0 && voxel.elevation < 3.0)
    {
      const double share = (voxel.elevation - 1.0) / 2.0;
      const double z = (1.0 - share) * 100.0 + share * 10'000.0;
      ASSERT_WITHIN(volume.values[voxel.index], 10.0 * std::log10(z), 0.0012,
        "interpolation of linear reflectivity, dBZ");
    }
  };
  ForEachVoxel(volume.grid, centralSite, check);
}

TEST(BeamMerge, FillingIsAnOption)
{
  const std::vector<PolarVolume> volumes = {VolumeOf({UniformSweep(1, 2.0, 20.0F)})};
  BeamMergeOptions options;
  options.fillColumns = true;
  const GriddedVolume open = MergeAt(volumes, 0.0);
  const GriddedVolume filled = MergeAt(volumes, 0.0, options);
  const auto check = [&](const SeenVoxel& voxel)
  {
    if (IsInReach(voxel) && std::abs(voxel.elevation - 2.0 + halfWidth) > edge)
    {
      const bool below = voxel.elevation < 2.0 - halfWidth;
      ASSERT_TRUE(!below || open.states[voxel.index] == VoxelState::NotScanned);
      // Near the site no level lies in the beam, and there is nothing to fill with.
      const bool seen = voxel.groundDistance > 20'000.0 && voxel.elevation < 2.4;
      ASSERT_TRUE(!seen || filled.states[voxel.index] == VoxelState::Echo);
      ASSERT_TRUE(!seen || std::abs(filled.values[voxel.index] - 20.0F) < 1e-3F);
    }
  };
  ForEachVoxel(open.grid, centralSite, check);
  EXPECT_GT(Count(filled, VoxelState::Echo), Count(open, VoxelState::Echo));
}

TEST(BeamMerge, RefusesAGridWithoutVoxels)
{
  GridSpecification empty = SceneGrid();
  empty.dimensions[2] = 0;
  EXPECT_THROW(BeamMerger{empty}, Error);
}

TEST(BeamMerge, WithoutVolumesNothingIsScanned)
{
  const GriddedVolume volume = MergeAt({}, 0.0);
  EXPECT_EQ(Count(volume, VoxelState::NotScanned), volume.grid.VoxelCount());
  // Nor with sweeps that hold nothing.
  const GriddedVolume hollow = MergeAt({VolumeOf({MakeSweep(1, 1.0, 1, 0)})}, 0.0);
  EXPECT_EQ(Count(hollow, VoxelState::NotScanned), hollow.grid.VoxelCount());
}

TEST(BeamMerge, StopsWhenAskedTo)
{
  const PolarVolume volume = VolumeOf({UniformSweep(1, 1.0, 20.0F)});
  BeamMerger merger(SceneGrid());
  EXPECT_FALSE(MergePolar(merger, {&volume}, sceneTime, {}, [](double) { return false; }));
}
