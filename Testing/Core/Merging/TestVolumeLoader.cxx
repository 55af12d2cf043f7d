// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Merging/VolumeLoader.h"

#include "HandMadeVolume.h"
#include "Scans/RadarsOfMissouri.h"
#include "TestData.h"
#include "Tolerance.h"
#include "nexrad/Series/ScanInputs.h"
#include "nexrad/System/Error.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <fstream>
#include <mutex>
#include <stdexcept>
#include <thread>

namespace nexrad
{
namespace
{

using namespace std::chrono_literals;
using testing::ConstantVolume;
using testing::keax;
using testing::klsx;
using testing::SetHeaderTime;
using testing::start;
using testing::TemporaryFolder;
using testing::WriteLevel2;

/// Three hours of two radars, a volume every 5 and every 6 minutes, and what a stream does to them.
class VolumeLoading : public ::testing::Test
{
protected:
  VolumeLoading()
  {
    this->Write(keax, "e", 5min);
    this->Write(klsx, "l", 6min);
    request.maximumGap = 15min;
  }

  void Write(const Site& site, const std::string& name, Duration period)
  {
    for (Duration after = 0min; after < 3h; after += period)
    {
      const auto path = folder.Path() / (name + std::to_string(after / 1min));
      paths.push_back(WriteLevel2(path, {ConstantVolume(site, start + after, 20.0)}));
    }
  }

  LoaderWork Work()
  {
    LoaderWork work;
    work.prepare = [this](const std::shared_ptr<const PolarVolume>& volume)
    {
      ReadyVolume ready = MakeReady(volume, request);
      const std::lock_guard<std::mutex> lock(mutex);
      ++decoded;
      made.emplace_back(ready.beam);
      return ready;
    };
    work.rule = VolumeRuleOf(request);
    return work;
  }

  std::unique_ptr<VolumeLoader> Open(
    unsigned threads = 2, const std::shared_ptr<PolarCache>& cache = nullptr)
  {
    const auto headers = ListByHeaders(paths);
    EXPECT_TRUE(headers);
    SeriesOptions options;
    options.moment = MomentName::REF;
    return std::make_unique<VolumeLoader>(
      SeriesFiles{paths, *headers, {}, {}}, options, this->Work(), cache, threads);
  }

  // All files, once they are as the test wants them.
  const SeriesScan& Scan()
  {
    if (!scan)
    {
      scan = ScanInputs({folder.Path()});
    }
    return *scan;
  }

  // Sites and starts of the volumes about a time, by a scan of all files.
  std::vector<std::string> Expected(Time time)
  {
    std::vector<std::string> names;
    for (const ChosenVolume& each :
      this->Scan().ChosenAt(time, VolumeRuleOf(request), {MomentName::REF}))
    {
      names.push_back(this->Scan().sites[each.site].site.name + FormatIso8601(each.volume->start));
    }
    return names;
  }

  // Whether each time so far is made of what a scan of all files leads to.
  bool IsAsScanned(const VolumeLoader& loader)
  {
    return std::all_of(loader.Made().begin(), loader.Made().end(),
      [this](const auto& step)
      {
        return step.second ==
               this->Scan().MadeOf(step.first, VolumeRuleOf(request), {MomentName::REF});
      });
  }

  static std::vector<std::string> Names(const std::vector<ReadyVolume>& volumes)
  {
    std::vector<std::string> names;
    for (const ReadyVolume& volume : volumes)
    {
      names.push_back(volume.beam->site.name + FormatIso8601(volume.beam->start));
    }
    return names;
  }

  std::size_t Alive()
  {
    const std::lock_guard<std::mutex> lock(mutex);
    return static_cast<std::size_t>(
      std::count_if(made.begin(), made.end(), [](const auto& each) { return !each.expired(); }));
  }

