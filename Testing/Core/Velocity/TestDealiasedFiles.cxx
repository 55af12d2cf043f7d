// SPDX-License-Identifier: BSD-3-Clause
// Formulas V4 on real files: sweeps folded again at half of their Nyquist velocity, and the share
// of neighbours that differ by more than it before and after.
#include "FoldScore.h"
#include "TestData.h"
#include "Tolerance.h"
#include "VelocityScan.h"
#include "nexrad/Level2/Level2File.h"
#include "nexrad/Velocity/Dealiasing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <functional>
#include <ostream>
#include <string>

using namespace nexrad;
using namespace nexrad::testing;

namespace
{

VelocityVolume ReadVelocities(const std::filesystem::path& folder, const std::string& name)
{
  return MakeVelocityVolume(MakePolarVolume(ReadLevel2(folder / "level2" / name), MomentName::VEL));
}

// What is found in velocities folded at half of the Nyquist velocity, against what is found in
// those of the file.
FoldScore ScoreAtHalf(VelocityVolume truth)
{
  Dealias(truth);
  VelocityVolume volume = truth;
  for (VelocitySweep& sweep : volume.sweeps)
  {
    FoldVelocities(sweep, 0.5F * sweep.rays.front().nyquist);
  }
  Dealias(volume);
  return CompareFolds(truth, volume);
}

} // namespace

struct HalvedFile
{
  const char* name;
  double right;   // at least, % of the folds that are known
  double smooth;  // at least, % of smooth gates
  double unknown; // at most, %
};

// In the names of the tests.
void PrintTo(const HalvedFile& file, std::ostream* stream)
{
  *stream << std::filesystem::path(file.name).stem().string();
}

class HalvedNyquist : public ::testing::TestWithParam<HalvedFile>
{
};

TEST_P(HalvedNyquist, IsRecovered)
{
  NEXRAD_REQUIRE_TEST_DATA(folder);
  const HalvedFile& file = GetParam();
  const FoldScore score = ScoreAtHalf(ReadVelocities(folder, file.name));
  EXPECT_AT_LEAST(score.RightShare(), file.right,
    std::string(file.name) + " at half its Nyquist velocity: right folds of those known, %");
  EXPECT_AT_LEAST(score.SmoothRightShare(), file.smooth,
    std::string(file.name) + " at half its Nyquist velocity: right folds among smooth gates, %");
  EXPECT_AT_MOST(score.UnknownShare(), file.unknown,
    std::string(file.name) + " at half its Nyquist velocity: gates without a fold, %");
}

INSTANTIATE_TEST_SUITE_P(RealFiles, HalvedNyquist,
  ::testing::Values(HalvedFile{"legacy/KTLX19990503_235621.gz", 99.8, 99.95, 0.39},
    HalvedFile{"legacy/KVWX_20050626_221551.gz", 99.93, 99.993, 0.8},
    HalvedFile{"superres/KCRP20170826_044114.bin", 99.8, 99.9985, 1.7},
    HalvedFile{"superres/KBLX20090603_004417_V03.gz", 99.95, 99.997, 0.35},
    HalvedFile{"multisite-20100911/KENX20100911_011108_V03.gz", 99.9, 99.99, 1.15},
    HalvedFile{"superres/PGUA20160602_055618_V06.raw.gz", 99.8, 99.98, 0.4},
    HalvedFile{"quality/KLSX19930707_040351.gz", 99.85, 99.95, 0.3},
    // An eighth of its velocities are noise about the radar, which no neighbour can place: more
    // than 99.5 % are right among smooth gates alone.
    HalvedFile{"superres/KDMX20220305_232324.bin", 98.2, 99.7, 6.0}));

struct JumpyFile
{
  const char* name;
  double before;  // at least, % of pairs
  double after;   // at most
  double unknown; // at most, % of gates
};

// In the names of the tests.
void PrintTo(const JumpyFile& file, std::ostream* stream)
{
  *stream << std::filesystem::path(file.name).stem().string();
}

class Jumps : public ::testing::TestWithParam<JumpyFile>
{
};

