// SPDX-License-Identifier: BSD-3-Clause
// Which cuts of their patterns small synthetic volumes have, and what ended them.
#include "nexrad/Level2/Level2File.h"

#include "Level2Bytes.h"
#include "Remarks.h"
#include "nexrad/Model/RadarVolume.h"

#include <gtest/gtest.h>

using namespace nexrad;
using namespace nexrad::testing;

namespace
{

// Writes one volume after the other into a file.
class FileOfCuts
{
public:
  FileOfCuts& Pattern(unsigned number, const std::vector<double>& angles)
  {
    pattern = number;
    parts.push_back(MakeMessage5(number, angles));
    return *this;
  }

  // A turn of 36 rays; `rays` of them are scanned.
  FileOfCuts& Cut(unsigned number, unsigned firstStatus = 0, unsigned lastStatus = 2,
    unsigned rays = 36, unsigned messageType = 31)
  {
    for (unsigned index = 0; index < rays; ++index)
    {
      RayPlan plan;
      plan.pattern = pattern;
      plan.cut = number;
      plan.number = index + 1;
      plan.azimuth = 10.0 * index;
      plan.elevation = 0.5 * number;
      plan.milliseconds = clock += 400; // a turn takes 14.4 s
      plan.status = index == 0 ? firstStatus : index + 1 == rays ? lastStatus : 1;
      parts.push_back(messageType == 1 ? MakeMessage1(plan) : MakeMessage31(plan));
    }
    return *this;
  }

  FileOfCuts& Wait(unsigned milliseconds)
  {
    clock += milliseconds;
    return *this;
  }

  RadarVolume Decode() const
  {
    return DecodeLevel2(Join({MakeVolumeHeader(), Join(parts)}), "file");
  }

private:
  std::vector<Bytes> parts;
  unsigned pattern = 21;
  std::uint32_t clock = 9'799'000;
};

const std::vector<double> fiveAngles = {0.5, 1.0, 1.5, 2.0, 2.5};

} // namespace

TEST(VolumeCuts, AWholeVolumeLacksNothing)
{
  const RadarVolume volume =
    FileOfCuts().Pattern(35, fiveAngles).Cut(1, 3).Cut(2).Cut(3).Cut(4).Cut(5, 5, 4).Decode();
  EXPECT_TRUE(volume.damage.empty()) << DamageOf(volume);
  EXPECT_TRUE(volume.complete);
  ASSERT_EQ(volume.cuts.size(), 1U);
  EXPECT_EQ(volume.cuts[0].expected, 5);
  EXPECT_EQ(volume.cuts[0].patternNumber, 35);
  EXPECT_TRUE(volume.cuts[0].missing.empty());
  EXPECT_EQ(volume.cuts[0].end, VolumeEnd::LastCut);
}

TEST(VolumeCuts, AMissingInteriorCutIsDamage)
{
  const RadarVolume volume =
    FileOfCuts().Pattern(35, fiveAngles).Cut(1, 3).Cut(4).Cut(5, 5, 4).Decode();
  EXPECT_EQ(
    DamageOf(volume), "cuts 2 and 3 of 5 are missing: the elevation numbers go from 1 to 4\n");
  EXPECT_FALSE(volume.complete);
  EXPECT_EQ(volume.cuts[0].missing, (std::vector<int>{2, 3}));
  EXPECT_EQ(volume.cuts[0].end, VolumeEnd::LastCut);
  // Without a pattern the numbers alone tell.
  EXPECT_EQ(DamageOf(FileOfCuts().Cut(1, 3).Cut(3, 5, 4).Decode()),
    "cut 2 is missing: the elevation numbers go from 1 to 3\n");
  EXPECT_EQ(DamageOf(FileOfCuts().Cut(2).Cut(3, 5, 4).Decode()),
    "cut 1 is missing: the first elevation number is 2\n");
}

