// SPDX-License-Identifier: BSD-3-Clause
// What a window sees of a series that another thread opens and loads.
#include "Filters/Series/BackgroundSeries.h"
#include "Filters/Series/InputSeries.h"

#include "TestData.h"
#include "nexrad/System/Error.h"

#include <vtkImageData.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstring>
#include <filesystem>
#include <mutex>
#include <set>
#include <thread>
#include <utility>

using namespace nexrad;

namespace
{

constexpr std::size_t None = 99;

struct Plan
{
  std::size_t count = 5;
  bool opens = true;
  bool opensSlowly = false;     // until it is told to stop
  std::size_t broken = None;    // cannot be loaded
  std::size_t brokenBox = None; // its box cannot be merged
  std::size_t slow = None;      // is loaded only once `release` is set
  std::size_t kibibytes = 1024; // of each volume
  std::size_t earliest = 0;     // minutes, of the first volume
  std::size_t rewritten = None; // has other contents than in other plans
};

// A series that notes what it was asked for.
class NotedSeries : public VolumeSeries
{
public:
  struct Notes
  {
    std::mutex mutex;
    std::vector<std::size_t> loaded;
    std::atomic<bool> release = false;
    std::atomic<int> stopped = 0;
    std::set<std::thread::id> threads;
  };

  NotedSeries(const Plan& thePlan, Notes& theNotes)
    : plan(thePlan)
    , notes(theNotes)
  {
    for (std::size_t i = 0; i < plan.count; ++i)
    {
      times.push_back(Time(std::chrono::minutes(plan.earliest + i)));
    }
  }

  const std::vector<Time>& Times() const override { return times; }

  std::string Contents(std::size_t index) const override
  {
    return std::to_string(plan.earliest + index) + (index == plan.rewritten ? " new" : "");
  }

  std::vector<std::string> Problems() const override
  {
    const std::lock_guard<std::mutex> lock(notes.mutex);
    return std::vector<std::string>(notes.loaded.size(), "damaged");
  }

  vtkSmartPointer<vtkImageData> Load(std::size_t index, const Progress& progress) override
  {
    while (index == plan.slow && !notes.release)
    {
      if (!progress(0.5))
      {
        ++notes.stopped;
        return nullptr;
      }
      std::this_thread::yield();
    }
    {
      const std::lock_guard<std::mutex> lock(notes.mutex);
      notes.loaded.push_back(index);
      notes.threads.insert(std::this_thread::get_id());
    }
    if (index == plan.broken)
    {
      throw Error("broken");
    }
    auto volume = vtkSmartPointer<vtkImageData>::New();
    volume->SetDimensions(1024, static_cast<int>(plan.kibibytes), 1);
    volume->SetOrigin(static_cast<double>(plan.earliest + index), 0.0, 0.0);
    volume->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
    return volume;
  }

  vtkSmartPointer<vtkImageData> LoadBox(
    std::size_t index, const BoxRequest& box, const Progress&) override
  {
    if (index == plan.brokenBox)
    {
      throw Error("broken box");
    }
    auto image = vtkSmartPointer<vtkImageData>::New();
    image->SetOrigin(static_cast<double>(index), box.faces[0], 0.0);
    return image;
  }

private:
  const Plan plan;
  Notes& notes;
  std::vector<Time> times;
};

class BackgroundSeriesTest : public ::testing::Test
{
protected:
  void Open(const Plan& plan, std::size_t memory = std::size_t(1) << 30)
  {
    onDisk = plan;
    options.open = [this](const Progress& progress) -> std::unique_ptr<VolumeSeries>
    {
      const Plan now = this->OnDisk();
      while (now.opensSlowly)
      {
        if (!progress(0.25))
        {
          throw Error("stopped");
        }
        std::this_thread::yield();
      }
      if (!now.opens)
      {
        throw Error("no such file");
      }
      return std::make_unique<NotedSeries>(now, notes);
    };
    options.memory = memory;
    options.wake = [this]
    {
      const std::lock_guard<std::mutex> lock(mutex);
      changed.notify_all();
    };
    series = std::make_unique<BackgroundSeries>(options);
  }

  Plan OnDisk()
  {
    const std::lock_guard<std::mutex> lock(mutex);
    return onDisk;
  }

  // The inputs are others now, and are opened again.
  void Reopen(const Plan& plan)
  {
    {
      const std::lock_guard<std::mutex> lock(mutex);
      onDisk = plan;
    }
    series->Reopen();
  }

  template <typename Condition>
  void WaitUntil(const Condition& condition)
  {
    std::unique_lock<std::mutex> lock(mutex);
    EXPECT_TRUE(
      changed.wait_for(lock, std::chrono::seconds(60), [&] { return condition(series->Get()); }));
  }

