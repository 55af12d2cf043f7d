// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Merging/SeriesMerger.h"

#include "DirectMerge.h"
#include "ErrorMessage.h"
#include "HandMadeVolume.h"
#include "Scans/RadarsOfMissouri.h"
#include "TestData.h"
#include "Tolerance.h"
#include "nexrad/Series/InputFiles.h"
#include "nexrad/Series/Steps.h"

#include <gtest/gtest.h>

#include <fstream>

namespace nexrad
{
namespace
{

using namespace std::chrono_literals;
using testing::ConstantVolume;
using testing::DirectMerge;
using testing::keax;
using testing::klsx;
using testing::SetHeaderTime;
using testing::start;
using testing::TemporaryFolder;
using testing::WriteLevel2;

/// An hour of two radars, a volume every 5 and every 6 minutes, each with a value of its own.
class MergingASeries : public ::testing::Test
{
protected:
  MergingASeries()
  {
    for (int i = 0; i < 12; ++i)
    {
      this->Write(keax, "e", start + i * 5min, 10.0 + i);
    }
    for (int i = 0; i < 10; ++i)
    {
      this->Write(klsx, "l", start + i * 6min, 30.0 + i);
    }
    options.grid.dimensions = {24, 12, 4};
    options.grid.range = 100'000.0;
    options.step = 4min;
    options.quality.level =
      QualityLevel::Off; // rays that hold one value are a fault of the receiver
  }

  void Write(const Site& site, const std::string& name, Time time, double value)
  {
    const auto path = folder.Path() / (name + FormatForFileName(time));
    paths.push_back(WriteLevel2(path, {ConstantVolume(site, time, value)}));
  }

  SeriesMerger InAnyOrder() const
  {
    MergerSetup setup;
    setup.threads = 2;
    setup.anyOrder = true;
    return {{folder.Path()}, options, setup};
  }

  void ExpectAsDirect(SeriesMerger& merger, Time time) const
  {
    const DirectMerge direct({folder.Path()}, options);
    const GriddedVolume expected = direct.At(time);
    const std::optional<GriddedVolume> made = merger.Merge(time);
    ASSERT_TRUE(made);
    EXPECT_TRUE(made->values == expected.values) << FormatIso8601(time);
    EXPECT_TRUE(made->states == expected.states) << FormatIso8601(time);
    EXPECT_EQ(made->sites, expected.sites);
  }

  // Times whose volumes would be made of something else now.
  static std::vector<Time> DueTimes(const SeriesMerger& merger, const Steps& steps)
  {
    std::vector<Time> due;
    for (const Time time : steps.Made())
    {
      if (steps.IsDue(time, merger.MadeOf(time)))
      {
        due.push_back(time);
      }
    }
    return due;
  }

