// SPDX-License-Identifier: BSD-3-Clause
// Pictures compared with Testing/Baseline/Rendering.
#include "RenderingTest.h"
#include "Scenes.h"

#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkOpenGLTextureSliceVolumeMapper.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <iostream>
#include <memory>

namespace
{

using namespace nexrad::testing;

class Baselines : public RenderingTest
{
protected:
  void SetUp() override
  {
    RenderingTest::SetUp();
    if (IsSkipped() || HasFatalFailure())
    {
      return;
    }
    this->Stage = std::make_unique<Scene>();
    SetStormFunctions(this->Stage->GetProperty(), VTK_FLOAT);
    this->Mapper->SetInputData(MakeStorm(48, VTK_FLOAT));
    vtkCamera* camera = this->Stage->GetRenderer()->GetActiveCamera();
    camera->SetFocalPoint(0.0, 0.0, 12.0);
    camera->SetPosition(50.0, -90.0, 60.0);
    camera->SetViewUp(0.0, 0.0, 1.0);
    camera->SetClippingRange(20.0, 250.0);
  }
  void TearDown() override
  {
    this->Stage.reset();
    RenderingTest::TearDown();
  }

  std::unique_ptr<Scene> Stage;
  vtkNew<vtkOpenGLTextureSliceVolumeMapper> Mapper;
};

} // namespace

// Two storm towers, the left one with a broad anvil, over a pale layer; red and magenta cores.
TEST_F(Baselines, Storm)
{
  EXPECT_LE(BaselineError(this->Stage->Draw(this->Mapper), "Storm"), BaselineTolerance);
}

// The same storm in a parallel view from the south-east, stretched to twice its height.
TEST_F(Baselines, StormStretchedParallel)
{
  this->Stage->GetVolume()->SetScale(1.0, 1.0, 2.0);
  vtkCamera* camera = this->Stage->GetRenderer()->GetActiveCamera();
  camera->SetFocalPoint(0.0, 0.0, 24.0);
  camera->ParallelProjectionOn();
  camera->SetParallelScale(45.0);
  EXPECT_LE(
    BaselineError(this->Stage->Draw(this->Mapper), "StormStretchedParallel"), BaselineTolerance);
}

// The comparison must fail on a picture that is not the storm: a quarter of the slices with the
// opacity left as it was for all of them, and the right picture shifted by a pixel.
TEST_F(Baselines, WrongPicturesFail)
{
  const Picture right = this->Stage->Draw(this->Mapper);
  auto shifted = Picture::New();
  shifted->DeepCopy(right);
  auto* pixels = static_cast<unsigned char*>(shifted->GetScalarPointer());
  std::rotate(pixels, pixels + 3, pixels + 3 * shifted->GetNumberOfPoints());
  EXPECT_GT(BaselineError(shifted, "Storm"), BaselineTolerance);

  this->Mapper->SetNumberOfSlices(64);
  this->Stage->GetProperty()->SetScalarOpacityUnitDistance(4.0);
  EXPECT_GT(BaselineError(this->Stage->Draw(this->Mapper), "Storm"), BaselineTolerance);
  this->Stage->GetProperty()->SetScalarOpacityUnitDistance(1.0);
  this->Mapper->SetNumberOfSlices(256);
  EXPECT_LE(BaselineError(this->Stage->Draw(this->Mapper), "Storm"), BaselineTolerance);
}

// With a smooth table the picture keeps its opacity from 128 to 1024 slices.
TEST_F(Baselines, SliceCountKeepsThePicture)
{
  const Picture background = this->Stage->Draw(nullptr);
  const Picture reference = this->Stage->Draw(this->Mapper);
  for (const auto& [slices, tolerance] : {std::pair(128, 4.0), {512, 2.0}, {1024, 2.0}})
  {
    this->Mapper->SetNumberOfSlices(slices);
    const Picture picture = this->Stage->Draw(this->Mapper);
    const Difference difference = Compare(picture, reference, background);
    std::cout << slices << " slices: mean difference from 256 " << difference.LargestMean()
              << " of 255\n";
    EXPECT_LE(difference.LargestMean(), tolerance);
  }
}
