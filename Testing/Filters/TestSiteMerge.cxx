// SPDX-License-Identifier: BSD-3-Clause
#include "EventCounter.h"
#include "HandMadeVolume.h"
#include "Scans/TwoRadars.h"
#include "TestData.h"
#include "Tolerance.h"

#include "vtkNexradDayReader.h"
#include "vtkNexradImageConversion.h"
#include "vtkNexradLevel2Reader.h"
#include "vtkNexradSeriesReader.h"
#include "vtkNexradSiteMerge.h"
#include "vtkNexradVolumeResampler.h"

#include "nexrad/Grid/GriddedVolume.h"

#include "vtkDataObject.h"
#include "vtkDoubleArray.h"
#include "vtkErrorCode.h"
#include "vtkExecutive.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStringArray.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>

namespace
{

using namespace std::chrono_literals;
using nexrad::GriddedVolume;
using nexrad::VoxelState;
using nexrad::testing::AnyHolds;
using nexrad::testing::EventCounter;

void UseSmallGrid(vtkNexradGridAlgorithm* algorithm)
{
  algorithm->SetDimensions(48, 48, 12);
}

vtkSmartPointer<vtkNexradLevel2Reader> ReaderOf(const std::filesystem::path& path)
{
  auto reader = vtkSmartPointer<vtkNexradLevel2Reader>::New();
  reader->SetFileName(path.c_str());
  return reader;
}

void ExpectSame(vtkImageData* image, vtkImageData* expected)
{
  const GriddedVolume volume = vtkNexradImageToVolume(image);
  const GriddedVolume truth = vtkNexradImageToVolume(expected);
  EXPECT_EQ(volume.grid.origin, truth.grid.origin);
  EXPECT_EQ(volume.grid.spacing, truth.grid.spacing);
  EXPECT_EQ(volume.time, truth.time);
  EXPECT_EQ(volume.sites, truth.sites);
  EXPECT_EQ(volume.values, truth.values);
  EXPECT_EQ(volume.states, truth.states);
}

// One file, read by the day reader and merged of the sweeps that the Level II reader gives.
struct DayAndMerge
{
  explicit DayAndMerge(const std::filesystem::path& file)
  {
    day->AddFileName(file.c_str());
    merge->AddInputConnection(ReaderOf(file)->GetOutputPort());
  }

  std::array<vtkNexradGridAlgorithm*, 2> Both() { return {day, merge}; }

  // To the first time of the file.
  void Update()
  {
    day->UpdateInformation();
    const double time = day->GetTimeSteps()->GetValue(0);
    day->UpdateTimeStep(time);
    merge->SetTime(time);
    merge->Update();
  }

  vtkNew<vtkNexradDayReader> day;
  vtkNew<vtkNexradSiteMerge> merge;
};

// Rays that went through the sweeps' grids and back must merge to the very same numbers.
TEST(SiteMerge, GivesWhatTheDayReaderGives)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  const std::filesystem::path run = data / "level2/run-kbgm-20050821";
  const double time = nexrad::ToSeconds(*nexrad::ParseIso8601("2005-08-21T02:55:00Z"));
  vtkNew<vtkNexradDayReader> day;
  UseSmallGrid(day);
  day->AddFileName(run.c_str());
  day->UpdateInformation();
  day->UpdateTimeStep(time);

  vtkNew<vtkNexradSiteMerge> merge;
  UseSmallGrid(merge);
  // In no order, and one more than is needed.
  for (const char* name :
    {"KBGM20050821_030047.gz", "KBGM20050821_024910.gz", "KBGM20050821_025458.gz"})
  {
    merge->AddInputConnection(ReaderOf(run / name)->GetOutputPort());
  }
  merge->SetTime(time);
  merge->Update();
  ExpectSame(merge->GetOutput(), day->GetOutput());
  EXPECT_EQ(merge->GetOutput()->GetInformation()->Get(vtkDataObject::DATA_TIME_STEP()), time);
  vtkInformation* info = merge->GetOutputInformation(0);
  ASSERT_EQ(info->Length(vtkStreamingDemandDrivenPipeline::TIME_STEPS()), 1);
  EXPECT_EQ(info->Get(vtkStreamingDemandDrivenPipeline::TIME_STEPS())[0], time);

