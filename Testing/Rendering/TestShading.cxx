// SPDX-License-Identifier: BSD-3-Clause
// Light and gradient opacity beside VTK's GPU ray caster.
#include "RayCasterComparison.h"
#include "Scenes.h"
#include "Tolerance.h"

#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkLightKit.h"
#include "vtkMath.h"
#include "vtkPiecewiseFunction.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <cmath>

namespace
{

using namespace nexrad::testing;

class Shading : public StormAgainstRayCaster
{
protected:
  void SetUp() override
  {
    StormAgainstRayCaster::SetUp();
    if (this->Stage != nullptr)
    {
      this->Stage->GetProperty()->ShadeOn();
    }
  }
  /// A storm as high as it is wide: VTK 9.1 stretches its normals by the edges of the volume where
  /// there are other lights than a headlight, so only a cube can be compared.
  void UseCube()
  {
    this->Input = MakeStorm(48, VTK_FLOAT, 48);
    this->Input->SetSpacing(64.0 / 47, 64.0 / 47, 64.0 / 47);
    this->Input->SetOrigin(-32.0, -32.0, -20.0);
    // VTK 9.1's highlights of other lights than a headlight mirror the sample at a corner.
    this->Stage->GetProperty()->SetSpecular(0.0);
  }
  void AddLight(double x, double y, double z, double red, double green, double blue)
  {
    vtkNew<vtkLight> light;
    light->SetPosition(x, y, z);
    light->SetFocalPoint(0.0, 0.0, 12.0);
    light->SetColor(red, green, blue);
    this->Stage->GetRenderer()->AddLight(light);
    this->Last = light;
  }
  void UseGradientOpacity()
  {
    // The magnitude is that of neighbours' differences over the mean spacing, dBZ.
    vtkNew<vtkPiecewiseFunction> opacity;
    opacity->AddPoint(0.0, 0.0);
    opacity->AddPoint(2.0, 0.0);
    opacity->AddPoint(6.0, 1.0);
    this->Stage->GetProperty()->SetGradientOpacity(opacity);
  }

  vtkSmartPointer<vtkLight> Last;
};

} // namespace

// The storm lit from the eye: dark edges, a highlight in the middle of each tower.
TEST_F(Shading, Headlight)
{
  this->Stage->GetProperty()->SetAmbient(0.2);
  this->Stage->GetProperty()->SetDiffuse(0.9);
  this->Stage->GetProperty()->SetSpecular(0.6);
  this->Stage->GetProperty()->SetSpecularPower(8.0);
  this->ExpectSamePictureAndBaseline("shaded-headlight", "Headlight", 0.19);
}

// A parallel view of the same.
TEST_F(Shading, HeadlightInAParallelView)
{
  this->Stage->GetProperty()->SetSpecular(0.4);
  this->AimCamera(true);
  this->ExpectSamePicture("shaded-parallel", 0.15);
}

// Turned and stretched by its actor: the light still comes from the eye.
TEST_F(Shading, HeadlightOnATurnedVolume)
{
  this->Stage->GetVolume()->SetScale(1.0, 0.8, 2.0);
  this->Stage->GetVolume()->RotateX(25.0);
  this->Stage->GetVolume()->SetPosition(4.0, 0.0, -6.0);
  this->ExpectSamePicture("shaded-turned", 0.12);
}

// Turned by the direction matrix of the image, beside the ray caster's picture of the same volume
// turned by its actor: VTK 9.1 does not turn the gradient with the direction matrix.
TEST_F(Shading, HeadlightOnATurnedImage)
{
  const Picture background = this->Stage->Draw(nullptr);
  const double angle = 30.0;
  this->Stage->GetVolume()->SetOrigin(this->Input->GetOrigin());
  this->Stage->GetVolume()->RotateZ(angle);
  const Picture expected = this->Stage->Draw(this->Configure(this->RayCaster));
  this->Stage->GetVolume()->SetOrientation(0.0, 0.0, 0.0);
  const double c = std::cos(vtkMath::RadiansFromDegrees(angle));
  const double s = std::sin(vtkMath::RadiansFromDegrees(angle));
  this->Input->SetDirectionMatrix(c, -s, 0.0, s, c, 0.0, 0.0, 0.0, 1.0);
  const Picture actual = this->Stage->Draw(this->Configure(this->Slices));
  const Difference difference = Compare(actual, expected, background);
  EXPECT_GT(difference.Pixels, 2500);
  EXPECT_AT_MOST(
    difference.LargestMean(), Allowed(0.12), "mean difference to the ray caster, of 255");
}

