// SPDX-License-Identifier: BSD-3-Clause
// Frame times of the slices, sampled and pre-integrated, beside VTK's ray casters, on the synthetic
// storm volume and on volumes that are visible everywhere: 796 x 532 pixels, 256 slices, as many
// samples along the axis of the view, 12 views. Then the same storms with and without shadows and
// occlusion, and how long a new light volume takes; and with each blend mode. Usage:
// BenchmarkMapper [light|modes] [points along x ...]: 128, 256, 512; default all three; light:
// shadows and occlusion alone; modes: blend modes alone.
#include "RenderingTest.h"
#include "Scenes.h"
#include "SyntheticStorm.h"

#include "vtkCamera.h"
#include "vtkContourValues.h"
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
/// 40 km of rain of 30 dBZ hide two thirds of what is behind.
constexpr double StormUnitDistance = 0.25;

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

double Median(std::vector<double>& times)
{
  const auto middle = times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2);
  std::nth_element(times.begin(), middle, times.end());
  return *middle;
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

  double GetMedian() { return Median(this->Times); }
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
    const double slices = this->Contenders[0].GetMedian();
    const double integrated = this->Contenders[1].GetMedian();
    const double rays = this->Contenders[2].GetMedian();
    const double fixedPoint = this->Contenders[3].GetMedian();
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

/// Frames of the storm, or of its surfaces, with shadows and occlusion beside those without, and
/// the times of new light.
class LightContest
{
public:
  LightContest(vtkImageData* image, int scalarType, bool surfaces)
    : Image(image)
    , Surfaces(surfaces)
  {
    SetStormFunctions(this->Stage.GetProperty(), scalarType);
    this->Stage.GetProperty()->SetScalarOpacityUnitDistance(StormUnitDistance);
    for (vtkOpenGLTextureSliceVolumeMapper* mapper : {this->Plain.Get(), this->Lit.Get()})
    {
      mapper->SetInputData(image);
      mapper->SetNumberOfSlices(Slices);
    }
    this->Lit->SetShadowStrength(0.7);
    this->Lit->SetOcclusionStrength(0.5);
    if (surfaces)
    {
      this->UseSurfaces();
    }
  }

  void Run()
  {
    for (int view = -1; view < Views; ++view) // the first ones upload and compile
    {
      this->Draw(this->Plain, view, this->PlainTimes);
      this->Draw(this->Lit, view, this->LitTimes);
    }
    vtkPiecewiseFunction* opacity = this->Stage.GetProperty()->GetScalarOpacity();
    std::vector<double> light = this->Renew(
      [&](int i) { this->Lit->SetLightDirection(std::cos(0.5 * i), std::sin(0.5 * i), 1.0); });
    std::vector<double> table = this->Renew([&](int) { opacity->Modified(); });
    std::vector<double> volume = this->Renew(
      [&](int)
      {
        this->Image->GetPointData()->GetScalars()->Modified();
        this->Lit->PreLoadData(this->Stage.GetRenderer(), this->Stage.GetVolume());
      });
    this->Stage.GetWindow()->SetDesiredUpdateRate(15.0);
    std::vector<double> dragged = this->Renew([&](int) { opacity->Modified(); });
    const int* size = this->Image->GetDimensions();
    const double plain = Median(this->PlainTimes);
    const double lit = Median(this->LitTimes);
    std::printf("| %dx%dx%d | %s | %s | %.1f | %.1f | %.2f | %.1f | %.1f | %.1f | %.1f |\n",
      size[0], size[1], size[2], this->Image->GetScalarTypeAsString(),
      this->Surfaces ? "surfaces" : "volume", plain, lit, lit / plain, Median(light), Median(table),
      Median(volume), Median(dragged));
    std::fflush(stdout);
  }

private:
  /// Those of the preset "iso-values", lit as in the scene of nexrad3d.
  void UseSurfaces()
  {
    const double noEcho = this->Image->GetScalarType() == VTK_FLOAT ? 0.0 : -33.0;
    for (const int i : {0, 1, 2})
    {
      this->Stage.GetProperty()->GetIsoSurfaceValues()->SetValue(i, 20.0 + 15.0 * i - noEcho);
    }
    this->Stage.GetProperty()->ShadeOn();
    for (vtkOpenGLTextureSliceVolumeMapper* mapper : {this->Plain.Get(), this->Lit.Get()})
    {
      mapper->SetBlendModeToIsoSurface();
      mapper->SmoothGradientOn();
    }
  }

