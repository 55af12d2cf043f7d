// SPDX-License-Identifier: BSD-3-Clause
// Isosurfaces lie where the synthetic storm has the value, whatever the number of slices.
#include "RenderingTest.h"
#include "Tolerance.h"

#include "nexrad/Simulation/StormField.h"
#include "nexrad/Simulation/StormSnapshot.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkColorTransferFunction.h"
#include "vtkContourValues.h"
#include "vtkFlyingEdges3D.h"
#include "vtkImageData.h"
#include "vtkImageExtractComponents.h"
#include "vtkLight.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkOpenGLTextureSliceVolumeMapper.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <memory>
#include <numeric>
#include <random>

namespace
{

using namespace nexrad;
using namespace nexrad::testing;

using Vector = std::array<double, 3>;

constexpr int PicturePixels = 400; // pixels along each side
constexpr double Surface = 35.0;   // dBZ
constexpr double Shown = 60.0;     // km that the picture is high
constexpr double Farthest = 50.0;  // km before and behind the focal point that depths are told for

/// A supercell 60 km wide and 16 km high in voxels of 500 x 500 x 250 m. Scalars: the depth behind
/// the camera's focal plane in km, and dBZ.
class Isosurfaces : public RenderingTest
{
protected:
  void SetUp() override
  {
    RenderingTest::SetUp();
    if (IsSkipped() || HasFatalFailure())
    {
      return;
    }
    this->Stage = std::make_unique<Scene>(PicturePixels, PicturePixels);
    this->AimCamera();
    this->MakeStorm();
    this->Mapper->SetInputData(this->Input);
    this->Mapper->SetBlendModeToIsoSurface();
    this->SetFunctions();
  }
  void TearDown() override
  {
    this->Stage.reset();
    RenderingTest::TearDown();
  }

  void AimCamera()
  {
    vtkCamera* camera = this->Stage->GetRenderer()->GetActiveCamera();
    camera->ParallelProjectionOn();
    camera->SetFocalPoint(0.0, 0.0, 7.0);
    camera->SetPosition(60.0, -90.0, 60.0);
    camera->SetViewUp(0.0, 0.0, 1.0);
    camera->SetParallelScale(Shown / 2.0);
    camera->SetClippingRange(10.0, 300.0);
    camera->GetDirectionOfProjection(this->Away.data());
    camera->OrthogonalizeViewUp();
    camera->GetViewUp(this->Up.data());
    vtkMath::Cross(this->Away.data(), this->Up.data(), this->Right.data());
    camera->GetFocalPoint(this->Focus.data());
  }

  double Depth(const Vector& place) const
  {
    double depth = 0.0;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      depth += (place[axis] - this->Focus[axis]) * this->Away[axis];
    }
    return depth;
  }

  /// dBZ of the storm at a place in km. Below clear air nothing is told apart.
  double Reflectivity(const Vector& km) const
  {
    return std::max(
      -10.0, this->Storm.Reflectivity({1000.0 * km[0], 1000.0 * km[1], 1000.0 * km[2]}));
  }

  void MakeStorm()
  {
    StormLife life;
    life.kind = StormKind::Supercell;
    life.middleTime = 43'200.0;
    life.lifetime = 12'000.0;
    life.peak = 60.0;
    life.top = 14'000.0;
    std::vector<StormElement> elements;
    std::vector<StormVortex> vortices;
    AddElements(life, life.middleTime, elements, vortices);
    this->Storm = StormSnapshot(elements, vortices, life.middleTime);

    this->Input = vtkSmartPointer<vtkImageData>::New();
    this->Input->SetDimensions(121, 121, 65);
    this->Input->SetSpacing(Voxel.data());
    this->Input->SetOrigin(-30.0, -30.0, 0.0);
    this->Input->AllocateScalars(VTK_FLOAT, 2);
    auto* scalars = static_cast<float*>(this->Input->GetScalarPointer());
    for (vtkIdType id = 0; id < this->Input->GetNumberOfPoints(); ++id)
    {
      Vector place{};
      this->Input->GetPoint(id, place.data());
      scalars[2 * id] = static_cast<float>(this->Depth(place));
      scalars[2 * id + 1] = static_cast<float>(this->Reflectivity(place));
    }
  }

  /// Red grows with depth; green rises and falls every eight kilometres.
  void SetFunctions()
  {
    vtkNew<vtkColorTransferFunction> color;
    for (double depth = -Farthest; depth <= Farthest + 1e-9; depth += HalfPeriod)
    {
      const bool odd = std::lround((depth + Farthest) / HalfPeriod) % 2 == 1;
      color->AddRGBPoint(depth, (depth + Farthest) / (2.0 * Farthest), odd ? 1.0 : 0.0, 0.0);
    }
    vtkNew<vtkPiecewiseFunction> opacity;
    opacity->AddPoint(0.0, 1.0);
    vtkVolumeProperty* property = this->Stage->GetProperty();
    property->IndependentComponentsOff();
    property->SetInterpolationTypeToLinear();
    property->SetColor(color);
    property->SetScalarOpacity(opacity);
    property->GetIsoSurfaceValues()->SetValue(0, Surface);
  }

