// SPDX-License-Identifier: BSD-3-Clause
#include "EventCounter.h"
#include "Feed/TarMaker.h"
#include "HandMadeVolume.h"
#include "Scans/RadarsOfMissouri.h"
#include "SweepAccess.h"
#include "TestData.h"
#include "Tolerance.h"

#include "vtkNexradLevel2Reader.h"
#include "vtkNexradSeriesReader.h"

#include "vtkCallbackCommand.h"
#include "vtkDataObject.h"
#include "vtkErrorCode.h"
#include "vtkExecutive.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStringArray.h"

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <vector>

namespace
{

using namespace std::chrono_literals;
using nexrad::testing::AnyHolds;
using nexrad::testing::ConstantVolume;
using nexrad::testing::EventCounter;
using nexrad::testing::GridOf;
using nexrad::testing::keax;
using nexrad::testing::klsx;
using nexrad::testing::NameOf;
using nexrad::testing::start;
using nexrad::testing::WriteLevel2;

/// KEAX at 18:00 (10 dBZ) and 18:05 (20 dBZ), KLSX at 18:02 (50 dBZ).
class SeriesReader : public ::testing::Test
{
protected:
  SeriesReader()
  {
    WriteLevel2(folder.Path() / "c", {ConstantVolume(keax, start, 10.0)});
    WriteLevel2(folder.Path() / "b", {ConstantVolume(klsx, start + 2min, 50.0)});
    WriteLevel2(folder.Path() / "a", {ConstantVolume(keax, start + 5min, 20.0)});
    reader->AddFileName(folder.Path().c_str());
    events->Observe(reader);
    events->Observe(reader->GetExecutive());
  }

  vtkPartitionedDataSetCollection* At(nexrad::Time time)
  {
    reader->UpdateInformation();
    reader->UpdateTimeStep(nexrad::ToSeconds(time));
    return reader->GetOutput();
  }

  static double FirstValue(vtkPartitionedDataSetCollection* sweeps, unsigned int sweep)
  {
    return GridOf(sweeps, sweep)->GetPointData()->GetArray("REF")->GetComponent(50, 0);
  }

  const nexrad::testing::TemporaryFolder folder;
  vtkNew<vtkNexradSeriesReader> reader;
  vtkNew<EventCounter> events;
};

TEST_F(SeriesReader, TimeStepsAreTheStartsOfAllVolumes)
{
  reader->UpdateInformation();
  vtkInformation* info = reader->GetOutputInformation(0);
  ASSERT_EQ(info->Length(vtkStreamingDemandDrivenPipeline::TIME_STEPS()), 3);
  const double* steps = info->Get(vtkStreamingDemandDrivenPipeline::TIME_STEPS());
  EXPECT_EQ(steps[0], nexrad::ToSeconds(start));
  EXPECT_EQ(steps[1], nexrad::ToSeconds(start + 2min));
  EXPECT_EQ(steps[2], nexrad::ToSeconds(start + 5min));
  EXPECT_TRUE(events->warnings.empty());
}

TEST_F(SeriesReader, ReadsATarArchiveAsItsFolder)
{
  std::vector<nexrad::testing::TarEntry> entries;
  for (const char* name : {"a", "b", "c"})
  {
    const std::string content = nexrad::testing::FileContent(folder.Path() / name);
    entries.push_back({name, {content.begin(), content.end()}});
  }
  const nexrad::testing::TemporaryFolder other;
  const auto tar =
    nexrad::testing::WriteBytes(other.Path() / "day.tar", nexrad::testing::MakeTar(entries));
  EXPECT_EQ(vtkNexradSeriesReader::CanReadFile(tar.c_str()), 1);
  reader->ClearFileNames();
  reader->AddFileName(tar.c_str());
  EXPECT_EQ(FirstValue(this->At(start), 0), 10.0);
  EXPECT_EQ(FirstValue(this->At(start + 5min), 0), 20.0);
  vtkNew<vtkNexradLevel2Reader> alone;
  EXPECT_EQ(vtkNexradLevel2Reader::CanReadFile(tar.c_str()), 0);
  EXPECT_EQ(vtkNexradLevel2Reader::CanReadFile((tar / "b").c_str()), 1);
  alone->SetFileName((tar / "b").c_str());
  alone->Update();
  EXPECT_EQ(FirstValue(alone->GetOutput(), 0), 50.0);
}

TEST_F(SeriesReader, ShowsEachSitesLatestVolume)
{
  vtkPartitionedDataSetCollection* sweeps = this->At(start);
  ASSERT_EQ(sweeps->GetNumberOfPartitionedDataSets(), 1U);
  EXPECT_EQ(NameOf(sweeps, 0), "KEAX Sweep 00 0.48 deg");
  EXPECT_EQ(FirstValue(sweeps, 0), 10.0);

  sweeps = this->At(start + 4min); // between time steps
  ASSERT_EQ(sweeps->GetNumberOfPartitionedDataSets(), 2U);
  EXPECT_EQ(NameOf(sweeps, 1), "KLSX Sweep 00 0.48 deg");
  EXPECT_EQ(FirstValue(sweeps, 0), 10.0);
  EXPECT_EQ(FirstValue(sweeps, 1), 50.0);
  EXPECT_EQ(sweeps->GetInformation()->Get(vtkDataObject::DATA_TIME_STEP()),
    nexrad::ToSeconds(start + 4min));

  sweeps = this->At(start + 5min);
  EXPECT_EQ(FirstValue(sweeps, 0), 20.0);
  EXPECT_EQ(this->At(start - 1min)->GetNumberOfPartitionedDataSets(), 0U);
}

TEST_F(SeriesReader, ProjectedCoordinatesPutEachSiteInItsPlace)
{
  vtkPartitionedDataSetCollection* sweeps = this->At(start + 5min);
  double bounds[6];
  GridOf(sweeps, 0)->GetBounds(bounds);
  const double keaxMiddle = 0.5 * (bounds[0] + bounds[1]);
  GridOf(sweeps, 1)->GetBounds(bounds);
  // The radars are 310 km apart, west and east of the centre.
  EXPECT_WITHIN(keaxMiddle, -155'500.0, 600.0, "place of KEAX, m");
  EXPECT_WITHIN(0.5 * (bounds[0] + bounds[1]), 155'500.0, 100.0, "place of KLSX, m");
}

TEST_F(SeriesReader, NamesWhatIsLeftOut)
{
  std::ofstream(folder.Path() / "notes.txt") << "nothing of interest to a radar";
  reader->UpdateInformation();
  ASSERT_EQ(events->warnings.size(), 1U);
  EXPECT_TRUE(AnyHolds(events->warnings, "notes.txt: not a Level II file: left out"));
  EXPECT_EQ(reader->GetDamage()->GetNumberOfValues(), 1);
}

TEST_F(SeriesReader, FailsWithoutAnyVolume)
{
  reader->ClearFileNames();
  reader->Update();
  EXPECT_EQ(reader->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::NoFileNameError));
  reader->AddFileName((folder.Path() / "absent").c_str());
  reader->Update();
  EXPECT_EQ(reader->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::FileNotFoundError));
  EXPECT_TRUE(AnyHolds(events->errors, "absent: no such file or folder"));
  std::ofstream(folder.Path() / "notes.txt") << "nothing of interest to a radar";
  reader->ClearFileNames();
  reader->AddFileName((folder.Path() / "notes.txt").c_str());
  reader->Update();
  EXPECT_EQ(reader->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::FileFormatError));
}