  const std::vector<float> speckled = vtkNexradImageToVolume(day->GetOutput()).values;
  day->SetFewestNeighbours(6);
  day->UpdateInformation();
  day->UpdateTimeStep(time);
  merge->SetFewestNeighbours(6);
  merge->Update();
  ExpectSame(merge->GetOutput(), day->GetOutput());
  EXPECT_NE(vtkNexradImageToVolume(day->GetOutput()).values, speckled);
}

// The Doppler halves of its split cuts reach as far as the others: waveforms and ranges must come
// through the grids as well.
TEST(SiteMerge, LeavesDopplerHalvesOutAsTheDayReaderDoes)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  const std::filesystem::path file = data / "level2/legacy/KVWX_20050626_221551.gz";
  const double time = nexrad::ToSeconds(*nexrad::ParseIso8601("2005-06-26T22:21:44Z"));
  vtkNew<vtkNexradDayReader> day;
  // The sweeps have the impossible velocities of this file as stored, which are some evidence.
  day->SetQualityToOff();
  UseSmallGrid(day);
  day->AddFileName(file.c_str());
  day->UpdateInformation();
  day->UpdateTimeStep(time);
  vtkNew<vtkNexradSiteMerge> merge;
  merge->SetQualityToOff();
  UseSmallGrid(merge);
  merge->AddInputConnection(ReaderOf(file)->GetOutputPort());
  merge->SetTime(time);
  merge->Update();
  ExpectSame(merge->GetOutput(), day->GetOutput());
}

// Nyquist velocities come through the grids as well, so that both dealias alike. The reader keeps
// what it made with one setting apart from what it makes with another.
TEST(SiteMerge, DealiasesAsTheDayReaderDoes)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  DayAndMerge of(data / "level2/legacy/KTLX19990503_235621.gz");
  const auto valuesWith = [&](bool dealiasing)
  {
    for (vtkNexradGridAlgorithm* each : of.Both())
    {
      UseSmallGrid(each);
      each->SetMoment("VEL");
      each->SetDealiasing(dealiasing);
    }
    of.Update();
    ExpectSame(of.merge->GetOutput(), of.day->GetOutput());
    return vtkNexradImageToVolume(of.day->GetOutput()).values;
  };
  EXPECT_TRUE(of.day->GetDealiasing());
  const std::vector<float> unfolded = valuesWith(true);
  EXPECT_NE(valuesWith(false), unfolded);
  EXPECT_EQ(valuesWith(true), unfolded);
}

// In voxels that are finer than the gates: the cells of means over coarser ones (Formulas G10)
// depend on how many gates a sweep has, and the grids of sweeps leave out gates that no ray
// reaches.
TEST(SiteMerge, DerivesMomentsAsTheDayReaderDoes)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  DayAndMerge of(data / "level2/legacy/KTLX19990503_235621.gz");
  const auto volumeOf = [&](const char* moment)
  {
    for (vtkNexradGridAlgorithm* each : of.Both())
    {
      UseSmallGrid(each);
      each->UseGeographicBoundsOn();
      each->SetGeographicBounds(-97.75, 35.21, -97.65, 35.29); // where the tornado is
      each->SetMoment(moment);
    }
    of.Update();
    GriddedVolume volume = vtkNexradImageToVolume(of.day->GetOutput());
    const GriddedVolume merged = vtkNexradImageToVolume(of.merge->GetOutput());
    EXPECT_EQ(volume.states, merged.states);
    for (std::size_t i = 0; i < volume.values.size(); ++i)
    {
      const float scale = std::max(1.0F, std::abs(volume.values[i]));
      EXPECT_NEAR(volume.values[i], merged.values[i], 1e-6F * scale);
    }
    EXPECT_STREQ(of.day->GetOutput()->GetPointData()->GetScalars()->GetName(), moment);
    return volume;
  };
  const GriddedVolume shear = volumeOf("AZSHEAR");
  EXPECT_AT_LEAST(*std::max_element(shear.values.begin(), shear.values.end()), 0.025,
    "merged azimuthal shear of the tornado, per second");
  volumeOf("DIV");
  const std::vector<float> estimated = volumeOf("SRV").values;
  for (vtkNexradGridAlgorithm* each : of.Both())
  {
    each->UseStormMotionOn();
    each->SetStormMotion(12.0, 8.0);
  }
  EXPECT_NE(volumeOf("SRV").values, estimated);
}

