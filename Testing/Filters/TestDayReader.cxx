// SPDX-License-Identifier: BSD-3-Clause
#include "EventCounter.h"
#include "HandMadeVolume.h"
#include "Scans/RadarsOfMissouri.h"
#include "Scans/TwoRadars.h"
#include "TestData.h"
#include "Tolerance.h"

#include "vtkNexradDayReader.h"
#include "vtkNexradImageConversion.h"
#include "vtkNexradVolumeReader.h"
#include "vtkNexradVolumeWriter.h"

#include "nexrad/Grid/GriddedVolume.h"
#include "nexrad/Grid/MakeGrid.h"
#include "nexrad/Level2/Level2File.h"
#include "nexrad/Thesis/ThesisMerge.h"

#include "vtkCallbackCommand.h"
#include "vtkDataObject.h"
#include "vtkDoubleArray.h"
#include "vtkErrorCode.h"
#include "vtkExecutive.h"
#include "vtkImageChangeInformation.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStringArray.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <sstream>

namespace
{

using namespace std::chrono_literals;
using nexrad::GriddedVolume;
using nexrad::VoxelState;
using nexrad::testing::AnyHolds;
using nexrad::testing::ConstantVolume;
using nexrad::testing::EventCounter;
using nexrad::testing::keax;
using nexrad::testing::klsx;
using nexrad::testing::start;
using nexrad::testing::WriteLevel2;

/// KEAX with 10, 20 and 40 dBZ at 18:00, 18:06 and 18:12; KLSX with 50 dBZ at 18:03.
class DayReader : public ::testing::Test
{
protected:
  DayReader()
  {
    WriteLevel2(folder.Path() / "1", {ConstantVolume(keax, start, 10.0)});
    WriteLevel2(folder.Path() / "2",
      {ConstantVolume(keax, start + 6min, 20.0), ConstantVolume(keax, start + 12min, 40.0)});
    WriteLevel2(folder.Path() / "3", {ConstantVolume(klsx, start + 3min, 50.0)});
    reader->AddFileName(folder.Path().c_str());
    reader->SetDimensions(48, 24, 8);
    reader->SetRange(100'000.0);
    reader->SetTimeStep(60.0);
    reader->SetOption(
      "method", "thesis"); // its times are those of whole volumes, which are round here
    events->Observe(reader);
    events->Observe(reader->GetExecutive());
  }

  GriddedVolume At(nexrad::Time time)
  {
    reader->UpdateInformation();
    reader->UpdateTimeStep(nexrad::ToSeconds(time));
    return vtkNexradImageToVolume(reader->GetOutput());
  }

  /// The value of all echoes on the western (KEAX) or eastern half; they must be alike.
  static float EchoOf(const GriddedVolume& volume, bool west)
  {
    float found = -1.0F;
    for (std::size_t i = 0; i < volume.values.size(); ++i)
    {
      const std::size_t x = i % static_cast<std::size_t>(volume.grid.dimensions[0]);
      const bool inWest = 2 * x < static_cast<std::size_t>(volume.grid.dimensions[0]);
      if (inWest == west && volume.states[i] == VoxelState::Echo)
      {
        EXPECT_TRUE(found < 0.0F || std::abs(found - volume.values[i]) < 1e-3F);
        found = volume.values[i];
      }
    }
    return found;
  }

  void ExpectFailure(unsigned long code, const std::string& text)
  {
    events->errors.clear();
    reader->Update();
    EXPECT_EQ(reader->GetErrorCode(), code);
    EXPECT_TRUE(AnyHolds(events->errors, text)) << text;
  }

  const nexrad::testing::TemporaryFolder folder;
  vtkNew<vtkNexradDayReader> reader;
  vtkNew<EventCounter> events;
};

TEST_F(DayReader, DoesNotMergeATimeAgainWhoseOutputIsInMemory)
{
  const GriddedVolume first = this->At(start);
  this->At(start + 6min);
  EXPECT_EQ(reader->GetNumberOfMerges(), 2);
  const GriddedVolume again = this->At(start);
  EXPECT_EQ(reader->GetNumberOfMerges(), 2);
  EXPECT_EQ(again.values, first.values);
  EXPECT_EQ(again.states, first.states);
  EXPECT_EQ(again.time, first.time);

  reader->SetHeightRange(0.0, 5000.0); // other settings make other volumes
  const GriddedVolume other = this->At(start);
  EXPECT_EQ(reader->GetNumberOfMerges(), 3);
  EXPECT_NE(other.grid, first.grid);
  reader->SetMemoryLimit(0);
  this->At(start);
  this->At(start + 6min);
  const int merges = reader->GetNumberOfMerges();
  this->At(start);
  EXPECT_EQ(reader->GetNumberOfMerges(), merges + 1);
}

TEST_F(DayReader, SaysWhatItCanRead)
{
  EXPECT_EQ(vtkNexradDayReader::CanReadFile((folder.Path() / "1").c_str()), 1);
  EXPECT_EQ(vtkNexradDayReader::CanReadFile(folder.Path().c_str()), 1);
  EXPECT_EQ(vtkNexradDayReader::CanReadFile((folder.Path() / "absent").c_str()), 0);
}

TEST_F(DayReader, StepsAreMultiplesFromTheFirstRayToTheLast)
{
  reader->UpdateInformation();
  // From 18:00:00 to 18:12:07.
  ASSERT_EQ(reader->GetTimeSteps()->GetNumberOfValues(), 13);
  EXPECT_EQ(reader->GetTimeSteps()->GetValue(0), nexrad::ToSeconds(start));
  EXPECT_EQ(reader->GetTimeSteps()->GetValue(12), nexrad::ToSeconds(start + 12min));
  vtkInformation* info = reader->GetOutputInformation(0);
  EXPECT_EQ(info->Length(vtkStreamingDemandDrivenPipeline::TIME_STEPS()), 13);
  EXPECT_EQ(
    info->Get(vtkStreamingDemandDrivenPipeline::TIME_RANGE())[1], nexrad::ToSeconds(start + 12min));
  ASSERT_EQ(reader->GetSites()->GetNumberOfValues(), 2);
  EXPECT_EQ(reader->GetSites()->GetValue(0), "KEAX");

  reader->SetBeginTime(nexrad::ToSeconds(start - 2min));
  reader->SetEndTime(nexrad::ToSeconds(start + 1min));
  reader->UpdateInformation();
  ASSERT_EQ(reader->GetTimeSteps()->GetNumberOfValues(), 4); // both ends count
  EXPECT_EQ(reader->GetTimeSteps()->GetValue(0), nexrad::ToSeconds(start - 2min));
}

TEST_F(DayReader, TheTimesOfTheDataAreThoseOfAllFilesWhateverTheBeginAndTheEnd)
{
  EXPECT_EQ(reader->GetFirstRay(), "");
  reader->UpdateInformation();
  EXPECT_EQ(reader->GetFirstRay(), nexrad::FormatIso8601(start));
  EXPECT_EQ(reader->GetLastRay(), nexrad::FormatIso8601(start + 12min + 7s + 180ms));

  reader->SetBeginTimeText(nexrad::FormatIso8601(start + 2min));
  reader->SetEndTimeText(nexrad::FormatIso8601(start + 3min));
  reader->UpdateInformation();
  EXPECT_EQ(reader->GetTimeSteps()->GetNumberOfValues(), 2);
  EXPECT_EQ(reader->GetFirstRay(), nexrad::FormatIso8601(start));
  EXPECT_EQ(reader->GetLastRay(), nexrad::FormatIso8601(start + 12min + 7s + 180ms));

  // A reader that is given an end at once has not read the last files for its time steps.
  vtkNew<vtkNexradDayReader> other;
  other->AddFileName(folder.Path().c_str());
  other->SetTimeStep(60.0);
  other->SetEndTime(nexrad::ToSeconds(start + 3min));
  other->UpdateInformation();
  EXPECT_EQ(other->GetLastRay(), reader->GetLastRay());

  reader->ClearFileNames();
  this->ExpectFailure(vtkErrorCode::NoFileNameError, "no file name");
  EXPECT_EQ(reader->GetFirstRay(), "");
  EXPECT_EQ(reader->GetLastRay(), "");
}

TEST_F(DayReader, BeginAndEndAreTextOrSecondsOrEmpty)
{
  EXPECT_EQ(reader->GetBeginTimeText(), "");
  EXPECT_EQ(reader->GetEndTimeText(), "");
  reader->SetBeginTimeText("2010-09-11 20:05");
  EXPECT_EQ(reader->GetBeginTimeText(), "2010-09-11T20:05:00.000Z");
  reader->SetEndTimeText("1284235500.5");
  EXPECT_EQ(reader->GetEndTimeText(), "2010-09-11T20:05:00.500Z");
  EXPECT_EQ(reader->GetEndTime(), 1284235500.5);

  for (const char* text : {"tomorrow", "2010-09-31", "nan"})
  {
    events->errors.clear();
    reader->SetEndTimeText(text);
    EXPECT_TRUE(AnyHolds(events->errors, text)) << text;
    EXPECT_EQ(reader->GetEndTime(), 1284235500.5) << text;
  }

  reader->SetBeginTimeText("");
  reader->SetEndTimeText("1e+299"); // as states of ParaView say it
  EXPECT_EQ(reader->GetBeginTime(), VTK_DOUBLE_MIN);
  EXPECT_EQ(reader->GetEndTime(), VTK_DOUBLE_MAX);
}

TEST_F(DayReader, OneVolumeWithoutAMultipleOfTheStepIsMadeAtItsMiddle)
{
  reader->ClearFileNames();
  reader->AddFileName((folder.Path() / "3").c_str()); // 18:03:00.000 to 18:03:07.180
  reader->SetTimeStep(3600.0);
  reader->UpdateInformation();
  ASSERT_EQ(reader->GetTimeSteps()->GetNumberOfValues(), 1);
  EXPECT_EQ(reader->GetTimeSteps()->GetValue(0), nexrad::ToSeconds(start + 3min + 3s));
}

TEST_F(DayReader, DaysWithoutARayAskForTheTimes)
{
  WriteLevel2(folder.Path() / "4", {ConstantVolume(klsx, start + 24h * 365, 50.0)});
  reader->SetTimeStep(300.0);
  this->ExpectFailure(vtkErrorCode::UserError, "BeginTime");
  reader->SetEndTime(nexrad::ToSeconds(start + 10min));
  reader->UpdateInformation();
  EXPECT_EQ(reader->GetTimeSteps()->GetNumberOfValues(), 3);
}

TEST_F(DayReader, ChoosesTheVolumesAboutAnyTimeForEachSite)
{
  EXPECT_NEAR(EchoOf(this->At(start), true), 10.0F, 1e-3F);
  EXPECT_NEAR(EchoOf(this->At(start + 3min), true), 15.0F, 1e-3F);
  EXPECT_NEAR(EchoOf(this->At(start + 7min + 30s), true), 25.0F, 1e-3F); // no time step
  EXPECT_NEAR(EchoOf(this->At(start + 20min), true), 40.0F, 1e-3F);      // beyond the last
  EXPECT_NEAR(EchoOf(this->At(start + 7min), false), 50.0F, 1e-3F);
  EXPECT_EQ(EchoOf(this->At(start + 20min), false), -1.0F); // farther than 15 minutes
  const GriddedVolume volume = this->At(start + 7min);
  EXPECT_EQ(volume.time, start + 7min);
  EXPECT_EQ(volume.sites, (std::vector<std::string>{"KEAX", "KLSX"}));
  EXPECT_EQ(volume.method, "thesis");
  EXPECT_EQ(reader->GetOutput()->GetInformation()->Get(vtkDataObject::DATA_TIME_STEP()),
    nexrad::ToSeconds(start + 7min));
  EXPECT_TRUE(events->errors.empty());
}

TEST_F(DayReader, TheDefaultMethodTakesEachRayAtItsOwnTime)
{
  vtkNew<vtkNexradDayReader> untouched;
  EXPECT_EQ(untouched->GetOption("method"), "beam");
  reader->SetOption("method", "beam");
  // The rays are scanned within seconds of the volume's start, so values lag by a little.
  const GriddedVolume volume = this->At(start + 3min);
  EXPECT_EQ(volume.method, "beam");
  EXPECT_EQ(volume.fill, -33.0F);
  for (std::size_t i = 0; i < volume.values.size(); ++i)
  {
    const float value = volume.values[i];
    const bool expected = std::abs(value - 50.0F) < 1e-3F || (value > 14.0F && value < 15.001F);
    ASSERT_TRUE(volume.states[i] != VoxelState::Echo || expected) << value;
  }
  // Asked again, and after other times, the answer is the same.
  this->At(start + 9min);
  EXPECT_EQ(this->At(start + 3min).values, volume.values);
}

TEST_F(DayReader, AncillaryArraysOnRequest)
{
  reader->SetOption("method", "beam");
  reader->SetOption("quality", "off"); // rays that hold one value are a fault of the receiver
  reader->UpdateInformation();
  reader->UpdateTimeStep(nexrad::ToSeconds(start + 3min));
  EXPECT_EQ(reader->GetOutput()->GetPointData()->GetArray("REF_age"), nullptr);
  reader->SetOption("ancillary", "on");
  reader->UpdateTimeStep(nexrad::ToSeconds(start + 3min));
  vtkPointData* points = reader->GetOutput()->GetPointData();
  for (const char* name : {"REF_age", "REF_radars", "REF_weight", "REF_site"})
  {
    ASSERT_NE(points->GetArray(name), nullptr) << name;
    EXPECT_EQ(
      points->GetArray(name)->GetNumberOfTuples(), reader->GetOutput()->GetNumberOfPoints());
  }
  EXPECT_EQ(points->GetArray("REF_radars")->GetRange()[1], 1.0); // their circles do not meet
  EXPECT_AT_LEAST(points->GetArray("REF_age")->GetRange()[1], 100.0, "largest age, s");
}

TEST_F(DayReader, AnswersTimesThroughThePipeline)
{
  vtkNew<vtkImageChangeInformation> downstream;
  downstream->SetInputConnection(reader->GetOutputPort());
  downstream->UpdateInformation();
  vtkInformation* info = downstream->GetOutputInformation(0);
  ASSERT_EQ(info->Length(vtkStreamingDemandDrivenPipeline::TIME_STEPS()), 13);
  info->Set(vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP(), nexrad::ToSeconds(start + 9min));
  downstream->Update();
  double range[2];
  downstream->GetOutput()->GetPointData()->GetArray("REF")->GetRange(range);
  EXPECT_NEAR(range[1], 50.0, 1e-3);
  EXPECT_EQ(reader->GetOutput()->GetInformation()->Get(vtkDataObject::DATA_TIME_STEP()),
    nexrad::ToSeconds(start + 9min));
}

TEST_F(DayReader, OutputIsTheGridThatWasAskedFor)
{
  reader->SetOption("bounds", "-95,38,-90,40");
  reader->SetHeightRange(1000.0, 9000.0);
  reader->SetOption("axes", "geographic");
  reader->Update();
  double bounds[6];
  reader->GetOutput()->GetBounds(bounds);
  // Points are the centres of voxels, half a spacing within the outer faces.
  EXPECT_NEAR(bounds[0], -95.0 + 0.5 * 5.0 / 48, 1e-9);
  EXPECT_NEAR(bounds[3], 40.0 - 0.5 * 2.0 / 24, 1e-9);
  EXPECT_NEAR(bounds[4], 1500.0, 1e-9);
  EXPECT_NEAR(bounds[5], 8500.0, 1e-9);
}

// Every gate of these volumes has 8 neighbours, but those of the first and of the last range.
TEST_F(DayReader, TakesOutGatesWithFewNeighbours)
{
  const auto echoes = [this](int fewest)
  {
    reader->SetOption("despeckle", fewest);
    const GriddedVolume volume = this->At(start + 3min);
    return std::count(volume.states.begin(), volume.states.end(), VoxelState::Echo);
  };
  const auto all = echoes(0);
  EXPECT_AT_LEAST(all, 700, "voxels of echo");
  EXPECT_EQ(echoes(5), all);
  EXPECT_LT(echoes(8), all);
  EXPECT_AT_LEAST(echoes(8), 700, "voxels of echo without speckle");
  EXPECT_EQ(echoes(9), 0);
  reader->SetOption("despeckle", 100);
  this->ExpectFailure(vtkErrorCode::UserError, "despeckle: '100' is no number from 0 to 26");
}

TEST_F(DayReader, LittleMemoryGivesTheSameVolumes)
{
  const GriddedVolume before = this->At(start + 5min);
  reader->SetMemoryLimit(0);
  const GriddedVolume after = this->At(start + 5min);
  EXPECT_EQ(before.values, after.values);
  EXPECT_EQ(before.states, after.states);
}

TEST_F(DayReader, ADamagedFileStillMakesTheDay)
{
  std::filesystem::resize_file(
    folder.Path() / "3", std::filesystem::file_size(folder.Path() / "3") - 30'000);
  std::ofstream(folder.Path() / "notes.txt") << "nothing of interest to a radar";
  EXPECT_NEAR(EchoOf(this->At(start + 3min), false), 50.0F, 1e-3F);
  EXPECT_TRUE(events->errors.empty());
  EXPECT_TRUE(AnyHolds(events->warnings, (folder.Path() / "3").string() + ": offset"));
  EXPECT_EQ(events->warnings.size(), 2U) << "one a file, whatever number of faults it has";
  EXPECT_EQ(reader->GetDamage()->GetNumberOfValues(), 2);
  ASSERT_EQ(reader->GetLeftOut()->GetNumberOfValues(), 1);
  EXPECT_EQ(reader->GetLeftOut()->GetValue(0), (folder.Path() / "notes.txt").string());
  reader->Modified();
  reader->Update(); // known already: no second warning
  EXPECT_EQ(events->warnings.size(), 2U);
}

TEST_F(DayReader, RequestsThatCannotBeMetAreErrors)
{
  reader->SetTimeStep(0.0);
  this->ExpectFailure(vtkErrorCode::UserError, "step");
  // Who asks again, downstream, is told so as well, and writes nothing.
  vtkNew<vtkNexradVolumeWriter> writer;
  events->Observe(writer);
  events->Observe(writer->GetExecutive());
  writer->SetInputConnection(reader->GetOutputPort());
  writer->SetFileName((folder.Path() / "day.nxv.series").c_str());
  EXPECT_EQ(writer->Write(), 0);
  EXPECT_EQ(writer->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::UserError));
  EXPECT_FALSE(std::filesystem::exists(folder.Path() / "day.nxv.series"));
  reader->SetTimeStep(3600.0);
  reader->SetBeginTime(nexrad::ToSeconds(start + 1min));
  this->ExpectFailure(vtkErrorCode::UserError, "no multiple of the time step");
  reader->SetBeginTime(VTK_DOUBLE_MIN);
  reader->SetHeightRange(9000.0, 1000.0);
  this->ExpectFailure(vtkErrorCode::UserError, "");
  reader->SetHeightRange(0.0, 9000.0);
  reader->SetMoment("VEL");
  this->ExpectFailure(vtkErrorCode::UserError, "VEL");
  reader->SetMoment("REF");
  reader->SetOption("method", 7.0);
  this->ExpectFailure(vtkErrorCode::UserError, "'7' is no method");
  reader->SetOption("method", "thesis");
  reader->ClearFileNames();
  this->ExpectFailure(vtkErrorCode::NoFileNameError, "no file name");
  reader->AddFileName((folder.Path() / "absent").c_str());
  this->ExpectFailure(vtkErrorCode::FileNotFoundError, "absent: no such file or folder");
}

// Options by their keys are those of the program, and count before the properties.
TEST_F(DayReader, TakesOptionsByTheirKeys)
{
  reader->SetOption("height", "1km,9km");
  reader->SetOption("dims", "8x6x4");
  const GriddedVolume volume = this->At(start + 3min);
  EXPECT_EQ(volume.grid.dimensions, (std::array<int, 3>{8, 6, 4}));
  EXPECT_EQ(volume.grid.origin[2], 2000.0);
  reader->SetOption("overlap", 0.0);
  EXPECT_EQ(reader->GetOption("overlap"), "mean");
  reader->SetOption("overlap-length", 80e3);
  EXPECT_EQ(reader->GetOption("overlap-length"), "80km");
  EXPECT_EQ(reader->GetOption("max-gap"), "15min");
  EXPECT_TRUE(events->errors.empty());
  reader->SetOption("colour", "red");
  EXPECT_TRUE(AnyHolds(events->errors, "there is no option colour"));
}

// A list of moments gives an array for each; a file without one of them still takes part.
TEST_F(DayReader, SeveralMomentsAreMergedInOneRun)
{
  reader->SetOption("method", "beam");
  nexrad::testing::HandMadeVolume volume = ConstantVolume(keax, start + 9min, 20.0);
  nexrad::testing::HandMadeMoment velocity = volume.sweeps[0].moments[0];
  velocity.name = nexrad::MomentName::VEL;
  volume.sweeps[0].moments.push_back(velocity);
  const nexrad::testing::TemporaryFolder own;
  WriteLevel2(own.Path() / "1", {volume});
  reader->AddFileName(own.Path().c_str());
  const GriddedVolume alone = this->At(start + 6min);
  reader->SetMoment("REF,VEL");
  const GriddedVolume both = this->At(start + 6min);
  ASSERT_EQ(both.further.size(), 1U);
  EXPECT_EQ(both.further[0].moment, nexrad::MomentName::VEL);
  EXPECT_NEAR(EchoOf(both.further[0], true), 20.0F, 1e-3F);
  EXPECT_TRUE(AnyHolds(events->warnings, "no ray has VEL"));
  EXPECT_TRUE(both.values == alone.values);
  EXPECT_TRUE(events->errors.empty());
  reader->SetMoment("REF,REF");
  this->ExpectFailure(vtkErrorCode::UserError, "REF,REF");
}

TEST_F(DayReader, ReportsProgressAndStopsWhenAsked)
{
  reader->Update();
  EXPECT_AT_LEAST(events->progress.size(), 3U, "reports of progress");
  EXPECT_TRUE(std::all_of(events->progress.begin(), events->progress.end(),
    [](double each) { return each >= 0.0 && each <= 1.0; }));
  vtkNew<vtkCallbackCommand> stop;
  stop->SetCallback([](vtkObject* caller, unsigned long, void*, void*)
    { static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(1); });
  const unsigned long tag = reader->AddObserver(vtkCommand::ProgressEvent, stop);
  reader->Modified();
  reader->Update();
  EXPECT_EQ(reader->GetOutput()->GetPointData()->GetNumberOfArrays(), 0);
  EXPECT_TRUE(events->errors.empty());
  reader->RemoveObserver(tag);
  reader->Modified();
  reader->Update();
  EXPECT_EQ(reader->GetOutput()->GetPointData()->GetNumberOfArrays(), 3);
}

TEST_F(DayReader, AScanThatWasStoppedStartsAgain)
{
  vtkNew<vtkCallbackCommand> stop;
  stop->SetCallback([](vtkObject* caller, unsigned long, void*, void*)
    { static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(1); });
  const unsigned long tag = reader->AddObserver(vtkCommand::ProgressEvent, stop);
  reader->Update();
  EXPECT_TRUE(events->errors.empty());
  EXPECT_EQ(reader->GetOutput()->GetNumberOfPoints(), 0);
  reader->RemoveObserver(tag);
  reader->Modified();
  reader->Update();
  EXPECT_EQ(reader->GetOutput()->GetPointData()->GetNumberOfArrays(), 3);
}

TEST_F(DayReader, ADayIsWrittenAndReadBack)
{
  const nexrad::testing::TemporaryFolder target;
  const std::string path = (target.Path() / "day.nxv.series").string();
  vtkNew<vtkNexradVolumeWriter> writer;
  vtkNew<EventCounter> writing;
  writing->Observe(writer);
  writer->SetInputConnection(reader->GetOutputPort());
  writer->SetFileName(path.c_str());
  writer->SetEncoding(vtkNexradVolumeWriter::FLOAT);
  ASSERT_EQ(writer->Write(), 1);
  EXPECT_EQ(writer->GetNumberOfWrittenFiles(), 14); // 13 steps and the index
  EXPECT_AT_LEAST(writing->progress.size(), 13U, "reports of progress");
  vtkNew<vtkNexradVolumeReader> volumes;
  volumes->SetFileName(path.c_str());
  volumes->UpdateInformation();
  for (const nexrad::Duration after : {nexrad::Duration(1min), nexrad::Duration(9min)})
  {
    volumes->UpdateTimeStep(nexrad::ToSeconds(start + after));
    const GriddedVolume expected = this->At(start + after);
    const GriddedVolume volume = vtkNexradImageToVolume(volumes->GetOutput());
    EXPECT_EQ(volume.time, start + after);
    EXPECT_EQ(volume.values, expected.values);
    EXPECT_EQ(volume.states, expected.states);
    EXPECT_EQ(volume.sites, expected.sites);
  }
}

TEST_F(DayReader, AStoppedWriterWritesNoIndex)
{
  const nexrad::testing::TemporaryFolder target;
  const std::string path = (target.Path() / "day.nxv.series").string();
  vtkNew<vtkNexradVolumeWriter> writer;
  writer->SetInputConnection(reader->GetOutputPort());
  writer->SetFileName(path.c_str());
  vtkNew<vtkCallbackCommand> stop;
  stop->SetCallback(
    [](vtkObject* caller, unsigned long, void*, void* progress)
    {
      if (*static_cast<double*>(progress) > 0.5)
      {
        static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(1);
      }
    });
  writer->AddObserver(vtkCommand::ProgressEvent, stop);
  EXPECT_EQ(writer->Write(), 0);
  EXPECT_EQ(writer->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::NoError));
  EXPECT_FALSE(std::filesystem::exists(path));
  EXPECT_EQ(writer->GetNumberOfWrittenFiles(), 7);
}

TEST_F(DayReader, PrintsItsState)
{
  std::ostringstream text;
  reader->Print(text);
  EXPECT_NE(text.str().find("TimeStep: 60"), std::string::npos);
  EXPECT_NE(text.str().find("dims: 48x24x8"), std::string::npos);
}

// The whole way on real files against the core's own: scan, choice of volumes and merge.
TEST(DayReaderOnRealFiles, GivesTheMergeOfTheVolumesAboutTheTime)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  const std::filesystem::path run = data / "level2/run-kbgm-20050821";
  vtkNew<vtkNexradDayReader> reader;
  reader->SetDimensions(64, 64, 16);
  reader->SetOption("method", "thesis");
  reader->AddFileName(run.c_str());
  reader->UpdateInformation();
  // The rays run from 02:43:19 to 03:12:12: 02:45, 02:50, … 03:10.
  ASSERT_EQ(reader->GetTimeSteps()->GetNumberOfValues(), 6);
  const nexrad::Time time = *nexrad::ParseIso8601("2005-08-21T02:55:00Z");
  EXPECT_EQ(reader->GetTimeSteps()->GetValue(2), nexrad::ToSeconds(time));
  reader->UpdateTimeStep(nexrad::ToSeconds(time));
  const GriddedVolume volume = vtkNexradImageToVolume(reader->GetOutput());

