// SPDX-License-Identifier: BSD-3-Clause
#include "Frames/MeasureDrawing.h"

#include "Frames/VolumeStage.h"
#include "Scene/Series/VolumeFiles.h"

#include <vtkImageData.h>
#include <vtkVolumeMapper.h>

#include <algorithm>

namespace nexrad::scene
{
namespace
{

using application::DrawingOfSize;
using application::DrawingRequest;
using application::FrameTimes;
using application::Measurement;

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

DrawingOfSize MeasureSize(VolumeStage& stage, const application::VolumesOfSize& volumes,
  const DrawingRequest& request, const Progress& progress)
{
  DrawingOfSize times;
  times.dimensions = volumes.dimensions;
  MeasureLoading(stage, volumes, request.runs, times);
  for (std::size_t i = 0; i < request.slices.size(); ++i)
  {
    times.frames.push_back(MeasureFrames(stage, request.slices[i], request.runs));
    if (progress)
    {
      progress(static_cast<double>(i + 1) / static_cast<double>(request.slices.size()));
    }
  }
  return times;
}

} // namespace

application::DrawingReport MeasureDrawing(const DrawingRequest& request)
{
  application::DrawingReport report;
  for (std::size_t i = 0; i < request.volumes.size(); ++i)
  {
    // A window for each size: the textures of one size do not stay beside those of the next.
    VolumeStage stage(request.size);
    report.sizes.push_back(MeasureSize(
      stage, request.volumes[i], request, ShareOf(request.progress, i, request.volumes.size())));
    report.opengl = stage.OpenGL();
  }
  return report;
}

} // namespace nexrad::scene
