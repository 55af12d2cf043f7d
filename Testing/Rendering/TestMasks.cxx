// SPDX-License-Identifier: BSD-3-Clause
// Masks and two-dimensional transfer functions beside VTK's GPU ray caster.
#include "RayCasterComparison.h"
#include "Scenes.h"
#include "Tolerance.h"

#include "vtkColorTransferFunction.h"
#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace
{

using namespace nexrad::testing;

class Masks : public StormAgainstRayCaster
{
protected:
  void SetUp() override
  {
    StormAgainstRayCaster::SetUp();
    if (this->Stage != nullptr)
    {
      // VTK 9.1 does not correct the opacity of labels and of two-dimensional functions for the
      // distance between samples: it is right there only if that is the unit distance.
      this->Stage->GetProperty()->SetScalarOpacityUnitDistance(this->SampleDistance);
      this->UseOpacity(0.15);
    }
  }
  void UseOpacity(double most)
  {
    vtkNew<vtkPiecewiseFunction> opacity;
    opacity->AddPoint(5.0, 0.0);
    opacity->AddPoint(60.0, most);
    this->Stage->GetProperty()->SetScalarOpacity(opacity);
  }

  /// West of the middle label 0, then 1, and 2 in the north-east.
  vtkSmartPointer<vtkImageData> MakeMask(
    unsigned char west, unsigned char east, unsigned char north)
  {
    auto mask = vtkSmartPointer<vtkImageData>::New();
    mask->CopyStructure(this->Input);
    mask->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
    const int* n = mask->GetDimensions();
    auto* value = static_cast<unsigned char*>(mask->GetScalarPointer());
    for (int k = 0; k < n[2]; ++k)
    {
      for (int j = 0; j < n[1]; ++j)
      {
        for (int i = 0; i < n[0]; ++i)
        {
          *value++ = 2 * i < n[0] ? west : (2 * j < n[1] ? east : north);
        }
      }
    }
    return mask;
  }
  void UseMask(vtkImageData* mask, int type)
  {
    this->ForBoth(
      [&](vtkGPUVolumeRayCastMapper* mapper)
      {
        mapper->SetMaskInput(mask);
        mapper->SetMaskType(type);
      });
  }
  void UseLabels()
  {
    this->UseMask(this->MakeMask(0, 1, 2), vtkGPUVolumeRayCastMapper::LabelMapMaskType);
    for (const int label : {1, 2})
    {
      vtkNew<vtkColorTransferFunction> color;
      color->AddRGBPoint(5.0, label == 1 ? 0.3 : 0.0, 0.2, label == 1 ? 0.0 : 0.3);
      color->AddRGBPoint(60.0, label == 1 ? 1.0 : 0.1, 0.5, label == 1 ? 0.1 : 1.0);
      vtkNew<vtkPiecewiseFunction> opacity;
      opacity->AddPoint(5.0, 0.0);
      opacity->AddPoint(60.0, label == 1 ? 0.1 : 0.3);
      this->Stage->GetProperty()->SetLabelColor(label, color);
      this->Stage->GetProperty()->SetLabelScalarOpacity(label, opacity);
    }
  }

  /// Red flat places, green slopes, the more opaque the stronger the echo.
  vtkSmartPointer<vtkImageData> MakeFunction2D()
  {
    auto table = vtkSmartPointer<vtkImageData>::New();
    table->SetDimensions(64, 32, 1);
    table->AllocateScalars(VTK_FLOAT, 4);
    auto* entry = static_cast<float*>(table->GetScalarPointer());
    for (int j = 0; j < 32; ++j)
    {
      for (int i = 0; i < 64; ++i, entry += 4)
      {
        const float slope = std::min(1.0f, float(j) / 14.0f);
        entry[0] = 1.0f - slope;
        entry[1] = slope;
        entry[2] = 0.3f;
        entry[3] = i < 30 ? 0.0f : 0.08f * float(i - 30) / 33.0f;
      }
    }
    return table;
  }
  /// An array of the points' heights beside the storm.
  void AddHeights(int components)
  {
    vtkNew<vtkFloatArray> heights;
    heights->SetName("height");
    heights->SetNumberOfComponents(components);
    for (vtkIdType id = 0; id < this->Input->GetNumberOfPoints(); ++id)
    {
      for (int c = 0; c < components; ++c)
      {
        heights->InsertNextValue(static_cast<float>(this->Input->GetPoint(id)[2]));
      }
    }
    this->Input->GetPointData()->AddArray(heights);
  }
  void Use2D()
  {
    this->Stage->GetProperty()->SetTransferFunction2D(this->MakeFunction2D());
    this->Stage->GetProperty()->SetTransferFunctionMode(vtkVolumeProperty::TF_2D);
  }
};

} // namespace

