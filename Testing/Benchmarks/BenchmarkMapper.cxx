// SPDX-License-Identifier: BSD-3-Clause
// Frame times of the slices, by fragments and by compute shaders, sampled and pre-integrated,
// beside VTK's ray casters, on the synthetic storm volume and on volumes that are visible
// everywhere, 12 views: of the whole frame, of the processor, and of the card for the volume alone.
// Then the same storms with and without shadows and occlusion, and how long a new light volume
// takes; and with each blend mode. Rays have as many samples along the axis of the view as there
// are slices. Usage: BenchmarkMapper [--size WIDTHxHEIGHT] [--slices N] [frames|light|modes]
// [points along x ...] Default: 796x532 pixels, 256 slices, 128 256 512, all three parts. With
// --size, VTK's fixed-point ray caster, which works on the processor, is left out.
#include "FrameTimes.h"
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
#include <ctime>
#include <string>
#include <utility>
#include <vector>

namespace
{

using namespace nexrad::testing;
using namespace nexrad::benchmarks;
using Clock = std::chrono::steady_clock;

/// Of all pictures.
int Width = 796;
int Height = 532;
bool WithFixedPoint = true;
int Slices = 256;
constexpr int Views = 12;
/// 40 km of rain of 30 dBZ hide two thirds of what is behind.
constexpr double StormUnitDistance = 0.25;

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

vtkSmartPointer<vtkVolumeProperty> MakeProperty(int scalarType)
{
  auto property = vtkSmartPointer<vtkVolumeProperty>::New();
  SetStormFunctions(property, scalarType);
  property->SetScalarOpacityUnitDistance(StormUnitDistance);
  return property;
}

/// The last point, down by a thousandth of its height.
void MovePoint(vtkPiecewiseFunction* function)
{
  double point[4];
  function->GetNodeValue(function->GetSize() - 1, point);
  point[1] *= 0.999;
  function->SetNodeValue(function->GetSize() - 1, point);
}

/// The storm, or something else of its size, drawn by all contenders.
class Contest
{
public:
  Contest(vtkImageData* image, std::vector<Contender> contenders)
    : Image(image)
    , Contenders(std::move(contenders))
  {
    for (Contender& contender : this->Contenders)
    {
      contender.Mapper->SetInputDataObject(image);
    }
  }

  std::vector<Contender>& GetContenders() { return this->Contenders; }

  /// @param drags whether the functions change before each picture
  void Run(const std::string& name, bool drags = false)
  {
    for (Contender& contender : this->Contenders)
    {
      this->Draw(contender, 0); // uploads, shaders
      contender.ForgetTimes();
    }
    RemoveMissing(this->Contenders);
    for (int view = 0; view < Views; ++view)
    {
      for (Contender& contender : this->Contenders)
      {
        if (drags)
        {
          MovePoint(contender.Property->GetScalarOpacity());
        }
        this->Draw(contender, view);
      }
    }
    const int* size = this->Image->GetDimensions();
    char drawn[200];
    std::snprintf(drawn, sizeof(drawn), "%dx%dx%d | %s | %s", size[0], size[1], size[2],
      this->Image->GetScalarTypeAsString(), name.c_str());
    PrintTimes(drawn, this->Contenders);
  }

private:
  void Draw(Contender& contender, int view)
  {
    AimCamera(this->Stage.GetRenderer(), this->Image, view);
    const auto distance =
      static_cast<float>(SampleDistance(this->Stage.GetRenderer(), this->Image));
    if (auto* rays = vtkGPUVolumeRayCastMapper::SafeDownCast(contender.Mapper))
    {
      rays->SetSampleDistance(distance);
    }
    if (auto* fixedPoint = vtkFixedPointVolumeRayCastMapper::SafeDownCast(contender.Mapper))
    {
      fixedPoint->SetSampleDistance(distance);
    }
    contender.Draw(this->Stage.GetWindow(), this->Stage.GetVolume());
  }

  vtkImageData* Image;
  Scene Stage{Width, Height, 0, false};
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
      this->Draw(this->Plain, view, this->PlainTimes, this->PlainProcessor);
      this->Draw(this->Lit, view, this->LitTimes, this->LitProcessor);
    }
    vtkPiecewiseFunction* opacity = this->Stage.GetProperty()->GetScalarOpacity();
    std::vector<double> light = this->Renew(
      [&](int i) { this->Lit->SetLightDirection(std::cos(0.5 * i), std::sin(0.5 * i), 1.0); });
    std::vector<double> table = this->Renew([&](int) { Lower(opacity); });
    std::vector<double> volume = this->Renew(
      [&](int)
      {
        this->Image->GetPointData()->GetScalars()->Modified();
        this->Lit->PreLoadData(this->Stage.GetRenderer(), this->Stage.GetVolume());
      });
    this->Stage.GetWindow()->SetDesiredUpdateRate(15.0);
    std::vector<double> dragged = this->Renew([&](int) { Lower(opacity); });
    const int* size = this->Image->GetDimensions();
    const double plain = Median(this->PlainTimes);
    const double lit = Median(this->LitTimes);
    std::printf("| %dx%dx%d | %s | %s | %.1f | %.1f | %.2f | %.2f | %.1f | %.1f | %.1f | %.1f |\n",
      size[0], size[1], size[2], this->Image->GetScalarTypeAsString(),
      this->Surfaces ? "surfaces" : "volume", plain, lit, lit / plain,
      Median(this->LitProcessor) / Median(this->PlainProcessor), Median(light), Median(table),
      Median(volume), Median(dragged));
    std::fflush(stdout);
  }

