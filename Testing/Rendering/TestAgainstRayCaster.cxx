// SPDX-License-Identifier: BSD-3-Clause
// The slices beside VTK's own GPU ray caster: same volume, camera and distance between samples.
#include "RayCasterComparison.h"
#include "Scenes.h"
#include "Tolerance.h"

#include "vtkCamera.h"
#include "vtkCellData.h"
#include "vtkColorTransferFunction.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkImageResize.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <cmath>

using namespace nexrad::testing;

// Two storm towers over a pale layer, the left one taller with a broad anvil; red and magenta
// cores.
TEST_F(AgainstRayCaster, PerspectiveFloat)
{
  this->UseStorm(VTK_FLOAT);
  this->AimCamera(false);
  this->ExpectSamePictureAndBaseline("storm-perspective-float", "Composite", 0.2);
}

// The same without perspective.
TEST_F(AgainstRayCaster, ParallelFloat)
{
  this->UseStorm(VTK_FLOAT);
  this->AimCamera(true);
  this->ExpectSamePictureAndBaseline("storm-parallel-float", "Parallel", 0.22);
}

// The same from bytes, one for each dBZ.
TEST_F(AgainstRayCaster, PerspectiveBytes)
{
  this->UseStorm(VTK_UNSIGNED_CHAR);
  this->AimCamera(false);
  this->ExpectSamePictureAndBaseline("storm-perspective-uint8", "Bytes", 1.4);
}

// Blocks of half as many voxels, each of one colour.
TEST_F(AgainstRayCaster, NearestInterpolation)
{
  this->UseStorm(VTK_FLOAT, 24);
  this->Stage->GetProperty()->SetInterpolationTypeToNearest();
  this->AimCamera(false);
  this->ExpectSamePictureAndBaseline("storm-nearest", "Nearest", 1.0);
}

// Stretched to twice its height, tipped towards the viewer and moved.
TEST_F(AgainstRayCaster, ActorMatrix)
{
  this->UseStorm(VTK_FLOAT);
  this->Stage->GetVolume()->SetScale(1.0, 0.8, 2.0);
  this->Stage->GetVolume()->RotateX(25.0);
  this->Stage->GetVolume()->SetPosition(4.0, 0.0, -6.0);
  this->AimCamera(false);
  this->ExpectSamePictureAndBaseline("storm-actor-matrix", "ActorMatrix", 0.16);
}

// Turned about the origin of the image by its direction matrix: shifted up and to the left.
TEST_F(AgainstRayCaster, DirectionMatrix)
{
  this->UseStorm(VTK_FLOAT);
  const double a = 0.5;
  this->Input->SetDirectionMatrix(
    std::cos(a), -std::sin(a), 0.0, std::sin(a), std::cos(a), 0.0, 0.0, 0.0, 1.0);
  this->AimCamera(false);
  this->ExpectSamePictureAndBaseline("storm-direction-matrix", "DirectionMatrix", 0.21);
}

TEST_F(AgainstRayCaster, FunctionsWithoutPoints)
{
  // Ramps over the scalars: grey fog that is thinnest where there is no echo. The slices come
  // first, because VTK's ray caster writes its ramps into the functions.
  this->UseStorm(VTK_FLOAT);
  this->AimCamera(false);
  vtkVolumeProperty* property = this->Stage->GetProperty();
  property->GetRGBTransferFunction()->RemoveAllPoints();
  property->GetScalarOpacity()->RemoveAllPoints();
  const Picture background = this->Stage->Draw(nullptr);
  const Picture actual = this->Stage->Draw(this->Configure(this->Slices));
  EXPECT_EQ(property->GetScalarOpacity()->GetSize(), 0);
  const Picture expected = this->Stage->Draw(this->Configure(this->RayCaster));
  const Difference difference = Compare(actual, expected, background);
  EXPECT_GT(difference.Pixels, 2500);
  EXPECT_AT_MOST(
    difference.LargestMean(), Allowed(0.5), "mean difference to the ray caster, of 255");
}

