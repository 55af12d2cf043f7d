// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Scene/Frame/CameraView.h"
#include "Scene/RadarSession.h"

#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <array>
#include <filesystem>
#include <string>
#include <vector>

class vtkRenderWindow;
class vtkRenderWindowInteractor;
class vtkTextActor;

namespace nexrad::scene
{

class ViewerStyle;

/// A window on a session, with its mouse and keys.
class Viewer
{
public:
  struct Options
  {
    std::array<int, 2> size = {1280, 720}; ///< pixels, of the window at first
    CameraView camera;
    Duration interval = std::chrono::milliseconds(500); ///< from one step to the next in playing
    std::filesystem::path pictures = ".";               ///< folder that takes screenshots
  };

  /// Opens the window on the first step. The session must outlive it. Throws Error when there is no
  /// display or the step cannot be loaded.
  Viewer(RadarSession& session, const Options& options);
  ~Viewer();
  Viewer(const Viewer&) = delete;
  Viewer& operator=(const Viewer&) = delete;

  /// Runs until the user closes the window.
  void Run();

  /// Does what a key does ("space", "Right", "s": X key symbols); other keys do nothing.
  void Press(const std::string& key);

  /// One step on, when it is playing; the clock of Run calls it.
  void Tick();

  vtkRenderWindow* Window() { return window; }
  bool IsPlaying() const { return playing; }
  Duration Interval() const { return options.interval; }
  const std::vector<std::filesystem::path>& Pictures() const { return written; }
  /// What went wrong since the window opened, a line each.
  const std::vector<std::string>& Problems() const { return problems; }

private:
  struct Key;
  static const std::vector<Key>& Keys();

  void Draw();
  void DrawStatus();
  void Step(int by);
  void Play(bool on);
  void ScaleInterval(double factor);
  void ScaleSlices(double factor);
  void MoveIsoValue(double by);
  void ApplyPreset(int number);
  void Turn(double azimuth, double tilt);
  void Zoom(double factor);
  void FollowSize();
  void StartClock();
  void WritePicture();
  void Report(const std::string& problem);

  RadarSession& session;
  Options options;
  CameraView camera;
  bool playing = false;
  bool help = true;
  double isoValue = 35.0; // dBZ
  std::string message;
  std::vector<std::filesystem::path> written;
  std::vector<std::string> problems;
  std::array<int, 2> size = {0, 0};
  vtkNew<vtkRenderWindow> window;
  vtkNew<vtkRenderWindowInteractor> interactor;
  vtkSmartPointer<ViewerStyle> style;
  vtkSmartPointer<vtkTextActor> keysCaption;
  vtkSmartPointer<vtkTextActor> statusCaption;
};

} // namespace nexrad::scene
