// SPDX-License-Identifier: BSD-3-Clause
#include "Viewer/SectionChart.h"

#include "Scene/Plan/PlanLayer.h"
#include "Scene/Scales/ColourScale.h"
#include "Scene/Shapes/Letters.h"
#include "Scene/Shapes/Theme.h"
#include "nexrad/Grid/GriddedVolume.h"

#include <vtkAxis.h>
#include <vtkBrush.h>
#include <vtkChartXY.h>
#include <vtkContextActor.h>
#include <vtkContextScene.h>
#include <vtkDataArray.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkImageData.h>
#include <vtkLookupTable.h>
#include <vtkPen.h>
#include <vtkPlotHistogram2D.h>
#include <vtkPointData.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>
#include <vtkTextProperty.h>

#include <QMouseEvent>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace nexrad::viewer
{
namespace
{

vtkColor4ub Bytes(const scene::Colour& colour)
{
  return {scene::ToByte(colour[0]), scene::ToByte(colour[1]), scene::ToByte(colour[2]), 255};
}

// The colours of the bins of the scale, then those of the states of places without a value.
vtkSmartPointer<vtkLookupTable> TableOf(
  const scene::ColourScale& colours, const scene::Theme& theme)
{
  const auto bins = static_cast<vtkIdType>(colours.bins.size());
  auto table = vtkSmartPointer<vtkLookupTable>::New();
  table->SetNumberOfTableValues(bins + static_cast<vtkIdType>(VoxelStateCount));
  const auto set = [&](vtkIdType place, const scene::Colour& colour)
  { table->SetTableValue(place, colour[0], colour[1], colour[2]); };
  for (vtkIdType bin = 0; bin < bins; ++bin)
  {
    set(bin, colours.bins[static_cast<std::size_t>(bin)].colour);
  }
  set(bins + static_cast<vtkIdType>(VoxelState::NoEcho), theme.ground);
  set(bins + static_cast<vtkIdType>(VoxelState::NotScanned), theme.notScanned);
  set(bins + static_cast<vtkIdType>(VoxelState::RangeFolded), theme.rangeFolded);
  set(bins + static_cast<vtkIdType>(VoxelState::Filtered), theme.filtered);
  table->SetTableRange(-0.5, static_cast<double>(table->GetNumberOfTableValues()) - 0.5);
  return table;
}

vtkDataArray* StatesOf(vtkImageData* section)
{
  const std::string name = section->GetPointData()->GetScalars()->GetName();
  return section->GetPointData()->GetArray((name + "_state").c_str());
}

std::uint8_t StateAt(vtkDataArray* states, vtkIdType point)
{
  return static_cast<std::uint8_t>(states->GetTuple1(point));
}

int PlaceInTable(double value, VoxelState state, const scene::ColourScale& colours)
{
  const bool isEcho = state == VoxelState::Echo;
  const int bin = isEcho ? scene::FindBin(colours, value) : -1;
  const VoxelState without = isEcho ? VoxelState::NoEcho : state;
  return bin >= 0 ? bin : static_cast<int>(colours.bins.size()) + static_cast<int>(without);
}

// The section as places in the table of colours, over km. A pixel of a chart's image begins at its
// point, where the points of the section are its middles.
vtkSmartPointer<vtkImageData> PictureOf(vtkImageData* section, const scene::ColourScale& colours)
{
  auto picture = vtkSmartPointer<vtkImageData>::New();
  const double* spacing = section->GetSpacing();
  const double* origin = section->GetOrigin();
  picture->SetExtent(section->GetExtent());
  picture->SetSpacing(spacing[0] / 1000.0, spacing[1] / 1000.0, 1.0);
  picture->SetOrigin(
    (origin[0] - 0.5 * spacing[0]) / 1000.0, (origin[1] - 0.5 * spacing[1]) / 1000.0, 0.0);
  picture->AllocateScalars(VTK_UNSIGNED_SHORT, 1);
  auto* place = static_cast<unsigned short*>(picture->GetScalarPointer());
  vtkDataArray* values = section->GetPointData()->GetScalars();
  vtkDataArray* states = StatesOf(section);
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    const VoxelState state = ToVoxelState(StateAt(states, i));
    place[i] = static_cast<unsigned short>(PlaceInTable(values->GetTuple1(i), state, colours));
  }
  return picture;
}

std::string TitleOf(vtkImageData* section, const scene::ColourScale& colours)
{
  vtkDataArray* states = StatesOf(section);
  std::array<bool, VoxelStateCount> held{};
  for (vtkIdType i = 0; i < states->GetNumberOfTuples(); ++i)
  {
    held[static_cast<std::size_t>(ToVoxelState(StateAt(states, i)))] = true;
  }
  std::string title = colours.title;
  for (const auto& [state, text] : scene::StateTexts)
  {
    title += held[static_cast<std::size_t>(state)] ? std::string("; ") + text : "";
  }
  return title;
}

void Style(vtkTextProperty* letters, const scene::Colour& colour, int size)
{
  letters->SetColor(colour[0], colour[1], colour[2]);
  letters->SetFontSize(size);
  letters->SetBold(0);
}

} // namespace

struct SectionChart::Shown
{
  vtkSmartPointer<vtkImageData> picture;
  scene::ColourScale colours;
  const scene::Theme* theme = nullptr;
  std::string title;
};

