// SPDX-License-Identifier: BSD-3-Clause
// Two to four components beside VTK's GPU ray caster.
#include "RayCasterComparison.h"
#include "Scenes.h"
#include "Tolerance.h"

#include "vtkActor.h"
#include "vtkColorTransferFunction.h"
#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkPolyDataMapper.h"
#include "vtkRenderer.h"
#include "vtkSphereSource.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <array>

namespace
{

using namespace nexrad::testing;

class Components : public AgainstRayCaster
{
protected:
  void SetUp() override
  {
    AgainstRayCaster::SetUp();
    if (this->Stage != nullptr)
    {
      this->AimCamera(false);
    }
  }

  /// Component 0 is the storm (dBZ + 33, 0 to 100), the others are ramps along x, y and z, 0 to
  /// 200.
  void UseComponents(int count, int scalarType)
  {
    vtkSmartPointer<vtkImageData> storm = MakeStorm(48, VTK_UNSIGNED_CHAR);
    this->Input = vtkSmartPointer<vtkImageData>::New();
    this->Input->CopyStructure(storm);
    this->Input->AllocateScalars(scalarType, count);
    vtkDataArray* scalars = this->Input->GetPointData()->GetScalars();
    const int* dimensions = storm->GetDimensions();
    for (vtkIdType id = 0; id < scalars->GetNumberOfTuples(); ++id)
    {
      scalars->SetComponent(id, 0, storm->GetPointData()->GetScalars()->GetComponent(id, 0));
      vtkIdType rest = id;
      for (int c = 1; c < count; ++c)
      {
        scalars->SetComponent(
          id, c, 200.0 * double(rest % dimensions[c - 1]) / (dimensions[c - 1] - 1));
        rest /= dimensions[c - 1];
      }
    }
  }
  /// A component's functions: one colour, growing opaque between two scalars.
  void SetFunctions(
    int component, double red, double green, double blue, double from, double to, double opacity)
  {
    vtkNew<vtkColorTransferFunction> color;
    color->AddRGBPoint(from, red, green, blue);
    color->AddRGBPoint(to, 0.5 + 0.5 * red, 0.5 + 0.5 * green, blue);
    vtkNew<vtkPiecewiseFunction> alpha;
    alpha->AddPoint(from, 0.0);
    alpha->AddPoint(to, opacity);
    this->Stage->GetProperty()->SetColor(component, color);
    this->Stage->GetProperty()->SetScalarOpacity(component, alpha);
    this->Stage->GetProperty()->SetInterpolationTypeToLinear();
  }
  /// Bytes that are colours and opacity.
  void UseColours()
  {
    this->UseComponents(4, VTK_UNSIGNED_CHAR);
    // VTK 9.1 looks the opacity up as if the fourth component spanned all bytes.
    this->Input->GetPointData()->GetScalars()->SetComponent(0, 3, 0.0);
    this->Input->GetPointData()->GetScalars()->SetComponent(1, 3, 255.0);
    this->SetFunctions(0, 1.0, 1.0, 1.0, 0.0, 255.0, 0.1);
    this->Stage->GetProperty()->IndependentComponentsOff();
  }
  /// The second component alone, blue, above a part of the second array's range.
  void SetFunctions2D(double from)
  {
    for (const int c : {0, 1})
    {
      vtkNew<vtkImageData> table;
      table->SetDimensions(64, 256, 1);
      table->AllocateScalars(VTK_FLOAT, 4);
      auto* entry = static_cast<float*>(table->GetScalarPointer());
      for (int i = 0; i < 64 * 256; ++i, entry += 4)
      {
        const bool seen = c == 1 && i / 64 >= 256.0 * from;
        std::fill_n(entry, 3, 0.3f);
        entry[2] = 1.0f;
        entry[3] = seen ? 0.05f * static_cast<float>(i % 64) / 64.0f : 0.0f;
      }
      this->Stage->GetProperty()->SetTransferFunction2D(c, table);
    }
  }
  /// The storm as the value or as red, green and blue; a ramp to the east as the opacity.
  void UseGrey(int count)
  {
    this->UseComponents(count, VTK_UNSIGNED_CHAR);
    vtkDataArray* scalars = this->Input->GetPointData()->GetScalars();
    for (vtkIdType id = 0; id < scalars->GetNumberOfTuples(); ++id)
    {
      const double value = 2.0 * scalars->GetComponent(id, 0);
      const double opacity = scalars->GetComponent(id, 1);
      for (int c = 0; c < count - 1; ++c)
      {
        scalars->SetComponent(id, c, value);
      }
      scalars->SetComponent(id, count - 1, opacity);
    }
    this->SetFunctions(0, 1.0, 1.0, 1.0, 0.0, 200.0, 1.0);
    vtkNew<vtkColorTransferFunction> grey;
    grey->AddRGBPoint(0.0, 0.0, 0.0, 0.0);
    grey->AddRGBPoint(255.0, 1.0, 1.0, 1.0);
    this->Stage->GetProperty()->SetColor(grey);
    this->Stage->GetProperty()->IndependentComponentsOff();
  }
  /// Opaque, in the middle of the volume.
  void AddBall()
  {
    vtkNew<vtkSphereSource> sphere;
    sphere->SetCenter(0.0, 0.0, 12.0);
    sphere->SetRadius(10.0);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(sphere->GetOutputPort());
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    this->Stage->GetRenderer()->AddActor(actor);
  }
  void UseIndependent(int count)
  {
    this->UseComponents(count, VTK_FLOAT);
    this->SetFunctions(0, 1.0, 0.2, 0.1, 40.0, 90.0, 0.4);
    this->SetFunctions(1, 0.1, 0.2, 1.0, 120.0, 200.0, 0.1);
    if (count > 2)
    {
      this->SetFunctions(2, 0.1, 1.0, 0.2, 150.0, 200.0, 0.2);
    }
    if (count > 3)
    {
      this->SetFunctions(3, 1.0, 1.0, 0.1, 100.0, 200.0, 0.05);
    }
  }
};

} // namespace