  const TemporaryFolder folder;
  std::vector<std::filesystem::path> paths;
  MergeOptions options;
};

TEST_F(MergingASeries, BeginsWithoutDecodingTheDay)
{
  SeriesMerger merger = this->InAnyOrder();
  ASSERT_TRUE(merger.Open());
  EXPECT_FALSE(merger.IsScanned());
  EXPECT_EQ(merger.DecodedFiles(), 4U); // the first and the last file of each radar
  EXPECT_EQ(merger.Sites(), (std::vector<std::string>{"KEAX", "KLSX"}));
  const DirectMerge direct({folder.Path()}, options);
  EXPECT_EQ(merger.Times(), direct.Times());
  merger.EndAt(start + 8min);
  this->ExpectAsDirect(merger, start + 8min);
  EXPECT_AT_MOST(merger.DecodedFiles(), 12U, "files decoded"); // of 22
}

TEST_F(MergingASeries, AnyOrderOfTimesGivesTheSame)
{
  for (const MergeMethod method : {MergeMethod::Beam, MergeMethod::Thesis})
  {
    options.method = method;
    SeriesMerger merger = this->InAnyOrder();
    ASSERT_TRUE(merger.Open());
    Steps steps;
    for (const Duration after : {Duration(40min), Duration(8min), Duration(9min), Duration(-5min),
           Duration(56min), Duration(8min)})
    {
      this->ExpectAsDirect(merger, start + after);
      steps.Make(start + after, merger.LastMadeOf(start + after));
    }
    EXPECT_LE(merger.DecodedFiles(), paths.size()); // the memory keeps all of them
    EXPECT_TRUE(merger.Settle());
    EXPECT_TRUE(this->DueTimes(merger, steps).empty());
  }
}

// Between the listing of the folder and the merge, one file is removed and another one cut.
TEST_F(MergingASeries, FilesThatVanishOrShrinkAreNamed)
{
  SeriesMerger merger({folder.Path()}, options);
  ASSERT_TRUE(merger.Open());
  const std::filesystem::path& vanished = paths[9];
  const std::filesystem::path& shrunk = paths[10];
  std::filesystem::remove(vanished);
  std::filesystem::resize_file(shrunk, std::filesystem::file_size(shrunk) / 2);
  for (const Time time : merger.Times())
  {
    EXPECT_TRUE(merger.Merge(time)) << FormatIso8601(time);
  }
  std::string lines;
  for (const InputProblem& problem : merger.Problems())
  {
    lines += problem.Line() + '\n';
  }
  EXPECT_NE(lines.find(vanished.string() + ": "), std::string::npos) << lines;
  EXPECT_NE(lines.find("No such file or directory"), std::string::npos) << lines;
  EXPECT_NE(lines.find(shrunk.string() + ": offset "), std::string::npos) << lines;
}

// A run that continues another one knows what that one knew of the files, and decodes none of them
// for the volumes that are there.
TEST_F(MergingASeries, WhatWasKnownOfTheFilesNeedNotBeDecodedAgain)
{
  SeriesMerger first({folder.Path()}, options);
  ASSERT_TRUE(first.Open());
  for (const Time time : first.Times())
  {
    ASSERT_TRUE(first.Merge(time));
  }
  const auto volumesOf = [](SeriesMerger& merger)
  {
    std::string volumes;
    for (const Time time : merger.Times())
    {
      EXPECT_TRUE(merger.Know(time));
      volumes += merger.MadeOf(time);
    }
    EXPECT_TRUE(merger.Settle());
    return volumes;
  };
  SeriesMerger second({folder.Path()}, options);
  ASSERT_TRUE(second.Open());
  second.LearnFiles(first.KnownFiles());
  const std::string volumes = volumesOf(second);
  EXPECT_EQ(second.DecodedFiles(), 4U) << "those that Open decoded";
  SeriesMerger ignorant({folder.Path()}, options);
  ASSERT_TRUE(ignorant.Open());
  EXPECT_EQ(volumesOf(ignorant), volumes);
  EXPECT_EQ(ignorant.DecodedFiles(), paths.size());
  EXPECT_THROW(second.LearnFiles({}), Error);
}

TEST_F(MergingASeries, LittleMemoryGivesTheSame)
{
  options.memory = 0;
  SeriesMerger merger = this->InAnyOrder();
  ASSERT_TRUE(merger.Open());
  for (const Duration after : {Duration(40min), Duration(8min), Duration(40min)})
  {
    this->ExpectAsDirect(merger, start + after);
  }
}

TEST_F(MergingASeries, OtherOptionsKeepWhatWasDecoded)
{
  SeriesMerger merger = this->InAnyOrder();
  ASSERT_TRUE(merger.Open());
  merger.EndAt(start + 20min);
  this->ExpectAsDirect(merger, start + 20min);
  const std::size_t decoded = merger.DecodedFiles();
  options.grid.dimensions = {20, 10, 3};
  options.beam.fillColumns = true;
  options.step = 10min;
  ASSERT_TRUE(merger.SetOptions(options));
  EXPECT_EQ(merger.Times().size(), 6U);
  merger.EndAt(start + 20min);
  this->ExpectAsDirect(merger, start + 20min);
  EXPECT_EQ(merger.DecodedFiles(), decoded);
}

TEST_F(MergingASeries, WithoutHeadersAllIsScanned)
{
  std::ofstream(folder.Path() / "notes.txt") << "no header, and no radar file";
  std::filesystem::resize_file(paths[5], 10);
  SeriesMerger merger = this->InAnyOrder();
  ASSERT_TRUE(merger.Open());
  this->ExpectAsDirect(merger, start + 20min);
  EXPECT_FALSE(merger.Problems().empty());
}

TEST_F(MergingASeries, AHeaderThatErrsIsFoundOut)
{
  SetHeaderTime(paths[4], start + 48min); // KEAX at 18:20
  SeriesMerger merger = this->InAnyOrder();
  ASSERT_TRUE(merger.Open());
  EXPECT_FALSE(merger.IsScanned());
  this->ExpectAsDirect(merger, start + 48min); // which decodes the file
  EXPECT_TRUE(merger.IsScanned());
  this->ExpectAsDirect(merger, start + 20min);
}

// The header of the last file puts it before all others: by the headers the series ends with the
// file before it, and a scan finds later time steps. Who was told of the others counts them.
TEST_F(MergingASeries, AScanInBetweenLeavesGridAndTimesAsTheyWereTold)
{
  SetHeaderTime(paths[11], start - 20min); // KEAX at 18:55
  options.begin = start;
  options.step = 5min;
  SeriesMerger merger = this->InAnyOrder();
  ASSERT_TRUE(merger.Open());
  const std::vector<Time> times = merger.Times();
  const GridSpecification grid = merger.Grid();
  for (const Time time : times)
  {
    ASSERT_TRUE(merger.Merge(time));
  }
  EXPECT_TRUE(merger.IsScanned());
  EXPECT_EQ(merger.Times(), times);
  EXPECT_EQ(merger.Grid(), grid);
  EXPECT_NE(merger.Times(), DirectMerge({folder.Path()}, options).Times());
  this->ExpectAsDirect(merger, start + 54min);
}

// As where radars are being received.
TEST_F(MergingASeries, FilesThatComeAndGoMeanwhileDoNoHarm)
{
  SeriesMerger merger = this->InAnyOrder();
  ASSERT_TRUE(merger.Open());
  const std::optional<GriddedVolume> before = merger.Merge(start + 20min);
  this->Write(keax, "new", start + 62min, 60.0);
  std::filesystem::remove(paths[9]); // KEAX at 18:45
  ASSERT_TRUE(merger.Scan());
  const std::optional<GriddedVolume> after = merger.Merge(start + 20min);
  EXPECT_TRUE(after->values == before->values);
  EXPECT_TRUE(merger.Merge(start + 45min));
  const std::vector<InputProblem> problems = merger.Problems();
  EXPECT_TRUE(std::any_of(problems.begin(), problems.end(),
    [this](const InputProblem& problem) { return problem.leftOut && problem.file == paths[9]; }));
}

TEST_F(MergingASeries, TimesFromWhichAHeaderHidAVolumeAreDue)
{
  SetHeaderTime(paths[4], start + 48min); // KEAX at 18:20
  SeriesMerger merger({folder.Path()}, options);
  ASSERT_TRUE(merger.Open());
  Steps steps;
  for (const Time time : merger.Times())
  {
    merger.Merge(time);
    steps.Make(time, merger.LastMadeOf(time));
  }
  const std::vector<Time> due = this->DueTimes(merger, steps);
  ASSERT_TRUE(merger.Settle());
  EXPECT_EQ(this->DueTimes(merger, steps), due) << "one process knows nothing of others";
  // Its rays are of 18:20 to 18:20:07; one volume before and one after tell the rest.
  EXPECT_EQ(due, (std::vector<Time>{start + 16min, start + 20min, start + 24min}));
  for (const Time time : merger.Times())
  {
    this->ExpectAsDirect(merger, time);
    steps.Make(time, merger.LastMadeOf(time));
  }
  ASSERT_TRUE(merger.Settle());
  EXPECT_TRUE(this->DueTimes(merger, steps).empty());
  EXPECT_FALSE(merger.IsScanned());
}

// The header of the last file puts it before all others: grid and times have to be told anew.
TEST_F(MergingASeries, OtherTimeStepsAskForAScan)
{
  SetHeaderTime(paths[11], start - 20min); // KEAX at 18:55
  options.begin = start;
  options.step = 5min;
  SeriesMerger merger({folder.Path()}, options);
  ASSERT_TRUE(merger.Open());
  EXPECT_FALSE(merger.Settle());
  ASSERT_TRUE(merger.Scan());
  EXPECT_EQ(merger.Times(), DirectMerge({folder.Path()}, options).Times());
  EXPECT_TRUE(merger.Settle());
}

TEST_F(MergingASeries, OneTimeNeedsItsFilesAlone)
{
  options.step.reset();
  options.time = start + 21min;
  SeriesMerger merger = this->InAnyOrder();
  ASSERT_TRUE(merger.Open());
  EXPECT_FALSE(merger.IsScanned());
  EXPECT_EQ(merger.Times(), std::vector<Time>{start + 21min});
  this->ExpectAsDirect(merger, start + 21min);
  options.time = start + 3h;
  const std::string error = testing::MessageOf([&] { this->InAnyOrder().Open(); });
  EXPECT_NE(error.find("18:00:00.000Z to "), std::string::npos);
}

TEST_F(MergingASeries, StopsWhenAsked)
{
  SeriesMerger merger = this->InAnyOrder();
  ASSERT_TRUE(merger.Open());
  EXPECT_FALSE(merger.Merge(start + 20min, [](double) { return false; }));
  this->ExpectAsDirect(merger, start + 20min);
  SeriesMerger scanning = this->InAnyOrder();
  ASSERT_TRUE(scanning.Open());
  EXPECT_FALSE(scanning.Scan([](double) { return false; }));
}

TEST_F(MergingASeries, InputsThatCannotBeUsedAreNamed)
{
  const auto open = [this](const std::filesystem::path& input)
  {
    SeriesMerger merger({input}, options);
    merger.Open();
  };
  const auto text = folder.Path() / "text";
  std::ofstream(text) << "no radar file";
  EXPECT_THROW(open(text), InputError);
  EXPECT_THROW(open(folder.Path() / "absent"), InputError);
}

} // namespace
} // namespace nexrad
