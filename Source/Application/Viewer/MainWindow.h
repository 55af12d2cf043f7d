// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Requests/ViewRequest.h"

#include <QMainWindow>
#include <QStringList>

#include <filesystem>
#include <vector>

class QDockWidget;
class QLabel;
class QListWidget;
class QMenu;
class QProgressBar;
class QPushButton;

namespace nexrad::viewer
{

class LookPanel;
class Playback;
class SceneView;
class SectionDock;

/// The window of `nexrad3d view`: a radar day in its time line, its scene and its settings.
class MainWindow : public QMainWindow
{
  Q_OBJECT

public:
  /// Opens the inputs of the request, if there are any.
  explicit MainWindow(const scene::ViewRequest& request);
  ~MainWindow() override;

  SceneView* View() const { return view; }
  Playback* Player() const { return playback; }
  /// Inputs that were damaged or left out, and what went wrong since the window opened.
  QStringList Problems() const;
  /// Pictures that were written.
  const std::vector<std::filesystem::path>& Pictures() const { return pictures; }

public slots:
  /// Opens files or folders in place of what is open.
  void Open(const QStringList& paths);
  /// Simulates an hour of storms over three radars, and opens it.
  void OpenSyntheticDay();

protected:
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

private:
  void MakeMenus();
  void MakeDocks();
  void MakeCutting();
  void MakeStatus();
  void AskForFiles();
  void AskForFolder();
  void AskForPicture();
  void TakePicture();
  void WritePicture(const std::filesystem::path& path);
  void ShowAbout();
  void OpenInputs(const scene::InputRequest& input, const QString& title, bool simulate);
  void Remember(const QStringList& paths);
  void FollowRecent();
  void FollowPlayback();
  void ShowVolume(vtkImageData* volume);
  void Report(const QString& problem);

  scene::ViewRequest request;
  Playback* playback = nullptr;
  SceneView* view = nullptr;
  LookPanel* look = nullptr;
  SectionDock* section = nullptr;
  QDockWidget* damageDock = nullptr;
  QListWidget* damage = nullptr;
  QLabel* doing = nullptr;
  QProgressBar* progress = nullptr;
  QPushButton* cancel = nullptr;
  QMenu* recent = nullptr;
  QMenu* windows = nullptr;
  QString title;
  bool first = true; ///< no volume of the series was shown yet
  std::vector<std::filesystem::path> pictures;
  QStringList failures; ///< since the series was opened
};

} // namespace nexrad::viewer
