// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Options/DrawingOptions.h"
#include "Options/SessionFile.h"

#include <QList>
#include <QMainWindow>
#include <QStringList>

#include <chrono>
#include <filesystem>
#include <vector>

class QAction;
class QDockWidget;
class QLabel;
class QListWidget;
class QMenu;
class QProgressBar;
class QPushButton;

namespace nexrad::viewer
{

class BoxMouse;
class FileActions;
class LookPanel;
class Playback;
class SceneView;
class SectionPanel;
class TransferFunctionEditor;
class WelcomePage;

/// What the view command asks for. The size is that of the window at first.
struct ViewRequest : scene::DrawingRequest
{
  Duration interval = std::chrono::milliseconds(500); ///< from one step to the next in playing
  std::filesystem::path pictures = ".";               ///< folder that takes screenshots
};

/// The window of `nexrad3d view`: a radar day in its time line, its scene and its settings.
class MainWindow : public QMainWindow
{
  Q_OBJECT

public:
  /// Opens the inputs of the request, if there are any.
  explicit MainWindow(const ViewRequest& request);
  ~MainWindow() override;

  SceneView* View() const { return view; }
  Playback* Player() const { return playback; }
  /// Inputs that were damaged or left out, and what went wrong since the window opened.
  QStringList Problems() const;
  /// Pictures that were written.
  const std::vector<std::filesystem::path>& Pictures() const { return pictures; }
  /// What is shown now, and how.
  application::Session Shown() const;
  /// Opens a session in place of what is open.
  void Show(const application::Session& session, const QString& title);
  /// Lists a problem beside those of the inputs.
  void Report(const QString& problem);
  /// Says for a few seconds what was done.
  void Announce(const QString& message);

public slots:
  /// Opens files or folders in place of what is open.
  void Open(const QStringList& paths);
  /// Simulates an hour of storms over three radars, and opens it.
  void OpenSyntheticDay();

protected:
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

private:
  QDockWidget* AddDock(const QString& title, const QString& name, QWidget* widget,
    Qt::DockWidgetArea area = Qt::RightDockWidgetArea);
  void MakeMenus();
  void MakeDocks();
  void MakeTransferFunction(QDockWidget* lookDock);
  void MakeCutting();
  void MakeSeenVoxels();
  void MakeStatus();
  void MakeWelcome();
  void AskForFiles();
  void AskForFolder();
  void AskForPicture();
  void TakePicture();
  void WritePicture(const std::filesystem::path& path);
  void ShowHelp();
  void FitPicture(const std::array<int, 2>& size);
  application::Session NewSession() const;
  void ShowMoment(const QString& moment);
  void ColourBy(const QString& array);
  void ShowMapOf(const QString& array);
  void OpenInputs(
    const application::Session& session, const QString& title, bool otherInputs = false);
  void Remember(const QStringList& paths);
  void FollowRecent();
  void FollowPlayback();
  void FollowEmptiness();
  void ShowVolume(vtkImageData* volume);

  ViewRequest request;
  application::Session opened; ///< its inputs, and what is done when their first volume is shown
  Playback* playback = nullptr;
  SceneView* view = nullptr;
  LookPanel* look = nullptr;
  SectionPanel* section = nullptr;
  QAction* drawSection = nullptr;
  BoxMouse* box = nullptr;
  TransferFunctionEditor* colours = nullptr;
  FileActions* files = nullptr;
  QDockWidget* damageDock = nullptr;
  QListWidget* damage = nullptr;
  QLabel* doing = nullptr;
  QProgressBar* progress = nullptr;
  QPushButton* cancel = nullptr;
  QMenu* recent = nullptr;
  QMenu* windows = nullptr;
  WelcomePage* welcome = nullptr;
  QList<QAction*> ofVolume; ///< what needs a volume that is shown
  QString title;
  QStringList asked;  ///< paths whose first volume is not shown yet
  bool first = true;  ///< no volume of the series was shown yet
  bool other = false; ///< the series has other inputs than the one before
  std::vector<std::filesystem::path> pictures;
  QStringList failures; ///< since the series was opened
};

} // namespace nexrad::viewer
