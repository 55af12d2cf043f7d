// SPDX-License-Identifier: BSD-3-Clause
// Leaving out what is invisible changes no pixel: each picture beside the same one drawn with an
// opacity of one in a billion where it was 0, which leaves nothing out.
#include "RendererBound.h"
#include "RenderingTest.h"
#include "Scenes.h"
#include "Tolerance.h"

#include "vtkCamera.h"
#include "vtkCellData.h"
#include "vtkContourValues.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkOpenGLTextureSliceVolumeMapper.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkRectilinearGrid.h"
#include "vtkRenderer.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <array>
#include <memory>

namespace
{

using namespace nexrad::testing;

class SkippedSpace : public RenderingTest
{
protected:
  void SetUp() override
  {
    RenderingTest::SetUp();
    if (IsSkipped() || HasFatalFailure())
    {
      return;
    }
    this->Stage = std::make_unique<Scene>(300, 220);
    this->UseStorm(VTK_FLOAT);
    vtkCamera* camera = this->Stage->GetRenderer()->GetActiveCamera();
    camera->SetFocalPoint(0.0, 0.0, 12.0);
    camera->SetPosition(50.0, -90.0, 70.0);
    camera->SetViewUp(0.0, 0.0, 1.0);
    this->Stage->GetRenderer()->ResetCameraClippingRange(-80, 80, -80, 80, -80, 80);
  }
  void TearDown() override
  {
    this->Stage.reset();
    RenderingTest::TearDown();
  }

  void UseStorm(int scalarType)
  {
    this->Input = MakeStorm(50, scalarType, 31);
    this->Mapper->SetInputData(this->Input);
    SetStormFunctions(this->Stage->GetProperty(), scalarType);
    this->Threshold = scalarType == VTK_FLOAT ? 15.0 : 15.0 + 33.0; // dBZ
  }

  void LookFromInside()
  {
    vtkCamera* camera = this->Stage->GetRenderer()->GetActiveCamera();
    camera->SetPosition(4.0, 2.0, 4.0);
    camera->SetFocalPoint(-10.0, -6.0, 8.0);
    camera->SetViewAngle(70.0);
    camera->SetClippingRange(0.5, 200.0);
  }

  /// Each seventh.
  void HidePoints()
  {
    vtkNew<vtkUnsignedCharArray> ghosts;
    ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
    ghosts->SetNumberOfTuples(this->Input->GetNumberOfPoints());
    ghosts->FillValue(0);
    for (vtkIdType id = 0; id < this->Input->GetNumberOfPoints(); id += 7)
    {
      ghosts->SetValue(id, vtkDataSetAttributes::HIDDENPOINT);
    }
    this->Input->GetPointData()->AddArray(ghosts);
  }

  Picture DrawWith(double opacityOfNothing)
  {
    vtkNew<vtkPiecewiseFunction> opacity;
    opacity->AddPoint(this->Threshold - 60.0, this->ShowsWeak ? 0.6 : opacityOfNothing);
    opacity->AddPoint(this->Threshold, opacityOfNothing);
    opacity->AddPoint(this->Threshold + 40.0, this->ShowsWeak ? opacityOfNothing : 0.6);
    this->Stage->GetProperty()->SetScalarOpacity(opacity);
    return this->Stage->Draw(this->Mapper);
  }

  /// Rounding may move a sample's place a little, where triangles interpolate it from other
  /// corners.
  void ExpectSamePicture(double worst = 1.0)
  {
    for (const bool preIntegration : {false, true})
    {
      this->Mapper->SetPreIntegration(preIntegration);
      this->ExpectSame(worst);
    }
  }

  void ExpectSame(double worst)
  {
    SCOPED_TRACE(this->Mapper->GetPreIntegration() ? "slabs" : "samples");
    const Picture background = this->Stage->Draw(nullptr);
    const Picture skipping = this->DrawWith(0.0);
    const Picture whole = this->DrawWith(1e-9);
    const Difference difference = Compare(skipping, whole, background);
    EXPECT_GT(difference.Pixels, 2000);
    EXPECT_AT_MOST(
      difference.Worst, worst, "largest difference with empty space skipped, of 255", OneCode);
    EXPECT_AT_MOST(difference.LargestMean(), BoundOfRenderer(0.0043, 0.021),
      "mean difference with empty space skipped, of 255",
      "one bound for all scenes: a few pixels round to the next code");
  }

