// SPDX-License-Identifier: BSD-3-Clause
#include "Viewer/Cutting/SectionPanel.h"

#include "Scene/Elements/Theme.h"
#include "Scene/Scales/ColourScale.h"
#include "Scene/VolumeAppearance.h"
#include "Viewer/Cutting/SectionChart.h"
#include "Viewer/Cutting/SectionTool.h"
#include "Viewer/Cutting/VolumeUnits.h"
#include "Viewer/Parts/Soon.h"
#include "nexrad/Grid/GriddedVolume.h"
#include "nexrad/Model/Moment.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkNexradTransferFunction.h>
#include <vtkNexradVerticalSection.h>
#include <vtkNexradVolumeScene.h>
#include <vtkPointData.h>

#include <QAction>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QHideEvent>
#include <QLabel>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace nexrad::viewer
{
namespace
{

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

SectionPanel::SectionPanel(const ShownScene& sceneView, QWidget* parent)
  : QWidget(parent)
  , view(sceneView)
  , tool(new SectionTool(sceneView, this))
  , chart(new SectionChart(this))
  , follow(new Soon(this, [this] { this->Follow(); }))
{
  this->setObjectName("section panel");
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(4, 0, 4, 4);
  column->addWidget(this->MakeRow());
  column->addWidget(chart, 1);
  chart->setMinimumHeight(140);
  connect(tool, &SectionTool::Moved, this, &SectionPanel::FollowSoon);
  connect(tool, &SectionTool::Drawn, this, [this] { draw->setChecked(false); });
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
    auto* button = new QToolButton(this);
    button->setText(name);
    button->setObjectName(name);
    button->setAccessibleName(name);
    button->setToolTip(tip);
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
  auto* box = new QDoubleSpinBox(this);
  box->setObjectName(tip);
  box->setAccessibleName(tip);
  box->setToolTip(tip + " of the centre of the projection, in kilometres; on geographic axes the "
                        "longitude or latitude in degrees");
  box->setRange(-2000.0, 2000.0);
  box->setDecimals(1);
  box->setKeyboardTracking(false);
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
  view.scene->SectionOff();
  view.drawSoon();
  this->FollowSoon();
}

void SectionPanel::TakeNumbers()
{
  vtkNexradVolumeScene* scene = view.scene;
  const double unit = HorizontalUnitOf(scene->GetVolume()).size;
  scene->SetSectionA(unit * ends[0]->value(), unit * ends[1]->value());
  scene->SetSectionB(unit * ends[2]->value(), unit * ends[3]->value());
  scene->SectionOn();
  view.drawSoon();
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
  vtkNexradVolumeScene* scene = view.scene;
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
  vtkNexradVolumeScene* scene = view.scene;
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
    const bool has = view.scene->GetSection() && !tool->IsDrawing();
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

SectionDock::SectionDock(const ShownScene& view, QWidget* parent)
  : QDockWidget("Section", parent)
  , panel(new SectionPanel(view, this))
  , draw(new QAction("Draw a &section", this))
{
  this->setObjectName("section dock");
  this->setFeatures(QDockWidget::DockWidgetClosable); // a chart of OpenGL stays in its window
  this->setWidget(panel);
  this->hide();
  draw->setShortcut(QKeySequence("X"));
  draw->setToolTip("Drag on the ground from A to B: the vertical section along that line");
  connect(draw, &QAction::triggered, this,
    [this]
    {
      this->show();
      panel->DrawLine(true);
    });
}

} // namespace nexrad::viewer
