// SPDX-License-Identifier: BSD-3-Clause
#include "Drawing/Render.h"

#include "Drawing/GeoTiff.h"
#include "Drawing/MovieWriter.h"
#include "Drawing/PictureWindow.h"
#include "Filters/Series/InputSeries.h"
#include "Filters/Series/VolumeSeries.h"
#include "Gltf/SurfaceScene.h"
#include "Scene/VolumeAppearance.h"
#include "nexrad/Merging/SeriesMerger.h"
#include "nexrad/System/Error.h"
#include "nexrad/System/MessageText.h"
#include "nexrad/System/Progress.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkNexradSession.h>
#include <vtkNexradVolumeScene.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace fs = std::filesystem;

namespace nexrad::scene
{

using application::Outcome;

namespace
{

// Whether the user leaves the times to the program.
bool HasFreeTime(const InputRequest& input)
{
  return !input.time && !input.grid.begin && !input.grid.end && !input.grid.step;
}

// Opens the inputs of a request whose output is a file for each time. Files of several radars, one
// of each and within an hour, make one file of all, unless the request names times: then the
// request gets the middle of their times, and takes rays as far from there as the farthest is, and
// the outcome gets a note.
std::unique_ptr<VolumeSeries> OpenForPictures(RenderRequest& request, Outcome& report)
{
  constexpr Duration longestLook = std::chrono::hours(1);
  auto series = OpenInputs(request.input, request.progress);
  const std::optional<TimeSpan> look = series->OneLook();
  if (!look || series->Times().size() < 2 || !HasFreeTime(request.input) ||
      look->last - look->first > longestLook)
  {
    return series;
  }
  series.reset(); // its memory is needed once
  request.input.time = MiddleTime(look->first, look->last);
  MergeOptions& merging = request.input.grid;
  const Duration half = look->last - *request.input.time;
  if (!request.maxGapGiven)
  {
    merging.maximumGap = std::max(merging.maximumGap, half + std::chrono::seconds(1));
  }
  report.notes.push_back(request.output.string() + ": one picture of all radars, at " +
                         FormatIso8601(*request.input.time) + "; their rays are up to " +
                         std::to_string(std::chrono::ceil<std::chrono::minutes>(half).count()) +
                         " min older or newer; --time or --step chooses other times");
  return OpenInputs(request.input, request.progress);
}

// Adds a note where several times made several files of one name.
void SayThatThereAreSeveral(const RenderRequest& request, Outcome& report)
{
  if (report.made.size() > 1)
  {
    report.notes.push_back(request.output.string() + ": " + std::to_string(report.made.size()) +
                           " times make as many pictures, each with its time in its name; --time "
                           "draws one, and a name in .ogv or .mp4 makes a movie");
  }
}

// Writes a file for each time that a request asks for, with the time in its name where there are
// several. Draws nothing, and needs no display.
Outcome WriteEachVolume(const RenderRequest& asked,
  void (*write)(const fs::path& path, vtkImageData* volume, const SceneOptions& options))
{
  RenderRequest request = asked;
  request.input.allVoxels = true;
  Outcome report;
  report.notes = LinesPassedOver(request.scene);
  auto series = OpenForPictures(request, report);
  const std::vector<std::size_t> chosen = ChooseTimes(*series, request.input);
  const Progress writing = ShareOf(request.progress, ScanShare, 1.0);
  for (std::size_t i = 0; i < chosen.size(); ++i)
  {
    const Progress part = ShareOf(writing, i, chosen.size());
    const vtkSmartPointer<vtkImageData> volume = series->Load(chosen[i], part);
    if (!volume || (part && !part(1.0)))
    {
      throw Error("stopped before all files were written");
    }
    const Time time = series->Times()[chosen[i]];
    const fs::path name = PictureName(request.output, time, chosen.size() > 1);
    write(name, volume, request.scene);
    report.made.push_back(name.string());
  }
  SayThatThereAreSeveral(request, report);
  report.problems = series->Problems();
  return report;
}

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

void DrawPictures(const RenderRequest& request, Shown& shown, Outcome& report)
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
    report.made.push_back(name.string());
    GoOn(part);
  }
}

// From where a frame of a movie is seen.
CameraView ViewOf(std::size_t frame, std::size_t frames, const RenderRequest& request)
{
  const auto number = static_cast<double>(frame);
  const auto count = static_cast<double>(frames);
  CameraView view = request.camera;
  if (request.fly && frames > 1)
  {
    view = OnTheWayTo(view, number / (count - 1.0)); // the last frame is there
  }
  view.azimuth += request.turn * number / count; // the last frame is one before the first
  return view;
}

void DrawMovie(const RenderRequest& request, Shown& shown, Outcome& report)
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
    scene->SetView(ViewOf(frame, frames, request));
    shown.session->Show(static_cast<int>(frame * count / frames), part);
    writer->AddFrame(DrawFor(request.output, window));
    GoOn(part);
  }
  writer->Finish();
  report.made.push_back(request.output.string());
}

} // namespace

Outcome Render(const RenderRequest& asked)
{
  RenderRequest request = asked;
  if (request.output.extension() == ".tif")
  {
    return WriteEachVolume(request, WriteGeoTiff);
  }
  if (request.output.extension() == ".glb")
  {
    return WriteEachVolume(request, WriteSurfaces);
  }
  RequireDisplay();
  Outcome report;
  report.notes = LinesPassedOver(request.scene);
  const bool pictures = request.output.extension() == ".png";
  auto series =
    pictures ? OpenForPictures(request, report) : OpenInputs(request.input, request.progress);
  std::vector<std::size_t> chosen = ChooseTimes(*series, request.input);
  if (request.scene.plan && series->LeavesOutFiner(chosen.front()))
  {
    report.notes.push_back(request.output.string() +
                           ": the file has finer voxels than the map, which has those that fit in "
                           "texture memory; a GeoTIFF (-o NAME.tif) has the finest");
  }
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
