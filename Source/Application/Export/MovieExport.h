// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Options/SessionFile.h"

#include <QObject>

#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <cstddef>
#include <filesystem>
#include <functional>
#include <future>
#include <memory>
#include <vector>

class vtkImageData;
class vtkNexradVolumeScene;

namespace nexrad::scene
{
class MovieWriter;
class PictureWindow;
} // namespace nexrad::scene

namespace nexrad::viewer
{

/// A movie that is to be made.
struct MovieJob
{
  std::filesystem::path output; ///< .ogv or .mp4; .png: a picture of each time
  application::Session shown;   ///< how it is drawn, and how long a frame is shown
  std::vector<Time> times;      ///< of the frames
  /// The volume of a frame; nothing as long as it is not loaded. May throw.
  std::function<vtkSmartPointer<vtkImageData>(std::size_t frame)> volume;
  /// The box in finer voxels of a frame, as the volume; empty where there is none.
  std::function<vtkSmartPointer<vtkImageData>(std::size_t frame)> box;
};

/// Frames a second of a movie that plays in that interval: at least 1, at most 120.
int FramesPerSecond(Duration interval);

/// Draws a movie off screen, a frame in each turn of the event loop, so that a window stays usable;
/// another thread writes. It begins with the first turn. The window has to make its own OpenGL
/// context current again after each frame and at the end.
class MovieExport : public QObject
{
  Q_OBJECT

public:
  explicit MovieExport(MovieJob job, QObject* parent = nullptr);
  /// Stops: a movie that is not finished leaves no file; pictures that were written stay.
  ~MovieExport() override;

signals:
  /// So many frames are drawn.
  void Advanced(int frames);
  /// The movie is written; or it cannot be, with what is wrong.
  void Ended(const QString& problem);

private:
  void Turn();
  void Begin();
  bool Write();

  const MovieJob job;
  vtkNew<vtkNexradVolumeScene> scene;
  std::unique_ptr<scene::PictureWindow> window;
  std::unique_ptr<scene::MovieWriter> writer; ///< none for pictures
  std::future<void> writing;                  ///< of a frame, or of the end
  std::size_t frame = 0;
  bool finishing = false;
};

} // namespace nexrad::viewer
