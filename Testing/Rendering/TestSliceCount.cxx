// SPDX-License-Identifier: BSD-3-Clause
// The picture keeps its opacity whatever the number of slices, and has no bands where there are
// many.
#include "RayCasterComparison.h"
#include "Scenes.h"
#include "Tolerance.h"

#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkPiecewiseFunction.h"
#include "vtkRenderer.h"
#include "vtkVolumeProperty.h"

#include <cmath>
#include <iostream>
#include <set>
#include <string>

namespace
{

using namespace nexrad::testing;

class SliceCount : public AgainstRayCaster
{
protected:
  Picture DrawWith(int slices)
  {
    this->Slices->SetNumberOfSlices(slices);
    Picture picture = this->Stage->Draw(this->Slices);
    EXPECT_EQ(this->Slices->GetNumberOfDrawnSlices(), slices);
    return picture;
  }

  /// Compares that many slices with 256, over the pixels that the volume covers.
  void ExpectLike256(const std::string& name, int slices, double tolerance)
  {
    const Picture background = this->Stage->Draw(nullptr);
    const Difference difference = Compare(this->DrawWith(slices), this->DrawWith(256), background);
    std::cout << name << ", " << slices << " slices: mean difference from 256 "
              << difference.LargestMean() << " of 255, worst " << difference.Worst << ", over "
              << difference.Pixels << " pixels\n";
    EXPECT_GT(difference.Pixels, 3000);
    EXPECT_AT_MOST(
      difference.LargestMean(), tolerance, name + ": mean difference from 256 slices, of 255")
      << name << ", " << slices << " slices";
  }

  /// A ramp of scalars along x from 0 to 1, on a cube of 8 units from the origin on.
  void UseRamp()
  {
    this->Input = MakeUniformCube(9, 0.0f);
    auto* scalar = static_cast<float*>(this->Input->GetScalarPointer());
    for (vtkIdType id = 0; id < this->Input->GetNumberOfPoints(); ++id)
    {
      scalar[id] = static_cast<float>(id % 9) / 8.0f;
    }
    this->Slices->SetInputData(this->Input);
  }
};

} // namespace

TEST_F(SliceCount, StormKeepsItsOpacity)
{
  this->UseStorm(VTK_FLOAT);
  this->Slices->SetInputData(this->Input);
  for (const bool parallel : {false, true})
  {
    this->AimCamera(parallel);
    const std::string name = parallel ? "storm, parallel" : "storm, perspective";
    this->ExpectLike256(name, 128, 0.33);  // measured: 0.17
    this->ExpectLike256(name, 512, 0.13);  // 0.07
    this->ExpectLike256(name, 1024, 0.12); // 0.06
  }
}

TEST_F(SliceCount, UniformCubeKeepsItsOpacity)
{
  this->Input = MakeUniformCube(9, 1.0f);
  this->Slices->SetInputData(this->Input);
  vtkRenderer* renderer = this->Stage->GetRenderer();
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetFocalPoint(4.0, 4.0, 4.0);
  camera->SetPosition(14.0, -11.0, 15.0);
  camera->SetViewUp(0.0, 0.0, 1.0);
  renderer->ResetCameraClippingRange(0.0, 8.0, 0.0, 8.0, 0.0, 8.0);
  // Opacity of a unit, and twice the largest difference that was measured.
  const std::pair<double, double> bounds[] = {{0.02, 0.0106}, {0.12, 0.051}, {0.5, 0.21}};
  for (const auto& [opacity, bound] : bounds)
  {
    SetUniformFunctions(this->Stage->GetProperty(), opacity);
    for (const int slices : {64, 128, 512, 1024})
    {
      this->ExpectLike256("cube of opacity " + std::to_string(opacity), slices, bound);
    }
  }
}

// A haze that thickens to the right, at most 3 % opaque, whose contrast is raised twenty times:
// each of 1024 slices adds up to 1/32000, far less than a step of 8 bits (or of 16, once the sum is
// near its end). Every pixel is what the formula says, and there are no bands: as many levels as 8
// bits have in that range.
TEST_F(SliceCount, ThinHazeHasNoBands)
{
  constexpr double most = 0.004; // opacity of a unit
  constexpr double contrast = 20.0;
  this->UseRamp();
  SetUniformFunctions(this->Stage->GetProperty(), 0.0);
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(0.0, 0.0);
  opacity->AddPoint(1.0, most);
  this->Stage->GetProperty()->SetScalarOpacity(opacity);
  this->Slices->SetFinalColorWindow(static_cast<float>(1.0 / contrast));
  this->Slices->SetFinalColorLevel(static_cast<float>(0.5 / contrast));
  vtkCamera* camera = this->Stage->GetRenderer()->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetFocalPoint(4.0, 4.0, 4.0);
  camera->SetPosition(4.0, 4.0, 30.0);
  camera->SetViewUp(0.0, 1.0, 0.0);
  camera->SetParallelScale(4.0); // the cube fills the picture
  camera->SetClippingRange(1.0, 60.0);
  for (const int slices : {256, 1024})
  {
    const Picture picture = this->DrawWith(slices);
    std::set<double> levels;
    double worst = 0.0;
    for (int x = 0; x < PictureSize; ++x)
    {
      const double scalar = (x + 0.5) / PictureSize;
      const double expected = 255.0 * contrast * (1.0 - std::pow(1.0 - most * scalar, 8.0));
      const double actual = PixelAt(picture, x, PictureSize / 2)[0];
      levels.insert(actual);
      worst = std::max(worst, std::abs(actual - expected));
    }
    std::cout << slices << " slices: worst difference from the formula " << worst << " of 255, "
              << levels.size() << " levels in " << PictureSize << " pixels\n";
    EXPECT_AT_MOST(worst, 1.0, "largest difference to the formula, of 255") << slices << " slices";
    EXPECT_AT_LEAST(levels.size(), 126u, "levels of grey") << slices << " slices";
  }
}
