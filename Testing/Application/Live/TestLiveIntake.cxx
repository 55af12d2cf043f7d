// SPDX-License-Identifier: BSD-3-Clause
#include "Live/LiveIntake.h"

#include "Feed/ChunkMaker.h"
#include "Feed/TarMaker.h"
#include "Scans/RadarsOfMissouri.h"
#include "TestData.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <functional>
#include <random>
#include <thread>

using namespace nexrad;
using namespace nexrad::application;
using namespace nexrad::testing;
using namespace std::chrono_literals;
namespace fs = std::filesystem;

namespace
{

/// A folder into which chunks of one radar come (synthetic), by a clock that runs a thousand times
/// as fast as the real one: half a minute of patience is 30 ms.
class LiveIntakes : public ::testing::Test
{
protected:
  static IntakeRules Rules()
  {
    IntakeRules rules;
    rules.settle = 1ms;
    return rules;
  }

  fs::path FolderOf(int number) const { return folder.Path() / "KEAX" / std::to_string(number); }

  void Write(int number, const MadeChunk& chunk, double share = 1.0) const
  {
    MadeChunk part = chunk;
    part.bytes.resize(static_cast<std::size_t>(static_cast<double>(chunk.bytes.size()) * share));
    WriteChunks(this->FolderOf(number), {part});
  }

  // Takes what came; the last change of the volume.
  std::vector<IntakeChange> Take()
  {
    intake.Arrive(listing.Poll());
    auto changes = intake.Take(listing, 10s);
    for (const IntakeChange& change : changes)
    {
      last = change.input;
      if (last.finished)
      {
        finished.push_back(last.volume);
      }
    }
    return changes;
  }

  // Until something holds, as it must at last.
  void TakeUntil(const std::function<bool()>& holds)
  {
    for (int i = 0; i < 5000 && !holds(); ++i)
    {
      this->Take();
      std::this_thread::sleep_for(2ms);
    }
    EXPECT_TRUE(holds());
  }

  ArrivingRadar Radar() const { return intake.Radars().at("KEAX"); }

  const TemporaryFolder folder;
  const LiveClock clock{ReplayRequest{start + 10min, 1000.0}};
  FolderListing listing{{folder.Path()}};
  LiveIntake intake{Rules(), clock};
  LiveInput last;
  std::vector<RadarVolume> finished;
};

} // namespace

TEST_F(LiveIntakes, HandOnEachSweepAsItCompletes)
{
  const auto chunks = CutIntoChunks(VolumeOfSweeps(keax, start, 3, 20.0));
  std::vector<std::size_t> sweeps;
  for (const MadeChunk& chunk : chunks)
  {
    this->Write(1, chunk);
    for (const IntakeChange& change : this->Take())
    {
      sweeps.push_back(change.input.volume.sweeps.size());
      EXPECT_TRUE(change.completed.has_value());
      EXPECT_EQ(change.input.finished, chunk.kind == 'E');
    }
  }
  EXPECT_EQ(sweeps, (std::vector<std::size_t>{1, 2, 3}));
  const ArrivingRadar radar = this->Radar();
  EXPECT_TRUE(radar.finished);
  EXPECT_EQ(radar.counts.used, 10U);
  EXPECT_EQ(radar.counts.missing, 0U);
  EXPECT_EQ(radar.volume, "20060312-180000");
}

TEST_F(LiveIntakes, WaitForTheRestOfAHalfWrittenChunk)
{
  const auto chunks = CutIntoChunks(VolumeOfSweeps(keax, start, 1, 20.0));
  this->Write(1, chunks[0]);
  this->Write(1, chunks[1], 0.5);
  EXPECT_TRUE(this->Take().empty());
  EXPECT_EQ(this->Radar().waiting, 1U);
  this->Write(1, chunks[1]);
  this->Write(1, chunks[2]);
  this->Write(1, chunks[3]);
  ASSERT_EQ(this->Take().size(), 1U);
  EXPECT_EQ(last.volume.RayCount(), 360U);
  EXPECT_TRUE(last.volume.damage.empty());
  const ArrivalCounts counts = this->Radar().counts;
  EXPECT_EQ(counts.used, 4U);
  EXPECT_EQ(counts.halfWritten, 1U);
  EXPECT_EQ(counts.cut, 0U);
  EXPECT_EQ(this->Radar().waiting, 0U);
}

