// SPDX-License-Identifier: BSD-3-Clause
#include "Drawing/Render.h"

#include "Drawing/MapFiles.h"
#include "Drawing/MovieOutput.h"
#include "Drawing/PictureWindow.h"
#include "Drawing/SurfaceFiles.h"
#include "Drawing/VolumeOutputs.h"
#include "Scene/RadarSession.h"
#include "Scene/VolumeAppearance.h"
#include "nexrad/Merging/SeriesMerger.h"
#include "nexrad/System/Error.h"
#include "nexrad/System/MessageText.h"
#include "nexrad/System/Progress.h"

#include <vtkImageData.h>

#include <memory>
#include <string>
#include <utility>

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

void DrawPictures(const RenderRequest& request, RadarSession& session, RenderReport& report)
{
  PictureWindow window(session.Scene(), request.size);
  const Progress drawing = ShareOf(request.progress, ScanShare, 1.0);
  for (std::size_t i = 0; i < session.Count(); ++i)
  {
    const Progress part = ShareOf(drawing, i, session.Count());
    session.Show(i, part);
    const fs::path name = PictureName(request.output, session.TimeAt(i), session.Count() > 1);
    WritePng(DrawFor(name, window), name);
    report.outputs.push_back(name);
    GoOn(part);
  }
}

void DrawMovie(const RenderRequest& request, RadarSession& session, RenderReport& report)
{
  const std::size_t frames =
    request.frames > 0 ? static_cast<std::size_t>(request.frames) : session.Count();
  PictureWindow window(session.Scene(), request.size);
  const Progress drawing = ShareOf(request.progress, ScanShare, 1.0);
  const auto writer = MakeMovieWriter(request.output, request.size, request.framesPerSecond);
  for (std::size_t frame = 0; frame < frames; ++frame)
  {
    const Progress part = ShareOf(drawing, frame, frames);
    session.Show(frame * session.Count() / frames, part);
    CameraView view = request.camera;
    view.azimuth += request.turn * static_cast<double>(frame) / static_cast<double>(frames);
    session.Scene().SetCamera(view);
    writer->AddFrame(DrawFor(request.output, window));
    GoOn(part);
  }
  writer->Finish();
  report.outputs.push_back(request.output);
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
  RadarSession session(std::move(series), std::move(chosen), request.scene, request.input.box);
  session.Scene().SetCamera(request.camera);
  if (pictures)
  {
    DrawPictures(request, session, report);
    SayThatThereAreSeveral(request, report);
  }
  else
  {
    DrawMovie(request, session, report);
  }
  report.problems = session.Problems();
  return report;
}

} // namespace nexrad::scene
