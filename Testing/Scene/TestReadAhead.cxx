// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/Series/RadarFiles.h"
#include "Scene/Series/ReadAhead.h"

#include "TestData.h"
#include "nexrad/System/Error.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <filesystem>
#include <memory>
#include <mutex>
#include <numeric>
#include <thread>
#include <utility>
#include <vector>

using namespace nexrad;
using namespace nexrad::scene;

namespace
{

// What a series was asked for, and whether more follows.
class Loads
{
public:
  void Begin()
  {
    const std::lock_guard<std::mutex> lock(mutex);
    ++all;
    mostAtOnce = std::max(mostAtOnce, ++atOnce);
    onOtherThreads += std::this_thread::get_id() != own ? 1 : 0;
    full = false;
    changed.notify_all();
  }
  void End()
  {
    const std::lock_guard<std::mutex> lock(mutex);
    --atOnce;
  }
  void Fill()
  {
    const std::lock_guard<std::mutex> lock(mutex);
    full = true;
    changed.notify_all();
  }

  // Waits until the loading of so many volumes has begun.
  void WaitFor(int expected)
  {
    this->Wait([this, expected] { return all >= expected; });
  }
  // Waits until so many volumes were loaded and there is room for none; how many were loaded.
  int FullAfter(int expected)
  {
    this->Wait([this, expected] { return all >= expected && full; });
    return this->All();
  }

  int All() const { return this->Get(all); }
  int MostAtOnce() const { return this->Get(mostAtOnce); }
  int OnOtherThreads() const { return this->Get(onOtherThreads); }

private:
  template <typename Condition>
  void Wait(const Condition& condition)
  {
    std::unique_lock<std::mutex> lock(mutex);
    EXPECT_TRUE(changed.wait_for(lock, std::chrono::seconds(60), condition)) << all << " loads";
  }
  int Get(const int& count) const
  {
    const std::lock_guard<std::mutex> lock(mutex);
    return count;
  }

  mutable std::mutex mutex;
  std::condition_variable changed;
  std::thread::id own = std::this_thread::get_id();
  int all = 0;
  int atOnce = 0;
  int mostAtOnce = 0;
  int onOtherThreads = 0;
  bool full = false;
};

struct CountedOptions
{
  std::size_t count = 4;
  bool ahead = true;
  std::size_t broken = 99;    // cannot be loaded
  std::size_t slow = 99;      // takes until it is told to stop
  std::size_t kibibytes = 0;  // of scalars, of each
  ReadAheadOptions readAhead; // an empty order: all
};

// Volumes of so many slices as their index says, and one.
class CountedSeries : public VolumeSeries
{
public:
  CountedSeries(const CountedOptions& seriesOptions, Loads& counted)
    : options(seriesOptions)
    , times(options.count)
    , loads(counted)
  {
  }

  const std::vector<Time>& Times() const override { return times; }
  bool CanLoadAhead() const override { return options.ahead; }

  vtkSmartPointer<vtkImageData> Load(std::size_t index, const Progress& progress) override
  {
    if (index == options.slow)
    {
      progress(0.5); // heard of before the loading counts as begun
    }
    loads.Begin();
    auto volume = this->Make(index, progress);
    loads.End();
    if (index == options.broken)
    {
      throw Error("broken");
    }
    return volume;
  }

private:
  vtkSmartPointer<vtkImageData> Make(std::size_t index, const Progress& progress) const
  {
    while (index == options.slow)
    {
      if (!progress(0.5))
      {
        return nullptr;
      }
      std::this_thread::yield();
    }
    auto volume = vtkSmartPointer<vtkImageData>::New();
    volume->SetDimensions(1, 1, static_cast<int>(index) + 1);
    if (options.kibibytes > 0)
    {
      volume->SetDimensions(1024, static_cast<int>(options.kibibytes), 1);
      volume->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
    }
    return volume;
  }

  CountedOptions options;
  std::vector<Time> times;
  Loads& loads;
};

std::unique_ptr<VolumeSeries> Series(Loads& loads, CountedOptions options = {})
{
  if (options.readAhead.order.empty())
  {
    options.readAhead.order.resize(options.count);
    std::iota(options.readAhead.order.begin(), options.readAhead.order.end(), std::size_t(0));
  }
  options.readAhead.full = [&loads] { loads.Fill(); };
  return ReadAhead(std::make_unique<CountedSeries>(options, loads), options.readAhead);
}

int Slices(VolumeSeries& series, std::size_t index)
{
  return series.Load(index, {})->GetDimensions()[2];
}

} // namespace