  // 02:54:54 and 03:00:42 lie about 02:55.
  const nexrad::PolarVolume before = nexrad::MakePolarVolume(
    nexrad::ReadLevel2(run / "KBGM20050821_025458.gz"), nexrad::MomentName::REF);
  const nexrad::PolarVolume after = nexrad::MakePolarVolume(
    nexrad::ReadLevel2(run / "KBGM20050821_030047.gz"), nexrad::MomentName::REF);
  nexrad::GridRequest request;
  request.dimensions = {64, 64, 16};
  const auto expected = nexrad::MergeThesis(
    {{&before, &after}}, nexrad::MakeGrid(request, {*before.site.position}), time);
  EXPECT_EQ(volume.values, expected->values);
  EXPECT_EQ(volume.states, expected->states);
  EXPECT_AT_LEAST(std::count(volume.states.begin(), volume.states.end(), VoxelState::Echo), 6'000,
    "voxels of echo");
}

vtkSmartPointer<vtkNexradDayReader> SmallDayOf(const std::filesystem::path& file)
{
  auto reader = vtkSmartPointer<vtkNexradDayReader>::New();
  reader->SetDimensions(48, 48, 12);
  reader->AddFileName(file.c_str());
  return reader;
}

GriddedVolume FirstVolumeOf(vtkNexradDayReader* reader)
{
  reader->UpdateInformation();
  reader->UpdateTimeStep(reader->GetTimeSteps()->GetValue(0));
  return vtkNexradImageToVolume(reader->GetOutput());
}