  std::unique_ptr<Scene> Stage;
  vtkSmartPointer<vtkImageData> Input;
  double Threshold = 15.0;
  bool ShowsWeak = false; ///< what is below the threshold, in place of what is above it
  vtkNew<vtkOpenGLTextureSliceVolumeMapper> Mapper;
};

} // namespace

TEST_F(SkippedSpace, Perspective)
{
  this->ExpectSamePicture();
}

TEST_F(SkippedSpace, ParallelBytes)
{
  this->UseStorm(VTK_UNSIGNED_CHAR);
  this->Stage->GetRenderer()->GetActiveCamera()->ParallelProjectionOn();
  this->Stage->GetRenderer()->GetActiveCamera()->SetParallelScale(30.0);
  this->ExpectSamePicture();
}

TEST_F(SkippedSpace, NearestInterpolation)
{
  // A sample half-way between two voxels may fall to either.
  this->Stage->GetProperty()->SetInterpolationTypeToNearest();
  this->ExpectSamePicture(BoundOfRenderer(2.0, 13.0));
}

// The colour from one array, 16 times its width below itself where it has no value; the opacity,
// which alone decides what is left out, from the storm.
TEST_F(SkippedSpace, TwoFields)
{
  vtkDataArray* storm = this->Input->GetPointData()->GetScalars();
  vtkNew<vtkFloatArray> both;
  both->SetNumberOfComponents(2);
  both->SetNumberOfTuples(storm->GetNumberOfTuples());
  for (vtkIdType i = 0; i < storm->GetNumberOfTuples(); ++i)
  {
    both->SetComponent(i, 0, i % 50 < 20 ? -1000.0 : double(i % 50));
    both->SetComponent(i, 1, storm->GetComponent(i, 0));
  }
  this->Input->GetPointData()->SetScalars(both);
  this->Stage->GetProperty()->IndependentComponentsOff();
  this->ExpectSamePicture();
}

TEST_F(SkippedSpace, CellScalars)
{
  vtkNew<vtkImageData> cells;
  cells->SetOrigin(this->Input->GetOrigin());
  cells->SetSpacing(this->Input->GetSpacing());
  cells->SetDimensions(51, 51, 32);
  cells->GetCellData()->SetScalars(this->Input->GetPointData()->GetScalars());
  this->Mapper->SetInputData(cells);
  this->ExpectSamePicture();
}

TEST_F(SkippedSpace, CameraInside)
{
  this->LookFromInside();
  this->ExpectSamePicture();
}

TEST_F(SkippedSpace, TurnedActorInPartOfTheWindow)
{
  this->Stage->GetVolume()->SetScale(1.0, -0.8, 1.5);
  this->Stage->GetVolume()->RotateX(25.0);
  this->Stage->GetRenderer()->SetViewport(0.2, 0.1, 0.93, 0.9);
  this->ExpectSamePicture();
}

TEST_F(SkippedSpace, CropsClipsAndHiddenPoints)
{
  this->HidePoints();
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(-6.0, -6.0, 0.0);
  plane->SetNormal(-0.6, 0.8, 0.1);
  this->Mapper->AddClippingPlane(plane);
  this->Mapper->CroppingOn();
  this->Mapper->SetCroppingRegionPlanes(-14.0, -6.0, -12.0, -4.0, 5.0, 9.0);
  this->Mapper->SetCroppingRegionFlagsToInvertedFence();
  this->ExpectSamePicture(BoundOfRenderer(1.0, 17.0)); // a sample at a cut may fall to either side
}

// The bricks of a rectilinear grid differ in size: those near the origin are a tenth as long as the
// last ones.
TEST_F(SkippedSpace, UnevenGrid)
{
  const int* points = this->Input->GetDimensions();
  vtkNew<vtkRectilinearGrid> grid;
  grid->SetDimensions(points);
  std::array<vtkNew<vtkFloatArray>, 3> coordinates;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double length = (points[axis] - 1) * this->Input->GetSpacing()[axis];
    for (int i = 0; i < points[axis]; ++i)
    {
      const double part = static_cast<double>(i) / (points[axis] - 1);
      coordinates[static_cast<std::size_t>(axis)]->InsertNextValue(
        static_cast<float>(this->Input->GetOrigin()[axis] + length * part * (0.1 + 0.9 * part)));
    }
  }
  grid->SetXCoordinates(coordinates[0]);
  grid->SetYCoordinates(coordinates[1]);
  grid->SetZCoordinates(coordinates[2]);
  grid->GetPointData()->SetScalars(this->Input->GetPointData()->GetScalars());
  this->Mapper->SetInputDataObject(grid);
  this->ExpectSamePicture();
}