TEST(ReadAhead, GivesTheVolumeThatIsAskedFor)
{
  Loads loads;
  const auto series = Series(loads);
  for (const std::size_t index : {0, 1, 2, 3, 0, 2, 1, 1, 3, 2, 1, 0, 3})
  {
    EXPECT_EQ(Slices(*series, index), static_cast<int>(index) + 1);
  }
  EXPECT_EQ(loads.MostAtOnce(), 1) << "a series is used by one thread at a time";
}

TEST(ReadAhead, ASeriesThatPlaysOnIsLoadedOnAnotherThread)
{
  Loads loads;
  const auto series = Series(loads);
  EXPECT_EQ(Slices(*series, 0), 1);
  int expected = 4;
  EXPECT_EQ(loads.FullAfter(expected), expected)
    << "all but the one asked for, which is not loaded again";
  for (const std::size_t index : {1, 2, 3, 0, 1, 2})
  {
    EXPECT_EQ(Slices(*series, index), static_cast<int>(index) + 1);
    ++expected;
    EXPECT_EQ(loads.FullAfter(expected), expected) << "each step takes one out, and lets one in";
  }
  EXPECT_EQ(loads.OnOtherThreads(), 9) << "all but the first";
}

TEST(ReadAhead, ACoarseVolumeLeavesWhatIsLoadedAhead)
{
  Loads loads;
  const auto series = Series(loads);
  EXPECT_EQ(Slices(*series, 0), 1);
  EXPECT_EQ(loads.FullAfter(4), 4);
  EXPECT_EQ(series->LoadCoarse(2)->GetDimensions()[2], 3);
  EXPECT_EQ(loads.All(), 5);
  EXPECT_EQ(Slices(*series, 1), 2);
  EXPECT_EQ(loads.FullAfter(6), 6) << "the first again";
}

TEST(ReadAhead, HoldsNoMoreMemoryThanAllowed)
{
  Loads loads;
  CountedOptions options;
  options.count = 20;
  options.kibibytes = 1000;
  options.readAhead.memory = std::size_t(3500) << 10;
  const auto series = Series(loads, options);
  series->Load(0, {});
  EXPECT_EQ(loads.FullAfter(4), 4) << "the first, and three of 1 MiB ahead";
  series->Load(1, {});
  EXPECT_EQ(loads.FullAfter(5), 5) << "one more has room";
  series->Load(4, {});
  EXPECT_EQ(loads.FullAfter(8), 8) << "two are passed over, three more have room";
}

TEST(ReadAhead, OneVolumeIsHeldAheadHoweverLarge)
{
  Loads loads;
  CountedOptions options;
  options.kibibytes = 1000;
  options.readAhead.memory = 0;
  const auto series = Series(loads, options);
  series->Load(0, {});
  EXPECT_EQ(loads.FullAfter(2), 2);
  series->Load(1, {});
  EXPECT_EQ(loads.FullAfter(3), 3);
}

TEST(ReadAhead, FollowsTheOrder)
{
  Loads loads;
  CountedOptions options;
  options.count = 9;
  options.readAhead.order = {7, 2, 5};
  const auto series = Series(loads, options);
  int expected = 2;
  for (const std::size_t index : {7, 2, 5, 7})
  {
    EXPECT_EQ(Slices(*series, index), static_cast<int>(index) + 1);
    ++expected;
    EXPECT_EQ(loads.FullAfter(expected), expected);
  }
  EXPECT_EQ(loads.OnOtherThreads(), expected - 1);
  EXPECT_EQ(Slices(*series, 4), 5) << "what is not in the order is loaded when asked for";
}

TEST(ReadAhead, PreparesEachVolumeAfterTheOneBeforeIt)
{
  Loads loads;
  std::vector<std::pair<int, int>> prepared; // slices of the volume, and of the one before
  CountedOptions options;
  options.readAhead.prepare = [&prepared](vtkImageData* volume, vtkImageData* before)
  { prepared.emplace_back(volume->GetDimensions()[2], before ? before->GetDimensions()[2] : 0); };
  {
    const auto series = Series(loads, options);
    series->Load(0, {});
    EXPECT_EQ(loads.FullAfter(4), 4);
    series->Load(1, {});
    EXPECT_EQ(loads.FullAfter(5), 5);
    series->Load(3, {}); // passes one over
    EXPECT_EQ(loads.FullAfter(7), 7);
  }
  const std::vector<std::pair<int, int>> expected = {
    {1, 0}, {2, 1}, {3, 2}, {4, 3}, {1, 4}, {2, 1}, {3, 2}};
  EXPECT_EQ(prepared, expected);
}

