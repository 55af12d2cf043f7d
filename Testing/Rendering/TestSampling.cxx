// SPDX-License-Identifier: BSD-3-Clause
// How far apart samples are, along the rays and over the picture.
#include "RayCasterComparison.h"
#include "Scenes.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkPlaneSource.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <cmath>

namespace
{

using namespace nexrad::testing;

class Sampling : public StormAgainstRayCaster
{
protected:
  void UseImageSampleDistance(float distance)
  {
    this->ForBoth(
      [distance](vtkGPUVolumeRayCastMapper* mapper) { mapper->SetImageSampleDistance(distance); });
  }
  /// A blue square that stands in the storm.
  void AddSquare()
  {
    vtkNew<vtkPlaneSource> square;
    square->SetOrigin(-30.0, -4.0, 0.0);
    square->SetPoint1(30.0, -4.0, 0.0);
    square->SetPoint2(-30.0, -4.0, 20.0);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(square->GetOutputPort());
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->GetProperty()->LightingOff();
    actor->GetProperty()->SetColor(0.0, 0.0, 1.0);
    this->Stage->GetRenderer()->AddActor(actor);
  }
};

} // namespace

// Samples two units apart, a voxel and a half: the same storm, a little rougher along the edges of
// the cores.
TEST_F(Sampling, SampleDistance)
{
  this->SampleDistance = 2.0;
  this->IntegratedTolerance = 3.5; // measured: 1.77
  this->ExpectSamePictureAndBaseline("sample-distance-2", "SampleDistance", Bar);
}

// Half of the window's resolution: the same storm, soft.
TEST_F(Sampling, CoarsePicture)
{
  this->UseImageSampleDistance(2.0f);
  this->ExpectSamePictureAndBaseline("image-sample-distance-2", "ImageSampleDistance", Bar);
}

// Twice the window's resolution.
TEST_F(Sampling, FinePicture)
{
  this->UseImageSampleDistance(0.5f);
  this->ExpectSamePicture("image-sample-distance-half", Bar);
}

// A coarse projection: its outline has steps, but no false values along it.
TEST_F(Sampling, CoarseMaximum)
{
  const Picture background = this->Stage->Draw(nullptr);
  this->Slices->SetBlendModeToMaximumIntensity();
  const Picture fine = this->Stage->Draw(this->Configure(this->Slices));
  this->UseImageSampleDistance(4.0f);
  const Difference difference = Compare(this->Stage->Draw(this->Slices), fine, background);
  EXPECT_GT(difference.LargestMean(), 0.1) << "the picture is as fine as before";
  EXPECT_LE(difference.LargestMean(), 8.0);
}

// Opaque geometry hides the same parts of a coarse picture, in windows with and without samples.
TEST_F(Sampling, CoarsePictureBehindGeometry)
{
  for (const int multiSamples : {0, 4})
  {
    this->Stage = std::make_unique<Scene>(256, 256, multiSamples);
    this->UseStorm(VTK_FLOAT);
    this->AimCamera(false);
    this->AddSquare();
    const Picture background = this->Stage->Draw(nullptr);
    this->UseImageSampleDistance(1.0f);
    const Picture fine = this->Stage->Draw(this->Configure(this->Slices));
    this->UseImageSampleDistance(2.0f);
    const Picture coarse = this->Stage->Draw(this->Slices);
    const Difference difference = Compare(coarse, fine, background);
    EXPECT_GT(difference.Pixels, 10000);
    EXPECT_GT(difference.LargestMean(), 0.1) << "the picture is as fine as before";
    EXPECT_LE(difference.LargestMean(), 4.0) << multiSamples << " samples";
  }
}

// A rate that cannot be met makes the picture coarse; a still picture is as fine as the first.
TEST_F(Sampling, InteractionMakesThePictureCoarse)
{
  const Picture background = this->Stage->Draw(nullptr);
  this->Slices->SetInputData(this->Input);
  this->Slices->SetNumberOfSlices(256);
  const Picture still = this->Stage->Draw(this->Slices);
  this->Stage->GetWindow()->SetDesiredUpdateRate(1e6);
  this->Stage->Draw(this->Slices); // the first one measures
  const Picture moving = this->Stage->Draw(this->Slices);
  EXPECT_GT(Compare(moving, still, background).LargestMean(), 1.0);
  this->Slices->SetMaximumImageSampleDistance(1.0f);
  EXPECT_EQ(Compare(this->Stage->Draw(this->Slices), still, background).LargestMean(), 0.0);
  this->Slices->SetMaximumImageSampleDistance(10.0f);
  this->Stage->GetWindow()->SetDesiredUpdateRate(1e-4);
  EXPECT_EQ(Compare(this->Stage->Draw(this->Slices), still, background).LargestMean(), 0.0);
}

// Where two pixels a ray are the most, a rate that cannot be met leaves the picture of
// CoarsePicture.
TEST_F(Sampling, AutomaticAdjustmentGivesTheCoarsePicture)
{
  this->Stage->Draw(this->Configure(this->Slices));
  this->Slices->SetNumberOfSlices(this->Slices->GetNumberOfDrawnSlices());
  this->Slices->AutoAdjustSampleDistancesOn();
  this->Slices->SetMaximumImageSampleDistance(2.0f);
  this->Stage->GetWindow()->SetDesiredUpdateRate(1e6);
  this->Stage->Draw(this->Slices); // the first one measures
  ExpectBaseline(this->Stage->Draw(this->Slices), "ImageSampleDistance");
}

// A cube of 9 points, 8 across, face on: the number of slices follows by hand.
TEST_F(Sampling, SampleDistanceGivesTheNumberOfSlices)
{
  this->Input = MakeUniformCube(9, 1.0f);
  SetUniformFunctions(this->Stage->GetProperty(), 0.12);
  vtkCamera* camera = this->Stage->GetRenderer()->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetFocalPoint(4.0, 4.0, 4.0);
  camera->SetPosition(4.0, 4.0, 30.0);
  camera->SetViewUp(0.0, 1.0, 0.0);
  camera->SetClippingRange(1.0, 60.0);
  const auto count = [&]
  {
    this->Stage->Draw(this->Slices);
    return this->Slices->GetNumberOfDrawnSlices();
  };
  this->Slices->SetInputData(this->Input);
  EXPECT_EQ(count(), 8) << "automatic: the shortest edge of a voxel";
  this->Slices->AutoAdjustSampleDistancesOff();
  this->Slices->SetSampleDistance(0.25f);
  EXPECT_EQ(count(), 32);
  // VTK's rule for 9 x 9 x 9 points of spacing 1: 1/200 of a voxel for 8 voxels, growing with the
  // cube root of their number: 0.005 * (729 / 8)^(1/3) = 0.0225 times the mean of 8 along an axis.
  this->Slices->LockSampleDistanceToInputSpacingOn();
  const int locked = count();
  EXPECT_GT(locked, 32);
  EXPECT_NEAR(PixelAt(this->Stage->Draw(this->Slices), PictureSize / 2, PictureSize / 2)[0],
    255.0 * 0.6403655, 1.0);
  this->Input->SetSpacing(2.0, 2.0, 2.0);
  EXPECT_EQ(count(), locked) << "it follows the voxels";
  this->Slices->SetNumberOfSlices(100);
  EXPECT_EQ(count(), 100) << "a number of slices comes first";
}
