// SPDX-License-Identifier: BSD-3-Clause
// RenderToImage gives the images of VTK's ray caster, and leaves the window alone; with
// UseDepthPass both begin at contours.
#include "RayCasterComparison.h"
#include "Scenes.h"
#include "Tolerance.h"

#include "vtkCamera.h"
#include "vtkContourValues.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkRenderer.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace
{

using namespace nexrad::testing;

struct Images
{
  vtkNew<vtkImageData> Color;
  vtkNew<vtkImageData> Depth;
};

class RenderToImage : public StormAgainstRayCaster
{
protected:
  void Draw(vtkGPUVolumeRayCastMapper* mapper, Images& images)
  {
    mapper->RenderToImageOn();
    const Picture background = this->Stage->Draw(nullptr);
    const Picture window = this->Stage->Draw(this->Configure(mapper));
    EXPECT_EQ(Compare(window, background, background).Pixels, 0) << "the window shows the volume";
    mapper->GetColorImage(images.Color);
    mapper->GetDepthImage(images.Depth);
  }

  /// From the eye, in the units of the world.
  double ToDistance(double depth)
  {
    const double* range = this->Stage->GetRenderer()->GetActiveCamera()->GetClippingRange();
    return range[0] * range[1] / (range[1] - depth * (range[1] - range[0]));
  }

  /// The bounds are those of the mean of colours and of depths, and of the part of the pixels that
  /// but one of both sees.
  void ExpectSameImages(const std::string& name, double ofColors, double ofDepths, double ofPixels)
  {
    Images rays;
    Images slices;
    this->Draw(this->RayCaster, rays);
    this->Draw(this->Slices, slices);
    for (vtkImageData* image : {slices.Color.Get(), slices.Depth.Get()})
    {
      EXPECT_EQ(image->GetDimensions()[0], PictureSize);
      EXPECT_EQ(image->GetDimensions()[1], PictureSize);
    }
    EXPECT_EQ(slices.Color->GetScalarType(), rays.Color->GetScalarType());
    ASSERT_EQ(slices.Depth->GetScalarType(), rays.Depth->GetScalarType());
    const double farthest =
      slices.Depth->GetScalarType() == VTK_FLOAT ? 1.0 : slices.Depth->GetScalarTypeMax();
    double colors = 0.0;
    double distances = 0.0;
    int seen = 0;
    int others = 0;
    for (int pixel = 0; pixel < PictureSize * PictureSize; ++pixel)
    {
      const int x = pixel % PictureSize;
      const int y = pixel / PictureSize;
      for (int i = 0; i < 4; ++i)
      {
        colors += std::abs(slices.Color->GetScalarComponentAsDouble(x, y, 0, i) -
                           rays.Color->GetScalarComponentAsDouble(x, y, 0, i));
      }
      const double depth = slices.Depth->GetScalarComponentAsDouble(x, y, 0, 0) / farthest;
      const double expected = rays.Depth->GetScalarComponentAsDouble(x, y, 0, 0) / farthest;
      if ((depth < 1.0) != (expected < 1.0))
      {
        ++others;
      }
      else if (depth < 1.0)
      {
        ++seen;
        distances += std::abs(this->ToDistance(depth) - this->ToDistance(expected));
      }
    }
    EXPECT_GT(seen, 800);
    EXPECT_AT_MOST(colors / (4.0 * PictureSize * PictureSize), ofColors,
      name + ": mean difference to the ray caster's colours, of 255");
    EXPECT_AT_MOST(distances / seen / this->SampleDistance, ofDepths,
      name + ": mean difference to the ray caster's depth, sample distances");
    EXPECT_AT_MOST(
      others / static_cast<double>(seen), ofPixels, name + ": pixels that but one of both sees");
  }
};

} // namespace

