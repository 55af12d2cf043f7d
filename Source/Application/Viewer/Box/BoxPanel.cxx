// SPDX-License-Identifier: BSD-3-Clause
#include "Viewer/Box/BoxPanel.h"

#include "Viewer/Box/BoxMouse.h"
#include "Viewer/Parts/NamedWidget.h"
#include "Viewer/Parts/Playback.h"
#include "Viewer/Parts/SceneView.h"

#include <QAction>
#include <QCheckBox>
#include <QDockWidget>
#include <QHBoxLayout>
#include <QLabel>
#include <QMainWindow>
#include <QToolButton>
#include <QVBoxLayout>

namespace nexrad::viewer
{
namespace
{

/// The box in finer voxels as buttons, a switch, and what it is: its size, voxels and time.
class BoxPanel : public QWidget
{
public:
  /// `box` must outlive it.
  explicit BoxPanel(BoxMouse& box, QWidget* parent = nullptr);

private:
  QToolButton* ButtonOf(QAction* action);
  void Follow();

  BoxMouse& box;
  QLabel* text = nullptr;
};

} // namespace

BoxPanel::BoxPanel(BoxMouse& boxMouse, QWidget* parent)
  : QWidget(parent)
  , box(boxMouse)
{
  this->setObjectName("box panel");
  auto* column = new QVBoxLayout(this);
  auto* row = new QHBoxLayout;
  row->addWidget(this->ButtonOf(box.MakeAction()));
  row->addWidget(this->ButtonOf(box.RemoveAction()));
  row->addStretch(1);
  column->addLayout(row);
  QAction* follow = box.FollowAction();
  auto* follows =
    Named(new QCheckBox("Follow the storm", this), "Follow the storm", follow->toolTip());
  connect(follows, &QCheckBox::clicked, follow, &QAction::trigger);
  connect(follow, &QAction::toggled, follows, &QCheckBox::setChecked);
  column->addWidget(follows);
  text = Named(new QLabel(this), "The box", "Size, voxels and time of the box that is shown");
  text->setWordWrap(true);
  text->setTextInteractionFlags(Qt::TextSelectableByMouse);
  column->addWidget(text);
  column->addStretch(1);
  connect(&box, &BoxMouse::Changed, this, &BoxPanel::Follow);
  this->Follow();
}

QToolButton* BoxPanel::ButtonOf(QAction* action)
{
  auto* button = new QToolButton(this);
  button->setDefaultAction(action);
  button->setFocusPolicy(Qt::NoFocus); // Escape goes to the picture
  return Named(button, action->objectName(), action->toolTip());
}

void BoxPanel::Follow()
{
  text->setText(box.Text());
}

BoxMouse* MakeBoxDock(QMainWindow& window, SceneView& view, Playback& playback, QDockWidget* behind)
{
  auto* box = new BoxMouse(view, playback);
  auto* dock = new QDockWidget("Box", &window);
  dock->setObjectName("box dock");
  dock->setWidget(new BoxPanel(*box, dock));
  window.addDockWidget(Qt::RightDockWidgetArea, dock);
  window.tabifyDockWidget(behind, dock);
  behind->raise();
  return box;
}

} // namespace nexrad::viewer