// A red storm in front of a blue haze that thickens to the east.
TEST_F(Components, TwoIndependent)
{
  this->UseIndependent(2);
  this->ExpectSamePictureAndBaseline("components-2", "TwoComponents", 0.83);
}

// The haze counts half, and each component's opacity has its own unit distance.
TEST_F(Components, TwoWeighted)
{
  this->UseIndependent(2);
  this->Stage->GetProperty()->SetComponentWeight(1, 0.5);
  this->Stage->GetProperty()->SetScalarOpacityUnitDistance(1, 2.0);
  this->ExpectSamePicture("components-2-weighted", 0.35);
}

// Red storm, blue haze to the east, green to the north.
TEST_F(Components, ThreeIndependent)
{
  this->UseIndependent(3);
  this->ExpectSamePictureAndBaseline("components-3", "ThreeComponents", 0.85);
}

// Yellow above as well.
TEST_F(Components, FourIndependent)
{
  this->UseIndependent(4);
  this->ExpectSamePictureAndBaseline("components-4", "FourComponents", 1.4);
}

// The second component is seen where the second component of another array is in its upper half, in
// the east: the picture of the same volume cut in the middle. VTK 9.1's ray caster cannot compile
// its shader for this.
TEST_F(Components, TwoIndependentWithASecondArray)
{
  this->UseIndependent(2);
  vtkNew<vtkFloatArray> places;
  places->SetName("places");
  places->SetNumberOfComponents(2);
  for (vtkIdType id = 0; id < this->Input->GetNumberOfPoints(); ++id)
  {
    const double* place = this->Input->GetPoint(id);
    places->InsertNextTuple2(place[2], place[0]);
  }
  this->Input->GetPointData()->AddArray(places);
  this->Stage->GetProperty()->SetTransferFunctionMode(vtkVolumeProperty::TF_2D);
  const Picture background = this->Stage->Draw(nullptr);
  this->SetFunctions2D(0.0);
  const std::array<double, 6> east{0.0, 32.0, -32.0, 32.0, 0.0, 24.0};
  this->Slices->SetCroppingRegionPlanes(east.data());
  this->Slices->SetCroppingRegionFlagsToSubVolume();
  this->Slices->CroppingOn();
  const Picture cropped = this->Stage->Draw(this->Configure(this->Slices));
  this->Slices->CroppingOff();
  const Picture whole = this->Stage->Draw(this->Slices);
  this->Slices->SetTransfer2DYAxisArray("places");
  EXPECT_EQ(Compare(this->Stage->Draw(this->Slices), whole, background).Worst, 0.0)
    << "functions that do not depend on the other array";
  this->SetFunctions2D(0.5);
  EXPECT_AT_MOST(Compare(this->Stage->Draw(this->Slices), cropped, background).LargestMean(), 0.045,
    "cut by a second array: mean difference to cropping, of 255");
  EXPECT_AT_LEAST(Compare(whole, cropped, background).LargestMean(), 14.0,
    "mean difference of the whole volume to its half, of 255");
}