TEST_F(RenderToImage, ColorsAndDepths)
{
  this->ExpectSameImages("images", 0.09, 2.2, 0.009);
  this->ForBoth([](auto* mapper) { mapper->SetDepthImageScalarTypeToUnsignedShort(); });
  this->ExpectSameImages("images with unsigned shorts", 0.09, 2.2, 0.009);
  this->ForBoth(
    [](auto* mapper)
    {
      mapper->SetDepthImageScalarTypeToFloat();
      mapper->SetClampDepthToBackface(1);
    });
  this->ExpectSameImages("images clamped", 0.09, 2.2, 0.0002);
}

TEST_F(RenderToImage, Surfaces)
{
  this->Stage->GetProperty()->GetIsoSurfaceValues()->SetValue(0, 25.0);
  this->ForBoth([](auto* mapper) { mapper->SetBlendModeToIsoSurface(); });
  this->ExpectSameImages("images of a surface", 0.03, 1.6, 0.003);
}

// What is not seen has no depth, and no colour.
TEST_F(RenderToImage, Nothing)
{
  this->Slices->CroppingOn();
  this->Slices->SetCroppingRegionPlanes(70.0, 80.0, 70.0, 80.0, 70.0, 80.0);
  Images images;
  this->Draw(this->Slices, images);
  EXPECT_EQ(images.Color->GetScalarComponentAsDouble(9, 9, 0, 0), 255.0);
  EXPECT_EQ(images.Color->GetScalarComponentAsDouble(9, 9, 0, 3), 0.0);
  EXPECT_EQ(images.Depth->GetScalarComponentAsDouble(9, 9, 0, 0), 1.0);
}

// VTK 9.1 displaces what is behind contours: where nothing is visible in front of them, its own
// picture changes by a mean of 14 of 255.
TEST_F(StormAgainstRayCaster, DepthPassLeavesTheRestAlone)
{
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(25.0, 0.0);
  opacity->AddPoint(26.0, 0.3);
  this->Stage->GetProperty()->SetScalarOpacity(opacity);
  const Picture background = this->Stage->Draw(nullptr);
  const Picture without = this->Stage->Draw(this->Configure(this->Slices));
  this->Slices->UseDepthPassOn();
  this->Slices->GetDepthPassContourValues()->SetValue(0, 25.0);
  const Picture with = this->Stage->Draw(this->Configure(this->Slices));
  EXPECT_EQ(Compare(with, without, background).Worst, 0.0);
}

TEST_F(StormAgainstRayCaster, DepthPassBeginsAtTheContour)
{
  constexpr double place = 3.3;
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(place, 0.0, 0.0);
  plane->SetNormal(-1.0, 0.0, 0.0);
  for (vtkIdType point = 0; point < this->Input->GetNumberOfPoints(); ++point)
  {
    this->Input->GetPointData()->GetScalars()->SetComponent(
      point, 0, this->Input->GetPoint(point)[0]);
  }
  SetUniformFunctions(this->Stage->GetProperty(), 0.02);
  // All rays go along x, and meet the contour.
  this->AimCamera(true);
  this->Stage->GetRenderer()->GetActiveCamera()->SetPosition(90.0, 0.0, 12.0);
  this->Stage->GetRenderer()->ResetCameraClippingRange();
  const Picture background = this->Stage->Draw(nullptr);
  this->Slices->AddClippingPlane(plane);
  const Picture clipped = this->Stage->Draw(this->Configure(this->Slices));
  this->Slices->RemoveAllClippingPlanes();
  this->Slices->UseDepthPassOn();
  this->Slices->GetDepthPassContourValues()->SetValue(0, place);
  const Picture contour = this->Stage->Draw(this->Configure(this->Slices));
  WritePicture(contour, "depth-pass");
  const Difference difference = Compare(contour, clipped, background);
  EXPECT_GT(difference.Pixels, 800);
  EXPECT_AT_MOST(difference.LargestMean(), 0.1, "mean difference to a clipping plane, of 255");
}
