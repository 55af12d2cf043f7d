// SPDX-License-Identifier: BSD-3-Clause
#include "Export/MovieExport.h"

#include "Drawing/MovieWriter.h"
#include "Drawing/PictureWindow.h"
#include "Export/SceneState.h"
#include "Scene/Frame/VolumeInformation.h"

#include <vtkImageData.h>
#include <vtkNexradVolumeScene.h>

#include <QTimer>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <exception>
#include <utility>

namespace nexrad::viewer
{
namespace
{

constexpr int pause = 10; // ms, until something that is waited for is asked for again

bool IsPicture(const std::filesystem::path& output)
{
  return output.extension() == ".png";
}

} // namespace

int FramesPerSecond(Duration interval)
{
  const double milliseconds = std::max(1.0, static_cast<double>(interval.count()));
  return static_cast<int>(std::lround(std::clamp(1000.0 / milliseconds, 1.0, 120.0)));
}

MovieExport::MovieExport(MovieJob movie, QObject* parent)
  : QObject(parent)
  , job(std::move(movie))
{
  QTimer::singleShot(0, this, &MovieExport::Turn);
}

MovieExport::~MovieExport()
{
  if (writing.valid())
  {
    writing.wait();
  }
  if (window)
  {
    window->MakeCurrent();
  }
}

void MovieExport::Begin()
{
  const scene::DrawingRequest& drawing = job.shown.drawing;
  scene::SceneOptions options = drawing.scene;
  options.namesOptions = false; // as in the window
  scene->SetOptions(options);
  scene->SetView(drawing.camera);
  window = std::make_unique<scene::PictureWindow>(scene->GetRenderer(), drawing.size);
  if (!IsPicture(job.output))
  {
    writer = scene::MakeMovieWriter(
      job.output, job.shown.drawing.size, FramesPerSecond(job.shown.interval));
  }
}

// Hands the next frame, or the end, to the other thread. False when there is nothing to write yet.
bool MovieExport::Write()
{
  if (frame == job.times.size())
  {
    finishing = true;
    writing = std::async(std::launch::async,
      [this]
      {
        if (writer)
        {
          writer->Finish();
        }
      });
    return true;
  }
  const vtkSmartPointer<vtkImageData> volume = job.volume(frame);
  if (!volume)
  {
    return false;
  }
  const vtkSmartPointer<vtkImageData> box = job.box ? job.box(frame) : nullptr;
  if (job.box && !box)
  {
    return false;
  }
  window->MakeCurrent();
  scene->SetVolume(volume);
  if (box)
  {
    const auto [west, east, south, north] = scene::SidesOf(box);
    scene->SetDetail(box);
    scene->MarkBox(west, east, south, north);
  }
  scene->Draw();
  if (frame == 0)
  {
    SetColours(job.shown.colours, {}, scene);
  }
  const vtkSmartPointer<vtkImageData> picture = window->Draw();
  const auto name = scene::PictureName(job.output, job.times[frame], job.times.size() > 1);
  writing = std::async(std::launch::async,
    [this, picture, name] { writer ? writer->AddFrame(picture) : scene::WritePng(picture, name); });
  ++frame;
  emit Advanced(static_cast<int>(frame));
  return true;
}

void MovieExport::Turn()
{
  try
  {
    if (!window)
    {
      this->Begin();
    }
    const bool busy =
      writing.valid() && writing.wait_for(std::chrono::seconds(0)) != std::future_status::ready;
    if (!busy && writing.valid())
    {
      writing.get(); // throws what went wrong
      if (finishing)
      {
        emit Ended("");
        return;
      }
    }
    const bool done = !busy && this->Write();
    QTimer::singleShot(done ? 0 : pause, this, &MovieExport::Turn);
  }
  catch (const std::exception& error)
  {
    emit Ended(error.what());
  }
}

} // namespace nexrad::viewer
