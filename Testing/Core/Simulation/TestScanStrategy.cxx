// SPDX-License-Identifier: BSD-3-Clause
#include "TestData.h"
#include "Tolerance.h"
#include "nexrad/Level2/Level2File.h"
#include "nexrad/Simulation/RadarSimulator.h"
#include "nexrad/Simulation/ScanStrategy.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace nexrad;

namespace
{

// Compares the simulator's pattern with message 5 of a real file.
void CompareWithMessage5(const std::filesystem::path& file, int number)
{
  const RadarVolume volume = ReadLevel2(file);
  ASSERT_TRUE(volume.coveragePattern) << file;
  ASSERT_EQ(volume.coveragePattern->number, number) << file;
  const std::vector<ScanCut>* cuts = FindScanStrategy(number);
  ASSERT_NE(cuts, nullptr);
  ASSERT_EQ(cuts->size(), volume.coveragePattern->cuts.size()) << number;
  for (std::size_t index = 0; index < cuts->size(); ++index)
  {
    const CoverageCut& cut = (*cuts)[index].cut;
    const CoverageCut& truth = volume.coveragePattern->cuts[index];
    EXPECT_NEAR(cut.elevation, truth.elevation, 0.001) << number << " cut " << index;
    EXPECT_EQ(cut.waveform, truth.waveform) << number << " cut " << index;
    EXPECT_EQ(cut.superResolution, truth.superResolution) << number << " cut " << index;
    EXPECT_NEAR(cut.azimuthRate, truth.azimuthRate, 0.001) << number << " cut " << index;
  }
}

double SecondsOf(const Sweep& sweep)
{
  return ToSeconds(sweep.rays.back().time) - ToSeconds(sweep.rays.front().time);
}

// Compares gates, rays, velocities and durations with the sweeps of a real message 1 file.
void CompareWithMessage1(const std::filesystem::path& file, int number)
{
  const RadarVolume volume = ReadLevel2(file);
  const std::vector<ScanCut>& cuts = *FindScanStrategy(number);
  ASSERT_EQ(volume.sweeps.size(), cuts.size()) << file;
  for (std::size_t index = 0; index < cuts.size(); ++index)
  {
    const CutLayout layout = LayOut(cuts[index], false);
    const Sweep& sweep = volume.sweeps[index];
    const Ray& ray = sweep.rays[sweep.rays.size() / 2];
    const std::string where = file.filename().string() + " cut " + std::to_string(index);
    const MomentRow& reflectivity = ray.Row(MomentName::REF);
    const MomentRow& velocity = ray.Row(MomentName::VEL);
    // One cut in one pattern differs: KLIX has 356 gates at 2.4 degrees, KBGM 336.
    EXPECT_WITHIN(layout.reflectivity.gates, reflectivity.gates, 20.0,
      "gates of reflectivity against a real cut")
      << where;
    EXPECT_EQ(layout.reflectivity.gates > 0, reflectivity.gates > 0) << where;
    EXPECT_EQ(layout.doppler.gates, velocity.gates) << where;
    if (velocity.gates > 0)
    {
      EXPECT_EQ(layout.doppler.firstGate, velocity.firstGate) << where;
      EXPECT_EQ(layout.doppler.gateSpacing, velocity.gateSpacing) << where;
      // The wavelengths of radars differ.
      EXPECT_WITHIN(NyquistVelocity(cuts[index].unambiguousRange) / ray.nyquist, 1.0, 0.05,
        "Nyquist velocity, part of a real cut's")
        << where;
    }
    EXPECT_WITHIN(
      layout.rays, static_cast<double>(sweep.rays.size()), 2.0, "rays against a real cut")
      << where;
    const double duration = layout.rays * layout.raySpacing / cuts[index].cut.azimuthRate;
    EXPECT_WITHIN(duration / SecondsOf(sweep), 1.0, 0.018, "duration, part of a real cut's")
      << where;
  }
}

} // namespace

