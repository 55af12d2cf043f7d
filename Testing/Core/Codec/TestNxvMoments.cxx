// SPDX-License-Identifier: BSD-3-Clause
// Files with several moments.
#include "nexrad/Codec/NxvFile.h"
#include "nexrad/Grid/GriddedVolume.h"
#include "nexrad/Grid/MomentCode.h"

#include "Comparison/VolumeComparison.h"
#include "ErrorMessage.h"
#include "TestData.h"
#include "VolumeMaker.h"
#include "nexrad/System/Error.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

using namespace nexrad;
using nexrad::testing::AddAncillary;
using nexrad::testing::ExpectSameVolume;
using nexrad::testing::FileContent;
using nexrad::testing::MakeGriddedVolume;
using nexrad::testing::MessageOf;
using nexrad::testing::TemporaryFolder;

namespace
{

namespace fs = std::filesystem;

// REF, VEL with range-folded voxels and ZDR, which takes two bytes, on one grid with states of
// their own; REF and VEL have ancillary arrays.
std::vector<GriddedVolume> MakeMoments()
{
  std::vector<GriddedVolume> moments(3, MakeGriddedVolume());
  moments[1].moment = MomentName::VEL;
  moments[2].moment = MomentName::ZDR;
  moments[1].states[1] = VoxelState::RangeFolded;
  moments[1].states[6] = VoxelState::NoEcho;
  moments[1].values[6] = moments[1].fill;
  moments[2].states[9] = VoxelState::NotScanned;
  moments[2].values[9] = moments[2].fill;
  AddAncillary(moments[0]);
  AddAncillary(moments[1]);
  return moments;
}

} // namespace

