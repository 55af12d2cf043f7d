// SPDX-License-Identifier: BSD-3-Clause
// Shadows and ambient occlusion in pictures: what they darken, and when they are made anew.
#include "RenderingTest.h"
#include "Scenes.h"

#include "vtkCamera.h"
#include "vtkColorTransferFunction.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkOpenGLTextureSliceVolumeMapper.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <vector>

namespace
{

using namespace nexrad::testing;

constexpr int WindowSize = 128; // pixels of the window along each side
constexpr double CubeEdge = 8.0;
constexpr double UnitOpacity = 0.12; // of one unit
constexpr int Points = 33;           // of the cube along each axis

/// A white cube from the origin on, seen along -z, with the light behind the viewer.
class Shadows : public RenderingTest
{
protected:
  void SetUp() override
  {
    RenderingTest::SetUp();
    if (IsSkipped() || HasFatalFailure())
    {
      return;
    }
    this->Stage = std::make_unique<Scene>(WindowSize, WindowSize);
    this->Input = MakeUniformCube(Points, 1.0f);
    this->Input->SetSpacing(
      CubeEdge / (Points - 1), CubeEdge / (Points - 1), CubeEdge / (Points - 1));
    this->Mapper->SetInputData(this->Input);
    this->Mapper->SetLightDirection(0.0, 0.0, 1.0);
    SetUniformFunctions(this->Stage->GetProperty(), UnitOpacity);
    vtkCamera* camera = this->Stage->GetRenderer()->GetActiveCamera();
    camera->SetFocalPoint(CubeEdge / 2, CubeEdge / 2, CubeEdge / 2);
    camera->SetPosition(CubeEdge / 2, CubeEdge / 2, CubeEdge + 20.0);
    camera->SetViewUp(0.0, 1.0, 0.0);
    camera->SetParallelScale(5.0);
    camera->ParallelProjectionOn();
    camera->SetClippingRange(1.0, 60.0);
  }
  void TearDown() override
  {
    this->Stage.reset();
    RenderingTest::TearDown();
  }

  Picture Draw() { return this->Stage->Draw(this->Mapper); }
  double Middle() { return PixelAt(this->Draw(), WindowSize / 2, WindowSize / 2)[0]; }

  /// The storm of the comparisons, seen from above one corner.
  void UseStorm()
  {
    this->Input = MakeStorm(48, VTK_FLOAT);
    this->Mapper->SetInputData(this->Input);
    SetStormFunctions(this->Stage->GetProperty(), VTK_FLOAT);
    vtkCamera* camera = this->Stage->GetRenderer()->GetActiveCamera();
    camera->SetFocalPoint(0.0, 0.0, 12.0);
    camera->SetPosition(50.0, -90.0, 70.0);
    camera->SetViewUp(0.0, 0.0, 1.0);
    camera->SetParallelScale(36.0);
    this->Stage->GetRenderer()->ResetCameraClippingRange(-80, 80, -80, 80, -80, 80);
  }

  /// The upper half of the cube is opaque, the lower one lets all light through.
  void UseLid()
  {
    vtkDataArray* scalars = this->Input->GetPointData()->GetScalars();
    for (vtkIdType id = 0; id < scalars->GetNumberOfTuples(); ++id)
    {
      scalars->SetComponent(id, 0, IsInLid(id) ? 1.0 : 0.0);
    }
    scalars->Modified();
    vtkNew<vtkPiecewiseFunction> opacity;
    opacity->AddPoint(0.0, 0.0);
    opacity->AddPoint(1.0, 1.0);
    this->Stage->GetProperty()->SetScalarOpacity(opacity);
  }
  static bool IsInLid(vtkIdType id) { return id / (Points * Points) > Points / 2; }

  /// Light at the cell in the middle of the lowest layer, 0 to 1.
  double LightBelow(int component = 0)
  {
    vtkImageData* light = this->Mapper->GetLightVolume();
    const int* size = light->GetDimensions();
    return light->GetScalarComponentAsDouble(size[0] / 2, size[1] / 2, 0, component);
  }

