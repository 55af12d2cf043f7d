// SPDX-License-Identifier: BSD-3-Clause
#include "Tables/MeasureDrawing.h"

#include "Drawing/PictureWindow.h"
#include "Filters/Series/VolumeFiles.h"
#include "Scene/Frame/CameraView.h"
#include "Scene/Frame/SceneFrame.h"
#include "Scene/SceneOptions.h"
#include "Scene/VolumeAppearance.h"
#include "Tables/BenchReport.h"
#include "Tables/Measurement.h"
#include "vtkNexradTransferFunction.h"

#include <vtkCamera.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkVolume.h>
#include <vtkVolumeMapper.h>
#include <vtkVolumeProperty.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

namespace nexrad::scene
{
namespace
{

using application::DrawingOfSize;
using application::DrawingRequest;
using application::FrameTimes;
using application::Measurement;

// How much heights are stretched, whatever is drawn: times of volumes are compared.
constexpr double exaggeration = 8.0;

// The value after "NAME:" in the lines of a report.
std::string Entry(const std::string& report, const std::string& name)
{
  std::istringstream lines(report);
  for (std::string line; std::getline(lines, line);)
  {
    if (line.compare(0, name.size() + 1, name + ':') == 0)
    {
      const std::size_t start = line.find_first_not_of(' ', name.size() + 1);
      return start == std::string::npos ? "unknown" : line.substr(start);
    }
  }
  return "unknown";
}

/// A window with a volume alone in it, without map and letters, drawn by the slices or by VTK's GPU
/// ray caster: for measuring. Colours, opacities and stretching of heights are those of the
/// program.
class VolumeStage
{
public:
  /// Throws Error when there is no display.
  explicit VolumeStage(const std::array<int, 2>& size);
  ~VolumeStage();
  VolumeStage(const VolumeStage&) = delete;
  VolumeStage& operator=(const VolumeStage&) = delete;

  /// The volume to be drawn by one of the two, as the project's filters write them. It is not
  /// changed.
  void SetVolume(MapperChoice choice, vtkImageData* volume);

  /// Draws a frame and waits until OpenGL has done it. Slices, or samples of the rays, are 1 /
  /// `slices` of the box's extent along the view's axis apart. Returns seconds.
  double Draw(MapperChoice choice, const CameraView& view, int slices);

  application::OpenGLNames OpenGL();

private:
  vtkVolumeMapper* Mapper(MapperChoice choice) { return mappers[static_cast<int>(choice)]; }
  double ThicknessAlongView() const;