// Of two radars that differ by 4 dB: neither, one, or half of it of each.
TEST(SiteMerge, TakesBiasesOffAsTheDayReaderDoes)
{
  const nexrad::testing::TemporaryFolder folder;
  vtkNew<vtkNexradDayReader> day;
  vtkNew<vtkNexradSiteMerge> merge;
  for (const auto& file : nexrad::testing::WriteTwoRadars(folder.Path(), 30.0, 34.0))
  {
    day->AddFileName(file.c_str());
    merge->AddInputConnection(ReaderOf(file)->GetOutputPort());
  }
  const std::array<vtkNexradGridAlgorithm*, 2> both = {day, merge};
  const auto largestWith = [&](const char* bias)
  {
    for (vtkNexradGridAlgorithm* each : both)
    {
      UseSmallGrid(each);
      each->SharpeningOff();
      each->SetBias(bias);
    }
    day->UpdateInformation();
    const double time = day->GetTimeSteps()->GetValue(0);
    day->UpdateTimeStep(time);
    merge->SetTime(time);
    merge->Update();
    const GriddedVolume merged = vtkNexradImageToVolume(merge->GetOutput());
    const GriddedVolume volume = vtkNexradImageToVolume(day->GetOutput());
    EXPECT_EQ(merged.states, volume.states);
    const std::vector<float>& values = volume.values;
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      EXPECT_NEAR(merged.values[i], values[i], 1e-4F);
    }
    return *std::max_element(values.begin(), values.end());
  };
  EXPECT_EQ(day->GetBias(), "off");
  EXPECT_NEAR(largestWith("off"), 34.0F, 1e-4F);
  EXPECT_NEAR(largestWith("KTWO:4"), 30.0F, 1e-4F);
  EXPECT_NEAR(largestWith("auto"), 32.0F, 1e-4F);
  EXPECT_TRUE(
    std::string(day->GetRadarComparison()->GetValue(0)).find("KONE - KTWO: median -4.00 dB") == 0);
  EXPECT_EQ(day->GetRadarComparison()->GetNumberOfValues(), 3);
  for (vtkNexradGridAlgorithm* each : both)
  {
    vtkNew<EventCounter> events;
    events->Observe(each);
    events->Observe(each->GetExecutive());
    each->SetBias("KABR:1");
    each->Update();
    EXPECT_TRUE(AnyHolds(events->errors, "a bias is given for KABR"));
  }
}

// The motion that is found, one that is given and none make three volumes; no speed is none.
TEST(SiteMerge, MovesEchoAsAsked)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  const std::filesystem::path run = data / "level2/run-kbgm-20050821";
  vtkNew<vtkNexradSiteMerge> merge;
  UseSmallGrid(merge);
  merge->AddInputConnection(ReaderOf(run / "KBGM20050821_024910.gz")->GetOutputPort());
  merge->AddInputConnection(ReaderOf(run / "KBGM20050821_030047.gz")->GetOutputPort());
  merge->SetTime(nexrad::ToSeconds(*nexrad::ParseIso8601("2005-08-21T02:57:00Z")));
  const auto valuesNow = [&merge]
  {
    merge->Update();
    EXPECT_EQ(merge->GetErrorCode(), vtkErrorCode::NoError);
    return vtkNexradImageToVolume(merge->GetOutput()).values;
  };
  EXPECT_EQ(merge->GetTimeInterpolation(), vtkNexradGridAlgorithm::MOTION);
  const std::vector<float> found = valuesNow();
  merge->SetTimeInterpolationToLinear();
  const std::vector<float> linear = valuesNow();
  EXPECT_NE(found, linear);
  merge->SetGivenMotion(0.0, 0.0);
  merge->UseGivenMotionOn();
  merge->SetTimeInterpolationToMotion();
  EXPECT_EQ(valuesNow(), linear);
  merge->SetGivenMotion(20.0, 5.0);
  const std::vector<float> given = valuesNow();
  EXPECT_NE(given, linear);
  EXPECT_NE(given, found);
  vtkNew<EventCounter> events;
  events->Observe(merge);
  events->Observe(merge->GetExecutive());
  merge->SetGivenMotion(200.0, 0.0);
  merge->Update();
  EXPECT_EQ(merge->GetErrorCode(), vtkErrorCode::UserError);
  EXPECT_TRUE(AnyHolds(events->errors, "150 m/s"));
}

