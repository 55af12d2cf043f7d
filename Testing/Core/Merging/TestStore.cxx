// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Merging/Store.h"

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
#include <set>
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
class StoredVolumes : public ::testing::Test
{
protected:
  StoredVolumes()
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

  StoreWork Work()
  {
    StoreWork work;
    work.options.moments = {MomentName::REF};
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

  // `memory`: bytes of moments that are kept for times in any order.
  std::unique_ptr<Store> Open(unsigned threads = 2, std::optional<std::size_t> memory = {})
  {
    const auto headers = ListByHeaders(paths);
    EXPECT_TRUE(headers);
    auto store = std::make_unique<Store>(paths, *headers, threads);
    if (memory)
    {
      store->KeepUpTo(*memory);
    }
    store->Begin(this->Work(), {});
    return store;
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

  // Whether each time so far was made of what a scan of all files leads to.
  bool IsAsScanned(const Store& store)
  {
    return std::all_of(asked.begin(), asked.end(),
      [&](Time time)
      {
        return store.LastMadeOf(time) ==
               this->Scan().MadeOf(time, VolumeRuleOf(request), {MomentName::REF});
      });
  }

  std::vector<ReadyVolume> About(Store& store, Time time)
  {
    asked.insert(time);
    return *store.About(time);
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

  std::size_t BytesOfAVolume()
  {
    std::size_t bytes = 0;
    ScanFile(paths[0], this->Work().options,
      [&bytes](const SeriesVolume&, const RadarVolume&,
        const std::shared_ptr<const PolarVolume>& moment) { bytes = MemoryOf(*moment); });
    return bytes;
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
  std::set<Time> asked;
  std::optional<SeriesScan> scan;
  std::mutex mutex;
  std::size_t decoded = 0;
  std::vector<std::weak_ptr<const BeamVolume>> made;
};

TEST_F(StoredVolumes, GivesWhatAScanWouldAndHoldsLittle)
{
  for (const unsigned threads : {1U, 3U})
  {
    decoded = 0;
    made.clear();
    const auto store = this->Open(threads);
    // From before the first volume to after the last, with steps shorter and longer than volumes.
    for (const Duration after : {Duration(-20min), Duration(-10min), Duration(0min), Duration(3s),
           Duration(4min), Duration(7min), Duration(20min), Duration(65min), Duration(66min),
           Duration(119min), Duration(179min), Duration(190min), Duration(200min)})
    {
      EXPECT_EQ(Names(this->About(*store, start + after)), this->Expected(start + after))
        << after / 1s << " s";
      // One in progress, one before, one after of each radar, and three ahead on each thread with
      // the one that it decodes.
      EXPECT_AT_MOST(this->Alive(), 2U * 3U + threads * 4U, "volumes in memory")
        << after / 1s << " s";
    }
    EXPECT_LE(decoded,
      paths.size()); // each once, and those between two times that neither needs not at all
    EXPECT_TRUE(this->IsAsScanned(*store));
  }
}

TEST_F(StoredVolumes, BeginsInTheMiddleAndEndsThere)
{
  const auto store = this->Open();
  store->EndAt(start + 100min);
  EXPECT_EQ(Names(this->About(*store, start + 95min)), this->Expected(start + 95min));
  EXPECT_EQ(Names(this->About(*store, start + 100min)), this->Expected(start + 100min));
  EXPECT_AT_MOST(decoded, 12U, "files decoded"); // of 66
}

TEST_F(StoredVolumes, ScansAFileOnRequestAndKeepsItForItsTime)
{
  const auto store = this->Open();
  const ScannedFile last = store->Scan(35); // KEAX at 20:55
  ASSERT_EQ(last.volumes.size(), 1U);
  EXPECT_EQ(last.volumes[0].second.start, start + 175min);
  for (Duration after = 0min; after <= 180min; after += 10min)
  {
    EXPECT_EQ(Names(this->About(*store, start + after)), this->Expected(start + after));
  }
  EXPECT_EQ(decoded, paths.size());
  EXPECT_EQ(store->Known()[35].volumes.size(), 1U);
}

TEST_F(StoredVolumes, TimesMayComeInAnyOrder)
{
  for (const bool cached : {false, true})
  {
    decoded = 0;
    const auto store = this->Open(2, cached ? std::optional(std::size_t(1) << 30) : std::nullopt);
    for (const Duration after : {Duration(120min), Duration(10min), Duration(175min),
           Duration(119min), Duration(121min), Duration(11min), Duration(-5min), Duration(60min)})
    {
      EXPECT_EQ(Names(this->About(*store, start + after)), this->Expected(start + after))
        << after / 1s << " s";
      // As when they ascend, and what each thread still decodes for the time before.
      EXPECT_AT_MOST(this->Alive(), 2U * 3U + 2U * 4U + 2U, "volumes in memory")
        << after / 1s << " s";
    }
    EXPECT_TRUE(this->IsAsScanned(*store));
    EXPECT_FALSE(store->HeadersErr());
    if (cached)
    {
      EXPECT_LE(store->DecodedFiles(), paths.size()); // each once at most
    }
  }
}

TEST_F(StoredVolumes, WithACacheNothingIsDecodedAheadOfTheFirstTime)
{
  // Decodes a file ahead in some milliseconds, or not at all.
  const auto looksAhead = [](const Store& store, std::size_t needed, Duration longest)
  {
    const auto end = std::chrono::steady_clock::now() + longest;
    while (store.DecodedFiles() <= needed && std::chrono::steady_clock::now() < end)
    {
      std::this_thread::sleep_for(5ms);
    }
    return store.DecodedFiles() > needed;
  };
  const auto store = this->Open(1, std::size_t(1) << 30);
  store->About(start + 61min);
  const std::size_t needed = store->DecodedFiles();
  store->About(start + 61min);
  EXPECT_FALSE(looksAhead(*store, needed, 300ms));
  store->About(start + 62min); // which needs the same files
  EXPECT_TRUE(looksAhead(*store, needed, 10s));

  const auto other = this->Open(1);
  other->About(start + 61min);
  EXPECT_TRUE(looksAhead(*other, needed, 10s));
}

TEST_F(StoredVolumes, MomentsAreKeptWithinTheLimit)
{
  constexpr std::size_t room = 24; // volumes
  const auto store = this->Open(1, room * this->BytesOfAVolume());
  for (Duration after = 0min; after <= 180min; after += 5min)
  {
    store->About(start + after);
  }
  EXPECT_EQ(store->DecodedFiles(), paths.size());
  // Of the last hour there are 12 and 10.
  store->About(start + 130min);
  EXPECT_EQ(store->DecodedFiles(), paths.size());
  store->About(start);
  EXPECT_GT(store->DecodedFiles(), paths.size());

  const auto forgetful = this->Open(1, 0);
  forgetful->About(start + 60min);
  forgetful->About(start + 120min);
  const std::size_t decodedOnce = forgetful->DecodedFiles();
  forgetful->About(start + 60min);
  EXPECT_GT(forgetful->DecodedFiles(), decodedOnce);
}

// As during a scan of all files: the earliest stay.
TEST_F(StoredVolumes, OffersDropNothing)
{
  constexpr std::size_t room = 10; // volumes
  const auto store = this->Open(1, room * this->BytesOfAVolume());
  SeriesOptions options = this->Work().options;
  options.threads = 1;
  const auto files = ScanEach(paths, options,
    [&](const SeriesVolume& volume, const RadarVolume&,
      const std::shared_ptr<const PolarVolume>& moment) { store->Offer(volume, moment); });
  store->LearnAll(*files);
  store->Begin(this->Work(), CollectSeries({}, *files));
  store->About(start + 40min, {true, false});
  EXPECT_EQ(store->DecodedFiles(), 0U);
  store->About(start + 60min, {true, false});
  EXPECT_GT(store->DecodedFiles(), 0U);
}

TEST_F(StoredVolumes, AFileThatChangedIsAnError)
{
  const auto store = this->Open(1);
  store->EndAt(start);
  store->About(start);
  store->About(start + 60min);
  WriteLevel2(paths[0], {ConstantVolume(keax, start + 1min, 20.0)});
  EXPECT_THROW(store->About(start), Error);
}

TEST_F(StoredVolumes, StopsWhenAsked)
{
  const auto store = this->Open(1);
  EXPECT_FALSE(store->About(start, {}, [](double) { return false; }));
  EXPECT_EQ(Names(this->About(*store, start)), this->Expected(start));
}

TEST_F(StoredVolumes, SitesThatAreNotWantedAreNotDecoded)
{
  const auto store = this->Open(1);
  for (Duration after = 0min; after < 60min; after += 5min)
  {
    store->About(start + after, {true, false});
  }
  const auto known = store->Known();
  EXPECT_TRUE(std::none_of(
    known.begin() + 36, known.end(), [](const auto& file) { return !IsUnknown(file); }));
  EXPECT_FALSE(IsUnknown(known[11]));
}

TEST_F(StoredVolumes, NoticesAHeaderThatHidesAVolume)
{
  // The header of KEAX at 18:30 puts it an hour later.
  SetHeaderTime(paths[6], start + 90min);
  const auto store = this->Open();
  this->About(*store, start + 20min);
  EXPECT_TRUE(this->IsAsScanned(*store));
  EXPECT_FALSE(store->HeadersErr());
  this->About(*store, start + 32min);
  EXPECT_FALSE(this->IsAsScanned(*store));
  this->About(*store, start + 90min); // which needs the file
  EXPECT_TRUE(store->HeadersErr());
}

TEST_F(StoredVolumes, HeadersMayErrByLessThanAVolume)
{
  for (std::size_t index = 0; index < paths.size(); ++index)
  {
    const Duration period = index < 36 ? 5min : 6min;
    const Time own = start + period * static_cast<int>(index < 36 ? index : index - 36);
    SetHeaderTime(paths[index], own + (index % 2 == 0 ? 40s : -50s));
  }
  const auto store = this->Open();
  for (Duration after = 30s; after < 3h; after += 90s)
  {
    EXPECT_EQ(Names(this->About(*store, start + after)), this->Expected(start + after));
  }
  EXPECT_TRUE(this->IsAsScanned(*store));
}

TEST_F(StoredVolumes, OfTwoCopiesTheFullerStays)
{
  testing::HandMadeVolume half = ConstantVolume(keax, start + 30min, 20.0);
  half.sweeps[0].rays = 180;
  half.sweeps[0].turn = 180.0;
  paths.insert(paths.begin(), WriteLevel2(folder.Path() / "another", {half}));
  const auto store = this->Open();
  const auto volumes = this->About(*store, start + 31min);
  EXPECT_EQ(Names(volumes), this->Expected(start + 31min));
  EXPECT_EQ(volumes[0].beam->sweeps[0].azimuths.size(), 362U);
  EXPECT_TRUE(this->IsAsScanned(*store));
}

TEST_F(StoredVolumes, ADamagedFileIsAGapAndNamed)
{
  std::filesystem::resize_file(paths[2], 30); // its header alone
  const auto store = this->Open();
  EXPECT_EQ(Names(this->About(*store, start + 11min)), this->Expected(start + 11min));
  const auto known = store->Known();
  ASSERT_FALSE(known[2].problems.empty());
  EXPECT_TRUE(known[2].problems.back().leftOut);
}

TEST_F(StoredVolumes, HandsOnWhatPreparingThrows)
{
  StoreWork work = this->Work();
  work.prepare = [](const std::shared_ptr<const PolarVolume>&) -> ReadyVolume
  { throw std::runtime_error("no room"); };
  Store store(paths, *ListByHeaders(paths), 2);
  store.Begin(work, {});
  EXPECT_THROW(store.About(start), std::runtime_error);
  EXPECT_THROW(store.Scan(0), std::runtime_error);
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
  const std::vector<TimedFile>& files = list->at("KEAX");
  ASSERT_EQ(files.size(), 2U);
  EXPECT_EQ(files[0].index, 1U);
  EXPECT_EQ(files[0].time, start);
  EXPECT_EQ(files[1].index, 0U);
  const auto renamed = ListByHeaders({later, first, other}, "KABC");
  ASSERT_EQ(renamed->size(), 1U);
  EXPECT_EQ(renamed->count("KABC"), 1U);
  std::ofstream(folder.Path() / "text") << "no header";
  EXPECT_FALSE(ListByHeaders({later, folder.Path() / "text"}));
  EXPECT_FALSE(ListByHeaders({folder.Path() / "absent"}));
}

} // namespace
} // namespace nexrad
