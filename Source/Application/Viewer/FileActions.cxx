// SPDX-License-Identifier: BSD-3-Clause
#include "Viewer/FileActions.h"

#include "Options/OptionTexts.h"
#include "Options/SessionFile.h"
#include "Output/OutputFile.h"
#include "Viewer/MainWindow.h"
#include "nexrad/System/Error.h"

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QFileDialog>
#include <QKeySequence>
#include <QMenu>

#include <string>

namespace fs = std::filesystem;

namespace nexrad::viewer
{
namespace
{

constexpr char sessionFilter[] = "Sessions (*.nxsession)";
constexpr char syntheticFolder[] = "synthetic-hour";

// Colours that were edited go into a file, which the command names.
fs::path WriteColours(const std::string& colours, const fs::path& folder, const std::string& time)
{
  const fs::path path = folder / ("nexrad3d-" + time + "-colours.json");
  application::WriteFile(
    path, reinterpret_cast<const unsigned char*>(colours.data()), colours.size());
  return path;
}

} // namespace

FileActions::FileActions(MainWindow& mainWindow)
  : QObject(&mainWindow)
  , window(mainWindow)
{
}

void FileActions::AddTo(QMenu* menu)
{
  QAction* copy = menu->addAction(
    "Copy the &render command", this, &FileActions::CopyCommand, QKeySequence("Ctrl+Shift+C"));
  copy->setToolTip("Put the command on the clipboard that draws this picture without the window");
  menu->addSeparator();
  menu->addAction("Open s&ession…", this, &FileActions::AskForSession);
  QAction* save = menu->addAction(
    "Save sessio&n…", this, &FileActions::AskToSaveSession, QKeySequence("Ctrl+Shift+S"));
  save->setToolTip("Save the inputs, the time, the camera and all settings to a file");
}

void FileActions::CopyCommand()
{
  application::Session session = window.Shown();
  if (!session.shown)
  {
    window.Announce("Open files first: there is nothing to draw yet");
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
      drawing.scene.colours = WriteColours(session.colours, window.PictureFolder(), time);
    }
    if (session.synthetic)
    {
      drawing.input.inputs = {fs::absolute(syntheticFolder)};
      before = "nexrad3d simulate " +
               application::QuoteForShell(drawing.input.inputs.front().string()) + " --hours 1 && ";
    }
    QApplication::clipboard()->setText(QString::fromStdString(
      before + application::RenderCommandOf(drawing, "nexrad3d-" + time + ".png")));
    window.Announce("The command that draws this picture is on the clipboard");
  }
  catch (const Error& error)
  {
    window.Report(error.what());
  }
}

void FileActions::AskToSaveSession()
{
  const application::Session session = window.Shown();
  if (!session.shown)
  {
    window.Announce("Open files first: there is nothing to save yet");
    return;
  }
  QString path =
    QFileDialog::getSaveFileName(&window, "Save session", "nexrad3d.nxsession", sessionFilter);
  if (path.isEmpty())
  {
    return;
  }
  if (!application::IsSessionFile(path.toStdString()))
  {
    path += application::SessionSuffix;
  }
  try
  {
    application::WriteSession(path.toStdString(), session);
    window.Announce("wrote " + path);
  }
  catch (const Error& error)
  {
    window.Report(error.what());
  }
}

void FileActions::AskForSession()
{
  const QString path = QFileDialog::getOpenFileName(&window, "Open session", "", sessionFilter);
  if (!path.isEmpty())
  {
    window.Open({path});
  }
}

void FileActions::OpenSession(const fs::path& path)
{
  try
  {
    window.Show(application::ReadSession(path), QString::fromStdString(path.filename().string()));
  }
  catch (const Error& error)
  {
    window.Report(error.what());
  }
}

} // namespace nexrad::viewer
