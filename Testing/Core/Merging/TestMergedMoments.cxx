// SPDX-License-Identifier: BSD-3-Clause
// Several moments merged in one run are those of runs for one moment each.
#include "nexrad/Merging/SeriesMerger.h"

#include "HandMadeVolume.h"
#include "Scans/RadarsOfMissouri.h"
#include "TestData.h"
#include "VolumePart.h"
#include "nexrad/Grid/GriddedVolume.h"
#include "nexrad/System/Error.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>

namespace nexrad
{
namespace
{

using namespace std::chrono_literals;
using testing::HandMadeMoment;
using testing::HandMadeVolume;
using testing::keax;
using testing::klsx;
using testing::start;
using testing::TemporaryFolder;
using testing::WriteLevel2;

// A moment that is nowhere the same, with gates below the threshold, and range folded where that is
// asked for.
HandMadeMoment Moment(MomentName name, int seed, bool folds)
{
  const auto word = [=](int ray, int gate)
  {
    const int value = (ray * 7 + gate * 3 + seed) % 97;
    return static_cast<std::uint8_t>(gate % 13 == 0                 ? 0
                                     : folds && (ray / 20) % 4 == 1 ? 1
                                                                    : 70 + value);
  };
  return {name, name == MomentName::REF ? 100 : 80, 0, 1000, word};
}

/// Half an hour of two radars with REF and VEL, but for some volumes of KLSX that lack VEL.
class MergingMoments : public ::testing::Test
{
protected:
  MergingMoments()
  {
    for (int i = 0; i < 7; ++i)
    {
      this->Write(keax, start + i * 5min, {MomentName::REF, MomentName::VEL});
    }
    for (int i = 0; i < 6; ++i)
    {
      const bool lacks = i == 1 || i == 2;
      this->Write(klsx, start + i * 6min,
        lacks ? std::vector<MomentName>{MomentName::REF}
              : std::vector<MomentName>{MomentName::REF, MomentName::VEL});
    }
    options.grid.dimensions = {24, 12, 4};
    options.grid.range = 100'000.0;
    options.grid.top = 4'000.0;
    options.step = 4min;
    options.beam.ancillary = true;
  }

  void Write(const Site& site, Time time, const std::vector<MomentName>& moments)
  {
    HandMadeVolume volume;
    volume.site = site;
    volume.start = time;
    volume.sweeps.resize(2);
    for (std::size_t sweep = 0; sweep < 2; ++sweep)
    {
      volume.sweeps[sweep].elevation = sweep == 0 ? 0.5F : 1.5F;
      volume.sweeps[sweep].nyquist = 60.0F;
      for (const MomentName moment : moments)
      {
        const int seed = static_cast<int>((time - start) / 1min) + 11 * static_cast<int>(sweep);
        volume.sweeps[sweep].moments.push_back(Moment(moment, seed, moment == MomentName::VEL));
      }
    }
    WriteLevel2(folder.Path() / (site.name + FormatForFileName(time)), {volume});
    ++files;
  }

  std::unique_ptr<SeriesMerger> Open(const std::vector<MomentName>& moments, MergerSetup setup = {})
  {
    MergeOptions own = options;
    own.moments = moments;
    setup.threads = 2;
    auto merger =
      std::make_unique<SeriesMerger>(std::vector<std::filesystem::path>{folder.Path()}, own, setup);
    EXPECT_TRUE(merger->Open());
    return merger;
  }

