// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNexradEchoClasses.h"

#include "EventCounter.h"
#include "HandMadeVolume.h"
#include "TestData.h"
#include "Tolerance.h"

#include "vtkNexradLevel2Reader.h"

#include "nexrad/Level2/Level2File.h"
#include "nexrad/Polar/PolarVolume.h"
#include "nexrad/Quality/EchoClassification.h"

#include "vtkErrorCode.h"
#include "vtkExecutive.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPointData.h"
#include "vtkStringArray.h"
#include "vtkStructuredGrid.h"
#include "vtkTrivialProducer.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace
{

using nexrad::EchoClass;
using nexrad::EchoReason;
using nexrad::testing::EventCounter;

// Calls with each grid that has REF.
template <class Visit>
void VisitGrids(vtkPartitionedDataSetCollection* sweeps, const Visit& visit)
{
  for (unsigned int i = 0; i < sweeps->GetNumberOfPartitionedDataSets(); ++i)
  {
    vtkPartitionedDataSet* grids = sweeps->GetPartitionedDataSet(i);
    for (unsigned int j = 0; j < grids->GetNumberOfPartitions(); ++j)
    {
      auto* grid = vtkStructuredGrid::SafeDownCast(grids->GetPartition(j));
      if (grid && grid->GetPointData()->HasArray("REF"))
      {
        visit(grid);
      }
    }
  }
}

vtkUnsignedCharArray* BytesOf(vtkStructuredGrid* grid, const char* name)
{
  auto* array = vtkUnsignedCharArray::SafeDownCast(grid->GetPointData()->GetArray(name));
  EXPECT_NE(array, nullptr) << name;
  return array;
}

// Gates by reason; the row that repeats the first ray is not counted.
nexrad::ReasonCounts CountReasons(vtkPartitionedDataSetCollection* sweeps)
{
  nexrad::ReasonCounts counts{};
  VisitGrids(sweeps,
    [&](vtkStructuredGrid* grid)
    {
      const vtkIdType rays = grid->GetFieldData()->GetArray("RayTime")->GetNumberOfTuples();
      auto* reasons = BytesOf(grid, "REF_reason");
      for (vtkIdType i = 0; i < rays * grid->GetDimensions()[0]; ++i)
      {
        ++counts.at(reasons->GetValue(i));
      }
    });
  counts[0] = 0; // without a value: grids are padded
  return counts;
}

} // namespace

TEST(EchoClassesFilter, AreThoseOfTheFile)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  for (const char* name : {"quality/KMLB19980707_220118.gz", "superres/KTLX20190715_120037_V06"})
  {
    const std::filesystem::path file = data / "level2" / name;
    const nexrad::RadarVolume volume = nexrad::ReadLevel2(file);
    nexrad::ReasonCounts expected = nexrad::ClassifyEcho(volume).counts;
    expected[0] = 0;
    vtkNew<vtkNexradLevel2Reader> reader;
    reader->SetFileName(file.c_str());
    vtkNew<vtkNexradEchoClasses> classes;
    classes->SetInputConnection(reader->GetOutputPort());
    classes->Update();
    const nexrad::ReasonCounts found = CountReasons(classes->GetOutput());
    std::size_t other = 0;
    for (std::size_t reason = 0; reason < found.size(); ++reason)
    {
      other +=
        std::max(found[reason], expected[reason]) - std::min(found[reason], expected[reason]);
    }
    EXPECT_AT_MOST(other, 20, "gates of another reason by the sweeps' rounded values",
      "of a million; it depends on which gates are at a limit");
  }
}

