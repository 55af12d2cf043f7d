// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNexradHistogram.h"

#include "EventCounter.h"
#include "nexrad/Grid/GriddedVolume.h"
#include "vtkNexradImageConversion.h"

#include "vtkErrorCode.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkTable.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <map>

namespace
{

using nexrad::GriddedVolume;
using nexrad::VoxelState;
using nexrad::testing::AnyHolds;
using nexrad::testing::EventCounter;

class Histogram : public ::testing::Test
{
protected:
  Histogram() { events->Observe(filter); }

  /// Eight voxels of REF, five with echo.
  void UseValues()
  {
    GriddedVolume volume;
    volume.grid.dimensions = {2, 2, 2};
    const auto echo = VoxelState::Echo;
    volume.states = {VoxelState::NotScanned, VoxelState::NoEcho, VoxelState::RangeFolded, echo,
      echo, echo, echo, echo};
    volume.values = {-33.0F, -33.0F, -33.0F, -0.5F, 10.0F, 10.4F, 10.9F, 12.0F};
    vtkNexradVolumeToImage(volume, image);
    filter->SetInputData(image);
  }

  /// Codes 2, 3, 4 … for -32, -31.5, -31 … dBZ; 0 and 1 are no echo and not scanned.
  void UseCodes(const std::vector<unsigned char>& codes)
  {
    image->SetDimensions(static_cast<int>(codes.size()), 1, 1);
    vtkNew<vtkUnsignedCharArray> scalars;
    scalars->SetName("REF");
    vtkNew<vtkFloatArray> values;
    values->SetName("REF_code_values");
    vtkNew<vtkUnsignedCharArray> states;
    states->SetName("REF_code_states");
    for (const unsigned char code : codes)
    {
      scalars->InsertNextValue(code);
    }
    for (int code = 0; code < 256; ++code)
    {
      values->InsertNextValue(code < 2 ? -33.0F : -33.0F + 0.5F * static_cast<float>(code));
      states->InsertNextValue(code == 0 ? 1 : code == 1 ? 3 : 0);
    }
    image->GetPointData()->SetScalars(scalars);
    image->GetFieldData()->AddArray(values);
    image->GetFieldData()->AddArray(states);
    filter->SetInputData(image);
  }

  /// Voxels by the middles of the bins that have any.
  std::map<double, double> Bins()
  {
    filter->Update();
    std::map<double, double> bins;
    vtkTable* table = filter->GetOutput();
    for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
    {
      const double voxels = table->GetValueByName(row, "voxels").ToDouble();
      if (voxels != 0.0)
      {
        bins[table->GetValueByName(row, "value").ToDouble()] = voxels;
      }
    }
    return bins;
  }

  vtkNew<vtkImageData> image;
  vtkNew<vtkNexradHistogram> filter;
  vtkNew<EventCounter> events;
};

} // namespace

TEST_F(Histogram, CountsEchoInBinsOfOneDecibel)
{
  this->UseValues();
  EXPECT_EQ(this->Bins(), (std::map<double, double>{{-0.5, 1}, {10.5, 3}, {12.5, 1}}));
  EXPECT_EQ(filter->GetOutput()->GetNumberOfRows(), 14) << "from the least to the greatest";
}

TEST_F(Histogram, BinsAreAsWideAsAsked)
{
  this->UseValues();
  filter->SetBinWidth(5.0);
  EXPECT_EQ(this->Bins(), (std::map<double, double>{{-2.5, 1}, {12.5, 4}}));
  filter->SetBinWidth(0.001);
  filter->Update();
  EXPECT_EQ(filter->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::UserError));
  EXPECT_TRUE(AnyHolds(events->errors, "4096"));
}

TEST_F(Histogram, EverySecondVoxelCountsTwice)
{
  this->UseValues();
  filter->SetMaximumNumberOfVoxels(4);
  EXPECT_EQ(this->Bins(), (std::map<double, double>{{10.5, 4}}));
}

// Of code 43, -11.5 dBZ, half lies below -11.5 and half above: -11.75 to -11.25.
TEST_F(Histogram, CodesAreSpreadOverTheValuesThatTheyStandFor)
{
  this->UseCodes({0, 1, 43, 43, 44, 44});
  filter->SetBinWidth(0.5);
  EXPECT_EQ(this->Bins(), (std::map<double, double>{{-11.75, 1}, {-11.25, 2}, {-10.75, 1}}));
  filter->SetBinWidth(0.0);
  EXPECT_EQ(this->Bins(), (std::map<double, double>{{-11.5, 3}, {-10.5, 1}}));
}

TEST_F(Histogram, NothingToCountGivesNoRows)
{
  this->UseCodes({0, 1});
  EXPECT_TRUE(this->Bins().empty());
  EXPECT_EQ(filter->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::NoError));
}

TEST_F(Histogram, AnArrayThatIsNotThereIsAnError)
{
  this->UseValues();
  filter->SetArrayName("VEL");
  filter->Update();
  EXPECT_TRUE(AnyHolds(events->errors, "no point array VEL"));
}
