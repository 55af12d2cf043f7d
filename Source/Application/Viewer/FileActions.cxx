// SPDX-License-Identifier: BSD-3-Clause
#include "Viewer/FileActions.h"

#include "Export/MovieExport.h"
#include "Export/SceneState.h"
#include "Options/DrawingOptions.h"
#include "Options/SessionFile.h"
#include "Output/OutputFile.h"
#include "Viewer/Playback.h"
#include "Viewer/SceneView.h"
#include "nexrad/Codec/NxvFile.h"
#include "nexrad/System/Error.h"
#include "nexrad/System/MessageText.h"
#include "vtkNexradImageConversion.h"
#include "vtkNexradMessages.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkNexradVolumeScene.h>
#include <vtkXMLImageDataWriter.h>

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QFileDialog>
#include <QKeySequence>
#include <QMenu>
#include <QProgressDialog>

#include <algorithm>
#include <exception>
#include <string>
#include <utility>
#include <vector>

namespace fs = std::filesystem;

namespace nexrad::viewer
{
namespace
{

constexpr char sessionFilter[] = "Sessions (*.nxsession)";
constexpr char notOpenYet[] = "The files are not open yet: wait for their first time";
constexpr char syntheticFolder[] = "synthetic-hour";

// Colours that were edited go into a file, which the command names.
fs::path WriteColours(const std::string& colours, const fs::path& folder, const std::string& time)
{
  const fs::path path = folder / ("nexrad3d-" + time + "-colours.json");
  application::WriteFile(
    path, reinterpret_cast<const unsigned char*>(colours.data()), colours.size());
  return path;
}

// As VTK XML image data. The file appears whole or not at all.
void WriteVti(const fs::path& path, const GriddedVolume& volume)
{
  vtkNew<vtkImageData> image;
  vtkNexradVolumeToImage(volume, image);
  vtkNexradAddRadarView(image);
  vtkNew<vtkXMLImageDataWriter> writer;
  vtkNexradMessages messages;
  messages.Watch(writer);
  writer->SetInputData(image);
  // To memory first: VTK's writer leaves a cut file behind when the disk is full.
  writer->WriteToOutputStringOn();
  writer->Write();
  if (!messages.Errors().empty())
  {
    throw FileError(path, messages.Errors().front());
  }
  const std::string bytes = writer->GetOutputString();
  application::WriteFile(path, reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size());
}

// Done on another thread: conversion and compression take longer than a window may wait.
void WriteVolume(vtkImageData* volume, const fs::path& path)
{
  const GriddedVolume values = vtkNexradImageToVolume(volume);
  if (path.extension() == ".vti")
  {
    WriteVti(path, values);
  }
  else
  {
    WriteNxv(path, values);
  }
}

// A path with one of these endings: as it is typed, or with the first of them.
fs::path WithEnding(const QString& path, const std::vector<std::string>& endings)
{
  const fs::path typed = path.toStdString();
  const std::string ending = typed.extension().string();
  return std::find(endings.begin(), endings.end(), ending) != endings.end()
           ? typed
           : fs::path(typed.string() + endings.front());
}

} // namespace

FileActions::FileActions(QWidget* mainWindow, SceneView& sceneView, Playback& thePlayback,
  std::function<application::Session()> shownNow, std::filesystem::path pictureFolder)
  : QObject(mainWindow)
  , window(mainWindow)
  , view(sceneView)
  , playback(thePlayback)
  , shown(std::move(shownNow))
  , pictures(std::move(pictureFolder))
{
}

FileActions::~FileActions()
{
  if (writing.valid())
  {
    writing.wait();
  }
}

QList<QAction*> FileActions::AddTo(QMenu* menu)
{
  menu->setToolTipsVisible(true);
  QAction* copy = menu->addAction(
    "Copy the &render command", this, &FileActions::CopyCommand, QKeySequence("Ctrl+Shift+C"));
  copy->setToolTip("Put the command on the clipboard that draws this picture without the window");
  QAction* volume = menu->addAction(
    "Save &volume as…", this, &FileActions::AskToSaveVolume, QKeySequence("Ctrl+E"));
  volume->setToolTip("Save the volume that is shown as .nxv or .vti");
  QAction* movies =
    menu->addAction("Save &movie as…", this, &FileActions::AskToSaveMovie, QKeySequence("Ctrl+M"));
  movies->setToolTip("Draw all times as .ogv or .mp4, or as a .png each");
  menu->addSeparator();
  QAction* open = menu->addAction("Open s&ession…", this, &FileActions::AskForSession);
  open->setToolTip("Open what was saved as a session, in place of what is open");
  QAction* save = menu->addAction(
    "Save sessio&n…", this, &FileActions::AskToSaveSession, QKeySequence("Ctrl+Shift+S"));
  save->setToolTip("Save the inputs, the time, the camera and all settings to a file");
  return {copy, volume, movies, save};
}

void FileActions::CopyCommand()
{
  application::Session session = shown();
  if (!session.shown)
  {
    emit Said(notOpenYet);
    return;
  }
  const std::string time = FormatForFileName(*session.shown);
  std::string before;
  try
  {
    scene::DrawingRequest& drawing = session.drawing;
    drawing.input.time = session.shown;
    if (!session.colours.empty())
    {
      UseColours(WriteColours(session.colours, pictures, time), drawing.scene);
    }
    if (session.synthetic)
    {
      drawing.input.inputs = {fs::absolute(syntheticFolder)};
      before = "nexrad3d simulate " +
               application::QuoteForShell(drawing.input.inputs.front().string()) + " --hours 1 && ";
    }
    QApplication::clipboard()->setText(QString::fromStdString(
      before + application::RenderCommandOf(drawing, "nexrad3d-" + time + ".png")));
    emit Said("The command that draws this picture is on the clipboard");
  }
  catch (const Error& error)
  {
    emit Failed(error.what());
  }
}

void FileActions::AskToSaveSession()
{
  const application::Session session = shown();
  if (!session.shown)
  {
    emit Said(notOpenYet);
    return;
  }
  const QString typed =
    QFileDialog::getSaveFileName(window, "Save session", "nexrad3d.nxsession", sessionFilter);
  if (typed.isEmpty())
  {
    return;
  }
  const fs::path path = WithEnding(typed, {application::SessionSuffix});
  try
  {
    application::WriteSession(path, session);
    emit Said("wrote " + QString::fromStdString(path.string()));
  }
  catch (const Error& error)
  {
    emit Failed(error.what());
  }
}

void FileActions::AskForSession()
{
  const QString path = QFileDialog::getOpenFileName(window, "Open session", "", sessionFilter);
  if (!path.isEmpty())
  {
    emit PathWanted(path);
  }
}

void FileActions::OpenSession(const fs::path& path)
{
  try
  {
    emit SessionRead(
      application::ReadSession(path), QString::fromStdString(path.filename().string()));
  }
  catch (const Error& error)
  {
    emit Failed(error.what());
  }
}

void FileActions::AskToSaveVolume()
{
  const QString path = QFileDialog::getSaveFileName(
    window, "Save volume", "nexrad3d.nxv", "Volumes (*.nxv);;VTK image data (*.vti)");
  if (!path.isEmpty())
  {
    this->SaveVolume(WithEnding(path, {".nxv", ".vti"}));
  }
}

void FileActions::SaveVolume(const fs::path& path)
{
  const vtkSmartPointer<vtkImageData> volume = view.Scene()->GetVolume();
  if (writing.valid())
  {
    writing.wait(); // for the volume before
  }
  writing = std::async(std::launch::async,
    [this, volume, path]
    {
      QString problem;
      try
      {
        WriteVolume(volume, path);
      }
      catch (const std::exception& error)
      {
        problem = error.what();
      }
      const auto report = [this, path, problem]
      {
        problem.isEmpty() ? this->Said("wrote " + QString::fromStdString(path.string()))
                          : this->Failed(problem);
      };
      QMetaObject::invokeMethod(this, report, Qt::QueuedConnection);
    });
}

void FileActions::AskToSaveMovie()
{
  if (playback.State().times.empty())
  {
    emit Said(notOpenYet);
    return;
  }
  const QString path = QFileDialog::getSaveFileName(
    window, "Save movie", "nexrad3d.ogv", "Movies (*.ogv *.mp4);;A picture of each time (*.png)");
  if (!path.isEmpty())
  {
    this->SaveMovie(WithEnding(path, {".ogv", ".mp4", ".png"}));
  }
}

void FileActions::SaveMovie(const fs::path& path)
{
  MovieJob job;
  job.output = path;
  job.shown = shown();
  job.times = playback.State().times;
  job.volume = [this, times = job.times](std::size_t frame)
  {
    if (playback.State().times != times)
    {
      throw Error("something else was opened: the movie is not finished");
    }
    return playback.Volume(frame);
  };
  if (playback.HasBox())
  {
    job.box = [this](std::size_t frame)
    {
      if (!playback.HasBox())
      {
        throw Error("the box was taken away: the movie is not finished");
      }
      return playback.VolumeOfBox(frame);
    };
  }
  const QString name = QString::fromStdString(path.string());
  delete progress;
  progress =
    new QProgressDialog("Drawing " + name, "Cancel", 0, static_cast<int>(job.times.size()), window);
  progress->setObjectName("movie");
  progress->setAutoReset(false);
  progress->setMinimumDuration(0);
  movie = std::make_unique<MovieExport>(std::move(job));
  connect(movie.get(), &MovieExport::Advanced, progress, &QProgressDialog::setValue);
  const auto makeCurrent = [this] { view.makeCurrent(); };
  connect(movie.get(), &MovieExport::Advanced, &view, makeCurrent);
  connect(movie.get(), &QObject::destroyed, &view, makeCurrent);
  connect(movie.get(), &MovieExport::Ended, this,
    [this, name](const QString& problem) { this->EndMovie(name, problem); });
  connect(progress, &QProgressDialog::canceled, this,
    [this, name]
    {
      this->CloseMovie();
      emit Said("cancelled: " + name + " is not written");
    });
  progress->show();
}

void FileActions::CloseMovie()
{
  movie->disconnect(this);
  movie.release()->deleteLater(); // which may have called this
  progress->deleteLater();
  progress = nullptr;
}

void FileActions::EndMovie(const QString& path, const QString& problem)
{
  this->CloseMovie();
  problem.isEmpty() ? this->Said("wrote " + path) : this->Failed(problem);
}

} // namespace nexrad::viewer