TEST_F(SkippedSpace, Extremes)
{
  this->Mapper->SetBlendModeToMaximumIntensity();
  this->ExpectSamePicture();
  this->Mapper->SetBlendModeToMinimumIntensity();
  this->ShowsWeak = true;
  this->ExpectSamePicture();
}

// Sums of 0 are black wherever there are samples, as where nothing is left out.
TEST_F(SkippedSpace, Sums)
{
  this->Mapper->SetBlendModeToAdditive();
  this->ExpectSame(1.0);
  this->Stage->GetRenderer()->SetBackground(0.2, 0.4, 0.8);
  this->ExpectSame(1.0);
}

// Nothing is opaque: the whole box is black.
TEST_F(SkippedSpace, SumsOfNothing)
{
  this->Mapper->SetBlendModeToAdditive();
  this->Threshold = 200.0;
  this->Stage->GetRenderer()->SetBackground(0.2, 0.4, 0.8);
  this->ExpectSame(0.0);
}

TEST_F(SkippedSpace, SumsWithCropsAndHiddenPoints)
{
  this->HidePoints();
  this->Mapper->CroppingOn();
  this->Mapper->SetCroppingRegionPlanes(-14.0, -6.0, -12.0, -4.0, 5.0, 9.0);
  this->Mapper->SetCroppingRegionFlagsToInvertedFence();
  this->Mapper->SetBlendModeToAdditive();
  this->Stage->GetRenderer()->SetBackground(0.2, 0.4, 0.8);
  this->ExpectSame(BoundOfRenderer(1.0, 37.0));
}

// Further iso-values that are clear change no pixel, but leave hardly a brick out.
TEST_F(SkippedSpace, Isosurfaces)
{
  this->Mapper->SetBlendModeToIsoSurface();
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(29.0, 0.0);
  opacity->AddPoint(30.0, 0.7);
  this->Stage->GetProperty()->SetScalarOpacity(opacity);
  this->Stage->GetProperty()->ShadeOn();
  const Picture background = this->Stage->Draw(nullptr);
  vtkContourValues* values = this->Stage->GetProperty()->GetIsoSurfaceValues();
  for (const bool inside : {false, true})
  {
    if (inside)
    {
      this->LookFromInside();
    }
    values->SetNumberOfContours(2);
    values->SetValue(0, 31.0);
    values->SetValue(1, 45.0);
    const Picture skipping = this->Stage->Draw(this->Mapper);
    for (int i = 2; i < 14; ++i)
    {
      values->SetValue(i, 4.0 * (i - 2) - 32.0 + 0.1);
    }
    const Picture whole = this->Stage->Draw(this->Mapper);
    const Difference difference = Compare(skipping, whole, background);
    EXPECT_GT(difference.Pixels, 2000);
    EXPECT_AT_MOST(difference.Worst, BoundOfRenderer(5.0, 59.0),
      "isosurfaces with empty space skipped, of 255",
      "where a ray grazes a surface, rounding moves the hit");
    EXPECT_AT_MOST(difference.LargestMean(), BoundOfRenderer(0.00028, 0.007),
      "mean difference of isosurfaces with empty space skipped");
  }
}

// Opaque above 30 dBZ where the gradient is large.
TEST_F(SkippedSpace, TwoDimensionalFunctions)
{
  const auto draw = [&](float opacityOfNothing)
  {
    vtkNew<vtkImageData> function;
    function->SetDimensions(64, 16, 1);
    function->AllocateScalars(VTK_FLOAT, 4);
    auto* entry = static_cast<float*>(function->GetScalarPointer());
    for (int i = 0; i < 64 * 16; ++i, entry += 4)
    {
      const bool seen = i % 64 > 40 && i / 64 > 2;
      entry[0] = 0.9f;
      entry[1] = static_cast<float>(i % 64) / 64.0f;
      entry[2] = 0.3f;
      entry[3] = seen ? 0.6f : opacityOfNothing;
    }
    this->Stage->GetProperty()->SetTransferFunction2D(function);
    return this->Stage->Draw(this->Mapper);
  };
  const Picture background = this->Stage->Draw(nullptr);
  const Picture skipping = draw(0.0f);
  const Difference difference = Compare(skipping, draw(1e-9f), background);
  EXPECT_GT(difference.Pixels, 1000);
  EXPECT_AT_MOST(difference.Worst, BoundOfRenderer(1.0, 3.0),
    "two-dimensional functions with empty space skipped, of 255", OneCode);
}