TEST_P(Jumps, BecomeFew)
{
  NEXRAD_REQUIRE_TEST_DATA(folder);
  const JumpyFile& file = GetParam();
  VelocityVolume volume = ReadVelocities(folder, file.name);
  const std::string name = file.name;
  EXPECT_AT_LEAST(CountJumps(volume).Share(), file.before,
    name + ": neighbours that differ by more than the Nyquist velocity in the file, %");
  const DealiasCounts counts = Dealias(volume);
  EXPECT_AT_MOST(CountJumps(volume).Share(), file.after,
    name + ": neighbours that differ by more than the Nyquist velocity, dealiased, %");
  EXPECT_AT_MOST(100.0 * static_cast<double>(counts.unknown) / static_cast<double>(counts.measured),
    file.unknown, name + ": gates without a fold, %");
}

INSTANTIATE_TEST_SUITE_P(RealFiles, Jumps,
  ::testing::Values(JumpyFile{"legacy/KTLX19990503_235621.gz", 1.1, 0.014, 0.12},
    JumpyFile{"legacy/KVWX_20050626_221551.gz", 0.06, 0.0005, 0.5},
    JumpyFile{"superres/KCRP20170826_044114.bin", 1.8, 0.05, 1.4}));

namespace
{

// The largest difference of two rays beside each other, m/s, among gates of a part of a sweep: the
// azimuths in degrees, the ranges in m.
double LargestShear(const VelocitySweep& sweep, double fromAzimuth, double toAzimuth,
  double fromRange, double toRange)
{
  double largest = 0.0;
  for (std::size_t ray = 0; ray + 1 < sweep.rays.size(); ++ray)
  {
    const auto azimuth = static_cast<double>(sweep.rays[ray].azimuth);
    for (std::size_t gate = 0; gate < sweep.gates; ++gate)
    {
      const double difference = static_cast<double>(
        sweep.values[sweep.Index(ray + 1, gate)] - sweep.values[sweep.Index(ray, gate)]);
      const double range = sweep.RangeOf(gate);
      if (azimuth > fromAzimuth && azimuth < toAzimuth && range > fromRange && range < toRange &&
          difference > largest)
      {
        largest = difference;
      }
    }
  }
  return largest;
}

} // namespace

// The tornado of 1999-05-03, 23:56 UTC, 257° and 38 km from KTLX: 29 m/s towards the radar beside
// 22 m/s away from it. The file has 24 m/s and 22 m/s away from it.
TEST(DealiasedFile, KeepsTheCoupletOfATornado)
{
  NEXRAD_REQUIRE_TEST_DATA(folder);
  VelocityVolume volume = ReadVelocities(folder, "legacy/KTLX19990503_235621.gz");
  EXPECT_AT_MOST(LargestShear(volume.sweeps.front(), 255.0, 259.0, 37'000.0, 40'000.0), 21.0,
    "velocity difference of the couplet in the file, m/s");
  Dealias(volume);
  EXPECT_AT_LEAST(LargestShear(volume.sweeps.front(), 255.0, 259.0, 37'000.0, 40'000.0), 49.0,
    "velocity difference of the couplet, dealiased, m/s");
}

// The sweeps that place each other may be worked on in any order, by any number of threads.
TEST(DealiasedFile, IsTheSameInWhateverOrderItsSweepsArePlaced)
{
  NEXRAD_REQUIRE_TEST_DATA(folder);
  const VelocityVolume measured = ReadVelocities(folder, "superres/KLSX20130206_175044_V06.gz");
  VelocityVolume forward = measured;
  Dealias(forward);
  DealiasOptions options;
  options.loop = [](int count, const std::function<void(int, int)>& work)
  {
    for (int index = count - 1; index >= 0; --index)
    {
      work(index, index + 1);
    }
  };
  VelocityVolume backward = measured;
  Dealias(backward, options);
  ASSERT_EQ(forward.sweeps.size(), backward.sweeps.size());
  for (std::size_t sweep = 0; sweep < forward.sweeps.size(); ++sweep)
  {
    EXPECT_EQ(forward.sweeps[sweep].states, backward.sweeps[sweep].states) << "sweep " << sweep;
    EXPECT_EQ(std::memcmp(forward.sweeps[sweep].values.data(), backward.sweeps[sweep].values.data(),
                forward.sweeps[sweep].values.size() * sizeof(float)),
      0)
      << "sweep " << sweep; // NaN equals itself, bit by bit
  }
}
