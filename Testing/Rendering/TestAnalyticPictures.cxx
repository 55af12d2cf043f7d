// SPDX-License-Identifier: BSD-3-Clause
// Pictures whose pixels can be worked out by hand: uniform cubes.
#include "RenderingTest.h"
#include "Scenes.h"
#include "Tolerance.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCellData.h"
#include "vtkContourValues.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkOpenGLTextureSliceVolumeMapper.h"
#include "vtkPlane.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

namespace
{

using namespace nexrad::testing;

constexpr int Size = 128;        // pixels of the window along each side
constexpr double Edge = 8.0;     // of the cube, from the origin on
constexpr double Opacity = 0.12; // of one unit

/// What a white volume of that opacity adds to a black pixel after a path of that length.
double Brightness(double path)
{
  return 255.0 * (1.0 - std::pow(1.0 - Opacity, path));
}

class AnalyticPictures : public RenderingTest
{
protected:
  void SetUp() override
  {
    RenderingTest::SetUp();
    if (!IsSkipped() && !HasFatalFailure())
    {
      this->Start(0);
    }
  }
  void TearDown() override
  {
    this->Stage.reset();
    RenderingTest::TearDown();
  }

  void Start(int multiSamples)
  {
    this->Stage = std::make_unique<Scene>(Size, Size, multiSamples);
    this->Input = MakeUniformCube(int(Edge) + 1, 1.0f);
    this->Mapper->SetInputData(this->Input);
    SetUniformFunctions(this->Stage->GetProperty(), Opacity);
    this->LookAlongZ();
  }

  /// Face on from 20 above the middle of the upper face; the view is 10 high at the focal point.
  void LookAlongZ()
  {
    vtkCamera* camera = this->Stage->GetRenderer()->GetActiveCamera();
    camera->SetFocalPoint(Edge / 2, Edge / 2, Edge / 2);
    camera->SetPosition(Edge / 2, Edge / 2, Edge + 20.0);
    camera->SetViewUp(0.0, 1.0, 0.0);
    camera->SetParallelScale(5.0);
    camera->ParallelProjectionOn();
    camera->SetClippingRange(1.0, 60.0);
  }

  void LookAlongX()
  {
    vtkCamera* camera = this->Stage->GetRenderer()->GetActiveCamera();
    camera->SetPosition(Edge + 20.0, Edge / 2, Edge / 2);
    camera->SetViewUp(0.0, 0.0, 1.0);
  }

  Picture Draw() { return this->Stage->Draw(this->Mapper); }

  /// Flags of the points or cells whose first index is below 4, so many of them along an axis.
  static vtkSmartPointer<vtkUnsignedCharArray> FlagLowX(int count, unsigned char flag)
  {
    auto ghosts = vtkSmartPointer<vtkUnsignedCharArray>::New();
    ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
    ghosts->SetNumberOfTuples(static_cast<vtkIdType>(count) * count * count);
    for (vtkIdType id = 0; id < ghosts->GetNumberOfTuples(); ++id)
    {
      ghosts->SetValue(id, id % count < 4 ? flag : 0);
    }
    return ghosts;
  }

  /// Seen from above, everything is there from that x on, and nothing before.
  void ExpectToBeginAt(double x)
  {
    const Picture above = this->Draw();
    const double pixelsPerUnit = Size / 10.0;
    const auto at = [&](double place)
    { return PixelAt(above, int(std::floor((place + 1.0) * pixelsPerUnit)), 64)[0]; };
    EXPECT_EQ(at(2.0), 0.0);
    EXPECT_EQ(at(x - 0.1), 0.0);
    for (const double place : {x + 0.1, 7.9})
    {
      EXPECT_WITHIN(
        at(place), Brightness(Edge), 1.0, "brightness beside hidden points, of 255", OneCode);
    }
  }

  /// Hides the points with x below 4 by a ghost array; their scalars are far off.
  void HideLowX()
  {
    for (vtkIdType id = 0; id < this->Input->GetNumberOfPoints(); ++id)
    {
      if (id % (int(Edge) + 1) < 4)
      {
        this->Input->GetPointData()->GetScalars()->SetComponent(id, 0, -1e30);
      }
    }
    this->Input->GetPointData()->AddArray(
      FlagLowX(int(Edge) + 1, vtkDataSetAttributes::HIDDENPOINT));
  }

