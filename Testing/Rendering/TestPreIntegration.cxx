// SPDX-License-Identifier: BSD-3-Clause
// Pre-integrated classification (Formulas L1): few slices beside pictures that can be worked out by
// hand, and beside many samples.
#include "RayCasterComparison.h"
#include "Scenes.h"
#include "Tolerance.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkColorTransferFunction.h"
#include "vtkContourValues.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkImageData.h"
#include "vtkNexradTransferFunction.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPlane.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <cmath>
#include <iostream>
#include <string>
#include <vector>

namespace
{

using namespace nexrad::testing;

constexpr double SlabEdge = 8.0;     // of the cube, from the origin on
constexpr double SlabOpacity = 0.12; // of one unit
constexpr double ViewHeight = 10.0;

/// What a white volume of that opacity adds to a black pixel after a path of that length.
double SlabBrightness(double path)
{
  return 255.0 * (1.0 - std::pow(1.0 - SlabOpacity, path));
}

/// Where the middle of a pixel lies in the plane of the view, from the cube's middle.
double FromMiddle(int pixel)
{
  return ((pixel + 0.5) / PictureSize - 0.5) * ViewHeight;
}

/// Two smooth storms in dBZ on 32 x 32 x 16 points, 64 units wide and 24 high.
vtkSmartPointer<vtkImageData> MakeSmoothStorm()
{
  vtkSmartPointer<vtkImageData> image = MakeStorm(32, VTK_FLOAT);
  auto* dBZ = static_cast<float*>(image->GetScalarPointer());
  const auto blob = [](double x, double y, double z, double radius, double height)
  { return std::exp(-(x * x + y * y) / (radius * radius) - z * z / (height * height)); };
  for (vtkIdType id = 0; id < image->GetNumberOfPoints(); ++id)
  {
    const double x = double(id % 32) / 31;
    const double y = double(id / 32 % 32) / 31;
    const double z = double(id / 1024) / 15;
    dBZ[id] = static_cast<float>(-33.0 + 95.0 * blob(x - 0.5, y - 0.5, z - 0.4, 0.245, 0.387) +
                                 70.0 * blob(x - 0.7, y - 0.3, z - 0.6, 0.173, 0.316));
  }
  return image;
}

/// A white cube, or one with a ramp of scalars, face on.
class PreIntegration : public AgainstRayCaster
{
protected:
  void SetUp() override
  {
    AgainstRayCaster::SetUp();
    if (this->Stage != nullptr)
    {
      this->UseInput(MakeUniformCube(int(SlabEdge) + 1, 1.0f));
      SetUniformFunctions(this->Stage->GetProperty(), SlabOpacity);
      this->LookFrom(0.0, 0.0, 1.0);
      this->Slices->PreIntegrationOn();
    }
  }

  void UseInput(vtkSmartPointer<vtkImageData> input)
  {
    this->Input = input;
    this->Slices->SetInputData(input);
  }

  /// Scalars from 0 to 1 along z.
  void UseRamp()
  {
    this->UseInput(MakeUniformCube(int(SlabEdge) + 1, 0.0f));
    vtkDataArray* scalars = this->Input->GetPointData()->GetScalars();
    for (vtkIdType id = 0; id < scalars->GetNumberOfTuples(); ++id)
    {
      scalars->SetComponent(id, 0, double(id / 81) / SlabEdge);
    }
  }

  /// Parallel, at the cube's middle.
  void LookFrom(double x, double y, double z)
  {
    constexpr double away = 30.0;
    vtkCamera* camera = this->Stage->GetRenderer()->GetActiveCamera();
    const double length = std::hypot(x, y, z);
    camera->SetFocalPoint(SlabEdge / 2, SlabEdge / 2, SlabEdge / 2);
    camera->SetPosition(SlabEdge / 2 + away * x / length, SlabEdge / 2 + away * y / length,
      SlabEdge / 2 + away * z / length);
    camera->SetViewUp(0.0, 1.0, 0.0);
    camera->SetParallelScale(ViewHeight / 2);
    camera->ParallelProjectionOn();
    camera->SetClippingRange(1.0, 60.0);
  }

  Picture DrawWith(int slices)
  {
    this->Slices->SetNumberOfSlices(slices);
    return this->Stage->Draw(this->Slices);
  }

  Picture DrawSampled(int slices)
  {
    this->Slices->PreIntegrationOff();
    const Picture picture = this->DrawWith(slices);
    this->Slices->PreIntegrationOn();
    return picture;
  }

