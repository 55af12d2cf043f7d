// SPDX-License-Identifier: BSD-3-Clause
#include "Viewer/TransferFunctionChart.h"

#include "Scene/VolumeAppearance.h"

#include <vtkAxis.h>
#include <vtkBrush.h>
#include <vtkCallbackCommand.h>
#include <vtkChartXY.h>
#include <vtkContextActor.h>
#include <vtkContextInteractorStyle.h>
#include <vtkContextMouseEvent.h>
#include <vtkContextScene.h>
#include <vtkControlPointsItem.h>
#include <vtkDoubleArray.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkLookupTable.h>
#include <vtkNexradTransferFunction.h>
#include <vtkObjectFactory.h>
#include <vtkPen.h>
#include <vtkPlotBar.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>
#include <vtkTable.h>
#include <vtkTextProperty.h>
#include <vtkVector.h>

#include <QEvent>
#include <QTimer>

#include <algorithm>
#include <cmath>
#include <functional>

class vtkNexradTransferFunction;

namespace nexrad::viewer
{

/// The nodes of one channel of a transfer function in a chart, which the mouse adds, moves and
/// removes: the left button moves a node, or adds one where there is none, and the middle and the
/// right button remove one.
class SplinePointsItem : public vtkControlPointsItem
{
public:
  static SplinePointsItem* New();
  vtkTypeMacro(SplinePointsItem, vtkControlPointsItem);

  /// Called while a button of the mouse is down in the item, after each change of the nodes.
  std::function<void()> moved = [] {};
  /// Called when that button is released.
  std::function<void()> finished = [] {};

  void SetFunction(vtkNexradTransferFunction* shown, int shownChannel)
  {
    if (shown == function && shownChannel == channel)
    {
      return;
    }
    if (function)
    {
      function->RemoveObserver(this->Callback);
    }
    function = shown;
    channel = shownChannel;
    this->SetCurrentPoint(-1);
    if (function)
    {
      function->AddObserver(vtkCommand::ModifiedEvent, this->Callback);
    }
    this->ResetBounds();
    this->ComputePoints();
  }

  bool IsPressed() const { return pressed; }

  vtkIdType AddPoint(double* position) override
  {
    if (!function)
    {
      return -1;
    }
    const vtkIdType before = this->GetNumberOfPoints();
    this->StartChanges();
    const vtkIdType added = function->AddNode(channel, position[0], position[1]);
    if (this->GetNumberOfPoints() > before)
    {
      this->AddPointId(added);
    }
    this->EndChanges();
    return added;
  }

  // The last node stays: without any, the channel is 0 everywhere and no curve is left to click on.
  vtkIdType RemovePoint(double* position) override
  {
    const vtkIdType index = this->GetControlPointId(position);
    if (index < 0 || this->GetNumberOfPoints() < 2)
    {
      return -1;
    }
    this->StartChanges();
    function->RemoveNode(channel, static_cast<int>(index));
    this->EndChanges();
    this->SetCurrentPoint(-1);
    return index;
  }

  vtkIdType GetNumberOfPoints() const override
  {
    return function ? function->GetNumberOfNodes(channel) : 0;
  }

  // Midpoint and sharpness, of which splines know nothing, are VTK's usual ones.
  void GetControlPoint(vtkIdType index, double* point) const override
  {
    point[2] = 0.5;
    point[3] = 0.0;
    if (function)
    {
      function->GetNode(channel, static_cast<int>(index), point);
    }
  }

  void SetControlPoint(vtkIdType index, double* point) override
  {
    this->StartChanges();
    function->MoveNode(channel, static_cast<int>(index), point[0], point[1]);
    this->EndChanges();
  }