  /// The same cube of voxels an eighth as high as wide, its scalars those of y; points above a
  /// slanted plane are hidden.
  void HideAboveSlope()
  {
    constexpr int flat = 8; // voxels in the height of one
    vtkNew<vtkImageData> slope;
    slope->SetDimensions(int(Edge) + 1, int(Edge) + 1, flat * int(Edge) + 1);
    slope->SetSpacing(1.0, 1.0, 1.0 / flat);
    slope->AllocateScalars(VTK_FLOAT, 1);
    vtkNew<vtkUnsignedCharArray> ghosts;
    ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
    for (vtkIdType id = 0; id < slope->GetNumberOfPoints(); ++id)
    {
      double point[3];
      slope->GetPoint(id, point);
      const bool isHidden = point[2] > SlopeAt(point[0]);
      ghosts->InsertNextValue(isHidden ? vtkDataSetAttributes::HIDDENPOINT : 0);
      slope->GetPointData()->GetScalars()->SetComponent(id, 0, isHidden ? -5.0 : point[1]);
    }
    slope->GetPointData()->AddArray(ghosts);
    this->Input = slope;
    this->Mapper->SetInputData(slope);
  }

  /// Height of the highest visible point.
  static double SlopeAt(double x) { return 2.0 + 0.5 * x; }

  std::unique_ptr<Scene> Stage;
  vtkSmartPointer<vtkImageData> Input;
  vtkNew<vtkOpenGLTextureSliceVolumeMapper> Mapper;
};

} // namespace

TEST_F(AnalyticPictures, CubeFaceOnHasItsOpacityWhateverTheSliceCount)
{
  for (const int slices : {1, 64, 128, 256, 512, 1024, 4096})
  {
    this->Mapper->SetNumberOfSlices(slices);
    const Picture picture = this->Draw();
    EXPECT_EQ(this->Mapper->GetNumberOfDrawnSlices(), slices);
    for (const double channel : PixelAt(picture, Size / 2, Size / 2))
    {
      EXPECT_WITHIN(
        channel, Brightness(Edge), 1.0, "brightness of the cube's middle, of 255", OneCode)
        << slices << " slices";
    }
    // The cube is 8 of the 10 units that the picture shows.
    EXPECT_WITHIN(PixelAt(picture, 15, Size / 2)[0], Brightness(Edge), 1.0,
      "brightness of the cube's edge, of 255", OneCode);
    EXPECT_EQ(PixelAt(picture, 11, Size / 2)[0], 0.0);
  }
}

TEST_F(AnalyticPictures, OpaqueCubeIsWholeWhateverTheSliceCount)
{
  // 0.6 of a unit: after 8 units 0.07 % are missing. Rays end where less than 0.1 % is.
  SetUniformFunctions(this->Stage->GetProperty(), 0.6);
  for (const bool perspective : {false, true})
  {
    this->Stage->GetRenderer()->GetActiveCamera()->SetParallelProjection(!perspective);
    for (const int slices : {40, 256, 1024})
    {
      this->Mapper->SetNumberOfSlices(slices);
      EXPECT_WITHIN(PixelAt(this->Draw(), Size / 2, Size / 2)[0], 254.8, 0.9,
        "brightness of an opaque cube, of 255", OneCode)
        << slices << " slices";
    }
  }
}

TEST_F(AnalyticPictures, UnitDistanceScalesTheOpacity)
{
  this->Stage->GetProperty()->SetScalarOpacityUnitDistance(2.5);
  EXPECT_WITHIN(PixelAt(this->Draw(), 64, 64)[0], Brightness(Edge / 2.5), 1.0,
    "brightness at another unit distance, of 255", OneCode);
}

TEST_F(AnalyticPictures, PerspectiveRaysHaveTheirOwnLength)
{
  // Formulas R1. From 20 above the upper face, a pixel p away from the middle of the picture looks
  // p/64 * tan(half of the view angle) off the axis: its path through the cube is so much longer.
  vtkCamera* camera = this->Stage->GetRenderer()->GetActiveCamera();
  camera->ParallelProjectionOff();
  camera->SetPosition(Edge / 2, Edge / 2, Edge + 3.0);
  camera->SetViewAngle(50.0);
  camera->SetClippingRange(0.5, 60.0);
  const double slope = std::tan(vtkMath::RadiansFromDegrees(25.0)) / (Size / 2);
  this->Mapper->SetNumberOfSlices(256);
  const Picture picture = this->Draw();
  for (const int offset : {0, 8, 16, 24})
  {
    const double tangent = (offset + 0.5) * slope; // pixels have their centre half a pixel off
    const double path = Edge * std::sqrt(1.0 + 2.0 * tangent * tangent);
    ASSERT_LT(tangent * (Edge + 3.0), Edge / 2) << "the ray must leave through the lower face";
    EXPECT_WITHIN(PixelAt(picture, 64 + offset, 64 + offset)[0], Brightness(path), 1.0,
      "brightness in perspective, of 255", OneCode)
      << offset;
  }
}

