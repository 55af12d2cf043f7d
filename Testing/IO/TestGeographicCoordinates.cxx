// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNexradGeographicCoordinates.h"
#include "vtkNexradMoments.h"

#include "nexrad/Grid/GriddedVolume.h"
#include "vtkNexradImageConversion.h"

#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"

#include <gtest/gtest.h>

#include <string>

namespace
{

using Coordinates = vtkNexradGeographicCoordinates;

class GeographicCoordinates : public ::testing::Test
{
protected:
  void MakeImage(double latitude, double longitude)
  {
    nexrad::GriddedVolume volume;
    volume.grid.dimensions = {1, 1, 1};
    volume.grid.centreLatitude = latitude;
    volume.grid.centreLongitude = longitude;
    volume.values = {0.0F};
    volume.states = {nexrad::VoxelState::NoEcho};
    vtkNexradVolumeToImage(volume, image);
  }

  void AddPair(double x, double y)
  {
    const double pair[2] = {x, y};
    from->SetNumberOfComponents(2);
    from->InsertNextTypedTuple(pair);
  }

  vtkNew<vtkImageData> image;
  vtkNew<vtkDoubleArray> from, to;
};

// About a point of the equator the equator is a circle of the semi-major axis of WGS84, and the
// pole lies a quarter of the meridian away: 10 001 965.729 m.
TEST_F(GeographicCoordinates, EquatorAndPole)
{
  MakeImage(0.0, 100.0);
  AddPair(0.0, 0.0);
  AddPair(6'378'137.0 * 3.14159265358979 / 180.0, 0.0);
  AddPair(0.0, 10'001'965.729);
  ASSERT_TRUE(Coordinates::ToGeographic(image, from, to));
  ASSERT_EQ(to->GetNumberOfTuples(), 3);
  EXPECT_NEAR(to->GetTypedComponent(0, 0), 100.0, 1e-12);
  EXPECT_NEAR(to->GetTypedComponent(0, 1), 0.0, 1e-12);
  EXPECT_NEAR(to->GetTypedComponent(1, 0), 101.0, 1e-9);
  EXPECT_NEAR(to->GetTypedComponent(1, 1), 0.0, 1e-9);
  EXPECT_NEAR(to->GetTypedComponent(2, 1), 90.0, 1e-7);
}

TEST_F(GeographicCoordinates, ThereAndBack)
{
  MakeImage(42.19, -75.98);
  for (int i = 0; i < 10'000; ++i) // more than one stretch of threads
  {
    AddPair(-230e3 + 46.0 * i, 230e3 - 23.0 * i);
  }
  vtkNew<vtkDoubleArray> again;
  ASSERT_TRUE(Coordinates::ToGeographic(image, from, to));
  ASSERT_TRUE(Coordinates::FromGeographic(image, to, again));
  for (vtkIdType i = 0; i < 20'000; ++i)
  {
    ASSERT_NEAR(again->GetValue(i), from->GetValue(i), 1e-6) << i;
  }
}

TEST_F(GeographicCoordinates, AnotherNumberOfComponentsIsRefused)
{
  MakeImage(42.0, -75.0);
  from->InsertNextValue(1.0);
  to->InsertNextValue(1.0);
  EXPECT_FALSE(Coordinates::ToGeographic(image, from, to));
  EXPECT_EQ(to->GetNumberOfTuples(), 0);
  EXPECT_FALSE(Coordinates::ToGeographic(nullptr, from, to));
  EXPECT_FALSE(Coordinates::FromGeographic(image, nullptr, to));
  EXPECT_FALSE(Coordinates::FromGeographic(image, from, nullptr));
}

TEST(Moments, NamesUnitsAndTitles)
{
  EXPECT_EQ(vtkNexradMoments::GetNumberOfMoments(), 11);
  EXPECT_STREQ(vtkNexradMoments::GetMomentName(0), "REF");
  EXPECT_STREQ(vtkNexradMoments::GetMomentName(10), "KDP");
  EXPECT_EQ(vtkNexradMoments::GetMomentName(11), nullptr);
  EXPECT_EQ(vtkNexradMoments::GetMomentName(-1), nullptr);
  EXPECT_STREQ(vtkNexradMoments::GetUnit("VEL"), "m/s");
  EXPECT_STREQ(vtkNexradMoments::GetUnit("RHO"), "");
  EXPECT_STREQ(vtkNexradMoments::GetTitle("AZSHEAR"), "Azimuthal shear");
  EXPECT_EQ(vtkNexradMoments::GetUnit("REF_age"), nullptr);
  EXPECT_EQ(vtkNexradMoments::GetTitle(nullptr), nullptr);
  EXPECT_TRUE(vtkNexradMoments::HasTwoSigns("DIV"));
  EXPECT_FALSE(vtkNexradMoments::HasTwoSigns("ZDR"));
  EXPECT_FALSE(vtkNexradMoments::HasTwoSigns("V"));
}

} // namespace