TEST(EchoClassesFilter, AGateWithAValueHasTheClassOfItsReason)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  const std::filesystem::path file = data / "level2/quality/KMLB19980707_220118.gz";
  vtkNew<vtkNexradLevel2Reader> reader;
  reader->SetFileName(file.c_str());
  vtkNew<vtkNexradEchoClasses> classes;
  classes->SetInputConnection(reader->GetOutputPort());
  classes->Update();
  std::array<std::size_t, nexrad::EchoClassCount> found{};
  VisitGrids(classes->GetOutput(),
    [&](vtkStructuredGrid* grid)
    {
      vtkDataArray* values = grid->GetPointData()->GetArray("REF");
      auto* kinds = BytesOf(grid, "REF_class");
      auto* reasons = BytesOf(grid, "REF_reason");
      for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
      {
        const int kind = kinds->GetValue(i);
        ASSERT_EQ(std::isnan(values->GetTuple1(i)), kind == 0) << i;
        ASSERT_EQ(kind, vtkNexradEchoClasses::GetClassOfReason(reasons->GetValue(i)));
        ++found.at(static_cast<std::size_t>(kind));
      }
      const int* dimensions = grid->GetDimensions();
      const vtkIdType rays = grid->GetFieldData()->GetArray("RayTime")->GetNumberOfTuples();
      for (vtkIdType gate = 0; dimensions[1] > rays && gate < dimensions[0]; ++gate)
      {
        ASSERT_EQ(kinds->GetValue(gate), kinds->GetValue(rays * dimensions[0] + gate));
      }
    });
  EXPECT_AT_LEAST(found[static_cast<std::size_t>(EchoClass::Weather)], 200'000, "gates of weather");
  EXPECT_AT_LEAST(found[static_cast<std::size_t>(EchoClass::Ground)], 2'000, "gates of ground");
  reader->Update();
  VisitGrids(reader->GetOutput(), [](vtkStructuredGrid* grid)
    { EXPECT_FALSE(grid->GetPointData()->HasArray("REF_class")) << "the input's own grid"; });
}

TEST(EchoClassesFilter, NamesAreInTheFieldData)
{
  EXPECT_STREQ(vtkNexradEchoClasses::GetEchoClassName(2), "ground");
  EXPECT_STREQ(vtkNexradEchoClasses::GetEchoReasonName(5), "ground texture");
  EXPECT_EQ(vtkNexradEchoClasses::GetEchoClassName(7), nullptr);
  EXPECT_EQ(vtkNexradEchoClasses::GetEchoReasonName(-1), nullptr);
  EXPECT_EQ(vtkNexradEchoClasses::GetClassOfReason(15), -1);
  for (int level = -1; level <= 3; ++level)
  {
    EXPECT_EQ(vtkNexradEchoClasses::IsTakenOut(level, 2), level == 1 || level == 2) << level;
    EXPECT_EQ(vtkNexradEchoClasses::IsTakenOut(level, 3), level == 2) << level;
    EXPECT_FALSE(vtkNexradEchoClasses::IsTakenOut(level, 1)) << level;
    EXPECT_FALSE(vtkNexradEchoClasses::IsTakenOut(level, 7)) << level;
  }
  const nexrad::testing::TemporaryFolder folder;
  const nexrad::Site site = {"KEAX", nexrad::Position{38.81, -94.264, 333.0}};
  const auto path = nexrad::testing::WriteLevel2(folder.Path() / "one",
    {nexrad::testing::ConstantVolume(site, *nexrad::ParseIso8601("2006-03-12T18:00:00Z"), 30.0)});
  vtkNew<vtkNexradLevel2Reader> reader;
  reader->SetFileName(path.c_str());
  vtkNew<vtkNexradEchoClasses> classes;
  classes->SetInputConnection(reader->GetOutputPort());
  classes->Update();
  std::size_t grids = 0;
  VisitGrids(classes->GetOutput(),
    [&](vtkStructuredGrid* grid)
    {
      ++grids;
      auto* names =
        vtkStringArray::SafeDownCast(grid->GetFieldData()->GetAbstractArray("EchoReasonNames"));
      ASSERT_NE(names, nullptr);
      EXPECT_EQ(names->GetNumberOfValues(), vtkNexradEchoClasses::GetNumberOfEchoReasons());
      // All gates hold one value, as a fault of the receiver gives.
      EXPECT_EQ(names->GetValue(BytesOf(grid, "REF_reason")->GetValue(0)), "constant value");
    });
  EXPECT_GT(grids, 0U);
}

TEST(EchoClassesFilter, SweepsWithoutTheirFieldDataAreAnError)
{
  const nexrad::testing::TemporaryFolder folder;
  const nexrad::Site site = {"KEAX", nexrad::Position{38.81, -94.264, 333.0}};
  const auto path = nexrad::testing::WriteLevel2(folder.Path() / "one",
    {nexrad::testing::ConstantVolume(site, *nexrad::ParseIso8601("2006-03-12T18:00:00Z"), 30.0)});
  vtkNew<vtkNexradLevel2Reader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  vtkNew<vtkPartitionedDataSetCollection> stripped;
  stripped->DeepCopy(reader->GetOutput());
  stripped->GetPartitionedDataSet(0)->GetPartition(0)->GetFieldData()->RemoveArray("RayTime");
  vtkNew<vtkNexradEchoClasses> classes;
  vtkNew<EventCounter> events;
  events->Observe(classes);
  events->Observe(classes->GetExecutive());
  vtkNew<vtkTrivialProducer> source;
  source->SetOutput(stripped);
  classes->SetInputConnection(source->GetOutputPort());
  classes->Update();
  EXPECT_EQ(classes->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::UserError));
  EXPECT_TRUE(nexrad::testing::AnyHolds(events->errors, "RayTime"));
}