TEST_F(AnalyticPictures, DiagonalPathAtManySlices)
{
  // Along the diagonal of two axes the middle ray is sqrt(2) edges long.
  vtkCamera* camera = this->Stage->GetRenderer()->GetActiveCamera();
  camera->SetPosition(Edge / 2 + 20.0, Edge / 2, Edge / 2 + 20.0);
  for (const int slices : {256, 1024})
  {
    this->Mapper->SetNumberOfSlices(slices);
    EXPECT_WITHIN(PixelAt(this->Draw(), 63, 64)[0], Brightness(Edge * std::sqrt(2.0)), 1.9,
      "brightness along the diagonal, of 255");
  }
}

TEST_F(AnalyticPictures, OpaqueGeometryHidesWhatIsBehind)
{
  for (const int multiSamples : {0, 4})
  {
    // A blue square in the middle of the cube covers the picture's right half.
    this->Start(multiSamples);
    vtkNew<vtkPlaneSource> square;
    square->SetOrigin(Edge / 2, -2.0, Edge / 2);
    square->SetPoint1(Edge + 2.0, -2.0, Edge / 2);
    square->SetPoint2(Edge / 2, Edge + 2.0, Edge / 2);
    vtkNew<vtkPolyDataMapper> squareMapper;
    squareMapper->SetInputConnection(square->GetOutputPort());
    vtkNew<vtkActor> actor;
    actor->SetMapper(squareMapper);
    actor->GetProperty()->LightingOff();
    actor->GetProperty()->SetColor(0.0, 0.0, 1.0);
    this->Stage->GetRenderer()->AddActor(actor);

    const Picture picture = this->Draw();
    const Color behind = PixelAt(picture, 40, 64);
    EXPECT_WITHIN(behind[0], Brightness(Edge), 1.0, "brightness without geometry, of 255", OneCode);
    const Color inFront = PixelAt(picture, 88, 64);
    EXPECT_WITHIN(
      inFront[0], Brightness(Edge / 2), 1.0, "brightness before geometry, of 255", OneCode)
      << multiSamples << " samples";
    EXPECT_WITHIN(inFront[2], 255.0, 1.0, "geometry behind the volume, of 255", OneCode);
    this->Stage->GetRenderer()->RemoveActor(actor);
  }
}

TEST_F(AnalyticPictures, CameraInsideSeesFromTheNearPlaneOn)
{
  vtkCamera* camera = this->Stage->GetRenderer()->GetActiveCamera();
  camera->ParallelProjectionOff();
  camera->SetPosition(Edge / 2, Edge / 2, 6.0);
  camera->SetFocalPoint(Edge / 2, Edge / 2, 0.0);
  camera->SetClippingRange(0.5, 20.0);
  EXPECT_WITHIN(PixelAt(this->Draw(), 64, 64)[0], Brightness(5.5), 1.0,
    "brightness from inside, of 255", OneCode);

  // With the whole cube behind the camera nothing is left.
  camera->SetPosition(Edge / 2, Edge / 2, -1.0);
  camera->SetFocalPoint(Edge / 2, Edge / 2, -5.0);
  EXPECT_EQ(PixelAt(this->Draw(), 64, 64)[0], 0.0);
}

TEST_F(AnalyticPictures, HiddenPointsContributeNothing)
{
  // Points 4 to 8 are visible: everything from x = 3.5 on, and no trace of the hidden scalars.
  this->HideLowX();
  for (const bool nearest : {false, true})
  {
    this->Stage->GetProperty()->SetInterpolationType(
      nearest ? VTK_NEAREST_INTERPOLATION : VTK_LINEAR_INTERPOLATION);
    this->LookAlongZ();
    this->ExpectToBeginAt(3.5);

    this->LookAlongX();
    EXPECT_WITHIN(PixelAt(this->Draw(), 64, 64)[0], Brightness(4.5), 1.0,
      "brightness through hidden points, of 255", OneCode);
  }
}

TEST_F(AnalyticPictures, HiddenCellsOfPointScalarsEndAtTheirFaces)
{
  this->Input->GetCellData()->AddArray(FlagLowX(int(Edge), vtkDataSetAttributes::HIDDENCELL));
  this->ExpectToBeginAt(4.0);
}