  void Draw(vtkVolumeMapper* mapper, int view, std::vector<double>& times)
  {
    AimCamera(this->Stage.GetRenderer(), this->Image, std::max(view, 0));
    this->Stage.GetVolume()->SetMapper(mapper);
    const auto begin = Clock::now();
    this->Stage.GetWindow()->Render();
    this->Stage.GetWindow()->WaitForCompletion();
    if (view >= 0)
    {
      times.push_back(Milliseconds(begin));
    }
  }

  /// Times of the light alone: what precedes it, a volume's upload, is done before.
  template <typename Change>
  std::vector<double> Renew(const Change& change)
  {
    std::vector<double> times;
    for (int i = 0; i < Views; ++i)
    {
      change(i);
      const auto begin = Clock::now();
      this->Lit->UpdateLight(this->Stage.GetRenderer(), this->Stage.GetVolume());
      this->Stage.GetWindow()->WaitForCompletion();
      times.push_back(Milliseconds(begin));
    }
    return times;
  }

  vtkImageData* Image;
  bool Surfaces;
  Scene Stage{796, 532, 0, false};
  vtkNew<vtkOpenGLTextureSliceVolumeMapper> Plain;
  vtkNew<vtkOpenGLTextureSliceVolumeMapper> Lit;
  std::vector<double> PlainTimes;
  std::vector<double> LitTimes;
};

/// A blend mode, or two-dimensional functions.
struct Mode
{
  const char* Name;
  int BlendMode;
  bool Table2D = false;
};

constexpr std::array<Mode, 7> Modes = {{{"composite", vtkVolumeMapper::COMPOSITE_BLEND},
  {"two-dimensional functions", vtkVolumeMapper::COMPOSITE_BLEND, true},
  {"isosurfaces of 30 and 45 dBZ", vtkVolumeMapper::ISOSURFACE_BLEND},
  {"maximum", vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND},
  {"minimum", vtkVolumeMapper::MINIMUM_INTENSITY_BLEND},
  {"average of 30 to 90 dBZ", vtkVolumeMapper::AVERAGE_INTENSITY_BLEND},
  {"additive", vtkVolumeMapper::ADDITIVE_BLEND}}};

/// The upper two thirds of the range of the scalars, above a tenth of the gradient magnitudes.
vtkSmartPointer<vtkImageData> MakeFunction2D()
{
  auto function = vtkSmartPointer<vtkImageData>::New();
  function->SetDimensions(64, 16, 1);
  function->AllocateScalars(VTK_FLOAT, 4);
  auto* entry = static_cast<float*>(function->GetScalarPointer());
  for (int i = 0; i < 64 * 16; ++i, entry += 4)
  {
    entry[0] = 0.9f;
    entry[1] = static_cast<float>(i % 64) / 64.0f;
    entry[2] = 0.3f;
    entry[3] = i % 64 > 21 && i / 64 > 1 ? 0.3f : 0.0f;
  }
  return function;
}