// The reader keeps what it made with one setting apart from what it makes with another.
TEST(DayReaderOnRealFiles, DealiasesAsAsked)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  const auto reader = SmallDayOf(data / "level2/legacy/KTLX19990503_235621.gz");
  reader->SetMoment("VEL");
  EXPECT_EQ(reader->GetOption("dealiasing"), "on");
  const std::vector<float> unfolded = FirstVolumeOf(reader).values;
  reader->SetOption("dealiasing", "off");
  EXPECT_NE(FirstVolumeOf(reader).values, unfolded);
  reader->SetOption("dealiasing", "on");
  EXPECT_EQ(FirstVolumeOf(reader).values, unfolded);
}

TEST(DayReaderOnRealFiles, DerivesMoments)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  const auto reader = SmallDayOf(data / "level2/legacy/KTLX19990503_235621.gz");
  reader->SetOption("bounds", "-97.75,35.21,-97.65,35.29"); // where the tornado is
  reader->SetMoment("AZSHEAR");
  const GriddedVolume shear = FirstVolumeOf(reader);
  EXPECT_AT_LEAST(*std::max_element(shear.values.begin(), shear.values.end()), 0.025,
    "merged azimuthal shear of the tornado, per second");
  EXPECT_STREQ(reader->GetOutput()->GetPointData()->GetScalars()->GetName(), "AZSHEAR");
  reader->SetMoment("SRV");
  const std::vector<float> estimated = FirstVolumeOf(reader).values;
  reader->SetOption("storm-motion", "12,8");
  EXPECT_NE(FirstVolumeOf(reader).values, estimated);
}