  std::array<int, 2> size;
  std::array<double, 6> box{}; ///< faces of the volume: west, east, south, north, bottom, top
  std::array<vtkSmartPointer<vtkVolumeMapper>, 2> mappers; ///< in the order of MapperChoice
  vtkSmartPointer<vtkImageData> placed;
  vtkNew<vtkVolume> volume;
  vtkNew<vtkRenderer> renderer;
  vtkSmartPointer<vtkRenderWindow> window;
};

VolumeStage::VolumeStage(const std::array<int, 2>& pictureSize)
  : size(pictureSize)
{
  RequireDisplay();
  SceneOptions options;
  options.preIntegration = false;
  for (const MapperChoice choice : {MapperChoice::TextureSlice, MapperChoice::RayCast})
  {
    options.mapper = choice;
    mappers[static_cast<std::size_t>(choice)] = MakeVolumeMapper(options);
  }
  volume->SetProperty(MakeVolumeProperty());
  MakeTransferFunction(options)->FillProperty(volume->GetProperty());
  renderer->AddVolume(volume);
  window = vtkSmartPointer<vtkRenderWindow>::New();
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(0);
  window->SetSize(size[0], size[1]);
  window->AddRenderer(renderer);
}

VolumeStage::~VolumeStage() = default;

void VolumeStage::SetVolume(MapperChoice choice, vtkImageData* data)
{
  const SceneFrame frame(data, exaggeration);
  placed = vtkSmartPointer<vtkImageData>::New();
  placed->ShallowCopy(data);
  frame.MoveToScene(placed);
  box = frame.Bounds();
  this->Mapper(choice)->SetInputDataObject(placed);
}

double VolumeStage::ThicknessAlongView() const
{
  const double* axis = renderer->GetActiveCamera()->GetDirectionOfProjection();
  const double* bounds = placed->GetBounds();
  double thickness = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    thickness += std::abs(axis[i]) * (bounds[2 * i + 1] - bounds[2 * i]);
  }
  return thickness;
}

double VolumeStage::Draw(MapperChoice choice, const CameraView& view, int slices)
{
  const double aspect = static_cast<double>(size[0]) / size[1];
  PointCamera(renderer->GetActiveCamera(), view, box, aspect, PictureArea());
  renderer->ResetCameraClippingRange();
  volume->SetMapper(this->Mapper(choice));
  SetSlices(this->Mapper(choice), slices, this->ThicknessAlongView());
  return application::SecondsOf(
    [this]
    {
      window->Render();
      window->WaitForCompletion();
    });
}

application::OpenGLNames VolumeStage::OpenGL()
{
  const std::string report = window->ReportCapabilities();
  return {Entry(report, "OpenGL vendor string"), Entry(report, "OpenGL renderer string"),
    Entry(report, "OpenGL version string")};
}

// From one of `count` sides, 20° from the vertical.
CameraView ViewFrom(int side, int count)
{
  CameraView view;
  view.azimuth += 360.0 * side / count;
  view.tilt = 70.0;
  return view;
}

// Seconds of each volume.
struct LoadingTimes
{
  std::vector<double> read;
  std::vector<double> upload;
};

// What a new volume adds to a frame; never below 0, though noise can be. One slice draws next to
// nothing.
double UploadSeconds(VolumeStage& stage, MapperChoice mapper)
{
  const CameraView view = ViewFrom(0, 1);
  const double first = stage.Draw(mapper, view, 1);
  return std::max(0.0, first - stage.Draw(mapper, view, 1));
}

void MeasureVolume(VolumeStage& stage, MapperChoice mapper, VolumeSeries& series, std::size_t index,
  LoadingTimes& times)
{
  vtkSmartPointer<vtkImageData> volume;
  series.AllowCodes(mapper == MapperChoice::TextureSlice); // as the program does
  times.read.push_back(application::SecondsOf([&] { volume = series.Load(index, {}); }));
  stage.SetVolume(mapper, volume);
  times.upload.push_back(UploadSeconds(stage, mapper));
}

// Shows the volumes one after the other, back at the first after the last. The first makes
// textures and shaders, and does not count.
void MeasureLoading(
  VolumeStage& stage, const application::VolumesOfSize& volumes, int runs, DrawingOfSize& times)
{
  const auto series = OpenVolumeFiles(volumes.files);
  LoadingTimes slicing;
  LoadingTimes rayCasting;
  for (int run = 0; run <= runs; ++run)
  {
    const auto index = static_cast<std::size_t>(run) % series->Times().size();
    MeasureVolume(stage, MapperChoice::TextureSlice, *series, index, slicing);
    MeasureVolume(stage, MapperChoice::RayCast, *series, index, rayCasting);
  }
  const auto summarize = [](std::vector<double>& seconds)
  {
    seconds.erase(seconds.begin());
    return application::Summarize(seconds);
  };
  times.read = summarize(slicing.read);
  times.upload = summarize(slicing.upload);
  times.rayCastingRead = summarize(rayCasting.read);
  times.rayCastingUpload = summarize(rayCasting.upload);
}

FrameTimes MeasureFrames(VolumeStage& stage, int slices, int runs)
{
  std::vector<double> slicing;
  std::vector<double> rayCasting;
  for (int run = 0; run < runs; ++run)
  {
    const CameraView view = ViewFrom(run, runs);
    slicing.push_back(stage.Draw(MapperChoice::TextureSlice, view, slices));
    rayCasting.push_back(stage.Draw(MapperChoice::RayCast, view, slices));
  }
  return {slices, application::Summarize(slicing), application::Summarize(rayCasting)};
}

DrawingOfSize MeasureSize(
  VolumeStage& stage, const application::VolumesOfSize& volumes, const DrawingRequest& request)
{
  DrawingOfSize times;
  times.dimensions = volumes.dimensions;
  MeasureLoading(stage, volumes, request.runs, times);
  for (const int slices : request.slices)
  {
    times.frames.push_back(MeasureFrames(stage, slices, request.runs));
  }
  return times;
}

} // namespace

application::DrawingReport MeasureDrawing(const DrawingRequest& request)
{
  application::DrawingReport report;
  for (const application::VolumesOfSize& volumes : request.volumes)
  {
    // A window for each size: the textures of one size do not stay beside those of the next.
    VolumeStage stage(request.size);
    report.sizes.push_back(MeasureSize(stage, volumes, request));
    report.opengl = stage.OpenGL();
  }
  return report;
}

} // namespace nexrad::scene