  // Asks for a step until it is there, and says which volume it was.
  double Shown(std::size_t step)
  {
    vtkSmartPointer<vtkImageData> volume;
    this->WaitUntil(
      [&](const auto&)
      {
        volume = series->Show(step);
        return volume != nullptr;
      });
    return volume ? volume->GetOrigin()[0] : -1.0;
  }

  static std::size_t CountLoaded(const BackgroundSeries::State& state)
  {
    return static_cast<std::size_t>(std::count(state.loaded.begin(), state.loaded.end(), true));
  }

  std::size_t CountLoads()
  {
    const std::lock_guard<std::mutex> lock(notes.mutex);
    return notes.loaded.size();
  }

  NotedSeries::Notes notes;
  Plan onDisk;
  std::mutex mutex;
  std::condition_variable changed;
  BackgroundSeriesOptions options;
  std::unique_ptr<BackgroundSeries> series;
};

} // namespace

TEST_F(BackgroundSeriesTest, LoadsTheStepThatIsShownAndThenThoseAfterIt)
{
  Plan plan;
  plan.slow = 0; // the first is loaded at once; another is asked for meanwhile
  this->Open(plan);
  this->WaitUntil([](const auto& state) { return state.loads.has_value(); });
  EXPECT_EQ(this->Shown(3), 3.0);
  EXPECT_EQ(notes.stopped, 1) << "what was not wanted any more was stopped";
  notes.release = true;
  this->WaitUntil([](const auto& state) { return CountLoaded(state) == 5; });
  EXPECT_EQ(notes.loaded, (std::vector<std::size_t>{3, 4, 0, 1, 2}));
  EXPECT_EQ(notes.threads.count(std::this_thread::get_id()), 0U);
  for (const std::size_t step : {0, 4, 2})
  {
    ASSERT_NE(series->Show(step), nullptr) << "all are in memory";
  }
  EXPECT_EQ(notes.loaded.size(), 5U);
}

// As a command does, which has nothing else to do.
TEST_F(BackgroundSeriesTest, WhoeverWaitsGetsTheStep)
{
  this->Open({});
  for (const std::size_t step : {0, 1, 2, 3, 0, 2, 1, 1, 3, 4, 0})
  {
    EXPECT_EQ(series->Wait(step)->GetOrigin()[0], static_cast<double>(step));
  }
  EXPECT_EQ(notes.loaded.size(), 5U) << "each once";
  EXPECT_EQ(notes.threads.count(std::this_thread::get_id()), 0U);
}

TEST_F(BackgroundSeriesTest, WhoeverWaitsIsToldHowFarItIsAndMayStop)
{
  Plan plan;
  plan.slow = 1;
  this->Open(plan);
  series->Wait(0);
  double told = 0.0;
  const auto stop = [&told](double fraction)
  {
    told = fraction;
    return fraction < 0.5;
  };
  EXPECT_EQ(series->Wait(1, stop), nullptr);
  EXPECT_EQ(told, 0.5);
  EXPECT_EQ(series->Wait(3)->GetOrigin()[0], 3.0) << "what is loaded in vain is stopped";
}

TEST_F(BackgroundSeriesTest, WhoeverWaitsForAFailureIsToldAndMayTryAgain)
{
  Plan plan;
  plan.broken = 1;
  this->Open(plan);
  EXPECT_THROW(series->Wait(1), Error);
  EXPECT_THROW(series->Wait(1), Error);
  EXPECT_EQ(series->Wait(2)->GetOrigin()[0], 2.0);
  EXPECT_GE(std::count(notes.loaded.begin(), notes.loaded.end(), std::size_t(1)), 2);
  plan.opens = false;
  this->Open(plan);
  EXPECT_THROW(series->Wait(0), Error);
}

TEST_F(BackgroundSeriesTest, RadarFilesMergeAheadToTheSameVolumes)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  MergeOptions grid;
  grid.grid.dimensions = {32, 32, 16};
  const std::vector<std::filesystem::path> inputs = {data / "level2" / "run-kbgm-20050821"};
  const auto direct = OpenRadarFiles(inputs, grid);
  ASSERT_GE(direct->Times().size(), 3U);
  options.open = [&](const Progress& progress) { return OpenRadarFiles(inputs, grid, progress); };
  BackgroundSeries ahead(options);
  for (const std::size_t index : {0, 1, 2, 0, 2, 1})
  {
    const auto volume = ahead.Wait(index);
    const auto expected = direct->Load(index, {});
    const auto bytes = static_cast<std::size_t>(32 * 32 * 16) * sizeof(float);
    ASSERT_EQ(volume->GetNumberOfPoints(), 32 * 32 * 16);
    EXPECT_EQ(std::memcmp(volume->GetScalarPointer(), expected->GetScalarPointer(), bytes), 0)
      << "volume " << index;
  }
  EXPECT_EQ(ahead.Get().damage, direct->Problems());
}

