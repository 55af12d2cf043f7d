// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Grid/FinerBox.h"

#include <vtkNew.h>

#include <QList>
#include <QObject>

#include <array>
#include <optional>

class QAction;
class QMouseEvent;
class QPointF;
class QString;
class vtkImageData;
class vtkNexradEchoPicker;

namespace nexrad::viewer
{

class Playback;
class SceneView;

/// Lets the user drag a box on the ground: with Ctrl and the left button, or with the left button
/// alone once the action that makes a box was chosen. The box is drawn in finer voxels for
/// each time that is shown; where it follows the storm, it is elsewhere at each time. Escape leaves
/// the action, or takes the box away.
class BoxMouse : public QObject
{
  Q_OBJECT

public:
  /// Both must outlive it.
  BoxMouse(SceneView& view, Playback& playback);
  ~BoxMouse() override;

  /// Checkable: the next drag makes the box.
  QAction* MakeAction() const { return make; }
  /// Checkable: the box follows the storm.
  QAction* FollowAction() const { return follow; }
  QAction* RemoveAction() const { return remove; }
  /// All of them, for a menu.
  QList<QAction*> Actions() const { return {make, follow, remove}; }

  /// Sets a box of the series that is open, or takes it away.
  void Set(const std::optional<BoxRequest>& box);
  /// What the box is now, in lines: its size, its voxels and its time, or how to make one.
  QString Text() const;

signals:
  /// What the box is, or how to make one; for the status bar.
  void Said(const QString& text);
  /// Another box is shown, or none.
  void Changed();

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  QAction* Add(const QString& name, const QString& tip);
  std::optional<std::array<double, 2>> GroundAt(const QPointF& place);
  bool Press(const QMouseEvent& event);
  void Mark(const QPointF& place);
  void Release();
  void Escape();
  void StartMaking(bool on);
  void Follow(bool on);
  void Show(vtkImageData* box);
  QString SizeText(const std::array<double, 4>& box) const;

  SceneView& view;
  Playback& playback;
  vtkNew<vtkNexradEchoPicker> picker;
  QAction* make;
  QAction* follow;
  QAction* remove;
  std::optional<std::array<double, 2>> from; ///< corner at which the drag began, of the volume
  std::array<double, 4> faces{};             ///< west, east, south, north; of the drag
};

/// The box in finer voxels as buttons, a switch, and what it is: its size, voxels and time. `box`
/// must outlive it.
QWidget* MakeBoxPanel(BoxMouse& box);

} // namespace nexrad::viewer