void MeasureMode(const Mode& mode, vtkImageData* storm)
{
  Scene stage(796, 532, 0, false);
  SetStormFunctions(stage.GetProperty(), VTK_FLOAT);
  stage.GetProperty()->SetScalarOpacityUnitDistance(StormUnitDistance);
  stage.GetProperty()->GetIsoSurfaceValues()->SetValue(0, 30.0);
  stage.GetProperty()->GetIsoSurfaceValues()->SetValue(1, 45.0);
  if (mode.Table2D)
  {
    stage.GetProperty()->SetTransferFunction2D(MakeFunction2D());
  }
  vtkNew<vtkOpenGLTextureSliceVolumeMapper> slices;
  slices->SetNumberOfSlices(Slices);
  vtkNew<vtkOpenGLGPUVolumeRayCastMapper> rays;
  rays->SetAutoAdjustSampleDistances(0);
  rays->SetUseJittering(0);
  const std::array<vtkGPUVolumeRayCastMapper*, 2> mappers = {slices.Get(), rays.Get()};
  std::array<std::vector<double>, 2> times;
  for (int view = -1; view < Views; ++view) // the first ones upload and compile
  {
    AimCamera(stage.GetRenderer(), storm, std::max(view, 0));
    rays->SetSampleDistance(static_cast<float>(SampleDistance(stage.GetRenderer(), storm)));
    for (std::size_t i = 0; i < mappers.size(); ++i)
    {
      mappers[i]->SetInputData(storm);
      mappers[i]->SetBlendMode(mode.BlendMode);
      mappers[i]->SetAverageIPScalarRange(30.0, 90.0);
      stage.GetVolume()->SetMapper(mappers[i]);
      const auto begin = Clock::now();
      stage.GetWindow()->Render();
      stage.GetWindow()->WaitForCompletion();
      if (view >= 0)
      {
        times[i].push_back(Milliseconds(begin));
      }
    }
  }
  const int* size = storm->GetDimensions();
  const double ofSlices = Median(times[0]);
  const double ofRays = Median(times[1]);
  std::printf("| %dx%dx%d | %s | %.1f | %.1f | %.2f |\n", size[0], size[1], size[2], mode.Name,
    ofSlices, ofRays, ofSlices / ofRays);
  std::fflush(stdout);
}

void MeasureModes(const std::vector<int>& sizes)
{
  std::printf("\nBlend modes on the storms, milliseconds\n\n"
              "| volume | blend mode | slices | GPU ray caster | slices / GPU |\n"
              "|---|---|---|---|---|\n");
  for (const int size : sizes)
  {
    const auto storm = nexrad::benchmarks::MakeSyntheticStorm({size, size, size / 2}, VTK_FLOAT);
    for (const Mode& mode : Modes)
    {
      MeasureMode(mode, storm);
    }
  }
}

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

void MeasureLight(const std::vector<int>& sizes)
{
  std::printf("\nShadows and occlusion: a frame without and with them, and a new light volume for "
              "another light, table or volume, and for another table during an interaction, "
              "milliseconds\n\n"
              "| volume | scalars | drawn | without | with | with / without | light | table | "
              "volume | dragged |\n|---|---|---|---|---|---|---|---|---|---|\n");
  for (const int size : sizes)
  {
    for (const int scalarType : {VTK_FLOAT, VTK_UNSIGNED_CHAR})
    {
      const auto storm = nexrad::benchmarks::MakeSyntheticStorm({size, size, size / 2}, scalarType);
      LightContest(storm, scalarType, false).Run();
      LightContest(storm, scalarType, true).Run();
    }
  }
}

} // namespace

int main(int argc, char* argv[])
{
  const std::string part = argc > 1 ? argv[1] : "";
  const bool partAlone = part == "light" || part == "modes";
  std::vector<int> sizes;
  for (int i = partAlone ? 2 : 1; i < argc; ++i)
  {
    sizes.push_back(std::atoi(argv[i]));
    if (sizes.back() < 4 || sizes.back() > 2048)
    {
      std::fprintf(
        stderr, "usage: BenchmarkMapper [light|modes] [points along x, 4 to 2048 ...]\n");
      return 2;
    }
  }
  if (sizes.empty())
  {
    sizes = {128, 256, 512};
  }
  if (partAlone)
  {
    part == "light" ? MeasureLight(sizes) : MeasureModes(sizes);
    return 0;
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
  MeasureLight(sizes);
  MeasureModes(sizes);
  return 0;
}