TEST_F(BackgroundSeriesTest, SaysTimesAndDamage)
{
  this->Open({});
  this->WaitUntil([](const auto& state) { return CountLoaded(state) == 5; });
  const BackgroundSeries::State state = series->Get();
  EXPECT_EQ(state.phase, BackgroundSeries::Phase::Open);
  ASSERT_EQ(state.times.size(), 5U);
  EXPECT_EQ(state.times[2], Time(std::chrono::minutes(2)));
  EXPECT_EQ(state.damage.size(), 5U) << "a line for each volume so far";
}

TEST_F(BackgroundSeriesTest, ShowsTheChosenStepsAlone)
{
  options.choose = [](const VolumeSeries&) { return std::vector<std::size_t>{4, 1}; };
  this->Open({});
  EXPECT_EQ(this->Shown(1), 1.0);
  EXPECT_EQ(this->Shown(0), 4.0);
  EXPECT_EQ(series->Get().times.size(), 2U);
}

TEST_F(BackgroundSeriesTest, TheMemoryIsKept)
{
  Plan plan;
  plan.count = 8;
  this->Open(plan, 3 * 1100 * 1024); // three volumes of 1 MiB
  for (const std::size_t step : {0, 1, 5, 7, 2})
  {
    EXPECT_EQ(this->Shown(step), static_cast<double>(step));
    this->WaitUntil(
      [step](const auto& state)
      {
        const auto& loaded = state.loaded; // the step and the next two
        return loaded[step] && loaded[(step + 1) % 8] && loaded[(step + 2) % 8];
      });
    EXPECT_EQ(CountLoaded(series->Get()), 3U);
  }
}

TEST_F(BackgroundSeriesTest, OneVolumeIsKeptWhateverTheMemory)
{
  this->Open({}, 1);
  for (const std::size_t step : {0, 3, 1})
  {
    EXPECT_EQ(this->Shown(step), static_cast<double>(step));
    EXPECT_EQ(CountLoaded(series->Get()), 1U);
  }
}

TEST_F(BackgroundSeriesTest, AFailureIsToldWhereItHappens)
{
  Plan plan;
  plan.broken = 1;
  this->Open(plan);
  EXPECT_EQ(this->Shown(0), 0.0);
  this->WaitUntil([](const auto& state) { return CountLoaded(state) == 4; });
  EXPECT_THROW(series->Show(1), Error);
  EXPECT_EQ(this->Shown(2), 2.0);
}

TEST_F(BackgroundSeriesTest, WhatCannotBeOpenedSaysWhy)
{
  Plan plan;
  plan.opens = false;
  this->Open(plan);
  this->WaitUntil([](const auto& state) { return state.phase == BackgroundSeries::Phase::Failed; });
  EXPECT_EQ(series->Get().failure, "no such file");
  EXPECT_EQ(series->Show(0), nullptr);
}

TEST_F(BackgroundSeriesTest, PausingLoadsTheStepThatIsShownAlone)
{
  Plan plan;
  plan.slow = 1;
  this->Open(plan);
  EXPECT_EQ(this->Shown(0), 0.0);
  this->WaitUntil([](const auto& state) { return state.loads == std::size_t(1); });
  series->Pause(true);
  this->WaitUntil([](const auto& state) { return !state.loads; });
  EXPECT_EQ(notes.stopped, 1);
  EXPECT_EQ(this->Shown(3), 3.0) << "what is asked for is loaded nevertheless";
  EXPECT_EQ(CountLoaded(series->Get()), 2U);
  notes.release = true;
  series->Pause(false);
  this->WaitUntil([](const auto& state) { return CountLoaded(state) == 5; });
}

TEST_F(BackgroundSeriesTest, APictureThatWasWaitedForIsDrawnBeforeOthersAreLoaded)
{
  options.drawsFirst = true;
  this->Open(Plan());
  EXPECT_EQ(this->Shown(0), 0.0);
  EXPECT_EQ(this->Shown(3), 3.0) << "what is asked for is loaded nevertheless";
  series->GoOn();
  this->WaitUntil([](const auto& state) { return CountLoaded(state) == 5; });
  EXPECT_EQ(notes.loaded, (std::vector<std::size_t>{0, 3, 4, 1, 2}));
  EXPECT_EQ(notes.stopped, 0) << "nothing else was being loaded";
}

TEST_F(BackgroundSeriesTest, PausingStopsTheOpening)
{
  Plan plan;
  plan.opensSlowly = true;
  this->Open(plan);
  this->WaitUntil([](const auto& state) { return state.fraction == 0.25; });
  series->Pause(true);
  this->WaitUntil([](const auto& state) { return state.phase == BackgroundSeries::Phase::Failed; });
  EXPECT_EQ(series->Get().failure, "stopped");
}

