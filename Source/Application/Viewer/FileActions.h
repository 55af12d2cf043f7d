// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Options/SessionFile.h"

#include <QList>
#include <QObject>

#include <filesystem>
#include <functional>
#include <future>
#include <memory>

class QAction;
class QMenu;
class QProgressDialog;
class QWidget;

namespace nexrad::viewer
{

class MovieExport;
class Playback;
class SceneView;

/// What the menu File does with what is shown, beside pictures: the command that draws it,
/// sessions, the volume, and movies.
class FileActions : public QObject
{
  Q_OBJECT

public:
  /// A child of the window; what is given must outlive it. `shown`: what is shown now, and how;
  /// `pictures`: the folder that takes what has no name of its own.
  FileActions(QWidget* window, SceneView& view, Playback& playback,
    std::function<application::Session()> shown, std::filesystem::path pictures);
  /// Waits for the volume that is being written; a movie that is not finished leaves no file.
  ~FileActions() override;

  /// Appends its entries; returns those that need a volume that is shown.
  QList<QAction*> AddTo(QMenu* menu);

  /// Opens a session in place of what is open; reports what is wrong with the file.
  void OpenSession(const std::filesystem::path& path);

signals:
  /// What was done, or why nothing is.
  void Said(const QString& text);
  /// What could not be done.
  void Failed(const QString& problem);
  /// A path is to be opened in place of what is open.
  void PathWanted(const QString& path);
  /// A session is to be shown in place of what is open.
  void SessionRead(const application::Session& session, const QString& name);

private:
  void CopyCommand();
  void AskToSaveSession();
  void AskForSession();
  void AskToSaveVolume();
  void SaveVolume(const std::filesystem::path& path);
  void AskToSaveMovie();
  void SaveMovie(const std::filesystem::path& path);
  void CloseMovie();
  void EndMovie(const QString& path, const QString& problem);

  QWidget* window;
  SceneView& view;
  Playback& playback;
  std::function<application::Session()> shown;
  std::filesystem::path pictures;
  std::future<void> writing;           ///< of a volume
  std::unique_ptr<MovieExport> movie;  ///< while it is made
  QProgressDialog* progress = nullptr; ///< of the movie
};

} // namespace nexrad::viewer