TEST(ReadAhead, WhatIsLoadedInVainIsStopped)
{
  Loads loads;
  CountedOptions options;
  options.slow = 1;
  const auto series = Series(loads, options);
  EXPECT_EQ(Slices(*series, 0), 1);
  loads.WaitFor(2);
  EXPECT_EQ(Slices(*series, 2), 3);
  EXPECT_TRUE(series->Problems().empty());
} // and what is loaded in the end is stopped as well: 3, 0, and 1 for ever

TEST(ReadAhead, WhoeverWaitsIsToldHowFarItIsAndMayStop)
{
  Loads loads;
  CountedOptions options;
  options.slow = 1;
  const auto series = Series(loads, options);
  EXPECT_EQ(Slices(*series, 0), 1);
  loads.WaitFor(2);
  double told = 0.0;
  const auto stop = [&told](double fraction)
  {
    told = fraction;
    return false;
  };
  EXPECT_EQ(series->Load(1, stop), nullptr);
  EXPECT_EQ(told, 0.5);
  EXPECT_EQ(Slices(*series, 3), 4);
}

TEST(ReadAhead, AFailureIsToldWhenItsVolumeIsAskedFor)
{
  Loads loads;
  CountedOptions options;
  options.broken = 1;
  const auto series = Series(loads, options);
  EXPECT_EQ(Slices(*series, 0), 1);
  loads.WaitFor(2);
  EXPECT_THROW(series->Load(1, {}), Error);
  EXPECT_EQ(Slices(*series, 2), 3) << "the others are still there";
  EXPECT_EQ(Slices(*series, 0), 1);
  EXPECT_THROW(series->Load(1, {}), Error);
  EXPECT_THROW(series->Load(1, {}), Error) << "it is tried again";
  EXPECT_EQ(Slices(*series, 3), 4);
}

TEST(ReadAhead, ASeriesOfOneVolumeIsLeftAlone)
{
  Loads loads;
  ReadAheadOptions options;
  options.order = {2};
  auto own = std::make_unique<CountedSeries>(CountedOptions{}, loads);
  const VolumeSeries* const address = own.get();
  EXPECT_EQ(ReadAhead(std::move(own), options).get(), address) << "nothing follows";
}

TEST(ReadAhead, ASeriesThatCannotIsLeftAlone)
{
  Loads loads;
  CountedOptions options;
  options.ahead = false;
  options.readAhead.order = {0, 1, 2, 3};
  auto own = std::make_unique<CountedSeries>(options, loads);
  const VolumeSeries* const address = own.get();
  EXPECT_EQ(ReadAhead(std::move(own), options.readAhead).get(), address);
}

TEST(ReadAhead, RadarFilesMergeAheadToTheSameVolumes)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  MergeOptions grid;
  grid.grid.dimensions = {32, 32, 16};
  const std::vector<std::filesystem::path> inputs = {data / "level2" / "run-kbgm-20050821"};
  const auto direct = OpenRadarFiles(inputs, grid);
  ASSERT_GE(direct->Times().size(), 3U);
  ReadAheadOptions options;
  options.order = {0, 1, 2};
  const auto ahead = ReadAhead(OpenRadarFiles(inputs, grid), options);
  for (const std::size_t index : {0, 1, 2, 0, 2, 1})
  {
    const auto volume = ahead->Load(index, {});
    const auto expected = direct->Load(index, {});
    vtkDataArray* values = volume->GetPointData()->GetScalars();
    vtkDataArray* expectedValues = expected->GetPointData()->GetScalars();
    ASSERT_EQ(values->GetNumberOfTuples(), 32 * 32 * 16);
    int different = 0;
    for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
    {
      different += values->GetTuple1(i) != expectedValues->GetTuple1(i) ? 1 : 0;
    }
    EXPECT_EQ(different, 0) << "volume " << index;
  }
  EXPECT_EQ(ahead->Problems(), direct->Problems());
}
