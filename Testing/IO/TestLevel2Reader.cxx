// SPDX-License-Identifier: BSD-3-Clause
#include "EventCounter.h"
#include "HandMadeVolume.h"
#include "Scans/RadarsOfMissouri.h"
#include "SweepAccess.h"
#include "TestData.h"
#include "Tolerance.h"

#include "nexrad/Level2/Level2File.h"
#include "vtkNexradLevel2Reader.h"

#include "vtkCallbackCommand.h"
#include "vtkDataArraySelection.h"
#include "vtkDataAssembly.h"
#include "vtkDataObject.h"
#include "vtkDoubleArray.h"
#include "vtkErrorCode.h"
#include "vtkExecutive.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

namespace
{

using nexrad::testing::AnyHolds;
using nexrad::testing::EventCounter;
using nexrad::testing::GridOf;
using nexrad::testing::keax;
using nexrad::testing::NameOf;
using nexrad::testing::start;
using nexrad::testing::TemporaryFolder;

/// Reads a file that must give no error; warnings are allowed.
vtkNew<vtkNexradLevel2Reader> Read(const std::filesystem::path& path)
{
  vtkNew<vtkNexradLevel2Reader> reader;
  vtkNew<EventCounter> events;
  events->Observe(reader);
  reader->SetFileName(path.c_str());
  reader->Update();
  EXPECT_TRUE(events->errors.empty()) << path;
  EXPECT_EQ(reader->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::NoError));
  return reader;
}

/// The gates of a row as the arrays must hold them, compared one by one. Returns their number.
std::size_t CompareRow(
  const nexrad::MomentRow& row, vtkStructuredGrid* grid, const char* name, vtkIdType line)
{
  auto* values = vtkFloatArray::SafeDownCast(grid->GetPointData()->GetArray(name));
  auto* states = vtkUnsignedCharArray::SafeDownCast(
    grid->GetPointData()->GetArray((std::string(name) + "_state").c_str()));
  const double* geometry = grid->GetFieldData()->GetArray("GateGeometry")->GetTuple(0);
  const vtkIdType columns = grid->GetDimensions()[0];
  std::size_t compared = 0;
  for (std::size_t gate = 0; gate < row.gates; ++gate)
  {
    const double range = row.firstGate + static_cast<double>(gate) * row.gateSpacing;
    if (range < 0.0)
    {
      continue;
    }
    const auto column = static_cast<vtkIdType>(std::lround((range - geometry[0]) / geometry[1]));
    const vtkIdType point = line * columns + column;
    if (states->GetValue(point) != static_cast<unsigned char>(row.State(gate)))
    {
      ADD_FAILURE() << name << " ray " << line << " gate " << gate;
      return compared;
    }
    const float value = values->GetValue(point);
    const bool valid = row.State(gate) == nexrad::GateState::Valid;
    if (valid ? value != row.Value(gate) : !std::isnan(value))
    {
      ADD_FAILURE() << name << " ray " << line << " gate " << gate << ": " << value;
      return compared;
    }
    ++compared;
  }
  return compared;
}

/// The grid of a sweep that holds a row's gates.
vtkStructuredGrid* FindGrid(vtkPartitionedDataSet* grids, const nexrad::MomentRow& row)
{
  for (unsigned int i = 0; i < grids->GetNumberOfPartitions(); ++i)
  {
    auto* grid = vtkStructuredGrid::SafeDownCast(grids->GetPartition(i));
    const double* geometry = grid->GetFieldData()->GetArray("GateGeometry")->GetTuple(0);
    const double offset = (geometry[0] - row.firstGate) / row.gateSpacing;
    if (geometry[1] == row.gateSpacing && offset == std::floor(offset) && offset >= 0.0)
    {
      return grid;
    }
  }
  return nullptr;
}

