// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Scene/Frame/CameraView.h"

#include <QVTKOpenGLNativeWidget.h>

#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <array>
#include <filesystem>
#include <string>

class QLabel;
class QMouseEvent;
class QPointF;
class QWheelEvent;
class vtkGenericOpenGLRenderWindow;
class vtkImageData;
class vtkNexradNavigator;
class vtkNexradVolumeScene;

namespace nexrad::scene
{
struct SceneOptions;
} // namespace nexrad::scene

namespace nexrad::viewer
{

class Soon;
class TurnAndZoom;

/// The part of the window that shows the scene. Dragging with the left button turns and tilts it,
/// with the right button zooms, and with the middle one, or the left one and Shift, moves it. The
/// wheel zooms towards the pointer; a double click moves what is there into the middle.
class SceneView : public QVTKOpenGLNativeWidget
{
  Q_OBJECT

public:
  explicit SceneView(QWidget* parent = nullptr);
  ~SceneView() override;

  vtkNexradVolumeScene* Scene() const { return scene; }
  /// Sets the scene as the options of the program say.
  void Apply(const scene::SceneOptions& options, const scene::CameraView& camera);
  /// What the camera does again after ResetCamera.
  void ResetCamera();
  /// Before something of another place is shown: the camera keeps its direction and shows the whole
  /// domain; nothing is cropped or clipped, and no section is on the ground.
  void LeavePlace();

  /// Draws once the events that wait are done with, however often it is asked for until then.
  void DrawSoon();

  /// Shows a volume. A preset of another moment is dropped.
  void SetVolume(vtkImageData* volume);

  /// Pixels of the pictures that are written: those of the screen.
  std::array<int, 2> PictureSize() const;

  /// Draws the scene now, without handles, and writes it as PNG. Throws Error when the file cannot
  /// be written, and for a volume that could not be drawn.
  void WritePicture(const std::filesystem::path& path);

  /// Pictures that were drawn since the window opened.
  int Drawn() const { return drawn; }

signals:
  /// The camera was moved by the mouse.
  void CameraMoved();
  /// Another volume is shown.
  void VolumeShown();
  /// The scene was drawn.
  void PictureDrawn();
  /// The volume, or a part of the scene, could not be drawn.
  void DrawingFailed(const QString& why);

protected:
  /// Brings the camera near with the mouse.
  bool event(QEvent* event) override;

private:
  bool Grab(const QMouseEvent& event);
  void ZoomByWheel(const QWheelEvent& event);
  void Draw();
  void ShowMove();

  vtkNew<vtkNexradVolumeScene> scene;
  vtkNew<vtkNexradNavigator> navigator;
  vtkNew<vtkGenericOpenGLRenderWindow> window;
  vtkSmartPointer<TurnAndZoom> style;
  Soon* drawing;
  scene::CameraView first;
  Qt::MouseButton panning = Qt::NoButton; ///< the button that is held for it
  int drawn = 0;
  std::string failure; ///< of drawing the volume that is shown; VTK reports it once
};

/// A place of the view as VTK counts: pixels of the screen from the lower left corner.
std::array<double, 2> ScenePixel(const SceneView& view, const QPointF& place);

/// Says what is under the pointer: value, place, height above sea level, and the radar. `view` must
/// outlive it.
QLabel* MakePointerReadout(SceneView& view);

} // namespace nexrad::viewer