TEST(SiteMerge, MergesSuperResolutionSitesAsTheDayReaderDoes)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  const std::filesystem::path set = data / "level2/multisite-20100911";
  const double time = nexrad::ToSeconds(*nexrad::ParseIso8601("2010-09-11T01:20:00Z"));
  vtkNew<vtkNexradDayReader> day;
  vtkNew<vtkNexradSiteMerge> merge;
  UseSmallGrid(day);
  UseSmallGrid(merge);
  day->SetMaximumGap(2700.0);
  merge->SetMaximumGap(2700.0);
  for (const char* name : {"KENX20100911_011108_V03.gz", "KTYX20100911_012210_V04.gz"})
  {
    day->AddFileName((set / name).c_str());
    merge->AddInputConnection(ReaderOf(set / name)->GetOutputPort());
  }
  day->UpdateInformation();
  day->UpdateTimeStep(time);
  merge->SetTime(time);
  merge->Update();
  ExpectSame(merge->GetOutput(), day->GetOutput());
  EXPECT_EQ(vtkNexradImageToVolume(merge->GetOutput()).sites.size(), 2U);
}

/// Hand-made volumes of one or two sites.
class SiteMergeByHand : public ::testing::Test
{
protected:
  vtkSmartPointer<vtkNexradLevel2Reader> Reader(
    const nexrad::Site& site, nexrad::Time time, double reflectivity)
  {
    const auto path = folder.Path() / std::to_string(count++);
    return ReaderOf(nexrad::testing::WriteLevel2(
      path, {nexrad::testing::ConstantVolume(site, time, reflectivity)}));
  }

  static float LargestEcho(vtkImageData* image)
  {
    const GriddedVolume volume = vtkNexradImageToVolume(image);
    return *std::max_element(volume.values.begin(), volume.values.end());
  }

  void ExpectFailure(vtkNexradGridAlgorithm* algorithm, const std::string& text)
  {
    vtkNew<EventCounter> events;
    events->Observe(algorithm);
    events->Observe(algorithm->GetExecutive());
    algorithm->Update();
    EXPECT_EQ(algorithm->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::UserError));
    EXPECT_TRUE(AnyHolds(events->errors, text)) << text;
  }

  const nexrad::Site keax = {"KEAX", nexrad::Position{38.81, -94.264, 333.0}};
  const nexrad::Site klsx = {"KLSX", nexrad::Position{38.699, -90.683, 220.0}};
  const nexrad::Time start = *nexrad::ParseIso8601("2006-03-12T18:00:00Z");
  const nexrad::testing::TemporaryFolder folder;
  int count = 0;
};

TEST_F(SiteMergeByHand, FindsTheBracketsBySiteAndStartTime)
{
  vtkNew<vtkNexradSiteMerge> merge;
  merge->SetMethodToThesis();
  UseSmallGrid(merge);
  merge->AddInputConnection(this->Reader(keax, start + 10min, 40.0)->GetOutputPort());
  merge->AddInputConnection(this->Reader(keax, start, 10.0)->GetOutputPort());
  merge->SetTime(nexrad::ToSeconds(start + 5min));
  merge->Update();
  EXPECT_NEAR(LargestEcho(merge->GetOutput()), 25.0F, 1e-3F);
  merge->SetTime(nexrad::ToSeconds(start + 10min));
  merge->Update();
  EXPECT_NEAR(LargestEcho(merge->GetOutput()), 40.0F, 1e-3F);
  merge->SetMaximumGap(60.0);
  merge->SetTime(nexrad::ToSeconds(start + 5min));
  merge->Update();
  EXPECT_TRUE(vtkNexradImageToVolume(merge->GetOutput()).sites.empty());
}

TEST_F(SiteMergeByHand, TakesTheSeriesReadersSweepsOfSeveralSites)
{
  this->Reader(keax, start, 10.0);
  this->Reader(klsx, start + 1min, 50.0);
  vtkNew<vtkNexradSeriesReader> series;
  series->AddFileName(folder.Path().c_str());
  series->UpdateInformation();
  series->UpdateTimeStep(nexrad::ToSeconds(start + 1min));
  vtkNew<vtkNexradSiteMerge> merge;
  merge->SetMethodToThesis();
  UseSmallGrid(merge);
  merge->AddInputDataObject(0, series->GetOutputDataObject(0));
  merge->SetTime(nexrad::ToSeconds(start + 1min));
  merge->Update();
  EXPECT_EQ(
    vtkNexradImageToVolume(merge->GetOutput()).sites, (std::vector<std::string>{"KEAX", "KLSX"}));
}