// People hand out single tilts of a volume; a loss takes some cuts, not most of them.
TEST(VolumeCuts, AFewCutsWithTheEndAreAnExcerpt)
{
  const RadarVolume volume = FileOfCuts().Pattern(35, fiveAngles).Cut(2, 3).Cut(5, 0, 4).Decode();
  EXPECT_EQ(DamageOf(volume), "");
  EXPECT_FALSE(volume.complete);
  EXPECT_TRUE(volume.cuts[0].excerpt);
  EXPECT_EQ(volume.cuts[0].missing, (std::vector<int>{1, 3, 4}));
  EXPECT_EQ(
    DescribeCuts(volume.cuts[0]).front(), "an excerpt of a volume: without cuts 1, 3 and 4 of 5");
  EXPECT_NE(DamageOf(FileOfCuts().Pattern(35, fiveAngles).Cut(2, 3).Cut(5).Decode()), "")
    << "without its end it may be what a loss left";
}

TEST(VolumeCuts, AVolumeThatTheRadarEndsEarlyIsNoDamage)
{
  const RadarVolume volume =
    FileOfCuts().Pattern(212, fiveAngles).Cut(1, 3).Cut(2).Cut(3, 5, 4).Decode();
  EXPECT_TRUE(volume.damage.empty()) << DamageOf(volume);
  EXPECT_TRUE(volume.complete);
  EXPECT_EQ(volume.cuts[0].end, VolumeEnd::Early);
  EXPECT_EQ(volume.cuts[0].notScanned, (std::vector<int>{4, 5}));
  EXPECT_TRUE(HasNote(volume, "the radar ended the volume after cut 3 of 5, as AVSET does"));
}

TEST(VolumeCuts, AMissingEndNamesTheCutsThatAreLost)
{
  const RadarVolume volume =
    FileOfCuts().Pattern(212, fiveAngles).Cut(1, 3).Cut(2).Cut(3, 0, 2).Decode();
  EXPECT_EQ(
    DamageOf(volume), "no end of volume: its last rays are missing, and cuts 4 and 5 of 5\n");
  EXPECT_FALSE(volume.complete);
  EXPECT_EQ(volume.cuts[0].end, VolumeEnd::Missing);
  EXPECT_EQ(volume.cuts[0].missing, (std::vector<int>{4, 5}));
}

TEST(VolumeCuts, LowCutsThatAreScannedAgainAreNoted)
{
  const RadarVolume sails =
    FileOfCuts().Pattern(212, {0.5, 1.0, 1.5, 0.5}).Cut(1, 3).Cut(2).Cut(3).Cut(4, 5, 4).Decode();
  EXPECT_EQ(sails.cuts[0].repeated, (std::vector<int>{4}));
  EXPECT_TRUE(HasNote(sails, "cut 4 again at the lowest elevation (SAILS)"));
  const RadarVolume mrle = FileOfCuts()
                             .Pattern(212, {0.5, 1.0, 1.5, 0.5, 1.0, 2.0})
                             .Cut(1, 3)
                             .Cut(2)
                             .Cut(3)
                             .Cut(4)
                             .Cut(5)
                             .Cut(6, 5, 4)
                             .Decode();
  EXPECT_EQ(mrle.cuts[0].repeated, (std::vector<int>{4, 5}));
  EXPECT_TRUE(HasNote(mrle, "cuts 4 and 5 again at low elevations (MRLE)"));
}

// The pattern of message 1 is known without message 5, which was empty then.
TEST(VolumeCuts, PatternsOfMessage1AreKnown)
{
  FileOfCuts file;
  file.Cut(1, 3, 2, 36, 1).Cut(2, 0, 2, 36, 1);
  EXPECT_EQ(file.Decode().cuts[0].expected, 11);
  EXPECT_EQ(DamageOf(file.Decode()),
    "no end of volume: its last rays are missing, and cuts 3 to 11 of 11\n");
}