  /// The depth that a colour tells.
  static double DepthOf(const Color& color)
  {
    const double coarse = color[0] / 255.0 * 2.0 * Farthest;
    const double inHalf = color[1] / 255.0 * HalfPeriod;
    double found = 0.0;
    double nearest = 1e9;
    for (int half = 0; half * HalfPeriod < 2.0 * Farthest; ++half)
    {
      const double depth = half * HalfPeriod + (half % 2 == 0 ? inHalf : HalfPeriod - inHalf);
      if (std::abs(depth - coarse) < nearest)
      {
        nearest = std::abs(depth - coarse);
        found = depth;
      }
    }
    return found - Farthest;
  }

  /// Distance in voxels from a place to the surface of the true storm, to first order.
  double VoxelsOff(const Vector& place) const
  {
    double slope = 0.0; // squared, dBZ a voxel
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      Vector before = place;
      Vector after = place;
      before[axis] -= 0.1 * Voxel[axis];
      after[axis] += 0.1 * Voxel[axis];
      slope += std::pow((this->Reflectivity(after) - this->Reflectivity(before)) / 0.2, 2);
    }
    return (this->Reflectivity(place) - Surface) / std::sqrt(slope);
  }

  struct Offsets
  {
    int pixels = 0;
    double mean = 0.0;     ///< of the distance, voxels
    double meanSide = 0.0; ///< the same with its sign: above 0 inside
    double share = 0.0;    ///< farther than a quarter of a voxel
  };

  /// Of all pixels of a picture that show the surface with all of their neighbours.
  Offsets Measure(const Picture& picture) const
  {
    const auto shows = [&](int x, int y) { return PixelAt(picture, x, y)[0] > 0.0; };
    Offsets offsets;
    for (int y = 1; y < PicturePixels - 1; ++y)
    {
      for (int x = 1; x < PicturePixels - 1; ++x)
      {
        if (!shows(x, y) || !shows(x - 1, y) || !shows(x + 1, y) || !shows(x, y - 1) ||
            !shows(x, y + 1))
        {
          continue;
        }
        const double depth = DepthOf(PixelAt(picture, x, y));
        Vector place{};
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
          place[axis] = this->Focus[axis] + depth * this->Away[axis] +
                        ((x + 0.5) / PicturePixels - 0.5) * Shown * this->Right[axis] +
                        ((y + 0.5) / PicturePixels - 0.5) * Shown * this->Up[axis];
        }
        const double off = this->VoxelsOff(place);
        ++offsets.pixels;
        offsets.mean += std::abs(off);
        offsets.meanSide += off;
        offsets.share += std::abs(off) > 0.25 ? 1.0 : 0.0;
      }
    }
    offsets.mean /= offsets.pixels;
    offsets.meanSide /= offsets.pixels;
    offsets.share /= offsets.pixels;
    return offsets;
  }

  /// One colour, lit from the south-east.
  void UseLight()
  {
    vtkNew<vtkColorTransferFunction> color;
    color->AddRGBPoint(0.0, 0.8, 0.8, 0.8);
    vtkVolumeProperty* property = this->Stage->GetProperty();
    property->SetColor(color);
    property->ShadeOn();
    property->SetAmbient(0.0);
    property->SetDiffuse(1.0);
    property->SetSpecular(0.0);
    vtkNew<vtkLight> light;
    light->SetLightTypeToSceneLight();
    light->SetPosition(60.0, -90.0, 90.0);
    light->SetFocalPoint(0.0, 0.0, 0.0);
    this->Stage->GetRenderer()->AddLight(light);
  }

  /// Adds noise of each voxel, with that standard deviation in dBZ.
  void AddNoise(double deviation)
  {
    std::mt19937 generator(5);
    std::normal_distribution<float> noise(0.0F, static_cast<float>(deviation));
    auto* scalars = static_cast<float*>(this->Input->GetScalarPointer());
    for (vtkIdType id = 0; id < this->Input->GetNumberOfPoints(); ++id)
    {
      scalars[2 * id + 1] += noise(generator);
    }
    this->Input->GetPointData()->GetScalars()->Modified();
  }

  /// How far pixels differ from the mean of their four neighbours: the median, 0 to 255.
  static double Sparkle(const Picture& picture)
  {
    std::vector<double> found;
    for (int y = 1; y < PicturePixels - 1; ++y)
    {
      for (int x = 1; x < PicturePixels - 1; ++x)
      {
        const std::array<double, 4> beside{PixelAt(picture, x - 1, y)[0],
          PixelAt(picture, x + 1, y)[0], PixelAt(picture, x, y - 1)[0],
          PixelAt(picture, x, y + 1)[0]};
        if (*std::min_element(beside.begin(), beside.end()) > 0.0)
        {
          const double mean = std::accumulate(beside.begin(), beside.end(), 0.0) / 4.0;
          found.push_back(std::abs(PixelAt(picture, x, y)[0] - mean));
        }
      }
    }
    const auto middle = found.begin() + static_cast<std::ptrdiff_t>(found.size() / 2);
    std::nth_element(found.begin(), middle, found.end());
    return *middle;
  }

  static constexpr Vector Voxel{0.5, 0.5, 0.25}; // km
  static constexpr double HalfPeriod = 4.0;      // km
  std::unique_ptr<Scene> Stage;
  vtkSmartPointer<vtkImageData> Input;
  vtkNew<vtkOpenGLTextureSliceVolumeMapper> Mapper;
  StormSnapshot Storm{{}, {}, 0.0};
  Vector Away{};
  Vector Up{};
  Vector Right{};
  Vector Focus{};
};

} // namespace