SectionChart::SectionChart(QWidget* parent)
  : QVTKOpenGLNativeWidget(parent)
  , pictures(std::make_unique<scene::TextPictures>())
{
  this->setObjectName("section");
  this->setAccessibleName("Vertical section");
  // No tool tip: it would cover what the mouse points at.
  this->setAccessibleDescription("Distance from A and height above mean sea level in km");
  this->setFocusPolicy(Qt::NoFocus);
  this->setMouseTracking(true);
  window->AddRenderer(renderer);
  this->setRenderWindow(window.Get());
  this->interactor()->SetInteractorStyle(nullptr);
  actor->GetScene()->SetRenderer(renderer);
  actor->GetScene()->AddItem(chart);
  renderer->AddActor(actor);
  chart->SetAutoSize(false);
  chart->SetShowLegend(false);
  chart->AddPlot(plot);
  chart->SetVisible(false);
}

SectionChart::~SectionChart() = default;

void SectionChart::Show(
  vtkImageData* section, const scene::ColourScale& colours, const scene::Theme& theme)
{
  shown.reset();
  const scene::Colour& sky = theme.skyBottom;
  renderer->SetBackground(sky[0], sky[1], sky[2]);
  if (section != nullptr && section->GetNumberOfPoints() > 0)
  {
    const scene::ColourScale flat = scene::WithoutRamps(colours);
    shown = std::make_unique<Shown>(
      Shown{PictureOf(section, flat), colours, &theme, TitleOf(section, colours)});
    plot->SetInputData(shown->picture);
    plot->SetTransferFunction(TableOf(flat, theme));
  }
  this->Draw();
}

void SectionChart::Draw()
{
  for (const auto& prop : colourBar)
  {
    renderer->RemoveViewProp(prop);
  }
  colourBar.clear();
  chart->SetVisible(shown != nullptr);
  if (shown)
  {
    this->DrawColourBar();
    this->DrawAxes();
  }
  if (this->isVisible() && window->GetReadyForRendering())
  {
    window->Render();
  }
}

void SectionChart::DrawColourBar()
{
  const double ratio = this->devicePixelRatioF();
  const std::array<int, 2> size = {static_cast<int>(std::lround(this->width() * ratio)),
    static_cast<int>(std::lround(this->height() * ratio))};
  const scene::TextStyle style = {
    static_cast<int>(std::lround(12.0 * ratio)), shown->theme->scale, shown->theme->rim};
  const scene::ColourBar bar =
    scene::MakeColourBar(shown->colours, size, style, shown->theme->frame, *pictures);
  colourBar = bar.props;
  for (const auto& prop : colourBar)
  {
    renderer->AddViewProp(prop);
  }
  chart->SetSize(vtkRectf(0.0F, 0.0F, static_cast<float>(bar.left), static_cast<float>(size[1])));
}

void SectionChart::DrawAxes()
{
  const int letters = static_cast<int>(std::lround(12.0 * this->devicePixelRatioF()));
  const scene::Theme& theme = *shown->theme;
  chart->SetTitle(shown->title);
  Style(chart->GetTitleProperties(), theme.title, letters);
  chart->GetBackgroundBrush()->SetColor(Bytes(theme.ground));
  double bounds[4];
  plot->GetBounds(bounds);
  const std::array<std::pair<int, const char*>, 2> axes = {
    {{vtkAxis::BOTTOM, "Distance from A to B, km"}, {vtkAxis::LEFT, "Height, km"}}};
  for (std::size_t i = 0; i < axes.size(); ++i)
  {
    vtkAxis* axis = chart->GetAxis(axes[i].first);
    axis->SetTitle(axes[i].second);
    axis->SetBehavior(vtkAxis::FIXED);
    axis->SetRange(bounds[2 * i], bounds[2 * i + 1]);
    axis->SetGridVisible(false); // lines over the colours would be taken for data
    axis->GetPen()->SetColor(Bytes(theme.scale));
    Style(axis->GetLabelProperties(), theme.scale, letters);
    Style(axis->GetTitleProperties(), theme.scale, letters);
  }
}

std::optional<std::array<double, 2>> SectionChart::PlaceAt(const QPoint& pixel) const
{
  if (!shown)
  {
    return std::nullopt;
  }
  const double ratio = this->devicePixelRatioF();
  const std::array<double, 2> at = {
    (pixel.x() + 0.5) * ratio, (this->height() - pixel.y() - 0.5) * ratio};
  double bounds[4];
  plot->GetBounds(bounds);
  std::array<double, 2> place{};
  for (std::size_t i = 0; i < 2; ++i)
  {
    const auto corner = static_cast<int>(i);
    const double first = chart->GetPoint1()[corner];
    const double last = chart->GetPoint2()[corner];
    const double share = (at[i] - first) / std::max(1.0, last - first);
    if (share < 0.0 || share > 1.0)
    {
      return std::nullopt;
    }
    place[i] = 1000.0 * (bounds[2 * i] + share * (bounds[2 * i + 1] - bounds[2 * i]));
  }
  return place;
}

void SectionChart::mouseMoveEvent(QMouseEvent* event)
{
  emit Pointed(event->pos());
}

void SectionChart::resizeEvent(QResizeEvent* event)
{
  QVTKOpenGLNativeWidget::resizeEvent(event);
  this->Draw();
}

} // namespace nexrad::viewer
