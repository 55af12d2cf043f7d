// SPDX-License-Identifier: BSD-3-Clause
#include "EventCounter.h"
#include "HandMadeVolume.h"
#include "SweepAccess.h"
#include "TestData.h"
#include "Tolerance.h"

#include "vtkNexradLevel2Reader.h"

#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{

using nexrad::MomentName;
using nexrad::testing::EventCounter;
using nexrad::testing::GridOf;
using nexrad::testing::HandMadeSweep;
using nexrad::testing::HandMadeVolume;

/// Writes one sweep to a file and reads it.
class SweepGrids : public ::testing::Test
{
protected:
  vtkPartitionedDataSetCollection* Read(const HandMadeSweep& sweep)
  {
    HandMadeVolume volume;
    volume.start = *nexrad::ParseIso8601("2006-03-12T18:00:00Z");
    volume.sweeps = {sweep};
    const auto path = nexrad::testing::WriteLevel2(folder.Path() / "file", {volume});
    events->Observe(reader);
    reader->SetFileName(path.c_str());
    reader->Update();
    EXPECT_TRUE(events->errors.empty());
    return reader->GetOutput();
  }

  static unsigned char State(vtkStructuredGrid* grid, const char* name, vtkIdType point)
  {
    auto* states = vtkUnsignedCharArray::SafeDownCast(
      grid->GetPointData()->GetArray((std::string(name) + "_state").c_str()));
    return states->GetValue(point);
  }

  static float Value(vtkStructuredGrid* grid, const char* name, vtkIdType point)
  {
    return vtkFloatArray::SafeDownCast(grid->GetPointData()->GetArray(name))->GetValue(point);
  }

  const nexrad::testing::TemporaryFolder folder;
  vtkNew<vtkNexradLevel2Reader> reader;
  vtkNew<EventCounter> events;
};

std::uint8_t GateWord(int, int gate)
{
  return static_cast<std::uint8_t>(gate);
}

TEST_F(SweepGrids, MomentsOfOneGeometryShareAGridAndOthersHaveTheirOwn)
{
  HandMadeSweep sweep;
  sweep.moments = {{MomentName::REF, 6, 1000, 1000, GateWord},
    {MomentName::VEL, 12, 500, 250, GateWord}, {MomentName::ZDR, 4, 1000, 1000, GateWord}};
  vtkPartitionedDataSetCollection* sweeps = this->Read(sweep);
  ASSERT_EQ(sweeps->GetPartitionedDataSet(0)->GetNumberOfPartitions(), 2U);
  vtkStructuredGrid* coarse = GridOf(sweeps, 0, 0);
  vtkStructuredGrid* fine = GridOf(sweeps, 0, 1);
  EXPECT_EQ(coarse->GetDimensions()[0], 6);
  EXPECT_EQ(fine->GetDimensions()[0], 12);
  EXPECT_NE(coarse->GetPointData()->GetArray("ZDR"), nullptr);
  EXPECT_EQ(coarse->GetPointData()->GetArray("VEL"), nullptr);
  EXPECT_NE(fine->GetPointData()->GetArray("VEL"), nullptr);
  EXPECT_EQ(fine->GetFieldData()->GetArray("GateGeometry")->GetComponent(0, 0), 500.0);
  EXPECT_EQ(fine->GetFieldData()->GetArray("GateGeometry")->GetComponent(0, 1), 250.0);
  EXPECT_STREQ(coarse->GetPointData()->GetScalars()->GetName(), "REF");

  // Words 0, 1, 2, …: below threshold, range folded, then (word − 66) / 2.
  EXPECT_EQ(State(coarse, "REF", 0), 1);
  EXPECT_EQ(State(coarse, "REF", 1), 2);
  EXPECT_EQ(State(coarse, "REF", 2), 0);
  EXPECT_TRUE(std::isnan(Value(coarse, "REF", 0)));
  EXPECT_TRUE(std::isnan(Value(coarse, "REF", 1)));
  EXPECT_EQ(Value(coarse, "REF", 5), -30.5F);
  // The shorter moment is padded.
  EXPECT_EQ(Value(coarse, "ZDR", 3), -31.5F);
  EXPECT_EQ(State(coarse, "ZDR", 4), 3);
  EXPECT_TRUE(std::isnan(Value(coarse, "ZDR", 5)));
}

TEST_F(SweepGrids, GatesAtNegativeRangeAreLeftOut)
{
  HandMadeSweep sweep;
  sweep.moments = {{MomentName::VEL, 10, -375, 250, GateWord}};
  vtkStructuredGrid* grid = GridOf(this->Read(sweep), 0);
  // −375 and −125 go; the first that stays is at 125 m, and keeps its word, 2.
  EXPECT_EQ(grid->GetDimensions()[0], 8);
  EXPECT_EQ(grid->GetFieldData()->GetArray("GateGeometry")->GetComponent(0, 0), 125.0);
  EXPECT_EQ(State(grid, "VEL", 0), 0);
  EXPECT_EQ(Value(grid, "VEL", 0), -32.0F);
  double point[3];
  grid->GetPoint(0, point);
  EXPECT_WITHIN(std::hypot(point[0], point[1]), 125.0, 0.009, "range of the first gate, m");
}

TEST_F(SweepGrids, TheFirstRayIsRepeatedAllTheWayRound)
{
  HandMadeSweep sweep;
  sweep.rays = 90;
  const auto byRay = [](int ray, int) { return static_cast<std::uint8_t>(ray + 2); };
  sweep.moments = {{MomentName::REF, 3, 1000, 1000, byRay}};
  vtkStructuredGrid* grid = GridOf(this->Read(sweep), 0);
  ASSERT_EQ(grid->GetDimensions()[1], 91);
  EXPECT_EQ(Value(grid, "REF", 90 * 3), Value(grid, "REF", 0));
  EXPECT_NE(Value(grid, "REF", 89 * 3), Value(grid, "REF", 0));
  EXPECT_EQ(grid->GetFieldData()->GetArray("RayAzimuth")->GetNumberOfTuples(), 90);
}

TEST_F(SweepGrids, ASectorIsNotClosed)
{
  HandMadeSweep sweep;
  sweep.rays = 90;
  sweep.turn = 350.0; // the gap is 13.9 degrees, the step 3.9
  sweep.moments = {{MomentName::REF, 3, 1000, 1000, GateWord}};
  EXPECT_EQ(GridOf(this->Read(sweep), 0)->GetDimensions()[1], 90);
}

TEST_F(SweepGrids, RaysStayInTheOrderScanned)
{
  HandMadeSweep sweep;
  sweep.rays = 36;
  sweep.firstAzimuth = 300.0;
  sweep.moments = {{MomentName::REF, 3, 1000, 1000, GateWord}};
  vtkFieldData* field = GridOf(this->Read(sweep), 0)->GetFieldData();
  EXPECT_NEAR(field->GetArray("RayAzimuth")->GetComponent(0, 0), 300.0, 1e-6);
  EXPECT_NEAR(field->GetArray("RayAzimuth")->GetComponent(6, 0), 0.0, 1e-6);
  EXPECT_NEAR(field->GetArray("RayTime")->GetComponent(35, 0) -
                field->GetArray("RayTime")->GetComponent(0, 0),
    0.7, 1e-6);
}

} // namespace