namespace
{

// Voxels of all states, of an echo that is no number, and of more bytes than a piece has.
GriddedVolume AllStates()
{
  GriddedVolume volume = MakeGriddedVolume({160, 64, 125});
  for (std::size_t i = 0; i < volume.states.size(); ++i)
  {
    volume.states[i] = static_cast<VoxelState>(i * i / 7 % 5);
    const bool echo = volume.states[i] == VoxelState::Echo;
    volume.values[i] = echo ? static_cast<float>(i % 900) / 10.0F - 10.0F : volume.fill;
  }
  std::fill_n(volume.states.begin() + 1'048'000, 1'000, VoxelState::Filtered);
  std::fill_n(volume.values.begin() + 1'048'000, 1'000, volume.fill);
  volume.states[17] = VoxelState::Echo;
  volume.values[17] = std::numeric_limits<float>::quiet_NaN();
  return volume;
}

// The same with codes in place of values and states.
GriddedVolume Coded(const GriddedVolume& volume)
{
  GriddedVolume coded = volume;
  coded.codes.resize(volume.values.size());
  MomentCode::Widest(volume.moment).WriteBytes(volume, 0, coded.codes.size(), coded.codes.data());
  for (std::size_t i = 0; i < volume.states.size();)
  {
    const auto begin = volume.states.begin() + static_cast<std::ptrdiff_t>(i);
    const auto count = static_cast<std::size_t>(
      std::find_if(begin, volume.states.end(), [&](VoxelState state) { return state != *begin; }) -
      begin);
    if (*begin == VoxelState::Filtered || *begin == VoxelState::RangeFolded)
    {
      coded.statesBesideCodes.push_back({i, count, *begin});
    }
    i += count;
  }
  coded.values.clear();
  coded.states.clear();
  return coded;
}

} // namespace

// A volume of codes is written as the one of values and states would be.
TEST(NxvMoments, CodesOfAMergeMakeTheSameFile)
{
  const TemporaryFolder folder;
  for (const MomentName moment : {MomentName::REF, MomentName::SW})
  {
    for (const bool folded : {true, false})
    {
      GriddedVolume volume = AllStates();
      volume.moment = moment;
      const VoxelState other = folded ? VoxelState::RangeFolded : VoxelState::NoEcho;
      std::replace(volume.states.begin(), volume.states.end(), VoxelState::RangeFolded, other);
      AddAncillary(volume);
      WriteNxv(folder.Path() / "values.nxv", volume);
      WriteNxv(folder.Path() / "codes.nxv", Coded(volume));
      EXPECT_TRUE(
        FileContent(folder.Path() / "codes.nxv") == FileContent(folder.Path() / "values.nxv"));
    }
  }
}

TEST(NxvMoments, CodesOfAMergeMakeNoOtherFile)
{
  const TemporaryFolder folder;
  const fs::path path = folder.Path() / "codes.nxv";
  const GriddedVolume coded = Coded(AllStates());
  NxvBandWriter bands(path, coded.grid);
  const std::string refusal =
    "a volume that was merged into codes can be written as these alone, without bricks";
  EXPECT_EQ(MessageOf([&] { WriteNxv(path, coded, NxvEncoding::Float); }), refusal);
  EXPECT_EQ(MessageOf([&] { WriteNxv(path, coded, NxvEncoding::Thesis); }), refusal);
  EXPECT_EQ(MessageOf([&] { bands.Add(coded); }), refusal);
  EXPECT_FALSE(fs::exists(path));
}

TEST(NxvMoments, EachIsWhatAFileOfItAloneHolds)
{
  const TemporaryFolder folder;
  const fs::path path = folder.Path() / "all.nxv";
  for (const auto encoding : {NxvEncoding::RadarSteps, NxvEncoding::Float})
  {
    WriteNxv(path, JoinMoments(MakeMoments()), encoding);
    const std::vector<GriddedVolume> read = SplitMoments(ReadNxv(path));
    ASSERT_EQ(read.size(), 3U);
    for (std::size_t i = 0; i < read.size(); ++i)
    {
      WriteNxv(folder.Path() / "one.nxv", MakeMoments()[i], encoding);
      const GriddedVolume alone = ReadNxv(folder.Path() / "one.nxv");
      ExpectSameVolume(read[i], alone);
      NxvReadOptions choice;
      choice.moments = {alone.moment};
      const GriddedVolume chosen = ReadNxv(path, choice);
      ExpectSameVolume(chosen, alone);
      EXPECT_TRUE(chosen.further.empty());
    }
  }
}

// Codes are of one moment: of the one asked for, wherever it is in the file.
TEST(NxvMoments, OneMomentIsReadAsCodes)
{
  const TemporaryFolder folder;
  const fs::path path = folder.Path() / "all.nxv";
  WriteNxv(path, JoinMoments(MakeMoments()));
  EXPECT_FALSE(HasNxvCodes(path));
  EXPECT_FALSE(ReadNxvCodes(path));
  NxvReadOptions options;
  options.moments = {MomentName::VEL};
  EXPECT_TRUE(HasNxvCodes(path, options));
  const auto coded = ReadNxvCodes(path, options);
  ASSERT_TRUE(coded);
  EXPECT_FALSE(ReadNxvCodes(path, options, true));
  EXPECT_EQ(coded->volume.moment, MomentName::VEL);
  const GriddedVolume read = ReadNxv(path, options);
  for (std::size_t i = 0; i < read.values.size(); ++i)
  {
    EXPECT_EQ(coded->meaning.values[coded->codes[i]], read.values[i]);
    const bool folded = read.states[i] == VoxelState::RangeFolded; // has the code of no echo
    EXPECT_EQ(coded->meaning.states[coded->codes[i]], folded ? VoxelState::NoEcho : read.states[i]);
  }
  EXPECT_EQ(coded->volume.ancillary.age, read.ancillary.age);
}

TEST(NxvMoments, AreListedAndReadInTheOrderAskedFor)
{
  const TemporaryFolder folder;
  const fs::path path = folder.Path() / "all.nxv";
  WriteNxv(path, JoinMoments(MakeMoments()));
  EXPECT_EQ(ReadNxvMoments(path),
    (std::vector<MomentName>{MomentName::REF, MomentName::VEL, MomentName::ZDR}));
  EXPECT_EQ(ReadNxvAncillaryArrayNames(path).size(), 8U);
  NxvReadOptions options;
  options.moments = {MomentName::ZDR, MomentName::REF};
  options.leaveOut = {"REF_age"};
  const GriddedVolume read = ReadNxv(path, options);
  ASSERT_EQ(read.further.size(), 1U);
  EXPECT_EQ(read.moment, MomentName::ZDR);
  EXPECT_EQ(read.further[0].values, ReadNxv(path).values);
  EXPECT_TRUE(read.further[0].ancillary.age.empty());
  EXPECT_FALSE(read.further[0].ancillary.weight.empty());
  options.moments = {MomentName::REF, MomentName::SW};
  const std::string error = MessageOf([&] { ReadNxv(path, options); });
  EXPECT_NE(error.find("the file has no SW; it has REF, VEL, ZDR"), std::string::npos) << error;
}

// The thesis's run lengths are for its one moment.
TEST(NxvMoments, FurtherOnesHaveNoRunLengths)
{
  const TemporaryFolder folder;
  const fs::path path = folder.Path() / "all.nxv";
  WriteNxv(path, JoinMoments(MakeMoments()), NxvEncoding::Thesis);
  const GriddedVolume read = ReadNxv(path);
  EXPECT_EQ(read.values[3], 2.0F); // 1.75 dBZ in whole dBZ
  WriteNxv(path, JoinMoments(MakeMoments()));
  EXPECT_EQ(read.further.at(0).values, ReadNxv(path).further.at(0).values);
}

TEST(NxvMoments, OneThatIsThereTwiceIsRefused)
{
  const TemporaryFolder folder;
  GriddedVolume twice = MakeGriddedVolume();
  twice.further = {MakeGriddedVolume()};
  WriteNxv(folder.Path() / "twice.nxv", twice);
  EXPECT_THROW(ReadNxv(folder.Path() / "twice.nxv"), Error);
}

TEST(NxvMoments, TakeMemoryEach)
{
  const TemporaryFolder folder;
  const fs::path path = folder.Path() / "all.nxv";
  WriteNxv(path, JoinMoments(MakeMoments()));
  NxvReadOptions options;
  options.moments = {MomentName::ZDR};
  // ZDR: value and state, and a code of two bytes while it is decoded.
  options.maximumBytes = MakeMoments()[0].values.size() * 7;
  EXPECT_NO_THROW(ReadNxv(path, options));
  options.moments = {MomentName::ZDR, MomentName::VEL};
  EXPECT_THROW(ReadNxv(path, options), Error);
  options.leaveOut = {"VEL_age", "VEL_radars", "VEL_weight", "VEL_site"};
  options.maximumBytes = MakeMoments()[0].values.size() * (7 + 5);
  EXPECT_NO_THROW(ReadNxv(path, options));
}
