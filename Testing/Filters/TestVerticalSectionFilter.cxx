// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNexradVerticalSection.h"

#include "EventCounter.h"
#include "vtkNexradImageConversion.h"

#include "nexrad/Grid/GriddedVolume.h"

#include "vtkErrorCode.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace nexrad;
using nexrad::testing::EventCounter;

namespace
{

// Four voxels of 1 km in a row, two levels of 500 m. At each level: 10, 20, 30 dBZ, no echo; in the
// upper level 40 dBZ more.
GriddedVolume Row()
{
  GriddedVolume volume;
  volume.grid.dimensions = {4, 1, 2};
  volume.grid.origin = {500.0, 0.0, 250.0};
  volume.grid.spacing = {1'000.0, 1'000.0, 500.0};
  volume.values = {10.0F, 20.0F, 30.0F, -33.0F, 50.0F, 60.0F, 70.0F, -33.0F};
  volume.states.assign(8, VoxelState::Echo);
  volume.states[3] = volume.states[7] = VoxelState::NoEcho;
  return volume;
}

class VerticalSectionFilter : public ::testing::Test
{
protected:
  VerticalSectionFilter()
  {
    vtkNexradVolumeToImage(Row(), image);
    filter->SetInputData(image);
    filter->SetA(0.0, 0.0);
    filter->SetB(4'000.0, 0.0);
    filter->SetSamplesAlong(8);
    filter->SetSamplesUpward(2);
    events->Observe(filter);
  }

  std::vector<float> Values()
  {
    auto* scalars = vtkFloatArray::SafeDownCast(filter->GetOutput()->GetPointData()->GetScalars());
    return {scalars->GetPointer(0), scalars->GetPointer(0) + scalars->GetNumberOfTuples()};
  }

  // The same volume as the codes of a file: the code is the place in the table.
  void UseCodes()
  {
    const GriddedVolume volume = Row();
    vtkNew<vtkUnsignedCharArray> codes;
    codes->SetName("REF");
    vtkNew<vtkFloatArray> values;
    values->SetName("REF_code_values");
    values->SetNumberOfTuples(256);
    values->Fill(0.0);
    vtkNew<vtkUnsignedCharArray> states;
    states->SetName("REF_code_states");
    states->SetNumberOfTuples(256);
    states->Fill(1.0);
    for (unsigned char code = 0; code < 8; ++code)
    {
      codes->InsertNextValue(code);
      values->SetValue(code, volume.values[code]);
      states->SetValue(code, static_cast<unsigned char>(volume.states[code]));
    }
    image->GetPointData()->Initialize();
    image->GetPointData()->SetScalars(codes);
    image->GetFieldData()->AddArray(values);
    image->GetFieldData()->AddArray(states);
  }

  vtkNew<vtkImageData> image;
  vtkNew<vtkNexradVerticalSection> filter;
  vtkNew<EventCounter> events;
};

TEST_F(VerticalSectionFilter, IsAnImageOfDistanceAndHeight)
{
  filter->Update();
  vtkImageData* section = filter->GetOutput();
  EXPECT_EQ(section->GetDimensions()[0], 8);
  EXPECT_EQ(section->GetDimensions()[1], 2);
  EXPECT_EQ(section->GetDimensions()[2], 1);
  EXPECT_EQ(section->GetSpacing()[0], 500.0);
  EXPECT_EQ(section->GetSpacing()[1], 500.0);
  EXPECT_EQ(section->GetOrigin()[0], 250.0);
  EXPECT_EQ(section->GetOrigin()[1], 250.0);
  EXPECT_STREQ(section->GetPointData()->GetScalars()->GetName(), "REF");
  EXPECT_TRUE(section->GetFieldData()->HasArray("TimeValue"));
  const std::vector<float> values = this->Values();
  const std::vector<float> lower = {10.0F, 12.5F, 17.5F, 22.5F, 27.5F, 30.0F};
  for (std::size_t i = 0; i < 6; ++i)
  {
    EXPECT_FLOAT_EQ(values[i], lower[i]) << i;
    EXPECT_FLOAT_EQ(values[8 + i], lower[i] + 40.0F) << i;
  }
  EXPECT_TRUE(std::isnan(values[6]));
  EXPECT_TRUE(std::isnan(values[7]));
  EXPECT_EQ(section->GetPointData()->GetArray("REF_state")->GetTuple1(7), 1.0);
}

TEST_F(VerticalSectionFilter, CodesGiveTheSectionOfTheirValues)
{
  filter->Update();
  const std::vector<float> ofValues = this->Values();
  this->UseCodes();
  image->Modified();
  filter->Update();
  const std::vector<float> ofCodes = this->Values();
  for (std::size_t i = 0; i < ofValues.size(); ++i)
  {
    EXPECT_TRUE(ofCodes[i] == ofValues[i] || (std::isnan(ofCodes[i]) && std::isnan(ofValues[i])));
  }
}

TEST_F(VerticalSectionFilter, ALineOfNoLengthIsAnError)
{
  filter->SetB(0.0, 0.0);
  filter->Update();
  EXPECT_EQ(filter->GetErrorCode(), vtkErrorCode::UserError);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
}

TEST_F(VerticalSectionFilter, AnImageWithoutStatesIsAnError)
{
  image->GetPointData()->RemoveArray("REF_state");
  filter->Update();
  EXPECT_EQ(filter->GetErrorCode(), vtkErrorCode::UserError);
}

} // namespace