TEST(VolumeCuts, ARestartOfTheRadarIsAShortVolume)
{
  FileOfCuts file;
  file.Pattern(35, fiveAngles).Cut(1, 3).Cut(2, 0, 1, 20).Wait(5'000);
  file.Pattern(12, {0.5, 1.0}).Cut(1, 3).Cut(2, 5, 4);
  const RadarVolume volume = file.Decode();
  EXPECT_TRUE(volume.damage.empty()) << DamageOf(volume);
  EXPECT_TRUE(volume.complete);
  EXPECT_TRUE(HasNote(
    volume, "volume 1 of the file: the radar broke the volume off after cut 2 of 5 and began"));
  const std::vector<RadarVolume> cycles = SplitCycles(volume);
  ASSERT_EQ(cycles.size(), 2U);
  EXPECT_EQ(cycles[0].sweeps.size(), 2U);
  EXPECT_EQ(cycles[0].cuts.at(0).end, VolumeEnd::NewVolume);
  EXPECT_EQ(cycles[0].cuts[0].notScanned, (std::vector<int>{3, 4, 5}));
  EXPECT_EQ(cycles[0].coveragePatternNumber, 35);
  EXPECT_EQ(cycles[1].coveragePatternNumber, 12);
  EXPECT_EQ(cycles[1].coveragePattern.value().cuts.size(), 2U);
  EXPECT_EQ(cycles[1].cuts.at(0).end, VolumeEnd::LastCut);
}

// In 45 s the radar may have scanned most of the rest, which the file lost.
TEST(VolumeCuts, ALaterVolumeIsNoRestart)
{
  FileOfCuts file;
  file.Pattern(35, fiveAngles).Cut(1, 3).Cut(2, 0, 1, 20).Wait(45'000).Cut(1, 3).Cut(2);
  const RadarVolume volume = file.Cut(3).Cut(4).Cut(5, 5, 4).Decode();
  EXPECT_EQ(DamageOf(volume), "cuts 3 to 5 of 5 are missing before the next volume\n"
                              "rays missing at the end of sweep 1 (elevation number 2)\n");
  EXPECT_FALSE(volume.complete);
}

// The file of the new volume tells what became of the one before.
TEST(VolumeCuts, ARestartInTheNextFileIsAShortVolume)
{
  constexpr unsigned taken = 22'400; // ms, of the first file
  FileOfCuts first;
  first.Pattern(35, fiveAngles).Cut(1, 3).Cut(2, 0, 1, 20);
  RadarVolume volume = first.Decode();
  ASSERT_TRUE(LacksEnd(volume));
  FileOfCuts later;
  EndWithNext(volume, later.Wait(taken + 45'000).Cut(1, 3).Cut(2, 5, 4).Decode());
  FileOfCuts within;
  EndWithNext(volume, within.Wait(taken + 5'000).Cut(1).Cut(2, 5, 4).Decode());
  FileOfCuts next;
  RadarVolume ofOther = next.Wait(taken + 5'000).Cut(1, 3).Cut(2, 5, 4).Decode();
  ofOther.site.name = "KOUN";
  EndWithNext(volume, ofOther);
  EXPECT_EQ(DamageOf(volume), DamageOf(first.Decode()));
  EXPECT_NE(DamageOf(volume), "");
  EndWithNext(volume, next.Decode());
  EXPECT_EQ(DamageOf(volume), "");
  EXPECT_TRUE(volume.complete);
  EXPECT_FALSE(LacksEnd(volume));
  EXPECT_EQ(volume.cuts[0].end, VolumeEnd::NewVolume);
  EXPECT_EQ(volume.cuts[0].notScanned, (std::vector<int>{3, 4, 5}));
  EXPECT_TRUE(volume.cuts[0].missing.empty());
  EXPECT_TRUE(HasNote(
    volume, "the radar broke the volume off after cut 2 of 5 and began a new one, of file"));
}
