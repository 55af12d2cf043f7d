// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Series/ScanInputs.h"

#include "HandMadeVolume.h"
#include "Scans/RadarsOfMissouri.h"
#include "TestData.h"
#include "ThreadProcesses.h"
#include "nexrad/Level2/Level2File.h"
#include "nexrad/Model/SiteTable.h"
#include "nexrad/System/Error.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>

namespace nexrad
{
namespace
{

using testing::AsProcesses;
using testing::ConstantVolume;
using testing::keax;
using testing::TemporaryFolder;
using testing::WriteLevel2;

void ExpectSame(const PackedComposite& a, const PackedComposite& b)
{
  EXPECT_EQ(a.rings, b.rings);
  EXPECT_EQ(a.echo, b.echo);
  EXPECT_EQ(a.echoTime, b.echoTime);
  EXPECT_EQ(a.picture, b.picture);
  ASSERT_EQ(a.tilts.size(), b.tilts.size());
  for (std::size_t i = 0; i < a.tilts.size(); ++i)
  {
    EXPECT_EQ(a.tilts[i].elevation, b.tilts[i].elevation);
    EXPECT_EQ(a.tilts[i].echo, b.tilts[i].echo);
  }
}

std::string Describe(const SeriesScan& scan)
{
  std::string text;
  for (const SiteSeries& series : scan.sites)
  {
    text += series.site.name + " at " + std::to_string(series.site.position->longitude) + '\n';
    for (const SeriesVolume& volume : series.volumes)
    {
      text += "  " + volume.file.string() + ' ' + std::to_string(volume.cycle) + ' ' +
              FormatIso8601(volume.start) + ' ' + FormatIso8601(volume.end) + ' ' +
              std::to_string(volume.rays) + ' ' + std::to_string(volume.reach) +
              (volume.synthetic ? " synthetic\n" : "\n");
    }
  }
  for (const InputProblem& problem : scan.problems)
  {
    text += problem.Line() + (problem.leftOut ? " (left out)\n" : "\n");
  }
  for (const std::string& note : scan.notes)
  {
    text += note + '\n';
  }
  return text;
}

// What a scan of inputs finds in one of several processes.
std::optional<SeriesScan> ScanShared(const std::vector<std::filesystem::path>& inputs,
  const Processes& processes, const SeriesOptions& options = {}, const VolumeVisitor& visitor = {},
  const Progress& progress = {})
{
  InputFiles found;
  processes.Together([&] { found = FindInputFiles(inputs); });
  const auto files =
    ScanTogether(found.paths, processes, ScanOrder::ByTime, options, visitor, progress);
  return files ? std::optional(CollectSeries(found.problems, *files)) : std::nullopt;
}

// The files that a process scans, in the order of their headers' times.
std::vector<std::filesystem::path> PartOf(
  const std::vector<std::filesystem::path>& paths, const Processes& processes, ScanOrder order)
{
  SeriesOptions options;
  options.threads = 1;
  std::vector<std::filesystem::path> own;
  ScanTogether(paths, processes, order, options,
    [&own](const SeriesVolume& volume, const RadarVolume&,
      const std::shared_ptr<const PolarVolume>&) { own.push_back(volume.file); });
  return own;
}

} // namespace

TEST(SharedScan, AllProcessesKnowWhatOneAloneWouldFind)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  // Damaged files, files without rays, several sites, several cycles in one file.
  const std::vector<std::filesystem::path> inputs = {
    data / "level2" / "damaged", data / "level2" / "pairs", data / "level2" / "run-kbgm-20050821"};
  const auto alone = ScanInputs(inputs);
  const std::string expected = Describe(*alone);
  ASSERT_NE(expected.find("KBGM at -75."), std::string::npos) << expected;
  ASSERT_NE(expected.find("no end of volume"), std::string::npos) << expected;
  ASSERT_NE(expected.find("metadata alone"), std::string::npos) << expected;
  std::atomic<int> visits{0};
  const auto scan = [&](const Processes& processes)
  {
    return ScanShared(inputs, processes, {},
      [&visits](const SeriesVolume&, const RadarVolume&, const std::shared_ptr<const PolarVolume>&)
      { ++visits; });
  };
  for (const auto& found : AsProcesses(3, scan))
  {
    EXPECT_EQ(Describe(*found), expected);
  }
  // Each volume is in the memory of one process, which decoded it.
  int volumes = 0;
  for (const SiteSeries& series : alone->sites)
  {
    volumes += static_cast<int>(series.volumes.size());
  }
  EXPECT_EQ(visits, volumes);
}