/// Every gate of every ray of a file against what the core reads. Returns their number.
std::size_t CompareWithCore(const std::filesystem::path& path)
{
  const nexrad::RadarVolume volume = nexrad::ReadLevel2(path);
  const auto reader = Read(path);
  vtkPartitionedDataSetCollection* sweeps = reader->GetOutput();
  EXPECT_EQ(sweeps->GetNumberOfPartitionedDataSets(), volume.sweeps.size());
  std::size_t compared = 0;
  for (unsigned int i = 0; i < sweeps->GetNumberOfPartitionedDataSets(); ++i)
  {
    const nexrad::Sweep& sweep = volume.sweeps[i];
    for (std::size_t ray = 0; ray < sweep.rays.size(); ++ray)
    {
      for (const nexrad::MomentName moment : nexrad::AllMoments)
      {
        const nexrad::MomentRow& row = sweep.rays[ray].Row(moment);
        if (row.gates > 0)
        {
          compared += CompareRow(row, FindGrid(sweeps->GetPartitionedDataSet(i), row),
            nexrad::ToString(moment), static_cast<vtkIdType>(ray));
        }
      }
    }
  }
  return compared;
}

TEST(Level2Reader, GivesEveryGateOfAMessage1FileAsTheCoreReadsIt)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  EXPECT_AT_LEAST(CompareWithCore(data / "level2/run-kbgm-20050821/KBGM20050821_024323.gz"),
    4'000'000U, "gates compared");
}

TEST(Level2Reader, GivesEveryGateOfAMessage31FileAsTheCoreReadsIt)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  EXPECT_AT_LEAST(CompareWithCore(data / "level2/superres/KDMX20220305_232324.bin"), 10'000'000U,
    "gates compared");
}

TEST(Level2Reader, DescribesTheVolumeAndEachSweep)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  const auto reader = Read(data / "level2/run-kbgm-20050821/KBGM20050821_024323.gz");
  vtkPartitionedDataSetCollection* sweeps = reader->GetOutput();
  ASSERT_EQ(sweeps->GetNumberOfPartitionedDataSets(), 11U);
  // The cut of the coverage pattern; an independent decoder finds a mean of 1.38577 degrees.
  EXPECT_EQ(NameOf(sweeps, 3), "Sweep 03 1.45 deg");
  vtkDataAssembly* assembly = sweeps->GetDataAssembly();
  ASSERT_NE(assembly, nullptr);
  const int node = assembly->FindFirstNodeWithName(
    vtkDataAssembly::MakeValidNodeName(NameOf(sweeps, 3).c_str()).c_str());
  ASSERT_EQ(assembly->GetDataSetIndices(node), std::vector<unsigned int>{3});

  vtkFieldData* field = GridOf(sweeps, 3)->GetFieldData();
  EXPECT_EQ(vtkStringArray::SafeDownCast(field->GetAbstractArray("Site"))->GetValue(0), "KBGM");
  EXPECT_WITHIN(
    field->GetArray("Position")->GetComponent(0, 0), 42.2, 0.0006, "latitude of KBGM, degrees");
  EXPECT_WITHIN(
    field->GetArray("Position")->GetComponent(0, 1), -75.985, 0.0005, "longitude of KBGM, degrees");
  EXPECT_EQ(field->GetArray("VCP")->GetComponent(0, 0), 21.0);
  EXPECT_EQ(field->GetArray("SweepIndex")->GetComponent(0, 0), 3.0);
  EXPECT_AT_LEAST(
    field->GetArray("NyquistVelocity")->GetComponent(0, 0), 20.0, "Nyquist velocity, m/s");
  EXPECT_WITHIN(field->GetArray("StartTime")->GetComponent(0, 0), 1124592199.0, 1.0,
    "time of the first ray, s"); // 02:43:19
  EXPECT_WITHIN(field->GetArray("EndTime")->GetComponent(0, 0), 1124592541.0, 0.4,
    "time of the last ray, s"); // 02:49:01
  // All the way round: a row more than rays, and the last is the first again.
  vtkStructuredGrid* grid = GridOf(sweeps, 3);
  const vtkIdType rays = field->GetArray("RayTime")->GetNumberOfTuples();
  ASSERT_EQ(grid->GetDimensions()[1], rays + 1);
  double first[3];
  double last[3];
  grid->GetPoint(grid->GetDimensions()[0] - 1, first);
  grid->GetPoint(grid->GetNumberOfPoints() - 1, last);
  EXPECT_EQ(first[0], last[0]);
  EXPECT_EQ(first[1], last[1]);
  EXPECT_EQ(sweeps->GetInformation()->Get(vtkDataObject::DATA_TIME_STEP()),
    field->GetArray("StartTime")->GetComponent(0, 0));
}

