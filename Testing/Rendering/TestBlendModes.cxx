// SPDX-License-Identifier: BSD-3-Clause
// Every blend mode beside VTK's GPU ray caster.
#include "RayCasterComparison.h"
#include "Scenes.h"

#include "vtkContourValues.h"
#include "vtkImageData.h"
#include "vtkPiecewiseFunction.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

namespace
{

using namespace nexrad::testing;

class BlendModes : public StormAgainstRayCaster
{
protected:
  void Use(vtkVolumeMapper::BlendModes mode)
  {
    this->ForBoth([mode](vtkGPUVolumeRayCastMapper* mapper) { mapper->SetBlendMode(mode); });
  }
  /// An opacity that grows with the scalar from the least one on.
  void UseRamp(double least, double most)
  {
    vtkNew<vtkPiecewiseFunction> opacity;
    opacity->AddPoint(-33.0, least);
    opacity->AddPoint(66.0, most);
    this->Stage->GetProperty()->SetScalarOpacity(opacity);
  }
};

} // namespace

// The cores as bright discs on the flat colour of the anvils: no depth.
TEST_F(BlendModes, Maximum)
{
  this->Use(vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND);
  this->ExpectSamePictureAndBaseline("storm-maximum", "Maximum", 0.058);
}

// The same from bytes and from signed shorts.
TEST_F(BlendModes, MaximumOfIntegers)
{
  this->Use(vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND);
  this->UseStorm(VTK_UNSIGNED_CHAR);
  this->ExpectSamePicture("storm-maximum-uint8", 0.44);
  this->UseStorm(VTK_SHORT);
  this->ExpectSamePicture("storm-maximum-int16", 0.059);
}

// The same between voxels that are not interpolated: blocks.
TEST_F(BlendModes, MaximumOfBlocks)
{
  this->UseStorm(VTK_FLOAT, 16);
  this->Stage->GetProperty()->SetInterpolationTypeToNearest();
  this->Use(vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND);
  this->ExpectSamePicture("storm-maximum-nearest", 0.23);
}

// The same from within the cropped middle: what is cut away does not count.
TEST_F(BlendModes, MaximumOfTheCroppedMiddle)
{
  this->Use(vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND);
  this->Crop({-20.0, 8.0, -25.0, 12.0, 2.0, 20.0}, VTK_CROP_SUBVOLUME);
  this->ExpectSamePicture("storm-maximum-cropped", 0.12);
}

// Everything is as bright as the least scalar on its ray: the whole box, faintly, darker rays none.
TEST_F(BlendModes, Minimum)
{
  this->Use(vtkVolumeMapper::MINIMUM_INTENSITY_BLEND);
  this->UseRamp(0.3, 1.0);
  this->ExpectSamePictureAndBaseline("storm-minimum", "Minimum", 0.75);
}

// Grey: the mean over each ray, brightest through the towers.
TEST_F(BlendModes, Average)
{
  this->Use(vtkVolumeMapper::AVERAGE_INTENSITY_BLEND);
  this->UseRamp(0.2, 1.0);
  this->ExpectSamePictureAndBaseline("storm-average", "Average", 0.51);
}

// Grey: the mean of the echo alone, so the towers are no brighter than their shares of the ray;
// rays without echo show nothing.
TEST_F(BlendModes, AverageOfPartOfTheRange)
{
  this->Use(vtkVolumeMapper::AVERAGE_INTENSITY_BLEND);
  this->UseRamp(0.2, 1.0);
  this->ForBoth(
    [](vtkGPUVolumeRayCastMapper* mapper) { mapper->SetAverageIPScalarRange(10.0, 100.0); });
  this->ExpectSamePicture("storm-average-range", 0.69);
}

// Grey: the sum over each ray, like an X-ray picture of the storm.
TEST_F(BlendModes, Additive)
{
  this->Use(vtkVolumeMapper::ADDITIVE_BLEND);
  this->UseRamp(0.0, 0.05);
  this->ExpectSamePictureAndBaseline("storm-additive", "Additive", 0.16);
}

// Two shells, 25 and 45 dBZ, the inner one seen through the outer one.
TEST_F(BlendModes, Isosurfaces)
{
  this->Use(vtkVolumeMapper::ISOSURFACE_BLEND);
  this->Stage->GetProperty()->GetIsoSurfaceValues()->SetValue(0, 25.0);
  this->Stage->GetProperty()->GetIsoSurfaceValues()->SetValue(1, 45.0);
  this->UseRamp(0.0, 0.8);
  this->ExpectSamePicture("storm-isosurfaces", 0.55);
}

// The same shells, lit.
TEST_F(BlendModes, ShadedIsosurfaces)
{
  this->Use(vtkVolumeMapper::ISOSURFACE_BLEND);
  this->Stage->GetProperty()->GetIsoSurfaceValues()->SetValue(0, 45.0);
  this->Stage->GetProperty()->GetIsoSurfaceValues()->SetValue(1, 25.0);
  this->Stage->GetProperty()->ShadeOn();
  this->UseRamp(0.0, 0.8);
  this->ExpectSamePictureAndBaseline("storm-isosurfaces-shaded", "IsosurfacesShaded", Bar);
}

TEST_F(BlendModes, IsosurfacesWithoutValuesAreNothing)
{
  this->Slices->SetBlendModeToIsoSurface();
  const Picture background = this->Stage->Draw(nullptr);
  const Picture picture = this->Stage->Draw(this->Configure(this->Slices));
  EXPECT_EQ(Compare(picture, background, background).Pixels, 0);
}
