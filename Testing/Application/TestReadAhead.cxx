// SPDX-License-Identifier: BSD-3-Clause
#include "Volumes/ReadAhead.h"

#include "Model/Error.h"

#include <vtkImageData.h>

#include <gtest/gtest.h>

#include <atomic>
#include <memory>
#include <thread>
#include <utility>

using namespace nexrad;
using namespace nexrad::application;

namespace
{

// What a series was asked for.
struct Loads
{
  std::atomic<int> all{0};
  std::atomic<int> onOtherThreads{0};
  std::thread::id own = std::this_thread::get_id();
};

// Volumes of so many voxels as their index says, and one; the volume `broken` cannot be loaded.
class CountedSeries : public VolumeSeries
{
public:
  CountedSeries(std::size_t count, Loads& counted, bool ahead, std::size_t brokenIndex)
    : times(count)
    , loads(counted)
    , canLoadAhead(ahead)
    , broken(brokenIndex)
  {
  }

  const std::vector<Time>& Times() const override { return times; }
  bool CanLoadAhead() const override { return canLoadAhead; }

  vtkSmartPointer<vtkImageData> Load(std::size_t index, const Progress&) override
  {
    ++loads.all;
    loads.onOtherThreads += std::this_thread::get_id() != loads.own ? 1 : 0;
    if (index == broken)
    {
      throw Error("broken");
    }
    auto volume = vtkSmartPointer<vtkImageData>::New();
    volume->SetDimensions(static_cast<int>(index) + 1, 1, 1);
    return volume;
  }

private:
  std::vector<Time> times;
  Loads& loads;
  bool canLoadAhead;
  std::size_t broken;
};

std::unique_ptr<VolumeSeries> Series(
  std::size_t count, Loads& loads, bool ahead = true, std::size_t broken = 99)
{
  return ReadAhead(std::make_unique<CountedSeries>(count, loads, ahead, broken));
}

int Voxels(VolumeSeries& series, std::size_t index)
{
  return static_cast<int>(series.Load(index, {})->GetNumberOfPoints());
}

} // namespace

TEST(ReadAhead, GivesTheVolumeThatIsAskedFor)
{
  Loads loads;
  const auto series = Series(4, loads);
  for (const std::size_t index : {0, 1, 2, 3, 0, 2, 1, 1, 3})
  {
    EXPECT_EQ(Voxels(*series, index), static_cast<int>(index) + 1);
  }
}

TEST(ReadAhead, ASeriesThatPlaysOnIsLoadedOnAnotherThread)
{
  Loads loads;
  {
    const auto series = Series(3, loads);
    for (const std::size_t index : {0, 1, 2, 0, 1})
    {
      EXPECT_EQ(Voxels(*series, index), static_cast<int>(index) + 1);
    }
  }
  EXPECT_EQ(loads.all, 6) << "each once, and one ahead";
  EXPECT_EQ(loads.onOtherThreads, 5) << "all but the first";
}

TEST(ReadAhead, AFailureIsToldWhenItsVolumeIsAskedFor)
{
  Loads loads;
  const auto series = Series(3, loads, true, 1);
  EXPECT_EQ(Voxels(*series, 0), 1);
  EXPECT_THROW(series->Load(1, {}), Error);
  EXPECT_EQ(Voxels(*series, 2), 3) << "the others are still there";
}

TEST(ReadAhead, OneVolumeIsLoadedOnce)
{
  Loads loads;
  {
    const auto series = Series(1, loads);
    EXPECT_EQ(Voxels(*series, 0), 1);
  }
  EXPECT_EQ(loads.all, 1);
}

TEST(ReadAhead, ASeriesThatCannotIsLeftAlone)
{
  Loads loads;
  {
    const auto series = Series(3, loads, false);
    EXPECT_EQ(Voxels(*series, 0), 1);
    EXPECT_EQ(Voxels(*series, 1), 2);
  }
  EXPECT_EQ(loads.all, 2);
  EXPECT_EQ(loads.onOtherThreads, 0);
}