private:
  /// Makes all of a function a little less.
  static void Lower(vtkPiecewiseFunction* function)
  {
    for (int i = 0; i < function->GetSize(); ++i)
    {
      double node[4];
      function->GetNodeValue(i, node);
      node[1] *= 0.99;
      function->SetNodeValue(i, node);
    }
  }

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

  void Draw(vtkVolumeMapper* mapper, int view, std::vector<double>& times,
    std::vector<double>& processorTimes)
  {
    AimCamera(this->Stage.GetRenderer(), this->Image, std::max(view, 0));
    this->Stage.GetVolume()->SetMapper(mapper);
    const std::clock_t processorBegin = std::clock();
    const auto begin = Clock::now();
    this->Stage.GetWindow()->Render();
    this->Stage.GetWindow()->WaitForCompletion();
    if (view >= 0)
    {
      times.push_back(Milliseconds(begin));
      processorTimes.push_back(static_cast<double>(std::clock() - processorBegin));
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
  Scene Stage{Width, Height, 0, false};
  vtkNew<vtkOpenGLTextureSliceVolumeMapper> Plain;
  vtkNew<vtkOpenGLTextureSliceVolumeMapper> Lit;
  std::vector<double> PlainTimes;
  std::vector<double> LitTimes;
  std::vector<double> PlainProcessor; ///< in std::clock's units
  std::vector<double> LitProcessor;
};

enum class Special
{
  None,
  Paged,    ///< in pages, whatever they take
  Dragged,  ///< a point of opacity moves before each picture
  Jittered, ///< samples as far apart as the mappers choose
  Table2D   ///< two-dimensional functions
};

struct Mode
{
  const char* Name;
  int BlendMode;
  Special Particular = Special::None;
};

constexpr std::array<Mode, 10> Modes = {{{"composite", vtkVolumeMapper::COMPOSITE_BLEND},
  {"in pages", vtkVolumeMapper::COMPOSITE_BLEND, Special::Paged},
  {"a point dragged", vtkVolumeMapper::COMPOSITE_BLEND, Special::Dragged},
  {"jittered, 0 slices", vtkVolumeMapper::COMPOSITE_BLEND, Special::Jittered},
  {"two-dimensional functions", vtkVolumeMapper::COMPOSITE_BLEND, Special::Table2D},
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
  const auto makeProperty = [&mode]
  {
    auto property = MakeProperty(VTK_FLOAT);
    property->GetIsoSurfaceValues()->SetValue(0, 30.0);
    property->GetIsoSurfaceValues()->SetValue(1, 45.0);
    if (mode.Particular == Special::Table2D)
    {
      property->SetTransferFunction2D(MakeFunction2D());
    }
    return property;
  };
  Contest contest(storm, MakeContenders(Slices, false, makeProperty));
  for (Contender& contender : contest.GetContenders())
  {
    auto* mapper = vtkGPUVolumeRayCastMapper::SafeDownCast(contender.Mapper);
    const bool jittered = mode.Particular == Special::Jittered;
    mapper->SetUseJittering(jittered);
    mapper->SetAutoAdjustSampleDistances(jittered);
    if (auto* slices = vtkOpenGLTextureSliceVolumeMapper::SafeDownCast(mapper))
    {
      slices->SetNumberOfSlices(jittered ? 0 : Slices);
      slices->SetMaxMemoryInBytes(mode.Particular == Special::Paged ? 1 : 0);
    }
    mapper->SetBlendMode(mode.BlendMode);
    mapper->SetAverageIPScalarRange(30.0, 90.0);
  }
  contest.Run(mode.Name, mode.Particular == Special::Dragged);
  if (auto* slices =
        vtkOpenGLTextureSliceVolumeMapper::SafeDownCast(contest.GetContenders().front().Mapper))
  {
    std::fprintf(stderr, "%s: %.1f MiB of texture\n", mode.Name,
      static_cast<double>(slices->GetTextureBytes()) / (1 << 20));
  }
}

void PrintHeading(const char* title, const char* drawn)
{
  std::printf("\n%s, milliseconds\n\n| volume | scalars | %s | %s |\n"
              "|---|---|---|---|---|---|---|---|---|---|\n",
    title, drawn, TimesHeading);
}

void MeasureModes(const std::vector<int>& sizes)
{
  PrintHeading("Blend modes on the storms", "blend mode");
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

std::vector<Contender> MakeAllContenders(int scalarType)
{
  const auto makeProperty = [scalarType] { return MakeProperty(scalarType); };
  std::vector<Contender> contenders = MakeContenders(Slices, true, makeProperty);
  if (WithFixedPoint)
  {
    auto fixedPoint = vtkSmartPointer<vtkFixedPointVolumeRayCastMapper>::New();
    fixedPoint->AutoAdjustSampleDistancesOff();
    fixedPoint->SetImageSampleDistance(1.0f);
    contenders.push_back(
      {"fixed-point ray caster", fixedPoint, nullptr, makeProperty(), {}, {}, {}});
  }
  return contenders;
}

void MeasureSize(int size)
{
  for (const int scalarType : {VTK_FLOAT, VTK_UNSIGNED_CHAR})
  {
    const auto storm = nexrad::benchmarks::MakeSyntheticStorm({size, size, size / 2}, scalarType);
    std::fprintf(stderr, "%d points along x, %s: %.1f %% of the voxels are visible\n", size,
      storm->GetScalarTypeAsString(), 100.0 * VisibleFraction(storm, MakeProperty(scalarType)));
    Contest contest(storm, MakeAllContenders(scalarType));
    contest.Run("storms");
    for (const double opacity : {0.02, 0.5, 1.0})
    {
      for (Contender& contender : contest.GetContenders())
      {
        contender.Property->SetScalarOpacityUnitDistance(1.0);
        contender.Property->GetScalarOpacity()->RemoveAllPoints();
        contender.Property->GetScalarOpacity()->AddPoint(0.0, opacity);
      }
      char name[64];
      std::snprintf(name, sizeof(name), "everywhere %.2f", opacity);
      contest.Run(name);
    }
  }
}

void MeasureLight(const std::vector<int>& sizes)
{
  std::printf("\nShadows and occlusion: a frame without and with them, and a new light volume for "
              "another light, table or volume, and for another table during an interaction, "
              "milliseconds\n\n"
              "| volume | scalars | drawn | without | with | with / without | processor with / "
              "without | light | table | volume | dragged |\n"
              "|---|---|---|---|---|---|---|---|---|---|---|\n");
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

void MeasureSizes(const std::vector<int>& sizes)
{
  PrintHeading("Frames", "visible");
  for (const int size : sizes)
  {
    MeasureSize(size);
  }
}

/// What is measured.
struct Arguments
{
  std::string Part; ///< empty: all
  std::vector<int> Sizes;
};

/// @return false if something is wrong
bool Parse(const std::vector<std::string>& words, Arguments& arguments)
{
  for (std::size_t i = 0; i < words.size(); ++i)
  {
    const bool hasValue = i + 1 < words.size();
    if (words[i] == "--size" && hasValue)
    {
      WithFixedPoint = false;
      if (std::sscanf(words[++i].c_str(), "%dx%d", &Width, &Height) != 2)
      {
        return false;
      }
    }
    else if (words[i] == "--slices" && hasValue)
    {
      Slices = std::atoi(words[++i].c_str());
    }
    else if (words[i] == "frames" || words[i] == "light" || words[i] == "modes")
    {
      arguments.Part = words[i];
    }
    else
    {
      arguments.Sizes.push_back(std::atoi(words[i].c_str()));
    }
  }
  return Width > 0 && Height > 0 && Slices > 0 &&
         std::all_of(arguments.Sizes.begin(), arguments.Sizes.end(),
           [](int size) { return size >= 4 && size <= 2048; });
}

} // namespace

int main(int argc, char* argv[])
{
  Arguments arguments;
  if (!Parse({argv + 1, argv + argc}, arguments))
  {
    std::fprintf(stderr,
      "usage: BenchmarkMapper [--size WIDTHxHEIGHT] [--slices N] [frames|light|modes] "
      "[points along x, 4 to 2048 ...]\n");
    return 2;
  }
  if (arguments.Sizes.empty())
  {
    arguments.Sizes = {128, 256, 512};
  }
  PrintRenderer(Scene(16, 16, 0, false).GetWindow());
  std::printf("%d x %d pixels, %d slices, median of %d views\n", Width, Height, Slices, Views);
  if (arguments.Part.empty() || arguments.Part == "frames")
  {
    MeasureSizes(arguments.Sizes);
  }
  if (arguments.Part.empty() || arguments.Part == "light")
  {
    MeasureLight(arguments.Sizes);
  }
  if (arguments.Part.empty() || arguments.Part == "modes")
  {
    MeasureModes(arguments.Sizes);
  }
  return 0;
}