TEST(Level2Reader, PublishesItsTime)
{
  const TemporaryFolder folder;
  const auto path = nexrad::testing::WriteLevel2(
    folder.Path() / "file", {nexrad::testing::ConstantVolume(keax, start, 20.0)});
  vtkNew<vtkNexradLevel2Reader> reader;
  reader->SetFileName(path.c_str());
  reader->UpdateInformation();
  vtkInformation* info = reader->GetOutputInformation(0);
  ASSERT_EQ(info->Length(vtkStreamingDemandDrivenPipeline::TIME_STEPS()), 1);
  EXPECT_EQ(info->Get(vtkStreamingDemandDrivenPipeline::TIME_STEPS())[0], nexrad::ToSeconds(start));
}

TEST(Level2Reader, ReadsTheMomentsThatAreEnabled)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  vtkNew<vtkNexradLevel2Reader> reader;
  reader->SetFileName((data / "level2/run-kbgm-20050821/KBGM20050821_024323.gz").c_str());
  reader->GetMomentSelection()->DisableAllArrays();
  reader->GetMomentSelection()->EnableArray("VEL");
  reader->Update();
  // The first cut is for reflectivity alone; the second has the velocity.
  EXPECT_EQ(GridOf(reader->GetOutput(), 0), nullptr);
  vtkStructuredGrid* grid = GridOf(reader->GetOutput(), 1);
  ASSERT_NE(grid, nullptr);
  EXPECT_NE(grid->GetPointData()->GetArray("VEL"), nullptr);
  EXPECT_EQ(grid->GetPointData()->GetArray("SW"), nullptr);
  reader->GetMomentSelection()->EnableArray("SW");
  reader->Update();
  EXPECT_NE(GridOf(reader->GetOutput(), 1)->GetPointData()->GetArray("SW"), nullptr);
}

TEST(Level2Reader, WarnsOfDamageAndReadsTheRest)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  const std::filesystem::path path = data / "level2/damaged/KIWX20160429_194300_V06.gz";
  vtkNew<vtkNexradLevel2Reader> reader;
  vtkNew<EventCounter> events;
  events->Observe(reader);
  reader->SetFileName(path.c_str());
  reader->Update();
  EXPECT_TRUE(events->errors.empty());
  ASSERT_FALSE(events->warnings.empty());
  EXPECT_TRUE(AnyHolds(events->warnings, path.string() + ": offset "));
  EXPECT_EQ(
    reader->GetDamage()->GetNumberOfValues(), static_cast<vtkIdType>(events->warnings.size()));
  EXPECT_EQ(reader->GetOutput()->GetNumberOfPartitionedDataSets(), 1U);
  // 76 rays are not all the way round: no row is repeated.
  EXPECT_EQ(GridOf(reader->GetOutput(), 0)->GetDimensions()[1], 76);
}

void ExpectFailure(const std::filesystem::path& path, unsigned long code, const std::string& text)
{
  vtkNew<vtkNexradLevel2Reader> reader;
  vtkNew<EventCounter> events;
  events->Observe(reader);
  events->Observe(reader->GetExecutive());
  reader->SetFileName(path.c_str());
  reader->Update();
  EXPECT_EQ(reader->GetErrorCode(), code) << path;
  EXPECT_TRUE(AnyHolds(events->errors, text)) << path;
  EXPECT_EQ(reader->GetOutput()->GetNumberOfPartitionedDataSets(), 0U);
}

TEST(Level2Reader, FailsWithACodeAndOneLine)
{
  const TemporaryFolder folder;
  ExpectFailure(
    folder.Path() / "absent", vtkErrorCode::FileNotFoundError, "absent: no such file or folder");
  ExpectFailure("", vtkErrorCode::NoFileNameError, "no file name");
  std::ofstream(folder.Path() / "text") << "This is no radar file, and it never was one.";
  ExpectFailure(
    folder.Path() / "text", vtkErrorCode::UnrecognizedFileTypeError, "text: not a Level II file");
}

TEST(Level2Reader, FailsOnFilesWithoutARay)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  for (const char* name : {"KBMX20160509_093623_V06.gz", "KJKL_20240227_102059"})
  {
    ExpectFailure(
      data / "level2/damaged" / name, vtkErrorCode::FileFormatError, "no ray could be read");
  }
}