// The eastern half of the storm, cut off straight.
TEST_F(Masks, Binary)
{
  this->UseMask(this->MakeMask(0, 255, 255), vtkGPUVolumeRayCastMapper::BinaryMaskType);
  this->ExpectSamePictureAndBaseline("mask-binary", "BinaryMask", 0.79);
}

// The same cut through a projection.
TEST_F(Masks, BinaryMaximum)
{
  this->UseMask(this->MakeMask(0, 255, 255), vtkGPUVolumeRayCastMapper::BinaryMaskType);
  this->ForBoth(
    [](vtkGPUVolumeRayCastMapper* mapper) { mapper->SetBlendModeToMaximumIntensity(); });
  this->UseOpacity(1.0);
  this->ExpectSamePicture("mask-binary-maximum", 0.48);
}

// The west in weather colours, the south-east orange, the north-east blue.
TEST_F(Masks, LabelMap)
{
  this->UseLabels();
  this->ExpectSamePicture("mask-labels", 0.51);
}

// The labels' colours shine through the weather colours, lit.
TEST_F(Masks, LabelMapBlendedAndShaded)
{
  this->UseLabels();
  this->Stage->GetProperty()->ShadeOn();
  this->ForBoth([](vtkGPUVolumeRayCastMapper* mapper) { mapper->SetMaskBlendFactor(0.4f); });
  this->ExpectSamePictureAndBaseline("mask-labels-blended", "LabelsBlended", 0.31);
}

// Labels have gradient opacities of their own: edges alone in the north-east.
TEST_F(Masks, LabelMapWithGradientOpacity)
{
  this->UseLabels();
  vtkNew<vtkPiecewiseFunction> everything;
  everything->AddPoint(0.0, 1.0);
  vtkNew<vtkPiecewiseFunction> edges;
  edges->AddPoint(0.0, 0.0);
  edges->AddPoint(20.0, 1.0);
  const Picture background = this->Stage->Draw(nullptr);
  const Picture filled = this->Stage->Draw(this->Configure(this->Slices));
  this->Stage->GetProperty()->SetGradientOpacity(everything);
  this->Stage->GetProperty()->SetLabelGradientOpacity(1, everything);
  this->Stage->GetProperty()->SetLabelGradientOpacity(2, edges);
  this->ExpectSamePicture("mask-labels-gradient", 0.47);
  const Picture hollow = this->Stage->Draw(this->Configure(this->Slices));
  EXPECT_AT_LEAST(Compare(hollow, filled, background).LargestMean(), 2.3,
    "mean change by the gradient opacity, of 255");
}

// Green where the echo changes fast, red where it is flat, above all in the layer near the ground.
TEST_F(Masks, Function2D)
{
  this->Use2D();
  this->ExpectSamePicture("function-2d", Bar);
}

// The same, lit.
TEST_F(Masks, Function2DShaded)
{
  this->Use2D();
  this->Stage->GetProperty()->ShadeOn();
  this->ExpectSamePictureAndBaseline("function-2d-shaded", "Function2DShaded", 1.2);
}

// The same functions over echo and height, in place of the slope: red below, green above.
TEST_F(Masks, Function2DOfASecondArray)
{
  this->Use2D();
  this->AddHeights(1);
  this->ForBoth(
    [](vtkGPUVolumeRayCastMapper* mapper) { mapper->SetTransfer2DYAxisArray("height"); });
  this->ExpectSamePictureAndBaseline("function-2d-array", "Function2DOfHeight", Bar);
  this->Stage->GetProperty()->SetInterpolationTypeToNearest();
  this->ExpectSamePicture("function-2d-array-nearest", Bar);
  this->Stage->GetProperty()->SetInterpolationTypeToLinear();
  this->Stage->GetProperty()->ShadeOn();
  this->ExpectSamePicture("function-2d-array-lit", 0.8);
}

