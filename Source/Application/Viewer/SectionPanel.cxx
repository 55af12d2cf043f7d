// SPDX-License-Identifier: BSD-3-Clause
#include "Viewer/SectionPanel.h"

#include "Scene/Frame/VolumeInformation.h"
#include "Scene/Scales/ColourScale.h"
#include "Scene/Shapes/Theme.h"
#include "Scene/VolumeAppearance.h"
#include "Viewer/SceneView.h"
#include "Viewer/SectionChart.h"
#include "Viewer/Widgets.h"
#include "nexrad/Grid/GriddedVolume.h"
#include "nexrad/Model/Moment.h"

#include <vtkCommand.h>
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkNexradTransferFunction.h>
#include <vtkNexradVerticalSection.h>
#include <vtkNexradVolumeScene.h>
#include <vtkPointData.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkWeakPointer.h>

#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QHideEvent>
#include <QLabel>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

namespace nexrad::viewer
{
namespace
{

constexpr double reach = 12.0; // pixels from an end at which the mouse takes it

std::array<double, 2> MouseOf(SceneView& view)
{
  const int* position = view.interactor()->GetEventPosition();
  return {static_cast<double>(position[0]), static_cast<double>(position[1])};
}

// The ground under the mouse, at the edge of the volume when the mouse is beyond it.
bool FindPlace(SceneView& view, std::array<double, 2>& place)
{
  vtkImageData* volume = view.Scene()->GetVolume();
  const std::array<double, 2> pixel = MouseOf(view);
  if (volume == nullptr || !view.Scene()->FindGround(pixel[0], pixel[1], place.data()))
  {
    return false;
  }
  const std::array<double, 6> faces = scene::FacesOf(volume);
  for (std::size_t axis = 0; axis < 2; ++axis)
  {
    place[axis] = std::clamp(place[axis], faces[2 * axis], faces[2 * axis + 1]);
  }
  return true;
}

void SetEnd(vtkNexradVolumeScene* scene, int end, std::array<double, 2> place)
{
  if (end == 0)
  {
    scene->SetSectionA(place.data());
  }
  else
  {
    scene->SetSectionB(place.data());
  }
}

QString StateText(int state)
{
  switch (static_cast<VoxelState>(state))
  {
  case VoxelState::NoEcho:
    return "no echo";
  case VoxelState::RangeFolded:
    return "range folded";
  case VoxelState::Filtered:
    return "filtered: quality control took the echo out";
  default:
    return "not scanned";
  }
}

} // namespace

/// Lets the mouse draw the line of a section on the ground of a scene, and move its ends. While it
/// does, the camera stands still.
class SectionTool
{
public:
  /// `view` must outlive it. `moved`: the line of the scene was drawn or moved; `drawn`: a new line
  /// was drawn, and drawing is off again.
  SectionTool(
    SceneView& sceneView, std::function<void()> whenMoved, std::function<void()> whenDrawn)
    : view(sceneView)
    , moved(std::move(whenMoved))
    , drawn(std::move(whenDrawn))
    , mouse(sceneView.interactor())
  {
    constexpr float beforeTheStyle = 0.6F;
    tags = {mouse->AddObserver(
              vtkCommand::LeftButtonPressEvent, this, &SectionTool::Press, beforeTheStyle),
      mouse->AddObserver(vtkCommand::MouseMoveEvent, this, &SectionTool::Move, beforeTheStyle),
      mouse->AddObserver(
        vtkCommand::LeftButtonReleaseEvent, this, &SectionTool::Release, beforeTheStyle)};
  }

  ~SectionTool()
  {
    for (const unsigned long tag : tags)
    {
      if (mouse)
      {
        mouse->RemoveObserver(tag);
      }
    }
  }

  SectionTool(const SectionTool&) = delete;
  SectionTool& operator=(const SectionTool&) = delete;

  /// Whether the next drag with the left button draws a new line.
  void SetDrawing(bool on)
  {
    drawing = on;
    view.setCursor(on ? Qt::CrossCursor : Qt::ArrowCursor);
  }

  bool IsDrawing() const { return drawing; }

private:
  bool Press(vtkObject*, unsigned long, void*)
  {
    dragged = this->EndAt(MouseOf(view));
    std::array<double, 2> place{};
    if (drawing && FindPlace(view, place))
    {
      vtkNexradVolumeScene* scene = view.Scene();
      scene->SectionOn();
      SetEnd(scene, 0, place);
      SetEnd(scene, 1, place);
      dragged = 1;
    }
    return dragged >= 0; // then the camera does not hear of it
  }

  bool Move(vtkObject*, unsigned long, void*)
  {
    if (dragged < 0)
    {
      return false;
    }
    this->Drag();
    return true;
  }