// Each component is lit by its own gradient and material.
TEST_F(Components, TwoIndependentShaded)
{
  this->UseIndependent(2);
  this->Stage->GetProperty()->ShadeOn(0);
  this->Stage->GetProperty()->ShadeOn(1);
  this->Stage->GetProperty()->SetDiffuse(0, 1.0);
  this->Stage->GetProperty()->SetAmbient(1, 0.6);
  this->Stage->GetProperty()->SetSpecular(1, 0.0);
  this->ExpectSamePicture("components-2-shaded", 0.69);
}

// The colour of the storm, the opacity of the ramp: the storm fades to the west.
TEST_F(Components, TwoDependent)
{
  this->UseComponents(2, VTK_FLOAT);
  this->SetFunctions(0, 1.0, 0.2, 0.1, 0.0, 200.0, 0.05);
  this->Stage->GetProperty()->IndependentComponentsOff();
  this->ExpectSamePictureAndBaseline("components-value-opacity", "ValueAndOpacity", 1.1);
}

// Red, green and blue themselves, the fourth component being the opacity.
TEST_F(Components, FourDependent)
{
  this->UseColours();
  this->ExpectSamePictureAndBaseline("components-rgba", "RGBA", 0.87);
}

// The same fading storm, lit, where it is flat clear: the gradient is that of the value.
TEST_F(Components, TwoDependentWithLightAndGradientOpacity)
{
  this->UseComponents(2, VTK_FLOAT);
  this->SetFunctions(0, 1.0, 0.2, 0.1, 0.0, 200.0, 0.1);
  vtkNew<vtkPiecewiseFunction> gradientOpacity;
  gradientOpacity->AddPoint(0.0, 0.1);
  gradientOpacity->AddPoint(10.0, 1.0);
  this->Stage->GetProperty()->SetGradientOpacity(gradientOpacity);
  this->Stage->GetProperty()->ShadeOn();
  this->Stage->GetProperty()->IndependentComponentsOff();
  this->ExpectSamePicture("components-value-opacity-lit", 0.45);
}

// The coloured block, lit where its red changes.
TEST_F(Components, FourDependentShaded)
{
  this->UseColours();
  this->Stage->GetProperty()->ShadeOn();
  this->Stage->GetProperty()->SetAmbient(0.5);
  this->ExpectSamePicture("components-rgba-lit", 0.52);
}

// Sum and mean of the value, by the opacity of the second component.
TEST_F(Components, ProjectionsOfTwoDependent)
{
  this->UseComponents(2, VTK_FLOAT);
  this->SetFunctions(0, 1.0, 1.0, 1.0, 0.0, 200.0, 0.03);
  this->Stage->GetProperty()->IndependentComponentsOff();
  this->ForBoth([](vtkGPUVolumeRayCastMapper* mapper) { mapper->SetBlendModeToAdditive(); });
  this->ExpectSamePicture("components-additive-dependent", 0.14);
  this->SetFunctions(0, 1.0, 1.0, 1.0, 0.0, 200.0, 1.0);
  this->ForBoth(
    [](vtkGPUVolumeRayCastMapper* mapper) { mapper->SetBlendModeToAverageIntensity(); });
  this->ExpectSamePicture("components-average-dependent", 0.58, 20.0);
}