  /// Both components.
  std::vector<double> AllLight()
  {
    std::vector<double> all;
    vtkDataArray* light = this->Mapper->GetLightVolume()->GetPointData()->GetScalars();
    for (vtkIdType i = 0; i < light->GetNumberOfTuples(); ++i)
    {
      all.push_back(light->GetComponent(i, 0));
      all.push_back(light->GetComponent(i, 1));
    }
    return all;
  }

  std::unique_ptr<Scene> Stage;
  vtkSmartPointer<vtkImageData> Input;
  vtkNew<vtkOpenGLTextureSliceVolumeMapper> Mapper;
};

double WorstDifference(const Picture& a, const Picture& b)
{
  return Compare(a, b, a).Worst;
}

} // namespace

// A sample at the depth s keeps 1 - strength + strength * exp(-density * extinction * s) of its
// colour, so the pixel is the integral of that over what the samples in front of it let through.
TEST_F(Shadows, ACubeLitFromTheViewerHasTheBrightnessOfTheFormula)
{
  const double extinction = -std::log(1.0 - UnitOpacity);
  const double once = 1.0 - std::exp(-extinction * CubeEdge);
  for (const double density : {1.0, 0.4})
  {
    const double both = 1.0 + density;
    const double twice = (1.0 - std::exp(-both * extinction * CubeEdge)) / both;
    this->Mapper->SetShadowDensity(density);
    for (const double strength : {0.25, 0.5, 1.0})
    {
      this->Mapper->SetShadowStrength(strength);
      EXPECT_NEAR(this->Middle(), 255.0 * ((1.0 - strength) * once + strength * twice), 1.0);
    }
  }
}

TEST_F(Shadows, SwitchedOffAgainThePictureIsTheSameToTheLastBit)
{
  this->UseStorm();
  const Picture before = this->Draw();
  EXPECT_EQ(this->Mapper->GetLightVolume(), nullptr);
  const Picture background = this->Stage->Draw(nullptr);
  for (const bool shade : {false, true})
  {
    this->Stage->GetProperty()->SetShade(shade);
    const Picture off = this->Draw();
    this->Mapper->SetShadowStrength(0.8);
    const Picture shadow = this->Draw();
    EXPECT_GT(Compare(off, shadow, background).LargestMean(), 1.8);
    this->Mapper->SetOcclusionStrength(0.8);
    EXPECT_GT(Compare(this->Draw(), shadow, background).LargestMean(), 0.6);
    this->Mapper->SetShadowStrength(0.0);
    this->Mapper->SetOcclusionStrength(0.0);
    EXPECT_EQ(WorstDifference(this->Draw(), off), 0.0);
  }
}

// The picture: the towers and the anvil of the storm, dark on the side away from the light.
TEST_F(Shadows, TheStormHasALitAndADarkSide)
{
  this->UseStorm();
  this->Mapper->SetLightDirection(-1.0, -1.0, 1.0);
  this->Mapper->SetShadowStrength(0.8);
  this->Mapper->SetOcclusionStrength(0.5);
  ExpectBaseline(this->Draw(), "Shadows");
}

// The light is what is diffuse and specular, the sky what is ambient.
TEST_F(Shadows, ShadowsDarkenDiffuseLightAndOcclusionAmbientLight)
{
  this->UseStorm();
  vtkVolumeProperty* property = this->Stage->GetProperty();
  property->ShadeOn();
  const auto expect = [&](double ambient, double diffuse, bool byShadow)
  {
    property->SetAmbient(ambient);
    property->SetDiffuse(diffuse);
    property->SetSpecular(0.0);
    this->Mapper->SetShadowStrength(0.0);
    this->Mapper->SetOcclusionStrength(0.0);
    const Picture off = this->Draw();
    this->Mapper->SetShadowStrength(1.0);
    EXPECT_EQ(WorstDifference(off, this->Draw()) > 20.0, byShadow);
    EXPECT_EQ(WorstDifference(off, this->Draw()) > 0.0, byShadow);
    this->Mapper->SetShadowStrength(0.0);
    this->Mapper->SetOcclusionStrength(1.0);
    EXPECT_EQ(WorstDifference(off, this->Draw()) > 20.0, !byShadow);
    EXPECT_EQ(WorstDifference(off, this->Draw()) > 0.0, !byShadow);
  };
  expect(1.0, 0.0, false);
  expect(0.0, 1.0, true);
}