TEST(SharedScan, PartsAreNeighboursInTime)
{
  const TemporaryFolder folder;
  std::vector<std::filesystem::path> paths;
  for (const char* const minute : {"50", "10", "40", "00", "30", "20"})
  {
    const Time start = *ParseIso8601(std::string("2006-03-12T18:") + minute + ":00Z");
    paths.push_back(WriteLevel2(
      folder.Path() / (std::string("at-") + minute), {ConstantVolume(keax, start, 20.0)}));
  }
  const auto scan = [&paths](const Processes& processes)
  { return PartOf(paths, processes, ScanOrder::ByTime); };
  const auto parts = AsProcesses(2, scan);
  EXPECT_EQ(parts[0], (std::vector{paths[3], paths[1], paths[5]}));
  EXPECT_EQ(parts[1], (std::vector{paths[4], paths[2], paths[0]}));
}

TEST(SharedScan, PartsMayBeNeighbouringSites)
{
  const TemporaryFolder folder;
  std::vector<std::filesystem::path> paths;
  for (const char* const name :
    {"KLSX", "KEAX", "KBGM", "KFWS"}) // far east and north, and far south
  {
    for (const char* const minute : {"10", "00"})
    {
      const Time start = *ParseIso8601(std::string("2006-03-12T18:") + minute + ":00Z");
      const Site site = {name, FindSite(name)->position};
      paths.push_back(WriteLevel2(
        folder.Path() / (std::string(name) + minute), {ConstantVolume(site, start, 20.0)}));
    }
  }
  const auto partsBy = [&paths](ScanOrder order)
  {
    const auto scan = [&paths, order](Processes processes)
    {
      std::vector<std::string> own;
      for (const std::filesystem::path& file : PartOf(paths, processes, order))
      {
        own.push_back(file.filename());
      }
      return own;
    };
    return AsProcesses(2, scan);
  };
  using Names = std::vector<std::string>;
  const auto byLongitude = partsBy(ScanOrder::ByLongitude);
  EXPECT_EQ(byLongitude[0], (Names{"KFWS00", "KFWS10", "KEAX00", "KEAX10"}));
  EXPECT_EQ(byLongitude[1], (Names{"KLSX00", "KLSX10", "KBGM00", "KBGM10"}));
  const auto byLatitude = partsBy(ScanOrder::ByLatitude);
  EXPECT_EQ(byLatitude[0], (Names{"KFWS00", "KFWS10", "KLSX00", "KLSX10"}));
  EXPECT_EQ(byLatitude[1], (Names{"KEAX00", "KEAX10", "KBGM00", "KBGM10"}));
}

