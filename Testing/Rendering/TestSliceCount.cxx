// SPDX-License-Identifier: BSD-3-Clause
// The picture keeps its opacity whatever the number of slices and however short a ray's way through
// the volume, and has no bands where there are many.
#include "RayCasterComparison.h"
#include "Scenes.h"
#include "Tolerance.h"

#include "vtkCamera.h"
#include "vtkContourValues.h"
#include "vtkImageData.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPlane.h"
#include "vtkRenderer.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <random>
#include <set>
#include <string>
#include <utility>

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
  for (const double opacity : {0.02, 0.12, 0.5}) // of a unit
  {
    SetUniformFunctions(this->Stage->GetProperty(), opacity);
    for (const int slices : {64, 128, 512, 1024})
    {
      this->ExpectLike256("cube of opacity " + std::to_string(opacity), slices, 0.0034); // 0.0017
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
    EXPECT_AT_MOST(worst, 0.9, "largest difference to the formula, of 255") << slices << " slices";
    EXPECT_AT_LEAST(levels.size(), 127u, "levels of grey") << slices << " slices";
  }
}

namespace
{

/// A layer 0.1 thick and 99 wide, half opaque for a ray that crosses it straight.
class ThinLayer : public SliceCount
{
protected:
  void SetUp() override
  {
    SliceCount::SetUp();
    if (this->Stage != nullptr)
    {
      this->Use(MakeLayer(), 0.1);
    }
  }

  /// Scalars from 0 at its bottom to 1 at its top, or 1 everywhere.
  static vtkSmartPointer<vtkImageData> MakeLayer(bool rises = false)
  {
    auto layer = vtkSmartPointer<vtkImageData>::New();
    layer->SetDimensions(100, 100, 2);
    layer->SetSpacing(1.0, 1.0, 0.1);
    layer->AllocateScalars(VTK_FLOAT, 1);
    auto* scalar = static_cast<float*>(layer->GetScalarPointer());
    for (vtkIdType id = 0; id < layer->GetNumberOfPoints(); ++id)
    {
      scalar[id] = rises && id < 100 * 100 ? 0.0f : 1.0f;
    }
    return layer;
  }

  void Use(vtkSmartPointer<vtkImageData> input, double thickness)
  {
    this->Input = input;
    this->Slices->SetInputData(input);
    SetUniformFunctions(this->Stage->GetProperty(), 0.5);
    this->Stage->GetProperty()->SetScalarOpacityUnitDistance(thickness);
  }

  /// Parallel rays at that angle (degrees) to the upright; the layer fills the picture.
  void LookAt(double angle)
  {
    const double* middle = this->Input->GetCenter();
    const double radians = angle * std::acos(-1.0) / 180.0;
    vtkCamera* camera = this->Stage->GetRenderer()->GetActiveCamera();
    camera->ParallelProjectionOn();
    camera->SetFocalPoint(middle);
    camera->SetPosition(middle[0] + 1.0, middle[1] - 100.0 * std::sin(radians),
      middle[2] + 100.0 * std::cos(radians));
    camera->SetViewUp(0.0, std::cos(radians), std::sin(radians));
    camera->SetParallelScale(this->Input->GetLength() / 16.0);
    camera->SetClippingRange(1.0, 300.0);
  }

  /// Least and greatest red of the picture's pixels.
  static std::pair<double, double> FindRange(const Picture& picture)
  {
    double least = 255.0;
    double most = 0.0;
    for (int pixel = 0; pixel < PictureSize * PictureSize; ++pixel)
    {
      const double red = PixelAt(picture, pixel % PictureSize, pixel / PictureSize)[0];
      least = std::min(least, red);
      most = std::max(most, red);
    }
    return {least, most};
  }

  /// All pixels are as opaque as the formula says, for several angles and numbers of slices.
  void ExpectItsOpacity()
  {
    for (const double angle : {5.0, 60.0, 75.0})
    {
      this->LookAt(angle);
      const double* toEye =
        this->Stage->GetRenderer()->GetActiveCamera()->GetDirectionOfProjection();
      const double expected = 255.0 * (1.0 - std::pow(0.5, 1.0 / std::abs(toEye[2])));
      for (const bool slabs : {false, true})
      {
        for (const int slices : {1, 64, 256})
        {
          this->Slices->SetPreIntegration(slabs);
          const auto [least, most] = FindRange(this->DrawWith(slices));
          EXPECT_AT_MOST(std::max(expected - least, most - expected), 1.0,
            "largest difference of a thin layer to its opacity, of 255", OneCode)
            << angle << " degrees, " << slices << (slabs ? " slabs" : " slices") << ": " << least
            << " to " << most << " in place of " << expected;
        }
      }
    }
  }
};

} // namespace

// The planes leave gaps that are wider than the way of a ray through the layer.
TEST_F(ThinLayer, HasItsOpacity)
{
  this->ExpectItsOpacity();
}

TEST_F(ThinLayer, HasItsOpacityAsCroppedOutOfACube)
{
  this->Use(MakeUniformCube(9, 1.0f), 0.008);
  this->Slices->CroppingOn();
  this->Slices->SetCroppingRegionPlanes(0.0, 8.0, 0.0, 8.0, 4.0, 4.008);
  this->ExpectItsOpacity();
  // All nine regions between the planes of z.
  this->Slices->SetCroppingRegionPlanes(3.0, 5.0, 3.0, 5.0, 4.0, 4.008);
  this->Slices->SetCroppingRegionFlags(0x1FF << 9);
  this->ExpectItsOpacity();
}

