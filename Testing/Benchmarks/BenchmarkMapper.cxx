// SPDX-License-Identifier: BSD-3-Clause
// Frame times of the slices, sampled and pre-integrated, beside VTK's ray casters, on the synthetic
// storm volume and on volumes that are visible everywhere: 796 x 532 pixels, 256 slices, as many
// samples along the axis of the view, 12 views. Usage: BenchmarkMapper [points along x ...]: 128,
// 256, 512; default all three.
#include "RenderingTest.h"
#include "Scenes.h"
#include "SyntheticStorm.h"

#include "vtkCamera.h"
#include "vtkDataArray.h"
#include "vtkFixedPointVolumeRayCastMapper.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkOpenGLGPUVolumeRayCastMapper.h"
#include "vtkOpenGLTextureSliceVolumeMapper.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace
{

using namespace nexrad::testing;
using Clock = std::chrono::steady_clock;

constexpr int Slices = 256;
constexpr int Views = 12;

/// What stands between the data and the eye.
struct Look
{
  std::string Name;
  /// Opacity of one unit, whatever the scalar; none: that of SetStormFunctions.
  std::optional<double> Everywhere;
};

double Milliseconds(Clock::time_point begin)
{
  return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
}

/// From 30 degrees above the horizon, all round; the volume fills the picture.
void AimCamera(vtkRenderer* renderer, vtkImageData* image, int view)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  const double azimuth = vtkMath::RadiansFromDegrees(360.0 * view / Views + 10.0);
  const double tilt = vtkMath::RadiansFromDegrees(30.0);
  camera->SetFocalPoint(image->GetCenter());
  camera->SetPosition(image->GetCenter()[0] + std::cos(tilt) * std::cos(azimuth),
    image->GetCenter()[1] + std::cos(tilt) * std::sin(azimuth),
    image->GetCenter()[2] + std::sin(tilt));
  camera->SetViewUp(0.0, 0.0, 1.0);
  camera->SetViewAngle(20.0);
  renderer->ResetCamera(image->GetBounds());
  camera->Zoom(1.35);
  renderer->ResetCameraClippingRange(image->GetBounds());
}

/// Distance of the slices along the axis of the view: so are the samples along the rays.
double SampleDistance(vtkRenderer* renderer, vtkImageData* image)
{
  const double* axis = renderer->GetActiveCamera()->GetDirectionOfProjection();
  const double* bounds = image->GetBounds();
  double thickness = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    thickness += std::abs(axis[i]) * (bounds[2 * i + 1] - bounds[2 * i]);
  }
  return thickness / Slices;
}

/// A mapper and the times of its frames.
struct Contender
{
  vtkSmartPointer<vtkVolumeMapper> Mapper;
  /// Its own: VTK's fixed-point ray caster adds a gradient opacity to the property, which the
  /// others would then have to heed.
  vtkSmartPointer<vtkVolumeProperty> Property;
  std::vector<double> Times;

  double Median()
  {
    std::nth_element(this->Times.begin(), this->Times.begin() + Views / 2, this->Times.end());
    return this->Times[Views / 2];
  }
};

class Contest
{
public:
  Contest(vtkImageData* image, int scalarType)
    : Image(image)
  {
    this->Stage = std::make_unique<Scene>(796, 532, 0, false);
    this->Slicer->SetNumberOfSlices(Slices);
    this->Integrator->SetNumberOfSlices(Slices);
    this->Integrator->PreIntegrationOn();
    this->Rays->AutoAdjustSampleDistancesOff();
    this->FixedPoint->AutoAdjustSampleDistancesOff();
    this->FixedPoint->SetImageSampleDistance(1.0f);
    for (vtkVolumeMapper* mapper : {static_cast<vtkVolumeMapper*>(this->Slicer.Get()),
           static_cast<vtkVolumeMapper*>(this->Integrator.Get()),
           static_cast<vtkVolumeMapper*>(this->Rays.Get()),
           static_cast<vtkVolumeMapper*>(this->FixedPoint.Get())})
    {
      mapper->SetInputDataObject(image);
      auto property = vtkSmartPointer<vtkVolumeProperty>::New();
      SetStormFunctions(property, scalarType);
      this->Contenders.push_back({mapper, property, {}});
    }
  }