// Where the second array has no number, its visible neighbours count.
TEST_F(Masks, SecondArrayWithGaps)
{
  this->Use2D();
  this->AddHeights(1);
  this->Slices->SetTransfer2DYAxisArray("height");
  const Picture background = this->Stage->Draw(nullptr);
  const Picture whole = this->Stage->Draw(this->Configure(this->Slices));
  vtkDataArray* scalars = this->Input->GetPointData()->GetScalars();
  vtkDataArray* heights = this->Input->GetPointData()->GetArray("height");
  for (vtkIdType id = 0; id < heights->GetNumberOfTuples(); ++id)
  {
    if (scalars->GetComponent(id, 0) < 12.0)
    {
      heights->SetComponent(id, 0, std::nan(""));
    }
  }
  heights->Modified();
  EXPECT_AT_MOST(Compare(this->Stage->Draw(this->Slices), whole, background).LargestMean(), 5.0,
    "mean change by gaps in weak echo, of 255");
}

TEST_F(Masks, BadSecondArraysAreRefusedOnce)
{
  this->AddHeights(5);
  this->Slices->SetTransfer2DYAxisArray("height");
  this->Stage->Draw(this->Configure(this->Slices)); // one-dimensional functions do not read it
  EXPECT_EQ(this->TakeMessages(), "");
  this->Use2D();
  for (const auto& [name, message] : {std::pair("height", "and 4 at most"),
         std::pair("width", "the volume has no array of the name")})
  {
    this->Slices->SetTransfer2DYAxisArray(name);
    EXPECT_FALSE(
      this->Slices->IsRenderSupported(this->Stage->GetWindow(), this->Stage->GetProperty()));
    this->Stage->Draw(this->Slices);
    EXPECT_NE(this->TakeMessages().find(message), std::string::npos);
    this->Stage->Draw(this->Slices);
    EXPECT_EQ(this->TakeMessages(), "");
  }
}

// The opacity of both is that of a unit distance, whatever the number of slices.
TEST_F(Masks, SliceCountKeepsThePicture)
{
  for (const bool labels : {false, true})
  {
    labels ? this->UseLabels() : this->Use2D();
    this->Slices->SetInputData(this->Input);
    const Picture background = this->Stage->Draw(nullptr);
    this->Slices->SetNumberOfSlices(256);
    const Picture reference = this->Stage->Draw(this->Slices);
    this->Slices->SetNumberOfSlices(512);
    const Difference difference = Compare(this->Stage->Draw(this->Slices), reference, background);
    EXPECT_GT(difference.Pixels, 1250);
    EXPECT_AT_MOST(difference.LargestMean(), 0.42, "mean difference to many slices, of 255")
      << (labels ? "labels" : "two dimensions");
    this->Stage->GetProperty()->SetTransferFunctionMode(vtkVolumeProperty::TF_1D);
  }
}

TEST_F(Masks, BadMasksAndFunctionsAreErrors)
{
  vtkNew<vtkImageData> small;
  small->SetDimensions(4, 4, 4);
  small->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  this->Slices->SetMaskInput(small);
  this->Stage->Draw(this->Configure(this->Slices));
  EXPECT_NE(this->TakeMessages().find("the mask must have the dimensions of the volume"),
    std::string::npos);
  this->Slices->SetMaskInput(nullptr);

  vtkNew<vtkImageData> gray;
  gray->SetDimensions(4, 4, 1);
  gray->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  this->Stage->GetProperty()->SetTransferFunction2D(gray);
  this->Stage->GetProperty()->SetTransferFunctionMode(vtkVolumeProperty::TF_2D);
  this->Stage->Draw(this->Slices);
  EXPECT_FALSE(this->TakeMessages().empty());

  this->Use2D();
  this->Slices->SetBlendModeToMaximumIntensity();
  EXPECT_FALSE(
    this->Slices->IsRenderSupported(this->Stage->GetWindow(), this->Stage->GetProperty()));
  this->Stage->Draw(this->Slices);
  EXPECT_NE(this->TakeMessages().find("in the composite blend mode alone"), std::string::npos);
}