TEST_F(ThinLayer, HasItsOpacityBetweenClippingPlanes)
{
  this->Use(MakeUniformCube(9, 1.0f), 0.008);
  for (const double direction : {1.0, -1.0})
  {
    vtkNew<vtkPlane> plane;
    plane->SetOrigin(4.0, 4.0, direction > 0.0 ? 4.0 : 4.008);
    plane->SetNormal(0.0, 0.0, direction);
    this->Slices->AddClippingPlane(plane);
  }
  this->ExpectItsOpacity();
}

// In modes that have no thickness, no pixel is missing.
TEST_F(ThinLayer, HasNoHolesInProjectionsAndSurfaces)
{
  SetUniformFunctions(this->Stage->GetProperty(), 1.0);
  for (const double angle : {5.0, 60.0, 75.0})
  {
    this->LookAt(angle);
    this->Slices->SetInputData(MakeLayer());
    this->Slices->SetBlendModeToMaximumIntensity();
    EXPECT_EQ(FindRange(this->DrawWith(64)).first, 255.0) << "maximum, " << angle << " degrees";
    this->Slices->SetInputData(MakeLayer(true));
    this->Slices->SetBlendModeToAverageIntensity();
    EXPECT_WITHIN(FindRange(this->DrawWith(64)).first, 127.5, 1.5,
      "least brightness of an average of 0 to 1, of 255", OneCode)
      << angle << " degrees";
    this->Slices->SetBlendModeToIsoSurface();
    this->Stage->GetProperty()->GetIsoSurfaceValues()->SetValue(0, 0.5);
    EXPECT_EQ(FindRange(this->DrawWith(64)).first, 255.0) << "isosurface, " << angle << " degrees";
  }
}

namespace
{

/// Blocks of voxels that are not interpolated, 121 points along z, seen along it.
class WallsOfVoxels : public SliceCount
{
protected:
  void SetUp() override
  {
    SliceCount::SetUp();
    if (this->Stage == nullptr)
    {
      return;
    }
    this->Input = vtkSmartPointer<vtkImageData>::New();
    this->Input->SetDimensions(17, 17, 121);
    this->Input->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
    std::mt19937 random(5);
    std::array<unsigned char, 4 * 4 * 31> blocks{};
    std::generate(blocks.begin(), blocks.end(), [&random] { return random() % 3 == 0 ? 200 : 0; });
    auto* scalar = static_cast<unsigned char*>(this->Input->GetScalarPointer());
    for (std::size_t id = 0; id < 17 * 17 * 121; ++id)
    {
      const std::size_t x = std::min<std::size_t>(3, id % 17 / 4);
      const std::size_t y = std::min<std::size_t>(3, id / 17 % 17 / 4);
      scalar[id] = blocks[(id / (17 * 17) / 4 * 4 + y) * 4 + x];
    }
    this->Slices->SetInputData(this->Input);
    SetUniformFunctions(this->Stage->GetProperty(), 0.0);
    vtkNew<vtkPiecewiseFunction> opacity;
    opacity->AddPoint(0.0, 0.0);
    opacity->AddPoint(200.0, 0.02);
    this->Stage->GetProperty()->SetScalarOpacity(opacity);
    this->Stage->GetProperty()->SetInterpolationTypeToNearest();
  }

  /// From above, turned by so many degrees.
  Picture DrawTurned(int slices, double degrees)
  {
    vtkCamera* camera = this->Stage->GetRenderer()->GetActiveCamera();
    camera->ParallelProjectionOn();
    camera->SetFocalPoint(8.0, 8.0, 60.0);
    camera->SetPosition(8.0, 8.0, 360.0);
    camera->SetViewUp(0.0, 1.0, 0.0);
    camera->Azimuth(degrees);
    camera->SetParallelScale(9.0);
    camera->SetClippingRange(100.0, 500.0);
    this->Slices->SetNumberOfSlices(slices);
    return this->Stage->Draw(this->Slices);
  }
};

} // namespace

// With 120 slices each lay on a face between voxels: walls were one voxel too thick or too thin, by
// the rounding of each pixel.
TEST_F(WallsOfVoxels, AreAsThickAsTheyAre)
{
  const Picture background = this->Stage->Draw(nullptr);
  const Picture fine = this->DrawTurned(2048, 0.0);
  // Twice the mean difference that was measured.
  for (const auto& [slices, bound] : {std::pair(0, 0.37), {119, 1.2}, {120, 0.37}, {121, 1.8}})
  {
    const Picture straight = this->DrawTurned(slices, 0.0);
    EXPECT_EQ(this->Slices->GetNumberOfDrawnSlices(), slices == 0 ? 120 : slices);
    const double difference = Compare(straight, fine, background).LargestMean();
    const double turned =
      Compare(straight, this->DrawTurned(slices, 0.001), background).LargestMean();
    std::cout << slices << " slices: mean difference to fine sampling " << difference
              << ", to a camera turned by 0.001 degrees " << turned << " of 255\n";
    EXPECT_AT_MOST(difference, bound, "walls of voxels: mean difference to 2048 slices, of 255")
      << slices << " slices";
    EXPECT_AT_MOST(
      turned, 0.02, "walls of voxels: mean difference to a camera turned a little, of 255")
      << slices << " slices";
  }
}