// Scalars of 16 bits, signed.
TEST_F(Components, TwoIndependentShorts)
{
  this->UseIndependent(2);
  this->UseComponents(2, VTK_SHORT);
  this->ExpectSamePicture("components-2-short", 0.82);
}

// The brightest of each component, added by weight.
TEST_F(Components, MaximumOfTwo)
{
  this->UseIndependent(2);
  this->ForBoth(
    [](vtkGPUVolumeRayCastMapper* mapper) { mapper->SetBlendModeToMaximumIntensity(); });
  this->Stage->GetProperty()->SetComponentWeight(1, 0.5);
  this->ExpectSamePicture("components-maximum", 0.11);
}

// Red, green and blue of the sample with the largest opacity on a ray, and of that with the least,
// with an opaque ball among them.
TEST_F(Components, ExtremesOfColours)
{
  this->UseColours();
  this->SetFunctions(0, 1.0, 1.0, 1.0, 0.0, 255.0, 1.0);
  this->AddBall();
  this->ForBoth(
    [](vtkGPUVolumeRayCastMapper* mapper) { mapper->SetBlendModeToMaximumIntensity(); });
  this->ExpectSamePictureAndBaseline("components-rgba-maximum", "MaximumOfRGBA", 0.95);
  this->SetFunctions(0, 1.0, 1.0, 1.0, 255.0, 0.0, 1.0);
  this->ForBoth(
    [](vtkGPUVolumeRayCastMapper* mapper) { mapper->SetBlendModeToMinimumIntensity(); });
  this->ExpectSamePicture("components-rgba-minimum", 1.05);
}

// A value and an opacity are a grey and an opacity. (VTK 9.1's ray caster keeps the first sample.)
TEST_F(Components, ExtremesOfValueAndOpacity)
{
  const Picture background = this->Stage->Draw(nullptr);
  for (const int mode :
    {vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND, vtkVolumeMapper::MINIMUM_INTENSITY_BLEND})
  {
    this->Slices->SetBlendMode(mode);
    this->UseGrey(4);
    const Picture colors = this->Stage->Draw(this->Configure(this->Slices));
    this->UseGrey(2);
    const Picture values = this->Stage->Draw(this->Configure(this->Slices));
    const Difference difference = Compare(values, colors, background);
    EXPECT_GT(difference.Pixels, 1000);
    EXPECT_AT_MOST(difference.LargestMean(), 0.1,
      "extreme of value and opacity: mean difference to grey and opacity, of 255", OneCode);
  }
}

// Sums of both components.
TEST_F(Components, AdditiveOfTwo)
{
  this->UseIndependent(2);
  this->SetFunctions(0, 1.0, 1.0, 1.0, 0.0, 100.0, 0.02);
  this->SetFunctions(1, 1.0, 1.0, 1.0, 0.0, 200.0, 0.01);
  this->ForBoth([](vtkGPUVolumeRayCastMapper* mapper) { mapper->SetBlendModeToAdditive(); });
  this->Stage->GetProperty()->SetComponentWeight(1, 0.5);
  this->ExpectSamePicture("components-additive", 0.21);
}

// Means of both components.
TEST_F(Components, AverageOfTwo)
{
  this->UseIndependent(2);
  this->ForBoth(
    [](vtkGPUVolumeRayCastMapper* mapper) { mapper->SetBlendModeToAverageIntensity(); });
  this->ExpectSamePicture("components-average", 0.079, 5.0);
}

// Each component has a mean of its own samples in the range.
TEST_F(Components, AverageOfPartOfTheRange)
{
  this->UseIndependent(2);
  this->ForBoth(
    [](vtkGPUVolumeRayCastMapper* mapper)
    {
      mapper->SetBlendModeToAverageIntensity();
      mapper->SetAverageIPScalarRange(10.0, 1000.0);
    });
  this->ExpectSamePicture("components-average-range", 0.1, 5.0);
}
