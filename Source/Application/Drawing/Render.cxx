// SPDX-License-Identifier: BSD-3-Clause
#include "Drawing/Render.h"

#include "Drawing/MapFiles.h"
#include "Drawing/MovieWriter.h"
#include "Drawing/PictureWindow.h"
#include "Drawing/VolumeOutputs.h"
#include "Gltf/SurfaceScene.h"
#include "Output/OutputFile.h"
#include "Scene/VolumeAppearance.h"
#include "nexrad/Merging/SeriesMerger.h"
#include "nexrad/System/Error.h"
#include "nexrad/System/MessageText.h"
#include "nexrad/System/Progress.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkNexradSession.h>
#include <vtkNexradVolumeScene.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace fs = std::filesystem;

namespace nexrad::scene
{
namespace
{

void GoOn(const Progress& progress)
{
  if (progress && !progress(1.0))
  {
    throw Error("stopped before all was drawn");
  }
}

// Draws the picture of a file; an error names the file.
vtkSmartPointer<vtkImageData> DrawFor(const fs::path& file, PictureWindow& window)
{
  try
  {
    return window.Draw();
  }
  catch (const Error& problem)
  {
    throw FileError(file, std::string("cannot be drawn: ") + problem.what());
  }
}

// What is drawn: a session, and the times of its steps.
struct Shown
{
  vtkNew<vtkNexradSession> session;
  std::vector<Time> times;
};

void DrawPictures(const RenderRequest& request, Shown& shown, RenderReport& report)
{
  PictureWindow window(shown.session->GetScene()->GetRenderer(), request.size);
  const Progress drawing = ShareOf(request.progress, ScanShare, 1.0);
  const std::size_t count = shown.times.size();
  for (std::size_t i = 0; i < count; ++i)
  {
    const Progress part = ShareOf(drawing, i, count);
    shown.session->Show(static_cast<int>(i), part);
    const fs::path name = PictureName(request.output, shown.times[i], count > 1);
    WritePng(DrawFor(name, window), name);
    report.outputs.push_back(name);
    GoOn(part);
  }
}

void DrawMovie(const RenderRequest& request, Shown& shown, RenderReport& report)
{
  const std::size_t count = shown.times.size();
  const std::size_t frames = request.frames > 0 ? static_cast<std::size_t>(request.frames) : count;
  vtkNexradVolumeScene* scene = shown.session->GetScene();
  PictureWindow window(scene->GetRenderer(), request.size);
  const Progress drawing = ShareOf(request.progress, ScanShare, 1.0);
  const auto writer = MakeMovieWriter(request.output, request.size, request.framesPerSecond);
  for (std::size_t frame = 0; frame < frames; ++frame)
  {
    const Progress part = ShareOf(drawing, frame, frames);
    CameraView view = request.camera;
    view.azimuth += request.turn * static_cast<double>(frame) / static_cast<double>(frames);
    scene->SetView(view);
    shown.session->Show(static_cast<int>(frame * count / frames), part);
    writer->AddFrame(DrawFor(request.output, window));
    GoOn(part);
  }
  writer->Finish();
  report.outputs.push_back(request.output);
}

RenderReport WriteSurfaces(const RenderRequest& request)
{
  const auto write = [&request](const fs::path& path, vtkImageData* volume)
  {
    const std::vector<unsigned char> bytes = MakeGlb(MakeSurfaceScene(volume, request.scene));
    application::WriteFile(path, bytes.data(), bytes.size());
  };
  return WriteEachVolume(request, write);
}

} // namespace

RenderReport Render(const RenderRequest& asked)
{
  RenderRequest request = asked;
  if (request.output.extension() == ".tif")
  {
    return WriteMaps(request);
  }
  if (request.output.extension() == ".glb")
  {
    return WriteSurfaces(request);
  }
  RequireDisplay();
  RenderReport report;
  report.notes = LinesPassedOver(request.scene);
  const bool pictures = request.output.extension() == ".png";
  auto series =
    pictures ? OpenForPictures(request, report) : OpenInputs(request.input, request.progress);
  std::vector<std::size_t> chosen = ChooseTimes(*series, request.input);
  Shown shown;
  for (const std::size_t index : chosen)
  {
    shown.times.push_back(series->Times()[index]);
  }
  shown.session->SetSeries(std::move(series), std::move(chosen), request.input.box);
  shown.session->GetScene()->SetOptions(request.scene);
  shown.session->GetScene()->SetView(request.camera);
  if (pictures)
  {
    DrawPictures(request, shown, report);
    SayThatThereAreSeveral(request, report);
  }
  else
  {
    DrawMovie(request, shown, report);
  }
  report.problems = shown.session->Problems();
  return report;
}

} // namespace nexrad::scene