// Of two radars that differ by 4 dB: neither, one, or half of it of each.
TEST(DayReaderOfTwoRadars, TakesBiasesOff)
{
  const nexrad::testing::TemporaryFolder folder;
  nexrad::testing::WriteTwoRadars(folder.Path(), 30.0, 34.0);
  const auto reader = SmallDayOf(folder.Path());
  reader->SetOption("sharpening", "off");
  const auto largestWith = [&](const char* bias)
  {
    reader->SetOption("bias", bias);
    const std::vector<float> values = FirstVolumeOf(reader).values;
    return *std::max_element(values.begin(), values.end());
  };
  EXPECT_EQ(reader->GetOption("bias"), "off");
  EXPECT_NEAR(largestWith("off"), 34.0F, 1e-4F);
  EXPECT_NEAR(largestWith("KTWO:4"), 30.0F, 1e-4F);
  EXPECT_NEAR(largestWith("auto"), 32.0F, 1e-4F);
  EXPECT_EQ(
    reader->GetRadarComparison()->GetValue(0).find("KONE - KTWO: median -4.00 dB"), std::size_t{0});
  EXPECT_EQ(reader->GetRadarComparison()->GetNumberOfValues(), 3);
  vtkNew<EventCounter> events;
  events->Observe(reader);
  events->Observe(reader->GetExecutive());
  reader->SetOption("bias", "KABR:1");
  reader->Update();
  EXPECT_TRUE(AnyHolds(events->errors, "a bias is given for KABR"));
}