TEST_F(LiveIntakes, TakeWhatIsThereOfAChunkThatStaysTorn)
{
  const auto chunks = CutIntoChunks(VolumeOfSweeps(keax, start, 2, 20.0));
  for (const MadeChunk& chunk : chunks)
  {
    this->Write(1, chunk, chunk.number == 3 ? 0.5 : 1.0);
  }
  this->TakeUntil([this] { return last.finished; });
  EXPECT_EQ(this->Radar().counts.cut, 1U);
  EXPECT_EQ(this->Radar().counts.used, 7U);
  const RadarVolume expected = ReadLevel2(this->FolderOf(1));
  EXPECT_EQ(last.volume.RayCount(), expected.RayCount());
  ASSERT_EQ(last.volume.damage.size(), expected.damage.size());
  // Then the rest comes after all.
  this->Write(1, chunks[2]);
  this->TakeUntil([this] { return last.volume.RayCount() == 720; });
  EXPECT_EQ(this->Radar().counts.replaced, 1U);
}

TEST_F(LiveIntakes, GiveAMissingChunkUpAndTakeItWhenItComes)
{
  const auto chunks = CutIntoChunks(VolumeOfSweeps(keax, start, 3, 20.0));
  for (const MadeChunk& chunk : chunks)
  {
    if (chunk.number != 6)
    {
      this->Write(1, chunk);
    }
  }
  this->Take();
  EXPECT_EQ(last.volume.sweeps.size(), 1U) << "what follows the missing chunk waits";
  EXPECT_EQ(this->Radar().awaited, std::vector<int>{6});
  this->TakeUntil([this] { return last.finished; });
  EXPECT_EQ(last.volume.sweeps.size(), 3U);
  EXPECT_EQ(last.volume.RayCount(), 960U);
  EXPECT_EQ(this->Radar().counts.missing, 1U);
  this->Write(1, chunks[5]);
  this->Take();
  EXPECT_EQ(last.volume.RayCount(), 1080U);
  EXPECT_TRUE(last.finished);
  EXPECT_EQ(this->Radar().counts.missing, 0U);
  EXPECT_EQ(this->Radar().counts.used, 10U);
}

TEST_F(LiveIntakes, CountWhatIsRepeated)
{
  const auto chunks = CutIntoChunks(VolumeOfSweeps(keax, start, 2, 20.0));
  WriteChunks(this->FolderOf(1), chunks);
  this->Take();
  EXPECT_TRUE(last.finished);
  for (const int number : {2, 4, 7})
  {
    const fs::path path = this->FolderOf(1) / chunks[static_cast<std::size_t>(number) - 1].name;
    fs::remove(path); // a new file, of another time
    this->Write(1, chunks[static_cast<std::size_t>(number) - 1]);
    fs::last_write_time(path, fs::last_write_time(path) + 1s);
  }
  EXPECT_TRUE(this->Take().empty());
  EXPECT_EQ(this->Radar().counts.repeated, 3U);
  EXPECT_EQ(this->Radar().counts.used, 7U);
}

// The folder with the number of a volume gets the chunks of a later one.
TEST_F(LiveIntakes, TellVolumesOfOneNumberApart)
{
  WriteChunks(this->FolderOf(999), CutIntoChunks(VolumeOfSweeps(keax, start, 2, 20.0)));
  this->Take();
  EXPECT_EQ(*last.volume.Start(), start);
  WriteChunks(this->FolderOf(999), CutIntoChunks(VolumeOfSweeps(keax, start + 5min, 1, 20.0)));
  this->Take();
  EXPECT_EQ(*last.volume.Start(), start + 5min);
  EXPECT_EQ(last.volume.sweeps.size(), 1U);
  EXPECT_TRUE(last.volume.damage.empty());
  EXPECT_EQ(this->Radar().counts.used, 11U);
}

