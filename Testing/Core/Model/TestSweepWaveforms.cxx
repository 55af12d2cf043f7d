// SPDX-License-Identifier: BSD-3-Clause
#include "Tolerance.h"
#include "nexrad/Model/Elevation.h"
#include "nexrad/Model/SiteTable.h"
#include "nexrad/Model/SweepWaveforms.h"

#include <gtest/gtest.h>

using namespace nexrad;

namespace
{

struct CutPlan
{
  float elevation = 0.5F;
  bool velocity = false;
  float range = 466'000.0F;
  float nyquist = 0.0F;
};

RadarVolume MakeVolume(const std::string& site, const std::vector<CutPlan>& cuts)
{
  RadarVolume volume;
  volume.site.name = site;
  for (const CutPlan& cut : cuts)
  {
    Ray ray;
    ray.elevation = cut.elevation;
    ray.unambiguousRange = cut.range;
    ray.nyquist = cut.nyquist;
    ray.Row(MomentName::REF).gates = 460;
    ray.Row(MomentName::VEL).gates = cut.velocity ? 920 : 0;
    volume.sweeps.push_back({static_cast<int>(volume.sweeps.size()) + 1, {ray, ray, ray}});
  }
  return volume;
}

std::vector<Waveform> WaveformsOf(RadarVolume volume)
{
  ResolveWaveforms(volume);
  std::vector<Waveform> waveforms;
  for (const Sweep& sweep : volume.sweeps)
  {
    waveforms.push_back(sweep.waveform);
  }
  return waveforms;
}

float RangeOf(const std::string& site, const CutPlan& cut)
{
  RadarVolume volume = MakeVolume(site, {cut});
  ResolveWaveforms(volume);
  return volume.sweeps[0].rays[1].unambiguousRange;
}

constexpr Waveform surveillance = Waveform::ContiguousSurveillance;
constexpr Waveform doppler = Waveform::ContiguousDoppler;
constexpr Waveform dopplerWithout = Waveform::ContiguousDopplerWithout;

} // namespace

// The cuts of KVWX, 2005-06-26, whose message 5 is zeros and whose cuts all have reflectivity: its
// split cuts have 460 gates in both halves.
TEST(SweepWaveforms, FollowFromTheRaysWithoutMessage5)
{
  EXPECT_EQ(
    WaveformsOf(MakeVolume("KVWX", {{0.5F, false}, {0.5F, true}, {1.5F, false}, {1.5F, true},
                                     {2.4F, true}, {6.0F, true}, {9.9F, true}})),
    (std::vector<Waveform>{surveillance, doppler, surveillance, doppler, Waveform::Batch,
      Waveform::Batch, dopplerWithout}));
  // A Doppler half that has lost the other one is none of a batch cut; nor is one at 2.5°.
  EXPECT_EQ(WaveformsOf(MakeVolume("KVWX", {{0.5F, true}, {2.5F, false}, {2.5F, true}})),
    (std::vector<Waveform>{doppler, surveillance, doppler}));
  EXPECT_EQ(WaveformsOf(MakeVolume("TDAL", {{0.5F, false}, {0.5F, true}, {3.1F, true}})),
    (std::vector<Waveform>{surveillance, dopplerWithout, dopplerWithout}));
}

TEST(SweepWaveforms, AreThoseOfMessage5WhereItsCutFits)
{
  RadarVolume volume = MakeVolume("KTLX", {{0.48F, false}, {0.48F, true}, {3.5F, true}});
  volume.coveragePattern = CoveragePattern{31,
    {{0.5, surveillance, true, 5.0}, {0.5, doppler, true, 5.0}, {3.5, dopplerWithout, false, 5.0}}};
  const std::vector<Waveform> told = {surveillance, doppler, dopplerWithout};
  EXPECT_EQ(WaveformsOf(volume), told);
  // Of another pattern: another angle, or velocity in a surveillance cut.
  volume.coveragePattern->cuts[2].elevation = 2.9;
  volume.coveragePattern->cuts[1].waveform = surveillance;
  EXPECT_EQ(WaveformsOf(volume), (std::vector<Waveform>{surveillance, doppler, Waveform::Batch}));
  volume.coveragePattern->cuts.resize(2);
  EXPECT_EQ(WaveformsOf(volume).back(), Waveform::Batch);
}

// c·λ/(8·26.35) with λ = 11.1 cm is 157.9 km, by hand; the ray itself says 148.
TEST(SweepWaveforms, AnUnknownRangeFollowsFromTheNyquistVelocity)
{
  EXPECT_EQ(RangeOf("KVWX", {0.5F, true, 148'000.0F, 26.35F}), 148'000.0F);
  for (const float nonsense : {0.0F, 100.0F, 6'553'500.0F})
  {
    EXPECT_WITHIN(
      RangeOf("KVWX", {0.5F, true, nonsense, 26.35F}), 157'861.0F, 1.3F, "unambiguous range, m");
    EXPECT_EQ(RangeOf("KVWX", {0.5F, true, nonsense, 0.0F}), 0.0F);
    EXPECT_EQ(RangeOf("TDAL", {0.5F, true, nonsense, 26.35F}), 0.0F);
  }
}

TEST(Elevation, OfACutIsTheMedianOfItsRays)
{
  EXPECT_EQ(MedianOf({}), 0.0);
  EXPECT_EQ(MedianOf({0.5, 38.0, 0.52, -4.0, 0.48}), 0.5);
  EXPECT_EQ(MedianOf({0.4, 0.6}), 0.6);
  EXPECT_FALSE(IsStray(1.37, 0.9, 0.95));
  EXPECT_TRUE(IsStray(1.38, 0.9, 0.95));
  EXPECT_TRUE(IsStray(-4.0, 0.9, 0.95));
}

TEST(SiteTable, KnowsTerminalRadarsByTheirNames)
{
  EXPECT_TRUE(IsTerminal({"TDAL", {}}));
  EXPECT_FALSE(IsTerminal({"KTLX", {}}));
  EXPECT_FALSE(IsTerminal({"", {}}));
  EXPECT_EQ(BeamWidthOf({"TDAL", {}}), 0.55);
  EXPECT_EQ(BeamWidthOf({"KTST", {}}), 0.95);
}