// Integers, as most volumes are.
TEST_F(Shading, HeadlightOnBytes)
{
  this->UseStorm(VTK_UNSIGNED_CHAR);
  this->ExpectSamePicture("shaded-uint8", 0.72);
}

// One side lit red from the west, the other blue from the south-east.
TEST_F(Shading, ColouredLights)
{
  this->UseCube();
  this->AddLight(-100.0, 0.0, 30.0, 1.0, 0.2, 0.1);
  this->AddLight(80.0, -80.0, 10.0, 0.1, 0.3, 1.0);
  this->ExpectSamePictureAndBaseline("shaded-coloured", "ColouredLights", 0.054);
}

// A lamp near the taller tower, fading with distance, with a cone about it.
TEST_F(Shading, SpotLight)
{
  this->UseCube();
  this->AddLight(-10.0, -50.0, 40.0, 1.0, 1.0, 1.0);
  this->Last->PositionalOn();
  this->Last->SetConeAngle(35.0);
  this->Last->SetExponent(2.0);
  this->Last->SetAttenuationValues(0.5, 0.01, 0.0);
  this->ExpectSamePictureAndBaseline("shaded-spot", "SpotLight", 0.56);
}

// The five lights of a light kit, highlights included, as ParaView lights its volumes: the
// highlights are VTK 9.1's only roughly (ray-caster-errors.md).
TEST_F(Shading, LightKit)
{
  this->UseCube();
  this->Stage->GetProperty()->SetSpecular(0.2);
  vtkNew<vtkLightKit> kit;
  kit->AddLightsToRenderer(this->Stage->GetRenderer());
  this->ExpectSamePicture("shaded-light-kit", 4.7);
}

// Without the light on the back: only what faces the light is lit.
TEST_F(Shading, OneSidedLight)
{
  this->UseCube();
  this->Stage->GetRenderer()->TwoSidedLightingOff();
  this->AddLight(-100.0, 0.0, 30.0, 1.0, 1.0, 1.0);
  this->ExpectSamePicture("shaded-one-sided", 0.062);
}

// What hardly changes is clear: the weak layer thins out, the middle of each core is paler.
TEST_F(Shading, GradientOpacity)
{
  this->Stage->GetProperty()->ShadeOff();
  this->UseGradientOpacity();
  this->ExpectSamePictureAndBaseline("gradient-opacity", "GradientOpacity", 0.21);
}

TEST_F(Shading, GradientOpacityOfOneChangesNothing)
{
  vtkVolumeProperty* property = this->Stage->GetProperty();
  vtkGPUVolumeRayCastMapper* slices = this->Configure(this->Slices);
  const Picture background = this->Stage->Draw(nullptr);
  const Picture without = this->Stage->Draw(slices);
  vtkPiecewiseFunction* opacity = property->GetGradientOpacity(); // made: 1 everywhere
  const Difference made = Compare(this->Stage->Draw(slices), without, background);
  EXPECT_GT(made.Pixels, 2000);
  EXPECT_EQ(made.Worst, 0.0);
  opacity->RemoveAllPoints();
  opacity->AddPoint(2.0, 0.0);
  opacity->AddPoint(6.0, 1.0);
  EXPECT_AT_LEAST(Compare(this->Stage->Draw(slices), without, background).LargestMean(), 3.0,
    "mean change by the gradient opacity, of 255");
  property->DisableGradientOpacityOn();
  EXPECT_EQ(Compare(this->Stage->Draw(slices), without, background).Worst, 0.0);
}