  const TemporaryFolder folder;
  std::size_t files = 0;
  MergeOptions options;
};

void ExpectSameMoment(const GriddedVolume& actual, const GriddedVolume& expected)
{
  EXPECT_EQ(actual.moment, expected.moment);
  EXPECT_EQ(actual.time, expected.time);
  EXPECT_TRUE(actual.grid == expected.grid);
  EXPECT_EQ(actual.sites, expected.sites);
  EXPECT_TRUE(actual.values == expected.values);
  EXPECT_TRUE(actual.states == expected.states);
  EXPECT_TRUE(actual.ancillary.age == expected.ancillary.age);
  EXPECT_TRUE(actual.ancillary.radars == expected.ancillary.radars);
  EXPECT_TRUE(actual.ancillary.weight == expected.ancillary.weight);
  EXPECT_TRUE(actual.ancillary.nearestSite == expected.ancillary.nearestSite);
}

TEST_F(MergingMoments, OneRunGivesWhatARunForEachGives)
{
  const auto both = this->Open({MomentName::REF, MomentName::VEL});
  const auto reflectivity = this->Open({MomentName::REF});
  const auto velocity = this->Open({MomentName::VEL});
  ASSERT_EQ(both->Times(), reflectivity->Times());
  ASSERT_EQ(both->Times(), velocity->Times());
  ASSERT_GE(both->Times().size(), 7U);
  bool folded = false;
  std::ptrdiff_t echoes = 0;
  GriddedVolume memory;
  for (const Time time : both->Times())
  {
    std::optional<GriddedVolume> merged = both->Merge(time, {}, {}, std::move(memory));
    ASSERT_TRUE(merged);
    ASSERT_EQ(merged->further.size(), 1U);
    ExpectSameMoment(*merged, *reflectivity->Merge(time));
    ExpectSameMoment(merged->further[0], *velocity->Merge(time));
    const std::vector<VoxelState>& states = merged->further[0].states;
    echoes += std::count(states.begin(), states.end(), VoxelState::Echo);
    folded =
      folded || std::find(states.begin(), states.end(), VoxelState::RangeFolded) != states.end();
    memory = std::move(*merged);
  }
  EXPECT_TRUE(folded);
  EXPECT_GT(echoes, 500);
  EXPECT_EQ(both->DecodedFiles(), files); // each once
  EXPECT_TRUE(both->Settle());
  const std::vector<InputProblem> problems = both->Problems();
  ASSERT_EQ(problems.size(), 2U);
  EXPECT_EQ(problems[0].what, "no ray has VEL");
  EXPECT_FALSE(problems[0].leftOut);
}

TEST_F(MergingMoments, TheFirstNamedIsTheVolumesOwn)
{
  const auto merger = this->Open({MomentName::VEL, MomentName::REF});
  const std::vector<GriddedVolume> moments = SplitMoments(*merger->Merge(start + 12min));
  ASSERT_EQ(moments.size(), 2U);
  EXPECT_EQ(moments[0].moment, MomentName::VEL);
  ExpectSameMoment(moments[0], *this->Open({MomentName::VEL})->Merge(start + 12min));
  ExpectSameMoment(moments[1], *this->Open({MomentName::REF})->Merge(start + 12min));
}

TEST_F(MergingMoments, AnyOrderOfTimesGivesTheSameFromTheCache)
{
  MergerSetup setup;
  setup.anyOrder = true;
  const auto both = this->Open({MomentName::REF, MomentName::VEL}, setup);
  const auto velocity = this->Open({MomentName::VEL});
  both->EndAt(start + 30min);
  for (const Duration after : {Duration(8min), Duration(24min), Duration(8min)})
  {
    ExpectSameMoment(both->Merge(start + after)->further[0], *velocity->Merge(start + after));
  }
  EXPECT_LE(both->DecodedFiles(), files);
}

// As the processes of a parallel server have it: all files are scanned, and of a block only the
// radars that reach it are decoded.
TEST_F(MergingMoments, ABlockIsAPartOfTheWhole)
{
  MergerSetup setup;
  setup.anyOrder = true;
  setup.scanFirst = true;
  const auto blocks = this->Open({MomentName::VEL, MomentName::REF}, setup);
  const auto whole = this->Open({MomentName::VEL, MomentName::REF});
  const GriddedVolume all = *whole->Merge(start + 12min);
  for (const int half : {0, 12})
  {
    const VoxelBlock block = {{half, 0, 0}, {half + 12, 12, 4}};
    const GriddedVolume expected = testing::TakePart(all, block);
    const GriddedVolume made = *blocks->Merge(start + 12min, {}, block);
    ExpectSameMoment(made, expected);
    ExpectSameMoment(made.further.at(0), expected.further.at(0));
  }
}

TEST_F(MergingMoments, AMomentTwiceAndOneThatTheMethodDoesNotKnowAreRefused)
{
  options.moments = {MomentName::REF, MomentName::VEL, MomentName::REF};
  EXPECT_THROW(SeriesOptionsOf(options), Error);
  options.moments = {MomentName::REF, MomentName::VEL};
  EXPECT_EQ(
    SeriesOptionsOf(options).moments, (std::vector<MomentName>{MomentName::REF, MomentName::VEL}));
  options.method = MergeMethod::Thesis;
  EXPECT_THROW(SeriesOptionsOf(options), Error);
}

// Where only some radars have a moment, each names all, and its nearest radars by that list.
TEST(VolumeMoments, RadarsThatLackAMomentAreNamedToo)
{
  GriddedVolume first;
  first.sites = {"KEAX", "KLSX"};
  GriddedVolume second;
  second.moment = MomentName::ZDR;
  second.sites = {"KLSX", "KSGF"};
  second.ancillary.nearestSite = {0, 1, AncillaryArrays::NoSite};
  const GriddedVolume joined = JoinMoments({first, second});
  const std::vector<std::string> all = {"KEAX", "KLSX", "KSGF"};
  EXPECT_EQ(joined.sites, all);
  EXPECT_EQ(joined.further.at(0).sites, all);
  EXPECT_EQ(joined.further.at(0).ancillary.nearestSite,
    (std::vector<std::uint8_t>{1, 2, AncillaryArrays::NoSite}));
}

TEST(MomentNames, AreReadFromAList)
{
  EXPECT_EQ(ParseMomentNames("VEL"), (std::vector<MomentName>{MomentName::VEL}));
  EXPECT_EQ(ParseMomentNames("VEL,REF,SW"),
    (std::vector<MomentName>{MomentName::VEL, MomentName::REF, MomentName::SW}));
  for (const char* text : {"", ",", "REF,", ",REF", "REF VEL", "REF,REF", "ref", "REF,XYZ"})
  {
    EXPECT_TRUE(ParseMomentNames(text).empty()) << text;
  }
}

} // namespace
} // namespace nexrad