  Difference CompareWith(const Picture& a, const Picture& b)
  {
    return Compare(a, b, this->Stage->Draw(nullptr));
  }
};

} // namespace

TEST_F(PreIntegration, IsOffByDefaultAndLeavesNothingBehind)
{
  EXPECT_FALSE(vtkSmartPointer<vtkOpenGLTextureSliceVolumeMapper>::New()->GetPreIntegration());
  this->UseStorm(VTK_FLOAT);
  this->UseInput(this->Input);
  this->AimCamera(false);
  const Picture before = this->DrawSampled(64);
  const Picture between = this->DrawWith(64);
  const Picture after = this->DrawSampled(64);
  EXPECT_EQ(this->CompareWith(before, after).Worst, 0.0);
  EXPECT_AT_LEAST(this->CompareWith(before, between).LargestMean(), 0.5,
    "mean change by the integration, of 255");
}

TEST_F(PreIntegration, OtherBlendModesAndNearestScalarsIgnoreIt)
{
  this->UseStorm(VTK_FLOAT);
  this->UseInput(this->Input);
  this->AimCamera(false);
  this->Stage->GetProperty()->GetIsoSurfaceValues()->SetValue(0, 30.0);
  for (const int mode : {vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND,
         vtkVolumeMapper::MINIMUM_INTENSITY_BLEND, vtkVolumeMapper::AVERAGE_INTENSITY_BLEND,
         vtkVolumeMapper::ADDITIVE_BLEND, vtkVolumeMapper::ISOSURFACE_BLEND})
  {
    this->Slices->SetBlendMode(mode);
    EXPECT_EQ(this->CompareWith(this->DrawWith(64), this->DrawSampled(64)).Worst, 0.0) << mode;
  }
  this->Slices->SetBlendModeToComposite();
  this->Stage->GetProperty()->SetInterpolationTypeToNearest();
  EXPECT_EQ(this->CompareWith(this->DrawWith(64), this->DrawSampled(64)).Worst, 0.0);
}

TEST_F(PreIntegration, ThereAreAsManySlabsAsAskedFor)
{
  for (const int slices : {1, 4, 5, 255})
  {
    this->DrawWith(slices);
    EXPECT_EQ(this->Slices->GetNumberOfDrawnSlices(), slices);
  }
}

TEST_F(PreIntegration, UniformCubeHasItsOpacityWithFewSlices)
{
  for (const int slices : {4, 8, 64, 1024})
  {
    this->LookFrom(0.0, 0.0, 1.0);
    Picture picture = this->DrawWith(slices);
    EXPECT_WITHIN(PixelAt(picture, 64, 64)[0], SlabBrightness(SlabEdge), 1.0,
      "brightness of the cube's middle, of 255", OneCode)
      << slices << " slices";
    EXPECT_WITHIN(PixelAt(picture, 15, 64)[0], SlabBrightness(SlabEdge), 1.0,
      "brightness of the cube's edge, of 255", OneCode)
      << slices << " slices";
    EXPECT_EQ(PixelAt(picture, 11, 64)[0], 0.0) << slices << " slices";
    this->LookFrom(1.0, 0.0, 1.0);
    picture = this->DrawWith(slices);
    for (const int x : {30, 64, 90})
    {
      // Across an edge: the path grows towards the middle.
      const double path = 2.0 * (SlabEdge / std::sqrt(2.0) - std::abs(FromMiddle(x)));
      EXPECT_WITHIN(PixelAt(picture, x, 64)[0], SlabBrightness(path), 1.0,
        "brightness across an edge of the cube, of 255", OneCode)
        << slices << " slices";
    }
  }
}

// An oblique plane ends each ray where it crosses it, not at the nearest slice.
TEST_F(PreIntegration, ClippingPlanesCutWithinASlab)
{
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(4.0, 4.0, 5.3);
  plane->SetNormal(0.3, 0.2, -1.0);
  this->Slices->AddClippingPlane(plane);
  for (const int slices : {4, 32})
  {
    const Picture picture = this->DrawWith(slices);
    for (const int x : {30, 64, 100})
    {
      for (const int y : {35, 80})
      {
        const double path = 5.3 + 0.3 * FromMiddle(x) + 0.2 * FromMiddle(y);
        EXPECT_WITHIN(PixelAt(picture, x, y)[0], SlabBrightness(path), 1.0,
          "brightness behind a clipping plane, of 255", OneCode)
          << slices << " slices, pixel " << x << ' ' << y;
      }
    }
  }
}