TEST_F(BackgroundSeriesTest, EndsWhileItWorks)
{
  Plan plan;
  plan.slow = 2;
  this->Open(plan);
  EXPECT_EQ(this->Shown(0), 0.0);
  this->WaitUntil([](const auto& state) { return state.loads == std::size_t(2); });
  series.reset();
  EXPECT_EQ(notes.stopped, 1);
  plan.opensSlowly = true;
  this->Open(plan);
  series.reset(); // while it is opened
}

TEST_F(BackgroundSeriesTest, GrowsByWhatWasAddedAlone)
{
  Plan plan;
  plan.count = 3;
  this->Open(plan);
  EXPECT_EQ(this->Shown(2), 2.0);
  this->WaitUntil([](const auto& state) { return CountLoaded(state) == 3; });
  plan.count = 5;
  this->Reopen(plan);
  this->WaitUntil([](const auto& state) { return CountLoaded(state) == 5; });
  EXPECT_EQ(notes.loaded.size(), 5U) << "none of them twice";
  EXPECT_EQ(series->Get().times.size(), 5U);
}

TEST_F(BackgroundSeriesTest, KeepsTheTimeThatIsShownWhenOthersComeBeforeIt)
{
  Plan plan;
  plan.earliest = 2;
  plan.count = 2;
  this->Open(plan);
  EXPECT_EQ(this->Shown(1), 3.0);
  this->WaitUntil([](const auto& state) { return CountLoaded(state) == 2; });
  plan.earliest = 0;
  plan.count = 4;
  plan.slow = 0; // is loaded last, after what follows the step that is shown
  this->Reopen(plan);
  this->WaitUntil([](const auto& state) { return state.loads == std::size_t(0); });
  EXPECT_EQ(CountLoaded(series->Get()), 2U) << "the two of before";
  EXPECT_EQ(this->Shown(3), 3.0);
  notes.release = true;
  this->WaitUntil([](const auto& state) { return CountLoaded(state) == 4; });
}

TEST_F(BackgroundSeriesTest, LoadsAgainWhatWasWrittenAnew)
{
  Plan plan;
  plan.count = 3;
  this->Open(plan);
  this->WaitUntil([](const auto& state) { return CountLoaded(state) == 3; });
  plan.rewritten = 1;
  this->Reopen(plan);
  this->WaitUntil(
    [this](const auto& state) { return this->CountLoads() == 4 && CountLoaded(state) == 3; });
  EXPECT_EQ(notes.loaded.back(), 1U);
}

TEST_F(BackgroundSeriesTest, StaysAsItWasWhereItCannotBeOpenedAgain)
{
  Plan plan;
  plan.count = 3;
  this->Open(plan);
  this->WaitUntil([](const auto& state) { return CountLoaded(state) == 3; });
  plan.opens = false;
  this->Reopen(plan);
  this->WaitUntil([](const auto& state) { return state.damage.size() == 4; });
  EXPECT_EQ(series->Get().damage.back(), "no such file");
  EXPECT_EQ(CountLoaded(series->Get()), 3U);
  plan.opens = true;
  plan.count = 4;
  this->Reopen(plan);
  this->WaitUntil([](const auto& state) { return CountLoaded(state) == 4; });
  EXPECT_EQ(series->Get().damage.size(), 4U) << "a line for each volume, and none of the failure";
}

TEST_F(BackgroundSeriesTest, MergesABoxForEachStep)
{
  this->Open({});
  this->WaitUntil([](const auto& state) { return CountLoaded(state) == 5; });
  EXPECT_EQ(series->Box(0), nullptr) << "none is set";
  BoxRequest box;
  for (const double west : {7.0, 8.0})
  {
    box.faces = {west, 10.0, 0.0, 1.0};
    series->SetBox(box);
    for (const std::size_t step : {4, 0, 2})
    {
      vtkSmartPointer<vtkImageData> merged;
      this->WaitUntil(
        [&](const auto&)
        {
          merged = series->Box(step);
          return merged != nullptr;
        });
      EXPECT_EQ(merged->GetOrigin()[0], static_cast<double>(step));
      EXPECT_EQ(merged->GetOrigin()[1], west);
    }
  }
  series->SetBox({});
  EXPECT_EQ(series->Box(0), nullptr);
  EXPECT_EQ(notes.loaded.size(), 5U) << "no volume is loaded again";
}

TEST_F(BackgroundSeriesTest, SaysWhyABoxCannotBeMerged)
{
  Plan plan;
  plan.count = 2;
  plan.brokenBox = 0;
  this->Open(plan);
  this->WaitUntil([](const auto& state) { return CountLoaded(state) == 2; });
  series->SetBox(BoxRequest());
  this->WaitUntil([this](const auto&) { return series->Box(1) != nullptr; });
  EXPECT_THROW(series->Box(0), Error);
}