TEST_F(Isosurfaces, LieWhereTheStormHasTheValue)
{
  for (const int slices : {64, 256, 1024})
  {
    this->Mapper->SetNumberOfSlices(slices);
    const Picture picture = this->Stage->Draw(this->Mapper);
    WritePicture(picture, "isosurface-depth-" + std::to_string(slices));
    const Offsets offsets = this->Measure(picture);
    std::cout << slices << " slices: " << offsets.mean << " voxels off, " << offsets.meanSide
              << " inwards, " << 100.0 * offsets.share << " % farther than 0.25, over "
              << offsets.pixels << " pixels\n";
    EXPECT_GT(offsets.pixels, 5000);
    EXPECT_AT_MOST(offsets.mean, slices == 64 ? 0.09 : 0.055,
      "distance from the true surface with " + std::to_string(slices) + " slices, voxels");
  }
}

// Beside vtkFlyingEdges3D's surface of the same volume, lit in the same way.
TEST_F(Isosurfaces, LookLikeFlyingEdges)
{
  this->UseLight();
  this->Mapper->SetNumberOfSlices(256);
  const Picture background = this->Stage->Draw(nullptr);
  const Picture slices = this->Stage->Draw(this->Mapper);
  vtkNew<vtkImageExtractComponents> reflectivity;
  reflectivity->SetInputData(this->Input);
  reflectivity->SetComponents(1);
  vtkNew<vtkFlyingEdges3D> edges;
  edges->SetInputConnection(reflectivity->GetOutputPort());
  edges->SetValue(0, Surface);
  vtkNew<vtkPolyDataMapper> triangles;
  triangles->SetInputConnection(edges->GetOutputPort());
  triangles->ScalarVisibilityOff();
  vtkNew<vtkActor> actor;
  actor->SetMapper(triangles);
  actor->GetProperty()->SetColor(0.8, 0.8, 0.8);
  actor->GetProperty()->SetAmbient(0.0);
  actor->GetProperty()->SetDiffuse(1.0);
  actor->GetProperty()->SetSpecular(0.0);
  this->Stage->GetRenderer()->AddActor(actor);
  const Picture expected = this->Stage->Draw(nullptr);
  WritePicture(slices, "isosurface-slices");
  WritePicture(expected, "isosurface-flying-edges");
  const Difference difference = Compare(slices, expected, background);
  std::cout << "beside vtkFlyingEdges3D: mean difference " << difference.LargestMean()
            << " of 255, over " << difference.Pixels << " pixels\n";
  EXPECT_GT(difference.Pixels, 5000);
  EXPECT_AT_MOST(difference.LargestMean(), 2.5, "mean difference to vtkFlyingEdges3D, of 255");
}

// A noise of 1 dBZ a voxel makes the light sparkle; a smoothed gradient less.
TEST_F(Isosurfaces, SmoothGradientsSparkleLess)
{
  this->UseLight();
  const Picture background = this->Stage->Draw(nullptr);
  const Picture clean = this->Stage->Draw(this->Mapper);
  this->Mapper->SmoothGradientOn();
  const Picture smooth = this->Stage->Draw(this->Mapper);
  this->AddNoise(1.0);
  const Picture noisySmooth = this->Stage->Draw(this->Mapper);
  this->Mapper->SmoothGradientOff();
  const Picture noisy = this->Stage->Draw(this->Mapper);
  WritePicture(noisySmooth, "isosurface-noise-smooth");
  WritePicture(noisy, "isosurface-noise");
  const double shape = Compare(smooth, clean, background).LargestMean();
  std::cout << "sparkle of 255: " << Sparkle(clean) << ", with 1 dBZ of noise " << Sparkle(noisy)
            << ", then smoothed " << Sparkle(noisySmooth)
            << "; smoothing alone changes the light by " << shape << '\n';
  EXPECT_AT_MOST(shape, 8.0, "change of light by smoothed gradients, of 255");
  EXPECT_AT_MOST((Sparkle(noisySmooth) - Sparkle(clean)) / (Sparkle(noisy) - Sparkle(clean)), 0.6,
    "sparkle with smoothed gradients over that without");
}
