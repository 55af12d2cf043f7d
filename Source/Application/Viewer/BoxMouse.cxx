// SPDX-License-Identifier: BSD-3-Clause
#include "Viewer/BoxMouse.h"

#include "Scene/Frame/VolumeInformation.h"
#include "Viewer/Playback.h"
#include "Viewer/SceneView.h"
#include "Viewer/Widgets.h"
#include "nexrad/Geometry/Angles.h"

#include <vtkImageData.h>
#include <vtkNexradEchoPicker.h>
#include <vtkNexradVolumeScene.h>

#include <QAction>
#include <QCheckBox>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QMouseEvent>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace nexrad::viewer
{

BoxMouse::BoxMouse(SceneView& sceneView, Playback& thePlayback)
  : QObject(&sceneView)
  , view(sceneView)
  , playback(thePlayback)
  , make(this->Add("Make a &box", "Drag on the ground with the left mouse button: the box is drawn "
                                  "in finer voxels. Escape leaves this"))
  , follow(this->Add("&Follow the storm",
      "The box moves from one time to the next as the echo in it moves, and stays in the domain"))
  , remove(this->Add("R&emove the box", "Show the volume without the box"))
{
  make->setCheckable(true);
  make->setShortcut(QKeySequence("B"));
  follow->setCheckable(true);
  remove->setEnabled(false);
  picker->SetScene(view.Scene());
  view.installEventFilter(this);
  connect(make, &QAction::toggled, this, &BoxMouse::StartMaking);
  connect(follow, &QAction::triggered, this, &BoxMouse::Follow);
  connect(remove, &QAction::triggered, this, [this] { this->Set(std::nullopt); });
  connect(&playback, &Playback::BoxLoaded, this, &BoxMouse::Show);
  connect(&playback, &Playback::Failed, this,
    [this]
    {
      if (!playback.HasBox())
      {
        this->Set(std::nullopt);
      }
    });
}

BoxMouse::~BoxMouse() = default;

QAction* BoxMouse::Add(const QString& name, const QString& tip)
{
  auto* action = new QAction(name, this);
  action->setObjectName(QString(name).remove('&'));
  action->setToolTip(tip);
  return action;
}

std::optional<std::array<double, 2>> BoxMouse::GroundAt(const QPointF& place)
{
  const auto [x, y] = ScenePixel(view, place);
  if (picker->PickGround(x, y, view.Scene()->GetRenderer()) == vtkNexradEchoPicker::NOTHING)
  {
    return std::nullopt;
  }
  return std::array<double, 2>{picker->GetPlace()[0], picker->GetPlace()[1]};
}

// "40.2 × 31.0 km", from west to east and from south to north.
QString BoxMouse::SizeText(const std::array<double, 4>& box) const
{
  const HorizontalUnit unit = HorizontalUnitOf(view.Scene()->GetVolume());
  const bool degrees = unit.metres != 1.0;
  const double narrowing = degrees ? std::cos(0.5 * (box[2] + box[3]) * RadiansPerDegree) : 1.0;
  return QString("%1 × %2 km")
    .arg((box[1] - box[0]) * unit.metres * narrowing / 1000.0, 0, 'f', 1)
    .arg((box[3] - box[2]) * unit.metres / 1000.0, 0, 'f', 1);
}

bool BoxMouse::Press(const QMouseEvent& event)
{
  const bool making = make->isChecked() && event.modifiers() == Qt::NoModifier;
  if (event.button() != Qt::LeftButton || !(making || event.modifiers() == Qt::ControlModifier))
  {
    return false;
  }
  from = this->GroundAt(event.localPos());
  faces = {};
  return true;
}

// Draws the box from the corner where the drag began; beyond the ground, it stays as it was.
void BoxMouse::Mark(const QPointF& place)
{
  if (const auto to = this->GroundAt(place))
  {
    const auto [west, east] = std::minmax((*from)[0], (*to)[0]);
    const auto [south, north] = std::minmax((*from)[1], (*to)[1]);
    faces = {west, east, south, north};
    view.Scene()->MarkBox(west, east, south, north);
    view.DrawSoon();
    emit Said("Box " + this->SizeText(faces));
  }
}

void BoxMouse::Release()
{
  from.reset();
  if (faces[1] > faces[0] && faces[3] > faces[2])
  {
    make->setChecked(false);
    BoxRequest request;
    request.faces = faces;
    this->Set(request);
    if (follow->isChecked())
    {
      this->Follow(true);
    }
  }
  else if (!make->isChecked())
  {
    this->Set(std::nullopt);
  }
}

void BoxMouse::Escape()
{
  const bool drags = from.has_value();
  from.reset();
  if (make->isChecked())
  {
    make->setChecked(false);
    view.Scene()->MarkNoBox();
    this->Show(view.Scene()->GetDetail());
    return;
  }
  if (drags || playback.HasBox())
  {
    this->Set(std::nullopt);
  }
}

void BoxMouse::StartMaking(bool on)
{
  view.setCursor(on ? Qt::CrossCursor : Qt::ArrowCursor);
  if (on)
  {
    view.setFocus(); // for Escape
    emit Said("Drag on the ground with the left mouse button to make the box; Escape leaves this");
  }
}

void BoxMouse::Set(const std::optional<BoxRequest>& box)
{
  if (box || playback.HasBox())
  {
    playback.SetBox(box);
  }
  if (box)
  {
    follow->setChecked(box->followedFrom.has_value());
    const auto& [west, east, south, north] = box->faces;
    view.Scene()->MarkBox(west, east, south, north);
  }
  else
  {
    view.Scene()->SetDetail(nullptr);
    view.Scene()->MarkNoBox();
  }
  remove->setEnabled(playback.HasBox());
  view.DrawSoon();
  emit Changed();
}

// The box is where it is now at the time that is shown: from there it moves, or there it stays.
void BoxMouse::Follow(bool on)
{
  const std::vector<Time>& times = playback.State().times;
  if (!playback.HasBox() || playback.Step() >= times.size())
  {
    return;
  }
  BoxRequest box = *playback.Box();
  if (vtkImageData* shown = view.Scene()->GetDetail())
  {
    box.faces = scene::SidesOf(shown);
  }
  box.followedFrom = on ? std::optional(times[playback.Step()]) : std::nullopt;
  this->Set(box);
}

void BoxMouse::Show(vtkImageData* box)
{
  view.Scene()->SetDetail(box);
  const bool following = playback.HasBox() && playback.Box()->followedFrom;
  if (box != nullptr && playback.HasBox())
  {
    const auto [west, east, south, north] = scene::SidesOf(box);
    view.Scene()->MarkBox(west, east, south, north);
    emit Said("Box " + this->SizeText(scene::SidesOf(box)) + "; Escape takes it away");
  }
  else if (!from && (following || !playback.HasBox()))
  {
    view.Scene()->MarkNoBox(); // where it is at this time, is not known yet
  }
  remove->setEnabled(playback.HasBox());
  view.DrawSoon();
  emit Changed();
}

QString BoxMouse::Text() const
{
  vtkImageData* box = view.Scene()->GetDetail();
  if (box == nullptr || !playback.HasBox())
  {
    return playback.HasBox()
             ? QString("The box is being merged.")
             : QString("A box is a part of the volume in finer voxels: of radar files it is merged "
                       "again in voxels of 250 m, of .nxv files the smallest are read. Choose "
                       "“Make a box”, or hold Ctrl, and drag on the ground.");
  }
  const int* size = box->GetDimensions();
  const auto time = scene::ReadVolumeInformation(box).time;
  QString lines = this->SizeText(scene::SidesOf(box)) +
                  QString("\n%1 × %2 × %3 voxels").arg(size[0]).arg(size[1]).arg(size[2]);
  if (time)
  {
    constexpr int letters = 19; // without milliseconds
    lines +=
      "\n" + QString::fromStdString(FormatIso8601(*time)).left(letters).replace('T', ' ') + " UTC";
  }
  return lines;
}

bool BoxMouse::eventFilter(QObject* watched, QEvent* event)
{
  auto* mouse = dynamic_cast<QMouseEvent*>(event);
  switch (event->type())
  {
  case QEvent::MouseButtonPress:
    return this->Press(*mouse);
  case QEvent::MouseMove:
    if (from)
    {
      this->Mark(mouse->localPos());
    }
    return from.has_value();
  case QEvent::MouseButtonRelease:
    if (from && mouse->button() == Qt::LeftButton)
    {
      this->Release();
      return true;
    }
    return false;
  case QEvent::KeyPress:
    if (dynamic_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape)
    {
      this->Escape();
      return true;
    }
    return false;
  default:
    return QObject::eventFilter(watched, event);
  }
}

QWidget* MakeBoxPanel(BoxMouse& box)
{
  auto* panel = new QWidget;
  panel->setObjectName("box panel");
  auto* column = new QVBoxLayout(panel);
  auto* row = new QHBoxLayout;
  for (QAction* action : {box.MakeAction(), box.RemoveAction()})
  {
    auto* button = Named(new QToolButton, action->objectName(), action->toolTip());
    button->setDefaultAction(action);
    button->setFocusPolicy(Qt::NoFocus); // Escape goes to the picture
    row->addWidget(button);
  }
  row->addStretch(1);
  column->addLayout(row);
  QAction* follow = box.FollowAction();
  auto* follows = Named(new QCheckBox("Follow the storm"), "Follow the storm", follow->toolTip());
  QObject::connect(follows, &QCheckBox::clicked, follow, &QAction::trigger);
  QObject::connect(follow, &QAction::toggled, follows, &QCheckBox::setChecked);
  column->addWidget(follows);
  auto* text = Named(new QLabel, "The box", "Size, voxels and time of the box that is shown");
  text->setWordWrap(true);
  text->setTextInteractionFlags(Qt::TextSelectableByMouse);
  column->addWidget(text);
  column->addStretch(1);
  const auto tell = [&box, text] { text->setText(box.Text()); };
  QObject::connect(&box, &BoxMouse::Changed, text, tell);
  tell();
  return panel;
}

} // namespace nexrad::viewer