TEST(Level2Reader, RecoversAfterAFailure)
{
  const TemporaryFolder folder;
  const auto path = nexrad::testing::WriteLevel2(
    folder.Path() / "file", {nexrad::testing::ConstantVolume(keax, start, 20.0)});
  vtkNew<vtkNexradLevel2Reader> reader;
  vtkNew<EventCounter> events;
  events->Observe(reader);
  events->Observe(reader->GetExecutive());
  reader->SetFileName((folder.Path() / "absent").c_str());
  reader->Update();
  reader->SetFileName(path.c_str());
  reader->Update();
  EXPECT_EQ(reader->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::NoError));
  EXPECT_EQ(reader->GetOutput()->GetNumberOfPartitionedDataSets(), 1U);
}

TEST(Level2Reader, SaysWhatItCanRead)
{
  const TemporaryFolder folder;
  std::ofstream(folder.Path() / "text") << "This is no radar file, and it never was one.";
  const auto path = nexrad::testing::WriteLevel2(
    folder.Path() / "file", {nexrad::testing::ConstantVolume(keax, start, 20.0)});
  EXPECT_EQ(vtkNexradLevel2Reader::CanReadFile(path.c_str()), 1);
  EXPECT_EQ(vtkNexradLevel2Reader::CanReadFile((folder.Path() / "text").c_str()), 0);
  EXPECT_EQ(vtkNexradLevel2Reader::CanReadFile((folder.Path() / "absent").c_str()), 0);
  EXPECT_EQ(vtkNexradLevel2Reader::CanReadFile(folder.Path().c_str()), 0);
  EXPECT_EQ(vtkNexradLevel2Reader::CanReadFile(nullptr), 0);
}

TEST(Level2Reader, ReadsAFolderOfChunks)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  const std::filesystem::path path = data / "level2/chunks/TORD-20260811";
  EXPECT_EQ(vtkNexradLevel2Reader::CanReadFile(path.c_str()), 1);
  const auto reader = Read(path);
  vtkIdType rays = 0;
  for (unsigned int i = 0; i < reader->GetOutput()->GetNumberOfPartitionedDataSets(); ++i)
  {
    vtkFieldData* field = GridOf(reader->GetOutput(), i)->GetFieldData();
    rays += field->GetArray("RayTime")->GetNumberOfTuples();
  }
  EXPECT_EQ(rays, 5760);
}

TEST(Level2Reader, ReportsProgressAndStopsWhenAsked)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  const std::filesystem::path path = data / "level2/run-kbgm-20050821/KBGM20050821_024323.gz";
  vtkNew<vtkNexradLevel2Reader> reader;
  vtkNew<EventCounter> events;
  events->Observe(reader);
  reader->SetFileName(path.c_str());
  reader->Update();
  EXPECT_AT_LEAST(events->progress.size(), 10U, "reports of progress");
  EXPECT_AT_MOST(events->progress.size(), 25U, "reports of progress");
  EXPECT_TRUE(std::is_sorted(events->progress.begin(), events->progress.end()));

  vtkNew<vtkCallbackCommand> stop;
  stop->SetCallback([](vtkObject* caller, unsigned long, void*, void*)
    { static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(1); });
  const unsigned long tag = reader->AddObserver(vtkCommand::ProgressEvent, stop);
  reader->Modified();
  reader->Update();
  EXPECT_EQ(reader->GetOutput()->GetNumberOfPartitionedDataSets(), 0U);
  reader->RemoveObserver(tag);
  reader->Modified();
  reader->Update();
  EXPECT_EQ(reader->GetOutput()->GetNumberOfPartitionedDataSets(), 11U);
}

TEST(Level2Reader, PrintsItsState)
{
  vtkNew<vtkNexradLevel2Reader> reader;
  reader->SetFileName("a-file");
  reader->SetCoordinatesToGeographic();
  std::ostringstream text;
  reader->Print(text);
  EXPECT_NE(text.str().find("FileName: a-file"), std::string::npos);
  EXPECT_NE(text.str().find("Coordinates: 1"), std::string::npos);
}

} // namespace