// The motion that is found, one that is given and none make three volumes; no speed is none.
TEST(DayReaderOnRealFiles, MovesEchoAsAsked)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  const std::filesystem::path run = data / "level2/run-kbgm-20050821";
  const auto reader = SmallDayOf(run / "KBGM20050821_024910.gz");
  reader->AddFileName((run / "KBGM20050821_030047.gz").c_str());
  reader->SetBeginTime(nexrad::ToSeconds(*nexrad::ParseIso8601("2005-08-21T02:55:00Z")));
  EXPECT_EQ(reader->GetOption("motion"), "estimated");
  const std::vector<float> found = FirstVolumeOf(reader).values;
  reader->SetOption("motion", "none");
  const std::vector<float> linear = FirstVolumeOf(reader).values;
  EXPECT_NE(found, linear);
  reader->SetOption("motion", "0,0");
  EXPECT_EQ(FirstVolumeOf(reader).values, linear);
  reader->SetOption("motion", "20,5");
  const std::vector<float> given = FirstVolumeOf(reader).values;
  EXPECT_NE(given, linear);
  EXPECT_NE(given, found);
  vtkNew<EventCounter> events;
  events->Observe(reader);
  events->Observe(reader->GetExecutive());
  reader->SetOption("motion", "200,0");
  reader->Update();
  EXPECT_EQ(reader->GetErrorCode(), vtkErrorCode::UserError);
  EXPECT_TRUE(AnyHolds(events->errors, "150 m/s"));
}

} // namespace
