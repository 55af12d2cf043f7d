// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNexradTwoFields.h"

#include "EventCounter.h"
#include "nexrad/Grid/GriddedVolume.h"
#include "vtkNexradImageConversion.h"

#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkErrorCode.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <gtest/gtest.h>

#include <limits>

namespace
{

using nexrad::GriddedVolume;
using nexrad::MomentName;
using nexrad::VoxelState;
using nexrad::testing::AnyHolds;
using nexrad::testing::EventCounter;

/// Eight voxels of REF and VEL. REF: two not scanned, one without echo, the others echo. VEL:
/// values in two of these, range folded in one, none in the rest.
class TwoFields : public ::testing::Test
{
protected:
  TwoFields()
  {
    GriddedVolume reflectivity;
    reflectivity.grid.dimensions = {2, 2, 2};
    reflectivity.sites = {"KEAX"};
    GriddedVolume velocity = reflectivity;
    velocity.moment = MomentName::VEL;
    const auto echo = VoxelState::Echo;
    const auto none = VoxelState::NoEcho;
    const auto unseen = VoxelState::NotScanned;
    const auto folded = VoxelState::RangeFolded;
    reflectivity.states = {unseen, unseen, none, echo, echo, echo, echo, echo};
    reflectivity.values = {-33.0F, -33.0F, -33.0F, 10.0F, 20.0F, 30.0F, 40.0F, 50.0F};
    reflectivity.ancillary.age = {0.0F, 0.0F, 5.0F, 10.0F, 20.0F, 30.0F, 40.0F, 50.0F};
    reflectivity.ancillary.radars = {0, 0, 1, 0, 1, 1, 1, 1}; // the fourth was filled
    velocity.states = {unseen, unseen, none, none, unseen, folded, echo, echo};
    velocity.values = {-33.0F, -33.0F, -33.0F, -33.0F, -33.0F, -33.0F, -12.0F, 7.0F};
    vtkNexradVolumeToImage(nexrad::JoinMoments({reflectivity, velocity}), image);
    filter->SetInputData(image);
    events->Observe(filter);
  }

  std::vector<float> Component(int component)
  {
    vtkDataArray* scalars = filter->GetOutput()->GetPointData()->GetScalars();
    std::vector<float> values;
    for (vtkIdType i = 0; i < scalars->GetNumberOfTuples(); ++i)
    {
      values.push_back(static_cast<float>(scalars->GetComponent(i, component)));
    }
    return values;
  }

  std::vector<bool> Hidden()
  {
    vtkDataArray* ghosts = filter->GetOutput()->GetPointData()->GetArray("vtkGhostType");
    std::vector<bool> hidden;
    for (vtkIdType i = 0; i < ghosts->GetNumberOfTuples(); ++i)
    {
      hidden.push_back(ghosts->GetComponent(i, 0) == vtkDataSetAttributes::HIDDENPOINT);
    }
    return hidden;
  }

  vtkNew<vtkImageData> image;
  vtkNew<vtkNexradTwoFields> filter;
  vtkNew<EventCounter> events;
};

TEST_F(TwoFields, ColourAndOpacityStandBesideEachOther)
{
  filter->SetColorArrayName("VEL");
  filter->Update();
  // 16 × 128 m/s below −64 m/s.
  const float missing = -2112.0F;
  EXPECT_EQ(this->Component(0),
    (std::vector<float>{missing, missing, missing, missing, missing, missing, -12.0F, 7.0F}));
  EXPECT_EQ(this->Component(1),
    (std::vector<float>{-33.0F, -33.0F, -33.0F, 10.0F, 20.0F, 30.0F, 40.0F, 50.0F}));
  EXPECT_EQ(
    this->Hidden(), (std::vector<bool>{true, true, false, false, false, false, false, false}));
  EXPECT_EQ(filter->GetUsedMissingValue(), -2112.0);
  EXPECT_EQ(filter->GetNumberOfMissingValues(), 4); // of those that are not hidden
  vtkDataArray* scalars = filter->GetOutput()->GetPointData()->GetScalars();
  EXPECT_STREQ(scalars->GetName(), "ColorAndOpacity");
  EXPECT_STREQ(scalars->GetComponentName(0), "VEL");
  EXPECT_STREQ(scalars->GetComponentName(1), "REF");
  // The input is as it was, and its arrays are in the output.
  EXPECT_STREQ(image->GetPointData()->GetScalars()->GetName(), "REF");
  EXPECT_TRUE(filter->GetOutput()->GetPointData()->HasArray("VEL_state"));
}

TEST_F(TwoFields, TheArrayOfTheOpacitiesSaysWhatIsHidden)
{
  filter->SetColorArrayName("REF");
  filter->SetOpacityArrayName("VEL");
  filter->Update();
  EXPECT_EQ(this->Hidden(), (std::vector<bool>{true, true, true, true, true, true, false, false}));
  EXPECT_EQ(this->Component(0)[6], 40.0F);
  EXPECT_EQ(this->Component(1)[6], -12.0F);
  EXPECT_EQ(filter->GetNumberOfMissingValues(), 0);
}

TEST_F(TwoFields, AnAgeIsMissingWhereNoRadarScanned)
{
  filter->SetColorArrayName("REF_age");
  filter->SetMissingValue(-1.0);
  filter->UseMissingValueOn();
  filter->Update();
  EXPECT_EQ(this->Component(0),
    (std::vector<float>{-1.0F, -1.0F, 5.0F, -1.0F, 20.0F, 30.0F, 40.0F, 50.0F}));
  EXPECT_EQ(filter->GetNumberOfMissingValues(), 1);
}

TEST_F(TwoFields, AnyArrayMayGiveTheColours)
{
  vtkNew<vtkFloatArray> shear;
  shear->SetName("shear");
  for (const float value :
    {1.0F, 2.0F, 3.0F, 4.0F, 5.0F, std::numeric_limits<float>::quiet_NaN(), 6.0F, 11.0F})
  {
    shear->InsertNextValue(value);
  }
  image->GetPointData()->AddArray(shear);
  filter->SetColorArrayName("shear");
  filter->Update();
  EXPECT_EQ(this->Component(0)[4], 5.0F);
  EXPECT_EQ(this->Component(0)[5], 1.0F - 16.0F * 10.0F);
  double range[2];
  EXPECT_FALSE(vtkNexradTwoFields::GetUsualRange("shear", range));
  EXPECT_TRUE(vtkNexradTwoFields::GetUsualRange("VEL_age", range));
}

TEST_F(TwoFields, AnArrayThatIsNotThereIsRefusedByName)
{
  filter->SetColorArrayName("SW");
  filter->Update();
  EXPECT_EQ(filter->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::UserError));
  EXPECT_TRUE(AnyHolds(events->errors, "no point array SW"));
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
}

} // namespace