  bool MouseButtonPressEvent(const vtkContextMouseEvent& mouse) override
  {
    pressed = true;
    if (mouse.GetButton() == vtkContextMouseEvent::LEFT_BUTTON)
    {
      const bool taken = this->vtkControlPointsItem::MouseButtonPressEvent(mouse);
      moved();
      return taken;
    }
    double position[2];
    const vtkVector2f at = mouse.GetPos();
    this->TransformScreenToData(
      static_cast<double>(at[0]), static_cast<double>(at[1]), position[0], position[1]);
    const vtkIdType under = this->FindPoint(position);
    if (under >= 0)
    {
      double point[4];
      this->GetControlPoint(under, point);
      this->RemovePoint(point);
      moved();
    }
    return true;
  }

  bool MouseDoubleClickEvent(const vtkContextMouseEvent& mouse) override
  {
    return this->MouseButtonPressEvent(mouse);
  }

  // VTK's own would hold the first and the last node at their heights.
  bool MouseMoveEvent(const vtkContextMouseEvent& mouse) override
  {
    if (!pressed)
    {
      return false;
    }
    if (mouse.GetButton() == vtkContextMouseEvent::LEFT_BUTTON && this->GetCurrentPoint() >= 0)
    {
      vtkVector2f position;
      this->TransformScreenToData(mouse.GetPos(), position);
      this->SetCurrentPointPos(position);
      moved();
    }
    return true;
  }

  bool MouseButtonReleaseEvent(const vtkContextMouseEvent&) override
  {
    if (pressed)
    {
      pressed = false;
      finished();
    }
    return true;
  }

protected:
  SplinePointsItem()
  {
    this->EnforceValidFunction = false; // a channel of one node is a constant
  }

  ~SplinePointsItem() override
  {
    if (function)
    {
      function->RemoveObserver(this->Callback);
    }
  }

  void emitEvent(unsigned long event, void* parameters) override
  {
    this->InvokeEvent(event, parameters);
  }