TEST(ScanStrategy, AgreesWithMessage5OfRealFiles)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  const std::filesystem::path folder = data / "level2";
  CompareWithMessage5(folder / "superres/example_nexrad_archive_msg31.bz2", 11);
  CompareWithMessage5(folder / "multisite-20100911/KENX20100911_011108_V03.gz", 21);
  CompareWithMessage5(folder / "superres/KDMX20250101_225441_V06", 31);
  CompareWithMessage5(folder / "superres/KLSX20130206_175044_V06.gz", 32);
  CompareWithMessage5(folder / "superres/KLOT20220317_000842_V06", 35);
  CompareWithMessage5(folder / "multisite-20100911/KTYX20100911_012210_V04.gz", 121);
  CompareWithMessage5(folder / "superres/KBLX20090603_004417_V03.gz", 212);
  CompareWithMessage5(folder / "damaged/KJGX19700101_000000_V06", 215);
}

TEST(ScanStrategy, LaysGatesAsRealMessage1FilesDo)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  const std::filesystem::path folder = data / "level2";
  CompareWithMessage1(folder / "run-kbgm-20050821/KBGM20050821_024323.gz", 21);
  CompareWithMessage1(folder / "pairs/KLIX20050828_180149.gz", 11);
  CompareWithMessage1(folder / "legacy/KABR20050101_000745.gz", 32);
}

// Many rays of that file are missing; its gates and velocities are whole.
TEST(ScanStrategy, Pattern12IsThatOfARealFile)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  const RadarVolume volume = ReadLevel2(data / "level2/pairs/KBBX20060113_165921.gz");
  const std::vector<ScanCut>& cuts = *FindScanStrategy(12);
  ASSERT_EQ(volume.sweeps.size(), cuts.size());
  for (std::size_t index = 0; index < cuts.size(); ++index)
  {
    const CutLayout layout = LayOut(cuts[index], false);
    const Ray& ray = volume.sweeps[index].rays[50];
    EXPECT_EQ(layout.reflectivity.gates, ray.Row(MomentName::REF).gates) << index;
    EXPECT_EQ(layout.doppler.gates, ray.Row(MomentName::VEL).gates) << index;
    EXPECT_WITHIN(volume.sweeps[index].MeanElevation(), cuts[index].cut.elevation, 0.085,
      "mean elevation against the pattern's, degrees")
      << index;
  }
}

TEST(ScanStrategy, Message31CutsHaveFineGates)
{
  const std::vector<ScanCut>& cuts = *FindScanStrategy(212);
  const CutLayout surveillance = LayOut(cuts[0], true);
  EXPECT_EQ(surveillance.reflectivity.gates, 1832);
  EXPECT_EQ(surveillance.reflectivity.firstGate, 2125);
  EXPECT_EQ(surveillance.doppler.gates, 0);
  EXPECT_EQ(surveillance.rays, 720);
  const CutLayout doppler = LayOut(cuts[1], true);
  EXPECT_EQ(doppler.reflectivity.gates, 1192);
  EXPECT_EQ(doppler.doppler.gates, 1192);
  const CutLayout high = LayOut(cuts.back(), true);
  EXPECT_EQ(high.rays, 360);
  EXPECT_WITHIN(high.reflectivity.gates, 232, 10,
    "gates of the last cut"); // as the last cut of KBLX, 2009-06-03
}

// Real files give no gate beyond: the pulses cannot tell what comes back from there.
TEST(ScanStrategy, CutsWithoutAmbiguityResolutionEndAtTheirRange)
{
  for (const int number : KnownCoveragePatterns())
  {
    for (const ScanCut& cut : *FindScanStrategy(number))
    {
      for (const bool superResolution : {false, true})
      {
        const GateLayout gates = LayOut(cut, superResolution).reflectivity;
        if (cut.cut.waveform == Waveform::ContiguousDopplerWithout)
        {
          EXPECT_LE(gates.Range(gates.gates - 1), cut.unambiguousRange * 1000.0)
            << number << ' ' << cut.cut.elevation;
        }
      }
    }
  }
}

TEST(ScanStrategy, KnowsThePatternsThatItNames)
{
  EXPECT_EQ(KnownCoveragePatterns(), (std::vector<int>{11, 12, 21, 31, 32, 35, 121, 212, 215}));
  EXPECT_EQ(FindScanStrategy(99), nullptr);
  EXPECT_WITHIN(ToSeconds(Time(VolumePeriod(21))), 347.0, 1.8,
    "period of a volume, s"); // the pace of KBGM, 2005-08-21
}