TEST_F(LiveIntakes, AVolumeWithoutItsEndIsFinishedByTheNext)
{
  auto chunks = CutIntoChunks(VolumeOfSweeps(keax, start, 2, 20.0));
  chunks.pop_back();
  WriteChunks(this->FolderOf(1), chunks);
  this->Take();
  EXPECT_FALSE(last.finished);
  WriteChunks(this->FolderOf(2), CutIntoChunks(VolumeOfSweeps(keax, start + 5min, 1, 20.0)));
  this->TakeUntil(
    [this]
    {
      return std::any_of(finished.begin(), finished.end(),
        [](const RadarVolume& volume) { return *volume.Start() == start; });
    });
}

TEST_F(LiveIntakes, NameWhatCannotBeUsed)
{
  fs::create_directories(folder.Path() / "KEAX");
  std::ofstream(folder.Path() / "KEAX" / "readme.txt") << "no radar file";
  WriteBytes(folder.Path() / "KEAX" / "day.tar", MakeTar({{"KEAX1", MakeSmallVolume(31)}}));
  WriteChunks(this->FolderOf(1), CutIntoChunks(VolumeOfSweeps(keax, start + 48h, 1, 20.0)));
  std::vector<std::string> problems;
  this->TakeUntil(
    [&]
    {
      for (std::string& line : intake.TakeProblems())
      {
        problems.push_back(std::move(line));
      }
      return problems.size() == 6;
    });
  const auto has = [&problems](const std::string& part)
  {
    return std::count_if(problems.begin(), problems.end(),
      [&part](const std::string& line) { return line.find(part) != std::string::npos; });
  };
  EXPECT_EQ(has("readme.txt: not a Level II file: left out"), 1);
  EXPECT_EQ(has("day.tar: an archive, which is not followed: left out"), 1);
  EXPECT_EQ(has("in the future: left out"), 4);
  EXPECT_EQ(intake.Radars().at("").counts.refused, 6U);
}

TEST_F(LiveIntakes, PassOverWhatIsTooOld)
{
  intake.SetOldest(start + 1h);
  WriteChunks(this->FolderOf(1), CutIntoChunks(VolumeOfSweeps(keax, start, 1, 20.0)));
  EXPECT_TRUE(this->Take().empty());
  EXPECT_EQ(intake.Radars().at("").counts.old, 4U);
}

// A file of a whole volume, written in pieces.
TEST_F(LiveIntakes, TakeAFileWhenItIsWhole)
{
  const auto chunks = CutIntoChunks(VolumeOfSweeps(keax, start, 2, 20.0));
  const fs::path path = folder.Path() / "KEAX20060312_180000_V06";
  std::ofstream file(path, std::ios::binary);
  for (const MadeChunk& chunk : chunks)
  {
    const auto* bytes = reinterpret_cast<const char*>(chunk.bytes.data());
    const auto half = static_cast<std::streamsize>(chunk.bytes.size() / 2);
    file.write(bytes, half).flush();
    EXPECT_TRUE(this->Take().empty()) << chunk.name;
    file.write(bytes + half, static_cast<std::streamsize>(chunk.bytes.size()) - half).flush();
  }
  ASSERT_EQ(this->Take().size(), 1U);
  EXPECT_TRUE(last.finished);
  EXPECT_EQ(last.volume.RayCount(), 720U);
  EXPECT_EQ(this->Radar().counts.used, 1U);
}

// A file without lengths in it, of which nothing was written for long, is taken at once.
TEST_F(LiveIntakes, AnOldFileIsTakenAtOnce)
{
  fs::create_directories(folder.Path() / "KEAX");
  const fs::path path =
    WriteLevel2(folder.Path() / "KEAX" / "old", {ConstantVolume(keax, start, 20.0)});
  fs::last_write_time(path, fs::file_time_type::clock::now() - 1h);
  EXPECT_EQ(this->Take().size(), 1U);
  EXPECT_EQ(intake.OldestWaiting(), std::nullopt);
  const auto chunks = CutIntoChunks(VolumeOfSweeps(keax, start + 5min, 1, 20.0));
  this->Write(1, chunks[0], 0.5);
  this->Take();
  EXPECT_EQ(intake.OldestWaiting(), start + 5min);
}