  void Run(const Look& look)
  {
    for (Contender& contender : this->Contenders)
    {
      contender.Times.clear();
      contender.Property->SetScalarOpacityUnitDistance(look.Everywhere ? 1.0 : StormUnitDistance);
      if (look.Everywhere)
      {
        contender.Property->GetScalarOpacity()->RemoveAllPoints();
        contender.Property->GetScalarOpacity()->AddPoint(0.0, *look.Everywhere);
      }
      this->Draw(contender, 0); // uploads, shaders
    }
    for (int view = 0; view < Views; ++view)
    {
      for (Contender& contender : this->Contenders)
      {
        contender.Times.push_back(this->Draw(contender, view));
      }
    }
    this->Print(look);
  }

private:
  /// 40 km of rain of 30 dBZ hide two thirds of what is behind.
  static constexpr double StormUnitDistance = 0.25;

  double Draw(Contender& contender, int view)
  {
    vtkRenderWindow* window = this->Stage->GetWindow();
    AimCamera(this->Stage->GetRenderer(), this->Image, view);
    const auto distance =
      static_cast<float>(SampleDistance(this->Stage->GetRenderer(), this->Image));
    this->Rays->SetSampleDistance(distance);
    this->FixedPoint->SetSampleDistance(distance);
    this->Stage->GetVolume()->SetMapper(contender.Mapper);
    this->Stage->GetVolume()->SetProperty(contender.Property);
    const auto begin = Clock::now();
    window->Render();
    window->WaitForCompletion();
    return Milliseconds(begin);
  }

  void Print(const Look& look)
  {
    const double slices = this->Contenders[0].Median();
    const double integrated = this->Contenders[1].Median();
    const double rays = this->Contenders[2].Median();
    const double fixedPoint = this->Contenders[3].Median();
    const int* size = this->Image->GetDimensions();
    std::printf("| %dx%dx%d | %s | %s | %.1f | %.1f | %.1f | %.1f | %.2f | %.2f | %.2f |\n",
      size[0], size[1], size[2], this->Image->GetScalarTypeAsString(), look.Name.c_str(), slices,
      integrated, rays, fixedPoint, integrated / slices, slices / rays, slices / fixedPoint);
    std::fflush(stdout);
  }

  vtkImageData* Image;
  std::unique_ptr<Scene> Stage;
  vtkNew<vtkOpenGLTextureSliceVolumeMapper> Slicer;
  vtkNew<vtkOpenGLTextureSliceVolumeMapper> Integrator;
  vtkNew<vtkOpenGLGPUVolumeRayCastMapper> Rays;
  vtkNew<vtkFixedPointVolumeRayCastMapper> FixedPoint;
  std::vector<Contender> Contenders;
};

double VisibleFraction(vtkImageData* image, vtkVolumeProperty* property)
{
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  vtkIdType visible = 0;
  for (vtkIdType id = 0; id < scalars->GetNumberOfTuples(); ++id)
  {
    visible += property->GetScalarOpacity()->GetValue(scalars->GetComponent(id, 0)) > 0.0 ? 1 : 0;
  }
  return double(visible) / double(scalars->GetNumberOfTuples());
}

void MeasureSize(int size)
{
  for (const int scalarType : {VTK_FLOAT, VTK_UNSIGNED_CHAR})
  {
    const auto storm = nexrad::benchmarks::MakeSyntheticStorm({size, size, size / 2}, scalarType);
    vtkNew<vtkVolumeProperty> property;
    SetStormFunctions(property, scalarType);
    std::fprintf(stderr, "%d points along x, %s: %.1f %% of the voxels are visible\n", size,
      storm->GetScalarTypeAsString(), 100.0 * VisibleFraction(storm, property));
    Contest contest(storm, scalarType);
    contest.Run({"storms", {}});
    for (const double opacity : {0.02, 0.5, 1.0})
    {
      char name[64];
      std::snprintf(name, sizeof(name), "everywhere %.2f", opacity);
      contest.Run({name, opacity});
    }
  }
}

} // namespace

int main(int argc, char* argv[])
{
  std::vector<int> sizes;
  for (int i = 1; i < argc; ++i)
  {
    sizes.push_back(std::atoi(argv[i]));
    if (sizes.back() < 4 || sizes.back() > 2048)
    {
      std::fprintf(stderr, "usage: BenchmarkMapper [points along x, 4 to 2048 ...]\n");
      return 2;
    }
  }
  if (sizes.empty())
  {
    sizes = {128, 256, 512};
  }
  std::printf("796 x 532 pixels, %d slices, median of %d views, milliseconds\n\n"
              "| volume | scalars | visible | slices | pre-integrated | GPU ray caster | "
              "fixed-point ray caster | pre-integrated / slices | slices / GPU | "
              "slices / fixed-point |\n|---|---|---|---|---|---|---|---|---|---|---|\n",
    Slices, Views);
  for (const int size : sizes)
  {
    MeasureSize(size);
  }
  return 0;
}