// The same, lit.
TEST_F(Shading, GradientOpacityAndLight)
{
  this->UseGradientOpacity();
  this->ExpectSamePicture("gradient-opacity-shaded", 0.1);
}

// An opaque white block, no cube, whose scalar grows along x, seen from above in a parallel view. A
// light that shines at 60 degrees to x returns cos 60 of itself; with the block turned by 25
// degrees towards it, cos 35. The highlight of a light from below at 45 degrees to x, with a power
// of 2: half-way between light and eye is 22.5 degrees from x (Blinn's, as in VTK 9.1); mirrored on
// x the light shines upwards, 45 degrees from the eye (Phong's, from VTK 9.2 on).
TEST_F(Shading, LightOnABlockIsWhatGeometrySays)
{
  this->Input = vtkSmartPointer<vtkImageData>::New();
  this->Input->SetDimensions(17, 5, 9);
  this->Input->SetSpacing(1.0, 2.0, 0.5);
  this->Input->SetOrigin(-8.0, -4.0, -2.0);
  this->Input->AllocateScalars(VTK_FLOAT, 1);
  auto* scalars = static_cast<float*>(this->Input->GetScalarPointer());
  for (vtkIdType id = 0; id < this->Input->GetNumberOfPoints(); ++id)
  {
    scalars[id] = static_cast<float>(id % 17);
  }
  SetUniformFunctions(this->Stage->GetProperty(), 0.95);
  vtkVolumeProperty* property = this->Stage->GetProperty();
  property->SetAmbient(0.0);
  property->SetDiffuse(1.0);
  property->SetSpecular(0.0);
  vtkRenderer* renderer = this->Stage->GetRenderer();
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->SetPosition(0.0, 0.0, 50.0);
  camera->SetViewUp(0.0, 1.0, 0.0);
  camera->SetParallelScale(6.0);
  camera->SetClippingRange(10.0, 100.0);
  vtkNew<vtkLight> light;
  light->SetFocalPoint(0.0, 0.0, 0.0);
  renderer->AddLight(light);
  const auto middle = [&]
  {
    const Picture picture = this->Stage->Draw(this->Configure(this->Slices));
    return PixelAt(picture, PictureSize / 2, PictureSize / 2)[0];
  };
  const auto cosine = [](double degrees) { return std::cos(vtkMath::RadiansFromDegrees(degrees)); };

  light->SetPosition(-cosine(60.0), -cosine(30.0), 0.0);
  EXPECT_WITHIN(middle(), 255.0 * cosine(60.0), 1.0, "brightness of a lit face, of 255", OneCode);
  this->Stage->GetVolume()->RotateZ(25.0);
  EXPECT_WITHIN(
    middle(), 255.0 * cosine(35.0), 1.0, "brightness of a turned face, of 255", OneCode);
  this->Stage->GetVolume()->RotateZ(-25.0);

  property->SetDiffuse(0.0);
  property->SetSpecular(1.0);
  property->SetSpecularPower(2.0);
  light->SetPosition(-1.0, 0.0, -1.0);
  const double angle = HasMirroredHighlights() ? 45.0 : 22.5;
  EXPECT_WITHIN(middle(), 255.0 * cosine(angle) * cosine(angle), 1.0,
    "brightness of a highlight, of 255", OneCode);
}

// Light must change the picture, or the comparisons above say nothing.
TEST_F(Shading, LightChangesThePicture)
{
  const Picture background = this->Stage->Draw(nullptr);
  const Picture lit = this->Stage->Draw(this->Configure(this->Slices));
  this->Stage->GetProperty()->ShadeOff();
  const Picture unlit = this->Stage->Draw(this->Configure(this->Slices));
  EXPECT_AT_LEAST(
    Compare(lit, unlit, background).LargestMean(), 11.0, "mean change by the light, of 255");
  this->UseGradientOpacity();
  const Picture shells = this->Stage->Draw(this->Configure(this->Slices));
  EXPECT_AT_LEAST(
    Compare(shells, unlit, background).LargestMean(), 6.0, "mean change by shells, of 255");
}