TEST_F(SiteMergeByHand, ResamplerGridsOneVolumeAtItsOwnTime)
{
  vtkNew<vtkNexradVolumeResampler> resampler;
  resampler->SetQualityToOff(); // rays that hold one value are a fault of the receiver
  UseSmallGrid(resampler);
  resampler->SetInputConnection(this->Reader(keax, start, 30.0)->GetOutputPort());
  resampler->Update();
  const GriddedVolume volume = vtkNexradImageToVolume(resampler->GetOutput());
  EXPECT_EQ(volume.time, start);
  EXPECT_EQ(volume.sites, std::vector<std::string>{"KEAX"});
  for (std::size_t i = 0; i < volume.values.size(); ++i)
  {
    EXPECT_NEAR(
      volume.values[i], volume.states[i] == VoxelState::Echo ? 30.0F : volume.fill, 1e-3F);
  }
  EXPECT_AT_LEAST(std::count(volume.states.begin(), volume.states.end(), VoxelState::Echo), 150,
    "voxels of echo");
  EXPECT_EQ(resampler->GetOutput()->GetInformation()->Get(vtkDataObject::DATA_TIME_STEP()),
    nexrad::ToSeconds(start));
}

TEST_F(SiteMergeByHand, CoordinatesOfTheSweepsDoNotMatter)
{
  const auto reader = this->Reader(keax, start, 30.0);
  vtkNew<vtkNexradVolumeResampler> resampler;
  resampler->SetQualityToOff(); // rays that hold one value are a fault of the receiver
  UseSmallGrid(resampler);
  resampler->SetInputConnection(reader->GetOutputPort());
  resampler->Update();
  const GriddedVolume local = vtkNexradImageToVolume(resampler->GetOutput());
  reader->SetCoordinatesToGeographic();
  resampler->Update();
  EXPECT_EQ(vtkNexradImageToVolume(resampler->GetOutput()).values, local.values);
}

TEST_F(SiteMergeByHand, InputsThatCannotBeMergedAreErrors)
{
  const auto reader = this->Reader(keax, start, 30.0);
  reader->Update();
  vtkNew<vtkPartitionedDataSetCollection> stripped;
  stripped->DeepCopy(reader->GetOutput());
  stripped->GetPartitionedDataSet(0)->GetPartition(0)->GetFieldData()->RemoveArray("RayTime");
  vtkNew<vtkNexradVolumeResampler> resampler;
  UseSmallGrid(resampler);
  resampler->SetInputDataObject(stripped);
  this->ExpectFailure(resampler, "RayTime");

  vtkNew<vtkNexradSiteMerge> merge;
  UseSmallGrid(merge);
  vtkNew<vtkPartitionedDataSetCollection> empty;
  merge->SetInputDataObject(empty);
  this->ExpectFailure(merge, "no input holds a sweep with REF");
}

// As in a series: two radars of one name, or a wrong position.
TEST_F(SiteMergeByHand, NamesakesFarApartAreAnError)
{
  const nexrad::Site moved = {"KEAX", nexrad::Position{38.82, -94.264, 340.0}}; // 1.1 km
  const nexrad::Site other = {"KEAX", nexrad::Position{41.0, -94.264, 333.0}};
  vtkNew<vtkNexradSiteMerge> merge;
  UseSmallGrid(merge);
  merge->SetTime(nexrad::ToSeconds(start));
  merge->AddInputConnection(this->Reader(keax, start, 30.0)->GetOutputPort());
  merge->AddInputConnection(this->Reader(moved, start + 1min, 30.0)->GetOutputPort());
  merge->Update();
  EXPECT_EQ(merge->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::NoError));
  merge->AddInputConnection(this->Reader(other, start + 2min, 30.0)->GetOutputPort());
  this->ExpectFailure(merge, "one input has a radar KEAX at 38.810, -94.264 degrees, and another "
                             "at 41.000, -94.264 degrees");
}

} // namespace