// Seeds of an arbitrary feed: each file is counted, and the volume is that of the folder.
TEST_F(LiveIntakes, AccountForEveryChunkOfAFeedInDisorder)
{
  std::mt19937 random(16);
  std::size_t written = 0;
  std::size_t again = 0;
  for (int number = 1; number <= 6; ++number)
  {
    auto chunks = CutIntoChunks(VolumeOfSweeps(keax, start + number * 1min, 3, 20.0 + number));
    std::shuffle(chunks.begin(), chunks.end(), random);
    for (const MadeChunk& chunk : chunks)
    {
      const unsigned draw = random() % 10;
      if (draw == 0)
      {
        continue; // missing
      }
      this->Write(number, chunk, draw == 1 ? 0.3 : 1.0);
      this->Take();
      this->Write(number, chunk);
      ++written;
      if (draw == 2)
      {
        this->Take();
        const fs::path path = this->FolderOf(number) / chunk.name;
        fs::last_write_time(path, fs::last_write_time(path) + 1s);
        ++again;
      }
      this->Take();
    }
  }
  intake.FinishAll(listing);
  const ArrivalCounts counts = this->Radar().counts;
  EXPECT_EQ(counts.used, written);
  EXPECT_GE(counts.repeated, again);
  EXPECT_EQ(counts.refused + counts.old + counts.cut, 0U);
}

// A file of another decade, whether it comes with the feed, after it or before it.
TEST_F(LiveIntakes, PassOverWhatIsOfAnotherDecade)
{
  const Site old = {"KIWX", Position{41.36, -85.7, 320.0}};
  const auto writeOld = [&](int number)
  {
    WriteChunks(folder.Path() / "KIWX" / std::to_string(number),
      CutIntoChunks(VolumeOfSweeps(old, start - 80'000h + number * 10min, 1, 20.0)));
  };
  writeOld(1);
  const auto first = this->Take();
  ASSERT_EQ(first.size(), 1U) << "it may be an archive";
  EXPECT_TRUE(intake.TakeProblems().empty());
  // With the next one comes the feed.
  writeOld(2);
  this->Write(1, CutIntoChunks(VolumeOfSweeps(keax, start + 5min, 1, 20.0))[0]);
  for (const MadeChunk& chunk : CutIntoChunks(VolumeOfSweeps(keax, start + 5min, 1, 20.0)))
  {
    this->Write(1, chunk);
  }
  const auto changes = this->Take();
  ASSERT_EQ(changes.size(), 2U);
  EXPECT_TRUE(changes[1].isTakenBack);
  EXPECT_EQ(changes[1].input.key, first[0].input.key);
  EXPECT_TRUE(changes[1].input.volume.sweeps.empty());
  EXPECT_EQ(changes[0].input.volume.site.name, "KEAX");
  writeOld(3);
  EXPECT_TRUE(this->Take().empty());
  const std::vector<std::string> problems = intake.TakeProblems();
  ASSERT_EQ(problems.size(), 3U) << "one line for each volume";
  for (const std::string& line : problems)
  {
    EXPECT_NE(line.find("KIWX/"), std::string::npos) << line;
    EXPECT_NE(line.find("long before the feed"), std::string::npos) << line;
  }
  std::size_t counted = 0;
  for (const auto& [name, radar] : intake.Radars())
  {
    counted += radar.counts.old;
    EXPECT_EQ(radar.counts.used, name == "KEAX" ? 4U : 0U) << name;
  }
  EXPECT_EQ(counted, 3U * 4U);
}

// What an archive has before a pause comes alone, so that its steps can be made first.
TEST_F(LiveIntakes, StopAtAPauseOfAnArchive)
{
  for (const auto ago : {9'000h, 8'000h})
  {
    WriteChunks(this->FolderOf(static_cast<int>(ago.count() % 999)),
      CutIntoChunks(VolumeOfSweeps(keax, start - ago, 1, 20.0)));
  }
  intake.Arrive(listing.Poll());
  ASSERT_EQ(intake.Take(listing, 10s).size(), 1U);
  EXPECT_TRUE(intake.IsBehind());
  const auto second = intake.Take(listing, 10s);
  ASSERT_EQ(second.size(), 1U);
  EXPECT_EQ(*second[0].input.volume.Start(), start - 8'000h);
  EXPECT_TRUE(intake.TakeProblems().empty());
}