TEST_F(AgainstRayCaster, MirroredActor)
{
  this->UseStorm(VTK_FLOAT);
  this->Stage->GetVolume()->SetScale(-1.0, 1.0, 1.0);
  this->AimCamera(false);
  this->ExpectSamePicture("storm-mirrored", 0.21);
}

// The storm of few layers and columns, many rows: soft across, sharp along.
TEST_F(AgainstRayCaster, VoxelsOfVeryUnequalEdges)
{
  // 96 x 24 x 12 points over the same box: voxels of 0.7 x 2.8 x 2.2.
  this->UseStorm(VTK_FLOAT);
  vtkNew<vtkImageResize> resize;
  resize->SetInputData(this->Input);
  resize->SetOutputDimensions(96, 24, 12);
  resize->Update();
  this->Input = resize->GetOutput();
  this->AimCamera(false);
  this->ExpectSamePictureAndBaseline("storm-unequal-voxels", "UnequalVoxels", 0.17);
}

TEST_F(AgainstRayCaster, OriginAndExtentThatDoNotStartAtZero)
{
  this->UseStorm(VTK_FLOAT);
  int extent[6];
  double origin[3];
  double spacing[3];
  this->Input->GetExtent(extent);
  this->Input->GetOrigin(origin);
  this->Input->GetSpacing(spacing);
  this->Input->SetExtent(7, extent[1] + 7, -3, extent[3] - 3, 5, extent[5] + 5);
  this->Input->SetOrigin(
    origin[0] - 7 * spacing[0], origin[1] + 3 * spacing[1], origin[2] - 5 * spacing[2]);
  this->AimCamera(false);
  this->ExpectSamePicture("storm-extent", 0.2);
}

// The storm held by cells.
TEST_F(AgainstRayCaster, CellScalars)
{
  vtkSmartPointer<vtkImageData> points = MakeStorm(48, VTK_FLOAT);
  SetStormFunctions(this->Stage->GetProperty(), VTK_FLOAT);
  this->Input = vtkSmartPointer<vtkImageData>::New();
  this->Input->SetOrigin(points->GetOrigin());
  this->Input->SetSpacing(points->GetSpacing());
  this->Input->SetDimensions(49, 49, 25);
  this->Input->GetCellData()->SetScalars(points->GetPointData()->GetScalars());
  this->AimCamera(false);
  this->ExpectSamePictureAndBaseline("storm-cells", "CellScalars", 0.2);
}

TEST_F(AgainstRayCaster, CroppingToTheMiddle)
{
  this->UseStorm(VTK_FLOAT);
  this->Crop({-20.0, 8.0, -25.0, 12.0, 2.0, 20.0}, VTK_CROP_SUBVOLUME);
  this->AimCamera(false);
  this->ExpectSamePicture("storm-cropped", 0.57);
}

// What is left in the corners of the box: pieces of the layer and of the anvil, cut straight.
TEST_F(AgainstRayCaster, CroppingToEightCorners)
{
  // The regions of the volume's corners alone: bits 0, 2, 6, 8 and the same above, 18 further.
  this->UseStorm(VTK_FLOAT);
  this->Crop({-14.0, -6.0, -12.0, -4.0, 5.0, 9.0}, 0x145 | (0x145 << 18));
  this->AimCamera(false);
  this->ExpectSamePictureAndBaseline("storm-corners", "CroppedCorners", 0.67);
}

// Cut open upright through the tall tower: its magenta core on the cut.
TEST_F(AgainstRayCaster, ClippingPlane)
{
  // As many points along z as along x and y: else the displacement that RayCasterCut undoes also
  // bends the ray caster's rays where the plane cuts them.
  this->Input = MakeStorm(48, VTK_FLOAT, 48);
  SetStormFunctions(this->Stage->GetProperty(), VTK_FLOAT);
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(-6.0, -6.0, 0.0);
  plane->SetNormal(-0.6, 0.8, 0.0);
  vtkNew<vtkPlane> rayCasterPlane;
  rayCasterPlane->SetOrigin(
    this->RayCasterCut(-6.0, 0), this->RayCasterCut(-6.0, 1), this->RayCasterCut(0.0, 2));
  rayCasterPlane->SetNormal(plane->GetNormal());
  this->RayCaster->AddClippingPlane(rayCasterPlane);
  this->Slices->AddClippingPlane(plane);
  this->AimCamera(false);
  this->ExpectSamePictureAndBaseline("storm-clipped", "Clipped", 1.3);
}

