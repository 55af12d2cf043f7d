// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>

#include <vtkNew.h>

#include <array>
#include <optional>

class QPointF;
class QString;
class vtkImageData;
class vtkNexradEchoPicker;

namespace nexrad::viewer
{

class Playback;
class SceneView;

/// Lets the user drag a box on the ground with Ctrl and the left button. The box is merged again in
/// finer voxels for each time that is shown. Escape takes it away.
class BoxMouse : public QObject
{
  Q_OBJECT

public:
  /// Both must outlive it.
  BoxMouse(SceneView& view, Playback& playback);
  ~BoxMouse() override;

signals:
  /// What the box is, or how to make one; for the status bar.
  void Said(const QString& text);

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  std::optional<std::array<double, 2>> GroundAt(const QPointF& place);
  void Mark(const QPointF& place);
  void Release();
  void TakeAway();
  void Show(vtkImageData* box);

  SceneView& view;
  Playback& playback;
  vtkNew<vtkNexradEchoPicker> picker;
  std::optional<std::array<double, 2>> from; ///< corner at which the drag began, of the volume
  std::array<double, 4> faces{};             ///< west, east, south, north
};

} // namespace nexrad::viewer
