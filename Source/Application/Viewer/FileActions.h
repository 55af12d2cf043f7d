// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QList>
#include <QObject>

#include <filesystem>
#include <future>
#include <memory>

class QAction;
class QMenu;
class QProgressDialog;

namespace nexrad::viewer
{

class MainWindow;
class MovieExport;

/// What the menu File does with what is shown, beside pictures: the command that draws it,
/// sessions, the volume, and movies.
class FileActions : public QObject
{
  Q_OBJECT

public:
  /// A child of the window.
  explicit FileActions(MainWindow& window);
  /// Waits for the volume that is being written; a movie that is not finished leaves no file.
  ~FileActions() override;

  /// Appends its entries; returns those that need a volume that is shown.
  QList<QAction*> AddTo(QMenu* menu);

  /// Opens a session in place of what is open; reports what is wrong with the file.
  void OpenSession(const std::filesystem::path& path);

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

  MainWindow& window;
  std::future<void> writing;           ///< of a volume
  std::unique_ptr<MovieExport> movie;  ///< while it is made
  QProgressDialog* progress = nullptr; ///< of the movie
};

} // namespace nexrad::viewer