// From within the storm, towards the tall tower: everything is covered.
TEST_F(AgainstRayCaster, CameraInside)
{
  this->UseStorm(VTK_FLOAT);
  vtkRenderer* renderer = this->Stage->GetRenderer();
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(4.0, 2.0, 4.0);
  camera->SetFocalPoint(-10.0, -6.0, 8.0);
  camera->SetViewUp(0.0, 0.0, 1.0);
  camera->SetViewAngle(60.0);
  camera->SetClippingRange(0.5, 200.0);
  // The storm is opaque from here; VTK's rays stop one 255th short of that, at each channel's cost.
  this->ExpectSamePictureAndBaseline("storm-inside", "CameraInside", Bar);
}

TEST_F(AgainstRayCaster, CameraInsideAStretchedVolume)
{
  this->UseStorm(VTK_FLOAT);
  this->Stage->GetVolume()->SetScale(2.0, 0.5, 3.0);
  vtkRenderer* renderer = this->Stage->GetRenderer();
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(20.0, 2.0, 20.0);
  camera->SetFocalPoint(-20.0, -3.0, 24.0);
  camera->SetViewUp(0.0, 0.0, 1.0);
  camera->SetViewAngle(60.0);
  camera->SetClippingRange(0.5, 300.0);
  this->ExpectSamePicture("storm-inside-stretched", 0.82);
}

TEST_F(AgainstRayCaster, OpaqueEverywhere)
{
  // Rays end early in both; here at 1023/1024, there at 254/255.
  this->UseStorm(VTK_FLOAT);
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(0.0, 0.5);
  this->Stage->GetProperty()->SetScalarOpacity(opacity);
  this->AimCamera(false);
  this->ExpectSamePicture("storm-opaque", Bar);
}

// The storm in harder contrast.
TEST_F(AgainstRayCaster, FinalWindowAndLevel)
{
  this->UseStorm(VTK_FLOAT);
  this->ForBoth(
    [](vtkGPUVolumeRayCastMapper* mapper)
    {
      mapper->SetFinalColorWindow(0.7f);
      mapper->SetFinalColorLevel(0.4f);
    });
  this->AimCamera(false);
  this->ExpectSamePictureAndBaseline("storm-window-level", "WindowLevel", 0.26);
}

TEST_F(AgainstRayCaster, DifferenceIsNoticed)
{
  // The measure itself: half of the opacity, or a camera turned by one degree, must not pass.
  this->UseStorm(VTK_FLOAT);
  this->AimCamera(false);
  const Picture background = this->Stage->Draw(nullptr);
  const Picture expected = this->Stage->Draw(this->Configure(this->RayCaster));
  this->Stage->GetProperty()->SetScalarOpacityUnitDistance(2.0);
  const Picture thinner = this->Stage->Draw(this->Configure(this->Slices));
  EXPECT_GT(Compare(thinner, expected, background).LargestMean(), Tolerance);
  EXPECT_GT(BaselineError(thinner, "Composite"), BaselineTolerance);
  this->Stage->GetProperty()->SetScalarOpacityUnitDistance(1.0);
  this->Stage->GetRenderer()->GetActiveCamera()->Azimuth(1.0);
  const Picture turned = this->Stage->Draw(this->Configure(this->Slices));
  EXPECT_GT(Compare(turned, expected, background).LargestMean(), Tolerance);
  EXPECT_GT(BaselineError(turned, "Composite"), BaselineTolerance);
  EXPECT_GT(BaselineError(turned, "no such picture"), BaselineTolerance);
}