TEST_F(Shadows, WithoutADirectionThereAreNone)
{
  this->UseStorm();
  const Picture off = this->Draw();
  this->Mapper->SetShadowStrength(1.0);
  this->Mapper->SetOcclusionStrength(1.0);
  this->Mapper->SetZenith(0.0, 0.0, 0.0);
  for (const double x :
    {0.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
  {
    this->Mapper->SetLightDirection(x, 0.0, 0.0);
    EXPECT_EQ(WorstDifference(this->Draw(), off), 0.0);
  }
}

TEST_F(Shadows, ProjectionsHaveNone)
{
  this->UseStorm();
  this->Mapper->SetBlendModeToMaximumIntensity();
  const Picture off = this->Draw();
  this->Mapper->SetShadowStrength(1.0);
  this->Mapper->SetOcclusionStrength(1.0);
  EXPECT_EQ(WorstDifference(this->Draw(), off), 0.0);
  EXPECT_EQ(this->Mapper->GetLightVolume(), nullptr);
}

// A light volume that is made anew is a modified image.
TEST_F(Shadows, LightIsMadeAnewForTheVolumeItsFunctionsAndTheLightAloneNotForTheCamera)
{
  this->UseStorm();
  this->Mapper->SetShadowStrength(0.5);
  this->Mapper->SetOcclusionStrength(0.5);
  this->Draw();
  vtkMTimeType made = this->Mapper->GetLightVolume()->GetMTime();
  const auto isMadeAnew = [&](const std::function<void()>& change)
  {
    change();
    this->Draw();
    const vtkMTimeType before = made;
    made = this->Mapper->GetLightVolume()->GetMTime();
    return made != before;
  };
  vtkRenderer* renderer = this->Stage->GetRenderer();
  vtkVolumeProperty* property = this->Stage->GetProperty();
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(0.0, 0.0, 10.0);
  EXPECT_FALSE(isMadeAnew([&] { renderer->GetActiveCamera()->Azimuth(20.0); }));
  EXPECT_FALSE(isMadeAnew([&] { renderer->GetActiveCamera()->Zoom(1.5); }));
  EXPECT_FALSE(isMadeAnew([&] { this->Stage->GetVolume()->SetPosition(1.0, 2.0, 3.0); }));
  EXPECT_FALSE(isMadeAnew([&] { this->Mapper->SetShadowStrength(0.7); }));
  EXPECT_FALSE(isMadeAnew([&] { this->Stage->GetWindow()->SetSize(100, 90); }));
  EXPECT_FALSE(
    isMadeAnew([&] { property->GetRGBTransferFunction()->AddRGBPoint(33.0, 1.0, 0.0, 0.0); }));
  // Colours so close to each other need a table of more entries.
  EXPECT_FALSE(
    isMadeAnew([&] { property->GetRGBTransferFunction()->AddRGBPoint(33.001, 0.0, 1.0, 0.0); }));
  EXPECT_FALSE(isMadeAnew([&] { property->GetScalarOpacity()->Modified(); }));
  EXPECT_TRUE(isMadeAnew([&] { this->Mapper->SetLightDirection(1.0, 0.0, 1.0); }));
  EXPECT_TRUE(isMadeAnew([&] { this->Mapper->SetZenith(0.0, 1.0, 1.0); }));
  EXPECT_TRUE(isMadeAnew([&] { property->GetScalarOpacity()->AddPoint(30.0, 0.1); }));
  EXPECT_TRUE(isMadeAnew([&] { property->SetScalarOpacityUnitDistance(2.0); }));
  EXPECT_TRUE(isMadeAnew([&] { this->Input->GetPointData()->GetScalars()->Modified(); }));
  EXPECT_TRUE(isMadeAnew([&] { this->Mapper->AddClippingPlane(plane); }));
  EXPECT_TRUE(isMadeAnew([&] { this->Stage->GetVolume()->RotateZ(10.0); }));
  EXPECT_FALSE(isMadeAnew([] {}));
}

TEST_F(Shadows, ACoarserVolumeServesWhileTheUserDrags)
{
  this->UseStorm();
  this->Input = MakeStorm(132, VTK_FLOAT);
  this->Mapper->SetInputData(this->Input);
  this->Mapper->SetShadowStrength(0.5);
  vtkRenderWindow* window = this->Stage->GetWindow();
  const auto countCells = [&] { return this->Mapper->GetLightVolume()->GetNumberOfPoints(); };
  this->Draw();
  const vtkIdType fine = countCells();
  EXPECT_LE(fine, 1048576);
  EXPECT_GT(fine, 1048576 / 4);

  window->SetDesiredUpdateRate(15.0);
  this->Stage->GetRenderer()->GetActiveCamera()->Azimuth(20.0);
  this->Draw();
  EXPECT_EQ(countCells(), fine) << "a camera that moves leaves the light as it is";
  this->Mapper->SetLightDirection(1.0, 0.0, 1.0);
  this->Draw();
  EXPECT_LE(countCells(), 1048576 / 8);
  window->SetDesiredUpdateRate(0.0001);
  this->Draw();
  EXPECT_EQ(countCells(), fine) << "a picture at rest has the whole resolution";

  window->SetDesiredUpdateRate(15.0);
  this->Mapper->AutoAdjustSampleDistancesOff();
  this->Mapper->SetLightDirection(0.0, 1.0, 1.0);
  this->Draw();
  EXPECT_EQ(countCells(), fine);
  window->SetDesiredUpdateRate(0.0001);
}

TEST_F(Shadows, UpdateLightDoesItBeforeTheFrame)
{
  this->UseStorm();
  this->Mapper->SetShadowStrength(0.5);
  this->Stage->GetVolume()->SetMapper(this->Mapper);
  ASSERT_TRUE(this->Mapper->UpdateLight(this->Stage->GetRenderer(), this->Stage->GetVolume()));
  ASSERT_NE(this->Mapper->GetLightVolume(), nullptr);
  const vtkMTimeType made = this->Mapper->GetLightVolume()->GetMTime();
  const Picture picture = this->Draw();
  EXPECT_EQ(this->Mapper->GetLightVolume()->GetMTime(), made);
  vtkNew<vtkOpenGLTextureSliceVolumeMapper> other;
  other->SetInputData(this->Input);
  other->SetLightDirection(0.0, 0.0, 1.0);
  other->SetShadowStrength(0.5);
  EXPECT_EQ(WorstDifference(this->Stage->Draw(other), picture), 0.0);
}

// The light stands in the world: what turns or stretches the volume does not turn it along.
TEST_F(Shadows, LightComesFromTheSameSideOfATurnedAndStretchedVolume)
{
  this->UseStorm();
  this->Mapper->SetShadowStrength(1.0);
  this->Mapper->SetLightDirection(0.0, -1.0, 0.25);
  this->Draw();
  const std::vector<double> expected = this->AllLight();
  this->Stage->GetVolume()->SetScale(1.0, 1.0, 4.0);
  this->Mapper->SetLightDirection(0.0, -1.0, 1.0);
  this->Draw();
  EXPECT_EQ(this->AllLight(), expected);
  this->Stage->GetVolume()->RotateZ(90.0);
  this->Mapper->SetLightDirection(1.0, 0.0, 1.0);
  this->Draw();
  const std::vector<double> turned = this->AllLight();
  ASSERT_EQ(turned.size(), expected.size());
  double worst = 0.0;
  for (std::size_t i = 0; i < turned.size(); ++i)
  {
    worst = std::max(worst, std::abs(turned[i] - expected[i]));
  }
  EXPECT_LE(worst, 1.5e-5); // of 1: the matrix is rounded
}

// An opaque lid keeps all light from what is below it, until it is cut, hidden or masked away.
TEST_F(Shadows, WhatIsNotDrawnCastsNoShadow)
{
  this->UseLid();
  this->Mapper->SetShadowStrength(1.0);
  const auto lightBelow = [&]
  {
    this->Draw();
    return this->LightBelow();
  };
  EXPECT_LT(lightBelow(), 0.001);

  vtkNew<vtkPlane> plane;
  plane->SetOrigin(0.0, 0.0, CubeEdge / 2);
  plane->SetNormal(0.0, 0.0, -1.0);
  this->Mapper->AddClippingPlane(plane);
  EXPECT_EQ(lightBelow(), 1.0);
  this->Mapper->RemoveAllClippingPlanes();
  EXPECT_LT(lightBelow(), 0.001);

  this->Mapper->CroppingOn();
  this->Mapper->SetCroppingRegionPlanes(-1.0, 9.0, -1.0, 9.0, -1.0, CubeEdge / 2);
  EXPECT_EQ(lightBelow(), 1.0);
  this->Mapper->SetCroppingRegionFlags(VTK_CROP_SUBVOLUME << 9); // the region above it alone
  EXPECT_LT(lightBelow(), 0.001);
  this->Mapper->CroppingOff();

  vtkNew<vtkUnsignedCharArray> flags;
  flags->SetNumberOfTuples(this->Input->GetNumberOfPoints());
  for (vtkIdType id = 0; id < flags->GetNumberOfTuples(); ++id)
  {
    flags->SetValue(id, IsInLid(id) ? 0 : 255);
  }
  vtkNew<vtkImageData> mask;
  mask->CopyStructure(this->Input);
  mask->GetPointData()->SetScalars(flags);
  this->Mapper->SetMaskTypeToBinary();
  this->Mapper->SetMaskInput(mask);
  EXPECT_EQ(lightBelow(), 1.0);
  this->Mapper->SetMaskInput(nullptr);
  EXPECT_LT(lightBelow(), 0.001);

  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  ghosts->SetNumberOfTuples(this->Input->GetNumberOfPoints());
  for (vtkIdType id = 0; id < ghosts->GetNumberOfTuples(); ++id)
  {
    ghosts->SetValue(id, IsInLid(id) ? vtkDataSetAttributes::HIDDENPOINT : 0);
  }
  this->Input->GetPointData()->AddArray(ghosts);
  EXPECT_EQ(lightBelow(), 1.0);
}

// The labels' own opacity holds where they are, as far as it counts.
TEST_F(Shadows, LabelsCastTheirOwnShadow)
{
  this->UseLid();
  this->Mapper->SetShadowStrength(1.0);
  vtkNew<vtkUnsignedCharArray> labels;
  labels->SetNumberOfTuples(this->Input->GetNumberOfPoints());
  labels->Fill(1.0);
  vtkNew<vtkImageData> mask;
  mask->CopyStructure(this->Input);
  mask->GetPointData()->SetScalars(labels);
  this->Mapper->SetMaskTypeToLabelMap();
  this->Mapper->SetMaskInput(mask);
  vtkNew<vtkPiecewiseFunction> clear;
  clear->AddPoint(0.0, 0.0);
  this->Stage->GetProperty()->SetLabelScalarOpacity(1, clear);
  this->Mapper->SetMaskBlendFactor(1.0);
  this->Draw();
  EXPECT_EQ(this->LightBelow(), 1.0);
  this->Mapper->SetMaskBlendFactor(0.0);
  this->Draw();
  EXPECT_LT(this->LightBelow(), 0.001);
}

TEST_F(Shadows, AnotherWindowGetsTheSameLight)
{
  this->UseStorm();
  this->Mapper->SetShadowStrength(0.8);
  const Picture first = this->Draw();
  Scene other(WindowSize, WindowSize);
  other.GetVolume()->SetProperty(this->Stage->GetProperty());
  other.GetRenderer()->SetActiveCamera(this->Stage->GetRenderer()->GetActiveCamera());
  EXPECT_EQ(WorstDifference(other.Draw(this->Mapper), first), 0.0);
  EXPECT_EQ(WorstDifference(this->Draw(), first), 0.0);
}
