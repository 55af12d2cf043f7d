// SPDX-License-Identifier: BSD-3-Clause
#include "RenderRequest.h"

#include "Model/Error.h"
#include "MovieWriter.h"
#include "PictureWindow.h"
#include "ProgressShare.h"
#include "RadarScene.h"
#include "Volumes/VolumeSeries.h"

#include <vtkImageData.h>

#include <algorithm>
#include <cmath>

namespace fs = std::filesystem;

namespace nexrad::scene
{
namespace
{

using application::ShareOf;
using application::VolumeSeries;

std::unique_ptr<VolumeSeries> OpenInputs(const RenderRequest& request)
{
  const auto holdsVolumes = [](const fs::path& path) { return application::HoldsVolumes(path); };
  const auto count = std::count_if(request.inputs.begin(), request.inputs.end(), holdsVolumes);
  if (count == 0)
  {
    application::GridOptions grid = request.grid;
    if (request.time)
    {
      // Every millisecond is a step, so that the time itself is one.
      grid.begin = grid.end = request.time;
      grid.step = Duration(1);
    }
    return application::OpenRadarFiles(
      request.inputs, grid, ShareOf(request.progress, 0.0, application::scanShare));
  }
  if (count != static_cast<std::ptrdiff_t>(request.inputs.size()))
  {
    throw Error("the inputs are volumes and radar files; draw one or the other");
  }
  return application::OpenVolumeFiles(request.inputs);
}

// Indices of the volumes to draw.
std::vector<std::size_t> ChooseTimes(const VolumeSeries& series, const RenderRequest& request)
{
  const std::vector<Time>& times = series.Times();
  std::vector<std::size_t> chosen;
  for (std::size_t i = 0; i < times.size(); ++i)
  {
    const bool wanted = request.time ? times[i] == *request.time
                                     : (!request.grid.begin || times[i] >= *request.grid.begin) &&
                                         (!request.grid.end || times[i] <= *request.grid.end);
    if (wanted)
    {
      chosen.push_back(i);
    }
  }
  if (chosen.empty())
  {
    throw Error("no volume at the time asked for; there are " + std::to_string(times.size()) +
                " from " + FormatIso8601(times.front()) + " to " + FormatIso8601(times.back()));
  }
  return chosen;
}

SceneOptions OptionsOf(const RenderRequest& request)
{
  SceneOptions options = request.scene;
  if (!request.colourTable.empty())
  {
    options.colours = ReadColourTable(request.colourTable);
  }
  return options;
}

// "out.png" for one picture, "out-20060312T180000Z.png" for one of several.
fs::path PictureName(const fs::path& output, Time time, bool several)
{
  if (!several)
  {
    return output;
  }
  return output.parent_path() /
         (output.stem().string() + "-" + FormatForFileName(time) + output.extension().string());
}

void DrawPictures(const RenderRequest& request, VolumeSeries& series,
  const std::vector<std::size_t>& chosen, RenderReport& report)
{
  RadarScene scene(OptionsOf(request));
  scene.SetCamera(request.camera);
  PictureWindow window(scene, request.size);
  const Progress drawing = ShareOf(request.progress, application::scanShare, 1.0);
  for (std::size_t i = 0; i < chosen.size(); ++i)
  {
    scene.SetVolume(series.Load(chosen[i], ShareOf(drawing, i, chosen.size())));
    const fs::path name = PictureName(request.output, series.Times()[chosen[i]], chosen.size() > 1);
    WritePng(window.Draw(), name);
    report.outputs.push_back(name);
  }
}

std::unique_ptr<MovieWriter> MakeMovieWriter(const RenderRequest& request)
{
  return request.output.extension() == ".mp4"
           ? MakeFfmpegWriter(request.output, request.size.data(), request.framesPerSecond)
           : MakeTheoraWriter(request.output, request.framesPerSecond);
}

void DrawMovie(const RenderRequest& request, VolumeSeries& series,
  const std::vector<std::size_t>& chosen, RenderReport& report)
{
  const std::size_t frames =
    request.frames > 0 ? static_cast<std::size_t>(request.frames) : chosen.size();
  RadarScene scene(OptionsOf(request));
  PictureWindow window(scene, request.size);
  const Progress drawing = ShareOf(request.progress, application::scanShare, 1.0);
  const auto writer = MakeMovieWriter(request);
  std::size_t shown = series.Times().size(); // no volume yet
  for (std::size_t frame = 0; frame < frames; ++frame)
  {
    const std::size_t index = chosen[frame * chosen.size() / frames];
    const Progress part = ShareOf(drawing, frame, frames);
    if (index != shown)
    {
      scene.SetVolume(series.Load(index, part));
      shown = index;
    }
    CameraView view = request.camera;
    view.azimuth += request.turn * static_cast<double>(frame) / static_cast<double>(frames);
    scene.SetCamera(view);
    writer->AddFrame(window.Draw());
    if (part)
    {
      part(1.0);
    }
  }
  writer->Finish();
  report.outputs.push_back(request.output);
}

} // namespace

RenderReport Render(const RenderRequest& request)
{
  RequireDisplay();
  const auto series = OpenInputs(request);
  const std::vector<std::size_t> chosen = ChooseTimes(*series, request);
  RenderReport report;
  if (request.output.extension() == ".png")
  {
    DrawPictures(request, *series, chosen, report);
  }
  else
  {
    DrawMovie(request, *series, chosen, report);
  }
  report.problems = series->Problems();
  return report;
}

} // namespace nexrad::scene