TEST(SharedScan, SummariesReachAllProcesses)
{
  const TemporaryFolder folder;
  const Time start = *ParseIso8601("2006-03-12T18:00Z");
  for (const double value : {10.0, 20.5, 30.0})
  {
    WriteLevel2(folder.Path() / std::to_string(value),
      {ConstantVolume(keax, start + Duration(std::llround(60'000.0 * value)), value)});
  }
  SeriesOptions options;
  options.moments = {MomentName::REF};
  options.summaries = true;
  const SeriesScan alone = *ScanInputs({folder.Path()}, options);
  const auto scan = [&](const Processes& processes)
  { return ScanShared({folder.Path()}, processes, options); };
  for (const auto& found : AsProcesses(2, scan))
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      const VolumeSummary& expected = *alone.sites[0].volumes[i].summary;
      const VolumeSummary& summary = *found->sites.at(0).volumes.at(i).summary;
      EXPECT_EQ(summary.reach, 100'000.0);
      EXPECT_EQ(summary.reach, expected.reach);
      ExpectSame(summary.composite, expected.composite);
      ExpectSame(summary.lowest, expected.lowest);
      const std::vector<float>& picture = summary.composite.picture;
      EXPECT_NE(std::count(picture.begin(), picture.end(),
                  static_cast<float>(std::array{10.0, 20.5, 30.0}[i])),
        0);
    }
  }
}

TEST(SharedScan, OneFailureFailsAll)
{
  const TemporaryFolder folder;
  const auto path = WriteLevel2(
    folder.Path() / "a", {ConstantVolume(keax, *ParseIso8601("2006-03-12T18:00Z"), 20.0)});
  // The second process does not see the file.
  const auto scan = [&](const Processes& processes)
  {
    try
    {
      ScanShared({processes.Rank() == 1 ? folder.Path() / "missing" : path}, processes);
    }
    catch (const Error& error)
    {
      return std::string(error.what());
    }
    return std::string("done");
  };
  for (const std::string& outcome : AsProcesses(3, scan))
  {
    EXPECT_NE(outcome.find("missing: no such file or folder"), std::string::npos);
  }
}

TEST(SharedScan, OneThatIsStoppedStopsAll)
{
  const TemporaryFolder folder;
  std::vector<std::filesystem::path> paths;
  for (const char* const name : {"a", "b", "c"})
  {
    paths.push_back(WriteLevel2(
      folder.Path() / name, {ConstantVolume(keax, *ParseIso8601("2006-03-12T18:00Z"), 20.0)}));
  }
  const auto scan = [&](const Processes& processes)
  {
    return ScanShared(
      paths, processes, {}, {}, [&processes](double) { return processes.Rank() != 2; })
      .has_value();
  };
  for (const bool finished : AsProcesses(3, scan))
  {
    EXPECT_FALSE(finished);
  }
}

TEST(SharedScan, RefusesBytesThatAreNoScan)
{
  EXPECT_THROW(UnpackScannedFiles("nonsense"), Error);
  EXPECT_TRUE(UnpackScannedFiles(PackScannedFiles({})).empty());
}

TEST(PeekVolumeHeader, ReadsTheHeaderThroughItsContainers)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  const auto level2 = data / "level2";
  // The times stand in the files' names, but for the milliseconds.
  const auto peek = [&level2](const char* file)
  {
    const std::optional<VolumeHeader> header = PeekVolumeHeader(level2 / file);
    return FormatIso8601(header && header->time ? *header->time : Time()).substr(0, 19);
  };
  EXPECT_EQ(peek("pairs/KVBX20190501_093433_V06"), "2019-05-01T09:34:33");
  EXPECT_EQ(peek("legacy/KABR20050101_000745.gz"), "2005-01-01T00:07:45");
  EXPECT_EQ(peek("run-kbgm-20050821/KBGM20050821_024323.gz"), "2005-08-21T02:43:23");
  EXPECT_EQ(peek("chunks/KLOT-20210729").substr(0, 10), "2021-07-29");
  EXPECT_EQ(PeekVolumeHeader(level2 / "pairs/KVBX20190501_093433_V06")->siteName, "KVBX");
  // A record alone has no header; a bzip2 stream would have to be decompressed.
  EXPECT_FALSE(PeekVolumeHeader(level2 / "superres" / "example_nexrad_archive_msg31.bz2"));
  EXPECT_FALSE(PeekVolumeHeader("/nonexistent"));
  EXPECT_FALSE(PeekVolumeHeader(level2));
}

} // namespace nexrad