TEST_F(AnalyticPictures, HiddenPointsOfCellScalarsEndHalfWayToTheNextPoint)
{
  vtkNew<vtkFloatArray> scalars;
  scalars->SetNumberOfTuples(this->Input->GetNumberOfCells());
  scalars->Fill(1.0);
  this->Input->GetPointData()->Initialize();
  this->Input->GetCellData()->SetScalars(scalars);
  this->Input->GetPointData()->AddArray(FlagLowX(int(Edge) + 1, vtkDataSetAttributes::HIDDENPOINT));
  this->ExpectToBeginAt(3.5);
}

// A surface across the view, whose points are hidden above a plane that rises by four voxels from
// column to column. Its edge was a stair: up to 0.2 beside the plane.
TEST_F(AnalyticPictures, SurfacesEndAtTheSlopeOfHiddenPoints)
{
  this->HideAboveSlope();
  vtkCamera* camera = this->Stage->GetRenderer()->GetActiveCamera();
  camera->SetPosition(Edge / 2, -20.0, Edge / 2);
  camera->SetViewUp(0.0, 0.0, 1.0);
  this->Stage->GetProperty()->GetIsoSurfaceValues()->SetValue(0, 4.3);
  this->Mapper->SetBlendMode(vtkVolumeMapper::ISOSURFACE_BLEND);
  const Picture picture = this->Draw();
  double farthest = 0.0;
  constexpr double unitsPerPixel = 10.0 / Size;
  for (int x = 40; x < 90; ++x)
  {
    int y = 20; // within the surface
    EXPECT_GT(PixelAt(picture, x, y)[0], 0.0) << x;
    while (y < Size && PixelAt(picture, x, y)[0] > 0.0)
    {
      ++y;
    }
    const double edge = y * unitsPerPixel - 1.0;
    const double expected = SlopeAt((x + 0.5) * unitsPerPixel - 1.0) + 0.5 / 8.0;
    farthest = std::max(farthest, std::abs(edge - expected));
  }
  EXPECT_AT_MOST(farthest, 0.07, "distance of the edge from the slope, of a voxel's width");
}

TEST_F(AnalyticPictures, ScalarsThatAreNotFiniteContributeNothing)
{
  vtkDataArray* scalars = this->Input->GetPointData()->GetScalars();
  for (vtkIdType id = 0; id < scalars->GetNumberOfTuples(); ++id)
  {
    if (id % (int(Edge) + 1) < 4)
    {
      scalars->SetComponent(id, 0, std::numeric_limits<double>::quiet_NaN());
    }
  }
  this->LookAlongX();
  EXPECT_WITHIN(PixelAt(this->Draw(), 64, 64)[0], Brightness(4.5), 1.0,
    "brightness through values that are not finite, of 255", OneCode);
}

TEST_F(AnalyticPictures, CutsAreExact)
{
  this->LookAlongX();
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(2.25, 0.0, 0.0);
  plane->SetNormal(1.0, 0.0, 0.0);
  this->Mapper->AddClippingPlane(plane);
  EXPECT_WITHIN(PixelAt(this->Draw(), 64, 64)[0], Brightness(5.75), 1.0,
    "brightness behind a clipping plane, of 255", OneCode);
  this->Mapper->RemoveAllClippingPlanes();

  this->Mapper->CroppingOn();
  this->Mapper->SetCroppingRegionPlanes(1.25, 3.5, -1.0, 9.0, -1.0, 9.0);
  EXPECT_WITHIN(PixelAt(this->Draw(), 64, 64)[0], Brightness(2.25), 1.0,
    "brightness of a cropped region, of 255", OneCode);
  // The regions below the lower and above the upper x plane, between the others: bits 12 and 14.
  this->Mapper->SetCroppingRegionFlags((1 << 12) | (1 << 14));
  EXPECT_WITHIN(PixelAt(this->Draw(), 64, 64)[0], Brightness(5.75), 1.0,
    "brightness of two cropped regions, of 255", OneCode);
}

TEST_F(AnalyticPictures, ViewportOffTheCorner)
{
  // The upper right quarter of the window alone is drawn into.
  this->Stage->GetRenderer()->SetViewport(0.5, 0.5, 1.0, 1.0);
  const Picture picture = this->Draw();
  EXPECT_WITHIN(PixelAt(picture, 96, 96)[0], Brightness(Edge), 1.0,
    "brightness in a viewport, of 255", OneCode);
  EXPECT_EQ(PixelAt(picture, 32, 96)[0], 0.0);
  EXPECT_EQ(PixelAt(picture, 96, 32)[0], 0.0);
}