// Cropping faces: of the part in the middle, and of all regions but that one.
TEST_F(PreIntegration, CroppingFacesCutTheVolume)
{
  this->Slices->CroppingOn();
  this->Slices->SetCroppingRegionPlanes(1.0, 7.0, 1.0, 7.0, 2.3, 6.1);
  this->Slices->SetCroppingRegionFlagsToSubVolume();
  for (const int slices : {4, 64})
  {
    EXPECT_WITHIN(PixelAt(this->DrawWith(slices), 64, 64)[0], SlabBrightness(3.8), 1.0,
      "brightness of a cropped region, of 255", OneCode);
  }
  this->Slices->SetCroppingRegionFlags(0x7ffffff & ~VTK_CROP_SUBVOLUME);
  // A slab counts as a whole where its middle is: up to half a slab at either face.
  EXPECT_WITHIN(PixelAt(this->DrawWith(256), 64, 64)[0], SlabBrightness(SlabEdge - 3.8), 1.0,
    "brightness of all regions but one, of 255", OneCode);
}

// Opaque geometry ends each ray where it stands: a black square across the cube, tilted.
TEST_F(PreIntegration, OpaqueGeometryCutsWithinASlab)
{
  vtkNew<vtkPlaneSource> square;
  square->SetOrigin(-4.0, -4.0, 3.3 - 0.25 * 8.0);
  square->SetPoint1(12.0, -4.0, 3.3 + 0.25 * 8.0);
  square->SetPoint2(-4.0, 12.0, 3.3 - 0.25 * 8.0);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(square->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(0.0, 0.0, 0.0);
  actor->GetProperty()->LightingOff();
  this->Stage->GetRenderer()->AddActor(actor);
  for (const bool parallel : {true, false})
  {
    vtkCamera* camera = this->Stage->GetRenderer()->GetActiveCamera();
    camera->SetParallelProjection(parallel);
    for (const int slices : {4, 32})
    {
      EXPECT_WITHIN(PixelAt(this->DrawWith(slices), 64, 64)[0], SlabBrightness(SlabEdge - 3.3), 1.0,
        "brightness before geometry, of 255", OneCode)
        << slices << " slices, " << (parallel ? "parallel" : "perspective");
    }
    if (parallel)
    {
      const Picture picture = this->DrawWith(4);
      for (const int x : {30, 90})
      {
        const double path = SlabEdge - 3.3 - 0.25 * FromMiddle(x);
        EXPECT_WITHIN(PixelAt(picture, x, 64)[0], SlabBrightness(path), 1.0,
          "brightness before tilted geometry, of 255", OneCode)
          << "pixel " << x;
      }
    }
  }
}

// The visible points end half-way between the last visible and the first hidden one.
TEST_F(PreIntegration, HiddenPointsContributeNothing)
{
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  ghosts->SetNumberOfTuples(this->Input->GetNumberOfPoints());
  vtkDataArray* scalars = this->Input->GetPointData()->GetScalars();
  for (vtkIdType id = 0; id < this->Input->GetNumberOfPoints(); ++id)
  {
    const bool hidden = id / 81 < 4; // z below 4
    ghosts->SetValue(id, hidden ? vtkDataSetAttributes::HIDDENPOINT : 0);
    scalars->SetComponent(id, 0, hidden ? -1e30 : 1.0);
  }
  this->Input->GetPointData()->AddArray(ghosts);
  for (const int slices : {16, 64})
  {
    EXPECT_WITHIN(PixelAt(this->DrawWith(slices), 64, 64)[0], SlabBrightness(SlabEdge - 3.5), 1.0,
      "brightness beside hidden points, of 255", OneCode)
      << slices << " slices";
  }
}

// Two thin layers, red about 0.5 and blue about 0.7, both between two slices of four, which see
// nothing of them. The layer in front hides some of the other.
TEST_F(PreIntegration, LayersBetweenTwoSlicesAreFoundInTheirOrder)
{
  constexpr double halfWidth = 0.05;
  constexpr double peak = 0.9; // opacity of one unit
  this->UseRamp();
  vtkNew<vtkColorTransferFunction> color;
  color->AddRGBPoint(0.599, 1.0, 0.0, 0.0);
  color->AddRGBPoint(0.601, 0.0, 0.0, 1.0);
  vtkNew<vtkPiecewiseFunction> opacity;
  for (const double layer : {0.5, 0.7})
  {
    opacity->AddPoint(layer - halfWidth, 0.0);
    opacity->AddPoint(layer, peak);
    opacity->AddPoint(layer + halfWidth, 0.0);
  }
  this->Stage->GetProperty()->SetColor(color);
  this->Stage->GetProperty()->SetScalarOpacity(opacity);
  // The mean of -ln(1 - a) while a goes from 0 to the peak, over the thickness of a layer.
  const double depth =
    ((1.0 - peak) * std::log(1.0 - peak) + peak) / peak * 2.0 * halfWidth * SlabEdge;
  const double first = 255.0 * (1.0 - std::exp(-depth));
  const double second = std::exp(-depth) * first;
  EXPECT_EQ(PixelAt(this->DrawSampled(4), 64, 64)[0], 0.0);
  for (const int slices : {4, 8, 32})
  {
    this->LookFrom(0.0, 0.0, 1.0); // blue is in front
    Color pixel = PixelAt(this->DrawWith(slices), 64, 64);
    EXPECT_WITHIN(pixel[2], first, 1.0, "brightness of the layer in front, of 255", OneCode)
      << slices << " slices";
    EXPECT_WITHIN(pixel[0], second, 1.0, "brightness of the layer behind, of 255", OneCode)
      << slices << " slices";
    this->LookFrom(0.0, 0.0, -1.0);
    pixel = PixelAt(this->DrawWith(slices), 64, 64);
    EXPECT_WITHIN(pixel[0], first, 1.0, "brightness of the layer in front, of 255", OneCode)
      << slices << " slices";
    EXPECT_WITHIN(pixel[2], second, 1.0, "brightness of the layer behind, of 255", OneCode)
      << slices << " slices";
  }
}

// Steep functions beside 2048 samples: the weather service's colour steps, shells of 4 dBZ about
// three iso-values, and a spike as wide as one voxel is on the flanks (10 dBZ).
TEST_F(PreIntegration, FewSlicesOfSteepFunctionsAreLikeManySamples)
{
  struct Functions
  {
    std::string Name;
    double HalfWidth; ///< of a shell, dBZ; 0: the opacities of the preset "all echo"
    std::vector<double> Values;
    double Tolerance; ///< of 64 slices; at most twice what was measured
  };
  const Functions tables[] = {{"colour steps", 0.0, {}, 1.0},
    {"iso-values", 2.0, {20.0, 35.0, 50.0}, 9.0}, {"spike of one voxel", 5.0, {35.0}, 9.0}};
  this->UseInput(MakeSmoothStorm());
  this->AimCamera(false);
  this->Stage->GetProperty()->SetScalarOpacityUnitDistance(1.0);
  for (const Functions& table : tables)
  {
    vtkNew<vtkNexradTransferFunction> function;
    function->ApplyPreset("all echo");
    if (table.HalfWidth > 0.0)
    {
      function->SetOpacityToIsoValues(
        table.Values.data(), static_cast<int>(table.Values.size()), 0.8, table.HalfWidth);
    }
    vtkNew<vtkColorTransferFunction> color;
    vtkNew<vtkPiecewiseFunction> opacity;
    function->FillSteppedColorFunction(color);
    function->FillOpacityFunction(opacity);
    this->Stage->GetProperty()->SetColor(color);
    this->Stage->GetProperty()->SetScalarOpacity(opacity);
    const Picture many = this->DrawSampled(2048);
    const auto differ = [&](const Picture& few)
    { return this->CompareWith(few, many).LargestMean(); };
    const double integrated = differ(this->DrawWith(64));
    const double sampled = differ(this->DrawSampled(256));
    std::cout << table.Name << ": mean difference from 2048 samples " << integrated
              << " of 255 with 64 integrated slices, " << differ(this->DrawWith(256))
              << " with 256, " << differ(this->DrawSampled(64)) << " with 64 samples, " << sampled
              << " with 256, " << differ(this->DrawSampled(512)) << " with 512\n";
    EXPECT_LE(integrated, sampled) << table.Name;
    EXPECT_AT_MOST(integrated, table.Tolerance,
      table.Name + ": mean difference of 64 integrated slices from 2048 samples, of 255");
  }
}