  const TemporaryFolder folder;
  std::vector<std::filesystem::path> paths;
  MergeRequest request;
  std::optional<SeriesScan> scan;
  std::mutex mutex;
  std::size_t decoded = 0;
  std::vector<std::weak_ptr<const BeamVolume>> made;
};

TEST_F(VolumeLoading, GivesWhatAScanWouldAndHoldsLittle)
{
  for (const unsigned threads : {1U, 3U})
  {
    decoded = 0;
    made.clear();
    const auto loader = this->Open(threads);
    // From before the first volume to after the last, with steps shorter and longer than volumes.
    for (const Duration after : {Duration(-20min), Duration(-10min), Duration(0min), Duration(3s),
           Duration(4min), Duration(7min), Duration(20min), Duration(65min), Duration(66min),
           Duration(119min), Duration(179min), Duration(190min), Duration(200min)})
    {
      EXPECT_EQ(Names(*loader->About(start + after)), this->Expected(start + after))
        << after / 1s << " s";
      // One in progress, one before, one after of each radar, and three ahead on each thread with
      // the one that it decodes.
      EXPECT_AT_MOST(this->Alive(), 2U * 3U + threads * 4U, "volumes in memory")
        << after / 1s << " s";
    }
    EXPECT_LE(decoded,
      paths.size()); // each once, and those between two times that neither needs not at all
    EXPECT_TRUE(this->IsAsScanned(*loader));
  }
}

TEST_F(VolumeLoading, BeginsInTheMiddleAndEndsThere)
{
  const auto loader = this->Open();
  loader->EndAt(start + 100min);
  EXPECT_EQ(Names(*loader->About(start + 95min)), this->Expected(start + 95min));
  EXPECT_EQ(Names(*loader->About(start + 100min)), this->Expected(start + 100min));
  EXPECT_AT_MOST(decoded, 12U, "files decoded"); // of 66
}

TEST_F(VolumeLoading, ScansAFileOnRequestAndKeepsItForItsTime)
{
  const auto loader = this->Open();
  const ScannedFile last = loader->Scan(35); // KEAX at 20:55
  ASSERT_EQ(last.volumes.size(), 1U);
  EXPECT_EQ(last.volumes[0].second.start, start + 175min);
  for (Duration after = 0min; after <= 180min; after += 10min)
  {
    EXPECT_EQ(Names(*loader->About(start + after)), this->Expected(start + after));
  }
  EXPECT_EQ(decoded, paths.size());
  EXPECT_EQ(loader->Known()[35].volumes.size(), 1U);
}

TEST_F(VolumeLoading, TimesMayComeInAnyOrder)
{
  for (const bool cached : {false, true})
  {
    decoded = 0;
    const auto cache = cached ? std::make_shared<PolarCache>(std::size_t(1) << 30) : nullptr;
    const auto loader = this->Open(2, cache);
    for (const Duration after : {Duration(120min), Duration(10min), Duration(175min),
           Duration(119min), Duration(121min), Duration(11min), Duration(-5min), Duration(60min)})
    {
      EXPECT_EQ(Names(*loader->About(start + after)), this->Expected(start + after))
        << after / 1s << " s";
      // As when they ascend, and what each thread still decodes for the time before.
      EXPECT_AT_MOST(this->Alive(), 2U * 3U + 2U * 4U + 2U, "volumes in memory")
        << after / 1s << " s";
    }
    EXPECT_TRUE(this->IsAsScanned(*loader));
    EXPECT_FALSE(loader->HeadersErr());
    if (cached)
    {
      EXPECT_LE(loader->DecodedFiles(), paths.size()); // each once at most
    }
  }
}

TEST_F(VolumeLoading, WithACacheNothingIsDecodedAheadOfTheFirstTime)
{
  // Decodes a file ahead in some milliseconds, or not at all.
  const auto looksAhead = [](const VolumeLoader& loader, std::size_t needed, Duration longest)
  {
    const auto end = std::chrono::steady_clock::now() + longest;
    while (loader.DecodedFiles() <= needed && std::chrono::steady_clock::now() < end)
    {
      std::this_thread::sleep_for(5ms);
    }
    return loader.DecodedFiles() > needed;
  };
  const auto loader = this->Open(1, std::make_shared<PolarCache>(std::size_t(1) << 30));
  loader->About(start + 61min);
  const std::size_t needed = loader->DecodedFiles();
  loader->About(start + 61min);
  EXPECT_FALSE(looksAhead(*loader, needed, 300ms));
  loader->About(start + 62min); // which needs the same files
  EXPECT_TRUE(looksAhead(*loader, needed, 10s));

  const auto other = this->Open(1);
  other->About(start + 61min);
  EXPECT_TRUE(looksAhead(*other, needed, 10s));
}

TEST_F(VolumeLoading, AFileThatChangedIsAnError)
{
  const auto loader = this->Open(1);
  loader->EndAt(start);
  loader->About(start);
  loader->About(start + 60min);
  WriteLevel2(paths[0], {ConstantVolume(keax, start + 1min, 20.0)});
  EXPECT_THROW(loader->About(start), Error);
}

TEST_F(VolumeLoading, StopsWhenAsked)
{
  const auto loader = this->Open(1);
  EXPECT_FALSE(loader->About(start, {}, [](double) { return false; }));
  EXPECT_EQ(Names(*loader->About(start)), this->Expected(start));
}

TEST_F(VolumeLoading, SitesThatAreNotWantedAreNotDecoded)
{
  const auto loader = this->Open(1);
  for (Duration after = 0min; after < 60min; after += 5min)
  {
    loader->About(start + after, {true, false});
  }
  const auto known = loader->Known();
  EXPECT_TRUE(std::none_of(
    known.begin() + 36, known.end(), [](const auto& file) { return !IsUnknown(file); }));
  EXPECT_FALSE(IsUnknown(known[11]));
}

TEST_F(VolumeLoading, NoticesAHeaderThatHidesAVolume)
{
  // The header of KEAX at 18:30 puts it an hour later.
  SetHeaderTime(paths[6], start + 90min);
  const auto loader = this->Open();
  loader->About(start + 20min);
  EXPECT_TRUE(this->IsAsScanned(*loader));
  EXPECT_FALSE(loader->HeadersErr());
  loader->About(start + 32min);
  EXPECT_FALSE(this->IsAsScanned(*loader));
  loader->About(start + 90min); // which needs the file
  EXPECT_TRUE(loader->HeadersErr());
}

TEST_F(VolumeLoading, HeadersMayErrByLessThanAVolume)
{
  for (std::size_t index = 0; index < paths.size(); ++index)
  {
    const Duration period = index < 36 ? 5min : 6min;
    const Time own = start + period * static_cast<int>(index < 36 ? index : index - 36);
    SetHeaderTime(paths[index], own + (index % 2 == 0 ? 40s : -50s));
  }
  const auto loader = this->Open();
  for (Duration after = 30s; after < 3h; after += 90s)
  {
    EXPECT_EQ(Names(*loader->About(start + after)), this->Expected(start + after));
  }
  EXPECT_TRUE(this->IsAsScanned(*loader));
}

TEST_F(VolumeLoading, OfTwoCopiesTheFullerStays)
{
  testing::HandMadeVolume half = ConstantVolume(keax, start + 30min, 20.0);
  half.sweeps[0].rays = 180;
  half.sweeps[0].turn = 180.0;
  paths.insert(paths.begin(), WriteLevel2(folder.Path() / "another", {half}));
  const auto loader = this->Open();
  const auto volumes = *loader->About(start + 31min);
  EXPECT_EQ(Names(volumes), this->Expected(start + 31min));
  EXPECT_EQ(volumes[0].beam->sweeps[0].azimuths.size(), 362U);
  EXPECT_TRUE(this->IsAsScanned(*loader));
}

TEST_F(VolumeLoading, ADamagedFileIsAGapAndNamed)
{
  std::filesystem::resize_file(paths[2], 30); // its header alone
  const auto loader = this->Open();
  EXPECT_EQ(Names(*loader->About(start + 11min)), this->Expected(start + 11min));
  const auto known = loader->Known();
  ASSERT_FALSE(known[2].problems.empty());
  EXPECT_TRUE(known[2].problems.back().leftOut);
}

TEST_F(VolumeLoading, HandsOnWhatPreparingThrows)
{
  LoaderWork work = this->Work();
  work.prepare = [](const std::shared_ptr<const PolarVolume>&) -> ReadyVolume
  { throw std::runtime_error("no room"); };
  SeriesOptions options;
  options.moment = MomentName::REF;
  VolumeLoader loader({paths, *ListByHeaders(paths), {}, {}}, options, work, nullptr, 2);
  EXPECT_THROW(loader.About(start), std::runtime_error);
  EXPECT_THROW(loader.Scan(0), std::runtime_error);
}

TEST(FileList, HeadersTellSiteAndTime)
{
  const TemporaryFolder folder;
  const auto later = WriteLevel2(folder.Path() / "a", {ConstantVolume(keax, start + 5min, 20.0)});
  const auto first = WriteLevel2(folder.Path() / "b", {ConstantVolume(keax, start, 20.0)});
  const auto other = WriteLevel2(folder.Path() / "c", {ConstantVolume(klsx, start, 20.0)});
  const auto list = ListByHeaders({later, first, other});
  ASSERT_TRUE(list);
  ASSERT_EQ(list->size(), 2U);
  EXPECT_EQ(list->at(0).name, "KEAX");
  ASSERT_EQ(list->at(0).files.size(), 2U);
  EXPECT_EQ(list->at(0).files[0].index, 1U);
  EXPECT_EQ(list->at(0).files[0].time, start);
  EXPECT_EQ(list->at(0).files[1].index, 0U);
  const auto renamed = ListByHeaders({later, first, other}, "KABC");
  ASSERT_EQ(renamed->size(), 1U);
  EXPECT_EQ(renamed->at(0).name, "KABC");
  std::ofstream(folder.Path() / "text") << "no header";
  EXPECT_FALSE(ListByHeaders({later, folder.Path() / "text"}));
  EXPECT_FALSE(ListByHeaders({folder.Path() / "absent"}));
}

} // namespace
} // namespace nexrad
