// SPDX-License-Identifier: BSD-3-Clause
// Every blend mode beside VTK's GPU ray caster.
#include "RayCasterComparison.h"
#include "Scenes.h"
#include "Tolerance.h"

#include "vtkActor.h"
#include "vtkCellData.h"
#include "vtkColorTransferFunction.h"
#include "vtkContourValues.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkPolyDataMapper.h"
#include "vtkRenderer.h"
#include "vtkSphere.h"
#include "vtkSphereSource.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <initializer_list>
#include <string>

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
  /// The storm as scalars of cells.
  void UseCells()
  {
    vtkSmartPointer<vtkImageData> points = this->Input;
    this->Input = vtkSmartPointer<vtkImageData>::New();
    this->Input->SetOrigin(points->GetOrigin());
    this->Input->SetSpacing(points->GetSpacing());
    const int* n = points->GetDimensions();
    this->Input->SetDimensions(n[0] + 1, n[1] + 1, n[2] + 1);
    this->Input->GetCellData()->SetScalars(points->GetPointData()->GetScalars());
  }
  void UseSlice()
  {
    this->Use(vtkVolumeMapper::SLICE_BLEND);
    this->UseRamp(0.2, 1.0);
    vtkNew<vtkPlane> plane;
    plane->SetOrigin(0.0, -6.0, 8.0);
    plane->SetNormal(0.2, -1.0, 0.3);
    this->Stage->GetProperty()->SetSliceFunction(plane);
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
  this->SampleDistance /= 4.0; // else it is chance which mapper finds a surface that a ray grazes
  this->Use(vtkVolumeMapper::ISOSURFACE_BLEND);
  this->Stage->GetProperty()->GetIsoSurfaceValues()->SetValue(0, 25.0);
  this->Stage->GetProperty()->GetIsoSurfaceValues()->SetValue(1, 45.0);
  this->UseRamp(0.0, 0.8);
  this->ExpectSamePicture("storm-isosurfaces", 0.15);
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

// A slanting plane through the towers. Scalars of cells: VTK 9.1 takes the fraction of the box for
// the texture coordinate here, which is displaced by up to half a point for scalars of points.
TEST_F(BlendModes, Slice)
{
  this->UseCells();
  this->UseSlice();
  this->ExpectSamePictureAndBaseline("storm-slice", "Slice", 0.078);
  this->Stage->GetVolume()->SetPosition(3.0, 2.0, -2.0);
  this->Stage->GetVolume()->RotateZ(30.0);
  this->ExpectSamePicture("storm-slice-turned", 0.08);
  this->Stage->GetProperty()->ShadeOn();
  this->ExpectSamePicture("storm-slice-lit", 0.03);
}

// The plane cut by the cropping planes.
TEST_F(BlendModes, CroppedSlice)
{
  this->UseCells();
  this->UseSlice();
  this->ForBoth(
    [](vtkGPUVolumeRayCastMapper* mapper)
    {
      mapper->CroppingOn();
      mapper->SetCroppingRegionPlanes(-20.0, 8.0, -25.0, 12.0, 2.0, 20.0);
      mapper->SetCroppingRegionFlagsToSubVolume();
    });
  this->ExpectSamePicture("storm-slice-cropped", 0.2);
}

// A ball before the plane and in it.
TEST_F(BlendModes, SliceWithABall)
{
  this->UseCells();
  this->UseSlice();
  vtkNew<vtkSphereSource> sphere;
  sphere->SetCenter(-5.0, -12.0, 12.0);
  sphere->SetRadius(9.0);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(sphere->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  this->Stage->GetRenderer()->AddActor(actor);
  this->ExpectSamePicture("storm-slice-ball", 0.035);
}

// Each point of the plane has the colour and the opacity of its scalar: a plane of constant height
// through a volume whose scalar is the height.
TEST_F(BlendModes, SliceOfTheHeight)
{
  const int* n = this->Input->GetDimensions();
  vtkDataArray* scalars = this->Input->GetPointData()->GetScalars();
  for (vtkIdType id = 0; id < scalars->GetNumberOfTuples(); ++id)
  {
    scalars->SetComponent(id, 0, double(id / (vtkIdType(n[0]) * n[1])) / (n[2] - 1));
  }
  scalars->Modified();
  vtkNew<vtkColorTransferFunction> color;
  color->AddRGBPoint(0.0, 0.0, 1.0, 0.0);
  color->AddRGBPoint(1.0, 1.0, 0.0, 0.5);
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(0.0, 0.0);
  opacity->AddPoint(1.0, 1.0);
  this->Stage->GetProperty()->SetColor(color);
  this->Stage->GetProperty()->SetScalarOpacity(opacity);
  vtkNew<vtkPlane> plane;
  const double* bounds = this->Input->GetBounds();
  plane->SetOrigin(0.0, 0.0, bounds[4] + 0.75 * (bounds[5] - bounds[4]));
  plane->SetNormal(0.0, 0.0, 1.0);
  this->Stage->GetProperty()->SetSliceFunction(plane);
  this->Slices->SetBlendMode(vtkVolumeMapper::SLICE_BLEND);
  const Color pixel =
    PixelAt(this->Stage->Draw(this->Configure(this->Slices)), PictureSize / 2, PictureSize / 2);
  const Color expected{0.75 * 0.75 * 255.0, 0.75 * 0.25 * 255.0, 0.75 * 0.375 * 255.0};
  for (const std::size_t c : {0, 1, 2})
  {
    EXPECT_WITHIN(pixel[c], expected[c], 1.0, "colour of a slice, of 255", OneCode);
  }
}

TEST_F(BlendModes, SliceWithoutAPlaneIsRefusedOnce)
{
  this->Slices->SetBlendMode(vtkVolumeMapper::SLICE_BLEND);
  vtkNew<vtkSphere> sphere;
  vtkNew<vtkPlane> plane;
  plane->SetNormal(0.0, 0.0, 0.0);
  for (vtkImplicitFunction* function :
    std::initializer_list<vtkImplicitFunction*>{nullptr, sphere, plane})
  {
    this->Stage->GetProperty()->SetSliceFunction(function);
    EXPECT_FALSE(
      this->Slices->IsRenderSupported(this->Stage->GetWindow(), this->Stage->GetProperty()));
  }
  this->Stage->Draw(this->Configure(this->Slices));
  EXPECT_NE(this->TakeMessages().find("slice blending needs a vtkPlane"), std::string::npos);
  this->Stage->Draw(this->Slices);
  EXPECT_EQ(this->TakeMessages(), "");
}