  vtkMTimeType GetControlPointsMTime() override
  {
    return function ? function->GetMTime() : this->GetMTime();
  }

private:
  vtkSmartPointer<vtkNexradTransferFunction> function;
  int channel = 3;
  bool pressed = false;
};

vtkStandardNewMacro(SplinePointsItem);

namespace
{

constexpr int samples = 512; // of the curves, and colours of the bars
constexpr int letters = 13;  // points
constexpr float thin = 1.3F; // pixels
constexpr float thick = 2.6F;
constexpr double barOpacity = 0.62;

scene::Colour ColourOf(int channel, const scene::Theme& theme)
{
  constexpr std::array<scene::Colour, 3> colours = {
    {{0.90, 0.28, 0.26}, {0.22, 0.66, 0.28}, {0.25, 0.50, 0.95}}};
  return channel < 3 ? colours[static_cast<std::size_t>(channel)] : theme.title;
}

// A column of numbers; the table keeps it.
vtkDoubleArray* Column(vtkTable* table, const char* name, int rows)
{
  auto* column = vtkDoubleArray::SafeDownCast(table->GetColumnByName(name));
  if (column == nullptr)
  {
    vtkNew<vtkDoubleArray> made;
    made->SetName(name);
    made->SetNumberOfValues(rows); // a table takes columns of its own length alone
    table->AddColumn(made);
    column = made;
  }
  column->SetNumberOfValues(rows);
  column->Modified();
  return column;
}

// The axis grows in such steps, so that it stands still while volumes differ a little.
double StepOf(double span)
{
  return span > 0.0 ? std::pow(10.0, std::floor(std::log10(span))) : 1.0;
}

void SetColour(vtkPen* pen, const scene::Colour& colour, double opacity)
{
  pen->SetColorF(colour[0], colour[1], colour[2], opacity);
}

} // namespace

TransferFunctionChart::TransferFunctionChart(QWidget* parent)
  : QVTKOpenGLNativeWidget(parent)
{
  this->setObjectName("transfer function chart");
  this->setAccessibleName("Colours and opacity over the values of the moment");
  this->setToolTip("Left button: move a point, or add one where there is none\n"
                   "Right or middle button: delete a point\n"
                   "Bars: how many voxels have which value, on a logarithmic scale");
  this->setFocusPolicy(Qt::StrongFocus);
  this->setMinimumSize(260, 180);
  window->SetMultiSamples(4);
  window->AddRenderer(renderer);
  this->setRenderWindow(window.Get());
  actor->GetScene()->SetRenderer(renderer);
  actor->GetScene()->AddItem(chart);
  renderer->AddActor(actor);
  vtkNew<vtkContextInteractorStyle> style;
  style->SetScene(actor->GetScene());
  window->GetInteractor()->SetInteractorStyle(style);
  points->moved = [this] { emit Edited(); };
  points->finished = [this] { emit EditFinished(); };
  this->MakePlots();
  this->FollowRange();
  this->StylePlots();
}

TransferFunctionChart::~TransferFunctionChart()
{
  points->SetFunction(nullptr, channel);
}

void TransferFunctionChart::MakePlots()
{
  chart->SetAutoAxes(false);
  chart->SetShowLegend(false);
  chart->SetZoomWithMouseWheel(false);
  chart->SetTooltip(nullptr);
  chart->SetBarWidthFraction(1.0F); // no gaps
  for (const int action : {vtkChart::PAN, vtkChart::ZOOM, vtkChart::SELECT})
  {
    chart->SetActionToButton(action, vtkContextMouseEvent::NO_BUTTON);
  }
  bars = vtkPlotBar::SafeDownCast(chart->AddPlot(vtkChart::BAR));
  for (const char* column : {"value", "height"})
  {
    Column(barTable, column, 2)->FillValue(0.0);
  }
  bars->SetInputData(barTable, "value", "height");
  bars->SetLookupTable(barColours);
  bars->SelectColorArray("value");
  bars->ScalarVisibilityOn();
  bars->EnableOpacityMappingOn();
  for (const char* column :
    {"value", ChannelNames[0], ChannelNames[1], ChannelNames[2], ChannelNames[3]})
  {
    Column(curveTable, column, samples)->FillValue(0.0);
  }
  for (std::size_t i = 0; i < curves.size(); ++i)
  {
    curves[i] = chart->AddPlot(vtkChart::LINE);
    curves[i]->SetInputData(curveTable, "value", ChannelNames[i]);
  }
  chart->AddPlot(points);
}

void TransferFunctionChart::SetFunction(vtkNexradTransferFunction* shown)
{
  if (shown != function)
  {
    function = shown;
    points->SetFunction(shown, channel);
  }
  this->FollowFunction();
}

void TransferFunctionChart::FollowFunction()
{
  if (!points->IsPressed())
  {
    this->FollowRange(); // the axis stands still under a point that moves
  }
  if (points->GetCurrentPoint() >= points->GetNumberOfPoints())
  {
    points->SetCurrentPoint(-1);
  }
  this->FollowCurves();
  this->FollowColours();
  this->DrawSoon();
}

void TransferFunctionChart::SetChannel(int edited)
{
  channel = edited;
  points->SetFunction(function, channel);
  this->StylePlots();
}

int TransferFunctionChart::SelectedPoint() const
{
  return static_cast<int>(points->GetCurrentPoint());
}

void TransferFunctionChart::SelectPoint(int index)
{
  points->SetCurrentPoint(index);
  this->DrawSoon();
}

bool TransferFunctionChart::IsHeld() const
{
  return points->IsPressed();
}

void TransferFunctionChart::SetHistogram(vtkTable* histogram)
{
  const auto rows = histogram != nullptr ? static_cast<int>(histogram->GetNumberOfRows()) : 0;
  bars->SetVisible(rows > 0);
  histogramRange = {0.0, 0.0};
  if (rows > 0)
  {
    auto* counted = vtkDoubleArray::SafeDownCast(histogram->GetColumnByName("voxels"));
    auto* middles = vtkDoubleArray::SafeDownCast(histogram->GetColumnByName("value"));
    const double most = std::max(1.0, counted->GetRange()[1]);
    vtkDoubleArray* values = Column(barTable, "value", rows);
    vtkDoubleArray* heights = Column(barTable, "height", rows);
    for (int row = 0; row < rows; ++row)
    {
      values->SetValue(row, middles->GetValue(row));
      heights->SetValue(row, std::log1p(counted->GetValue(row)) / std::log1p(most));
    }
    const double width = rows > 1 ? middles->GetValue(1) - middles->GetValue(0) : 1.0;
    histogramRange = {middles->GetValue(0) - width, middles->GetValue(rows - 1) + width};
    barTable->Modified();
  }
  this->FollowFunction();
}

void TransferFunctionChart::SetTitle(const QString& title)
{
  chart->GetAxis(vtkAxis::BOTTOM)->SetTitle(title.toStdString());
  this->DrawSoon();
}

void TransferFunctionChart::SetTheme(scene::ThemeChoice shown)
{
  theme = shown;
  this->StylePlots();
}

// What the nodes and the histogram need, to full steps.
void TransferFunctionChart::FollowRange()
{
  std::array<double, 2> needed = histogramRange;
  if (function)
  {
    double nodes[2];
    function->GetRange(nodes);
    const bool alone = !(histogramRange[0] < histogramRange[1]);
    needed = {alone ? nodes[0] : std::min(nodes[0], needed[0]),
      alone ? nodes[1] : std::max(nodes[1], needed[1])};
  }
  if (!(needed[0] < needed[1]))
  {
    needed[1] = needed[0] + 1.0;
  }
  const double step = StepOf(0.5 * (needed[1] - needed[0]));
  range = {std::floor(needed[0] / step) * step, std::ceil(needed[1] / step) * step};
  chart->GetAxis(vtkAxis::BOTTOM)->SetRange(range.data());
  this->FollowLabels();
  double bounds[4] = {range[0], range[1], 0.0, 1.0};
  points->SetUserBounds(bounds);
}

// The axis has round numbers in the unit of the colour bar.
void TransferFunctionChart::FollowLabels()
{
  const scene::LabelUnit unit = scene::LabelUnitOf(function, "");
  vtkAxis* axis = chart->GetAxis(vtkAxis::BOTTOM);
  if (unit.ToLabel(range[0]) == range[0] && unit.ToLabel(range[1]) == range[1])
  {
    axis->SetCustomTickPositions(nullptr);
    return;
  }
  constexpr double most = 9.0; // labels
  const double least = unit.ToLabel(range[0]);
  const double greatest = unit.ToLabel(range[1]);
  const double step = vtkAxis::NiceNumber((greatest - least) / most, true);
  vtkNew<vtkDoubleArray> places;
  vtkNew<vtkStringArray> texts;
  for (double label = std::ceil(least / step) * step; label <= greatest; label += step)
  {
    places->InsertNextValue(unit.ToValue(label));
    texts->InsertNextValue(QString::number(label, 'g', 6).toStdString());
  }
  axis->SetCustomTickPositions(places, texts);
}

void TransferFunctionChart::FollowCurves()
{
  vtkDoubleArray* values = Column(curveTable, "value", samples);
  for (int i = 0; i < samples; ++i)
  {
    const double share = static_cast<double>(i) / (samples - 1);
    values->SetValue(i, range[0] + share * (range[1] - range[0]));
  }
  for (int each = 0; each < 4; ++each)
  {
    vtkDoubleArray* levels =
      Column(curveTable, ChannelNames[static_cast<std::size_t>(each)], samples);
    for (int i = 0; i < samples; ++i)
    {
      levels->SetValue(i, function ? function->Evaluate(each, values->GetValue(i)) : 0.0);
    }
  }
  curveTable->Modified();
}

// Bars have the colours that the volume has for their values.
void TransferFunctionChart::FollowColours()
{
  barColours->SetNumberOfTableValues(samples);
  barColours->SetTableRange(range.data());
  std::array<vtkDoubleArray*, 3> levels{};
  for (std::size_t each = 0; each < levels.size(); ++each)
  {
    levels[each] = vtkDoubleArray::SafeDownCast(curveTable->GetColumnByName(ChannelNames[each]));
  }
  for (int i = 0; i < samples; ++i)
  {
    barColours->SetTableValue(
      i, levels[0]->GetValue(i), levels[1]->GetValue(i), levels[2]->GetValue(i), barOpacity);
  }
  barTable->Modified();
}

void TransferFunctionChart::StylePlots()
{
  const scene::Theme& look = scene::ThemeOf(theme);
  renderer->SetBackground(look.skyBottom[0], look.skyBottom[1], look.skyBottom[2]);
  this->StyleAxes(look);
  bars->GetPen()->SetLineType(vtkPen::NO_PEN);
  for (int each = 0; each < 4; ++each)
  {
    vtkPen* pen = curves[static_cast<std::size_t>(each)]->GetPen();
    SetColour(pen, ColourOf(each, look), each == channel ? 1.0 : 0.55);
    pen->SetWidth(each == channel ? thick : thin);
  }
  const scene::Colour colour = ColourOf(channel, look);
  const scene::Colour& rim = look.skyBottom;
  SetColour(points->GetPen(), colour, 1.0);
  points->GetBrush()->SetColorF(rim[0], rim[1], rim[2], 1.0);
  chart->GetAxis(vtkAxis::LEFT)->SetTitle(ChannelNames[static_cast<std::size_t>(channel)]);
  this->DrawSoon();
}

void TransferFunctionChart::StyleAxes(const scene::Theme& look)
{
  for (const int side : {vtkAxis::BOTTOM, vtkAxis::LEFT})
  {
    vtkAxis* axis = chart->GetAxis(side);
    axis->SetBehavior(vtkAxis::FIXED);
    for (vtkTextProperty* text : {axis->GetTitleProperties(), axis->GetLabelProperties()})
    {
      text->SetColor(look.scale[0], look.scale[1], look.scale[2]);
      text->SetFontSize(letters);
      text->BoldOff();
    }
    SetColour(axis->GetPen(), look.scale, 1.0);
    SetColour(axis->GetGridPen(), look.wall, 1.0);
  }
  chart->GetAxis(vtkAxis::LEFT)->SetRange(0.0, 1.0);
  for (const int side : {vtkAxis::TOP, vtkAxis::RIGHT})
  {
    chart->GetAxis(side)->SetVisible(false);
  }
}

QPointF TransferFunctionChart::PlaceOf(double value, double level) const
{
  const int* corner = chart->GetPoint1();
  const int* opposite = chart->GetPoint2();
  const double x =
    corner[0] + (value - range[0]) / (range[1] - range[0]) * (opposite[0] - corner[0]);
  const double y = corner[1] + level * (opposite[1] - corner[1]);
  return {x / this->devicePixelRatioF(), this->height() - 1.0 - y / this->devicePixelRatioF()};
}

// Keys are those of the window: VTK's own would switch its stereo picture on or leave.
bool TransferFunctionChart::event(QEvent* event)
{
  const bool key = event->type() == QEvent::KeyPress || event->type() == QEvent::KeyRelease;
  return key ? this->QOpenGLWidget::event(event) : this->QVTKOpenGLNativeWidget::event(event);
}

// VTK's style of charts draws a scene that changed, at most every 40 ms.
void TransferFunctionChart::DrawSoon()
{
  actor->GetScene()->SetDirty(true);
}

// What changed while the chart was hidden.
void TransferFunctionChart::showEvent(QShowEvent* event)
{
  this->QVTKOpenGLNativeWidget::showEvent(event);
  QTimer::singleShot(0, this,
    [this]
    {
      if (window->GetReadyForRendering())
      {
        window->Render();
      }
    });
}

} // namespace nexrad::viewer