  bool Release(vtkObject*, unsigned long, void*)
  {
    if (dragged < 0)
    {
      return false;
    }
    this->Drag();
    dragged = -1;
    if (drawing)
    {
      this->SetDrawing(false);
      drawn();
    }
    return true;
  }

  // The end of the line that is near a pixel; −1: none.
  int EndAt(const std::array<double, 2>& pixel) const
  {
    vtkNexradVolumeScene* scene = view.Scene();
    int nearest = -1;
    double least = reach * view.devicePixelRatioF();
    for (int end = 0; scene->GetSection() && end < 2; ++end)
    {
      const double* place = end == 0 ? scene->GetSectionA() : scene->GetSectionB();
      double at[2];
      if (!scene->FindPixel(place[0], place[1], at))
      {
        continue;
      }
      const double distance = std::hypot(at[0] - pixel[0], at[1] - pixel[1]);
      nearest = distance < least ? end : nearest;
      least = std::min(least, distance);
    }
    return nearest;
  }

  void Drag()
  {
    std::array<double, 2> place{};
    if (FindPlace(view, place))
    {
      SetEnd(view.Scene(), dragged, place);
      view.DrawSoon();
      moved();
    }
  }

  SceneView& view;
  std::function<void()> moved;
  std::function<void()> drawn;
  vtkWeakPointer<vtkRenderWindowInteractor> mouse; ///< goes before this object does
  std::vector<unsigned long> tags;
  bool drawing = false;
  int dragged = -1; ///< the end that follows the mouse: 0 A, 1 B; −1 none
};

SectionPanel::SectionPanel(SceneView& sceneView, QWidget* parent)
  : QWidget(parent)
  , view(sceneView)
  , tool(std::make_unique<SectionTool>(
      sceneView, [this] { this->FollowSoon(); }, [this] { draw->setChecked(false); }))
  , chart(new SectionChart(this))
  , follow(new Soon(this, [this] { this->Follow(); }))
{
  this->setObjectName("section panel");
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(4, 0, 4, 4);
  column->addWidget(this->MakeRow());
  column->addWidget(chart, 1);
  chart->setMinimumHeight(140);
  connect(chart, &SectionChart::Pointed, this, &SectionPanel::Tell);
  this->Follow();
}

SectionPanel::~SectionPanel() = default;

QWidget* SectionPanel::MakeRow()
{
  auto* line = new QWidget(this);
  auto* row = new QHBoxLayout(line);
  row->setContentsMargins(0, 0, 0, 0);
  const auto add = [&](const QString& name, const QString& tip)
  {
    auto* button = Named(new QToolButton(this), name, tip);
    button->setText(name);
    button->setFocusPolicy(Qt::NoFocus);
    row->addWidget(button);
    return button;
  };
  draw = add("Draw the line", "Drag on the ground from A to B with the left mouse button (X)");
  draw->setCheckable(true);
  remove = add("Remove", "Take the line and its section away");
  ends = {this->AddNumber(row, "A", "How far east the end A is"),
    this->AddNumber(row, "", "How far north the end A is"),
    this->AddNumber(row, "B", "How far east the end B is"),
    this->AddNumber(row, "", "How far north the end B is")};
  reading = new QLabel(this);
  reading->setObjectName("section reading");
  reading->setAccessibleName("Value under the mouse");
  reading->setToolTip("Distance from A in km, height above mean sea level in km, and the value "
                      "where the mouse points at the section");
  reading->setMinimumWidth(10); // a long text must not widen the window
  row->addWidget(reading, 1);
  connect(draw, &QToolButton::toggled, this, &SectionPanel::DrawLine);
  connect(remove, &QToolButton::clicked, this, &SectionPanel::Remove);
  return line;
}

QDoubleSpinBox* SectionPanel::AddNumber(QBoxLayout* row, const QString& name, const QString& tip)
{
  if (!name.isEmpty())
  {
    row->addWidget(new QLabel(name, this));
  }
  QDoubleSpinBox* box = MakeCoordinate(tip, this);
  box->setToolTip(tip + " of the centre of the projection, in kilometres; on geographic axes the "
                        "longitude or latitude in degrees");
  row->addWidget(box);
  connect(box, qOverload<double>(&QDoubleSpinBox::valueChanged), this, &SectionPanel::TakeNumbers);
  return box;
}

void SectionPanel::showEvent(QShowEvent* event)
{
  QWidget::showEvent(event);
  this->FollowSoon();
}

// A drag on the picture turns the camera again once nothing says that it would draw a line.
void SectionPanel::hideEvent(QHideEvent* event)
{
  QWidget::hideEvent(event);
  if (!event->spontaneous())
  {
    this->DrawLine(false);
  }
}

void SectionPanel::DrawLine(bool on)
{
  draw->setChecked(on);
  tool->SetDrawing(on);
  this->Tell({-1, -1});
  if (on)
  {
    emit Draws();
  }
}

void SectionPanel::Remove()
{
  this->DrawLine(false);
  view.Scene()->SectionOff();
  view.DrawSoon();
  this->FollowSoon();
}

void SectionPanel::TakeNumbers()
{
  vtkNexradVolumeScene* scene = view.Scene();
  const double unit = HorizontalUnitOf(scene->GetVolume()).size;
  scene->SetSectionA(unit * ends[0]->value(), unit * ends[1]->value());
  scene->SetSectionB(unit * ends[2]->value(), unit * ends[3]->value());
  scene->SectionOn();
  view.DrawSoon();
  this->FollowSoon();
}

void SectionPanel::FollowSoon()
{
  if (this->isVisible())
  {
    follow->Ask();
  }
}

void SectionPanel::Follow()
{
  this->FollowNumbers();
  this->Cut();
  this->Tell({-1, -1});
}

void SectionPanel::FollowNumbers()
{
  vtkNexradVolumeScene* scene = view.Scene();
  const HorizontalUnit unit = HorizontalUnitOf(scene->GetVolume());
  const std::array<double, 4> places = {scene->GetSectionA()[0], scene->GetSectionA()[1],
    scene->GetSectionB()[0], scene->GetSectionB()[1]};
  for (std::size_t i = 0; i < ends.size(); ++i)
  {
    const QSignalBlocker quiet(ends[i]);
    ends[i]->setDecimals(unit.decimals);
    ends[i]->setSuffix(unit.suffix);
    ends[i]->setValue(places[i] / unit.size);
    ends[i]->setEnabled(scene->GetVolume() != nullptr);
  }
  draw->setEnabled(scene->GetVolume() != nullptr);
  remove->setEnabled(scene->GetSection());
}

void SectionPanel::Cut()
{
  vtkNexradVolumeScene* scene = view.Scene();
  vtkImageData* volume = scene->GetVolume();
  const bool hasLine =
    !std::equal(scene->GetSectionA(), scene->GetSectionA() + 2, scene->GetSectionB());
  if (volume == nullptr || !scene->GetSection() || !hasLine || !scene->Update())
  {
    chart->Show(nullptr, {}, scene::ThemeOf(scene->GetOptions().theme));
    return;
  }
  filter->SetInputData(volume);
  filter->SetA(scene->GetSectionA());
  filter->SetB(scene->GetSectionB());
  filter->Update();
  vtkImageData* section = filter->GetOutput();
  const char* name = volume->GetPointData()->GetScalars()->GetName();
  chart->Show(section, scene::ScaleOf(name, scene->GetTransferFunction()),
    scene::ThemeOf(scene->GetOptions().theme));
}

void SectionPanel::Tell(const QPoint& pixel)
{
  const auto place = chart->PlaceAt(pixel);
  if (!place)
  {
    const bool has = view.Scene()->GetSection() && !tool->IsDrawing();
    reading->setText(has ? QString("Point at the section for its values.")
                         : QString("Drag on the ground from A to B."));
    return;
  }
  vtkImageData* section = filter->GetOutput();
  int index[2];
  for (int axis = 0; axis < 2; ++axis)
  {
    const double cell = ((*place)[static_cast<std::size_t>(axis)] - section->GetOrigin()[axis]) /
                        section->GetSpacing()[axis];
    index[axis] =
      std::clamp(static_cast<int>(std::lround(cell)), 0, section->GetDimensions()[axis] - 1);
  }
  vtkDataArray* values = section->GetPointData()->GetScalars();
  const std::string name = values->GetName();
  const vtkIdType point = index[0] + static_cast<vtkIdType>(section->GetDimensions()[0]) * index[1];
  const double value = values->GetTuple1(point);
  const auto moment = ParseMomentName(name);
  const QString text =
    std::isnan(value)
      ? StateText(static_cast<int>(
          section->GetPointData()->GetArray((name + "_state").c_str())->GetTuple1(point)))
      : QString("%1 %2 %3")
          .arg(QString::fromStdString(name))
          .arg(value, 0, 'f', moment ? DigitsOf(*moment) : 1)
          .arg(moment ? UnitOf(*moment) : "");
  reading->setText(QString("%1 km from A, %2 km high: %3")
                     .arg((*place)[0] / 1000.0, 0, 'f', 1)
                     .arg((*place)[1] / 1000.0, 0, 'f', 2)
                     .arg(text));
}

} // namespace nexrad::viewer