TEST_F(SeriesReader, SaysWhatItCanRead)
{
  const nexrad::testing::TemporaryFolder other;
  EXPECT_EQ(vtkNexradSeriesReader::CanReadFile(other.Path().c_str()), 0);
  std::ofstream(other.Path() / "text") << "This is no radar file, and it never was one.";
  EXPECT_EQ(vtkNexradSeriesReader::CanReadFile(other.Path().c_str()), 0);
  EXPECT_EQ(vtkNexradSeriesReader::CanReadFile((other.Path() / "text").c_str()), 0);
  EXPECT_EQ(vtkNexradSeriesReader::CanReadFile((other.Path() / "absent").c_str()), 0);
  EXPECT_EQ(vtkNexradSeriesReader::CanReadFile(nullptr), 0);
  EXPECT_EQ(vtkNexradSeriesReader::CanReadFile((folder.Path() / "a").c_str()), 1);
  EXPECT_EQ(vtkNexradSeriesReader::CanReadFile(folder.Path().c_str()), 1);
  std::filesystem::rename(folder.Path() / "a", other.Path() / "a");
  EXPECT_EQ(vtkNexradSeriesReader::CanReadFile(other.Path().c_str()), 1);
}

TEST_F(SeriesReader, StopsWhenAskedAndStartsAgain)
{
  vtkNew<vtkCallbackCommand> stop;
  stop->SetCallback([](vtkObject* caller, unsigned long, void*, void*)
    { static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(1); });
  const unsigned long tag = reader->AddObserver(vtkCommand::ProgressEvent, stop);
  reader->Update();
  EXPECT_TRUE(events->errors.empty());
  EXPECT_EQ(reader->GetOutput()->GetNumberOfPartitionedDataSets(), 0U);
  reader->RemoveObserver(tag);
  reader->Modified();
  reader->Update();
  EXPECT_EQ(reader->GetOutput()->GetNumberOfPartitionedDataSets(), 1U);
}

TEST(SeriesReaderOnRealFiles, CountsTheCyclesOfAFile)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  vtkNew<vtkNexradSeriesReader> reader;
  vtkNew<EventCounter> events; // the files have missing rays
  events->Observe(reader);
  reader->AddFileName((data / "level2/pairs/KBBX20060113_165921.gz").c_str());
  reader->AddFileName((data / "level2/pairs/KBBX20060113_170337.gz").c_str());
  reader->UpdateInformation();
  vtkInformation* info = reader->GetOutputInformation(0);
  // One volume in the first file, four in the second.
  EXPECT_EQ(info->Length(vtkStreamingDemandDrivenPipeline::TIME_STEPS()), 5);
}

} // namespace
