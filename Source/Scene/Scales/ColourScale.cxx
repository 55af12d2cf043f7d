// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/Scales/ColourScale.h"

#include "nexrad/Model/Moment.h"

#include <vtkActor2D.h>
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProperty2D.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>
#include <string>
#include <utility>

namespace nexrad::scene
{
namespace
{

double ToBins(const ColourScale& scale, double value)
{
  return value * scale.factor + scale.offset;
}

// The colour of a bin at a value in the unit of the bins.
Colour ColourIn(const ColourBin& bin, double value)
{
  Colour colour = bin.colour;
  if (bin.ramp)
  {
    const double share = std::clamp((value - bin.from) / (bin.ramp->at - bin.from), 0.0, 1.0);
    std::transform(colour.begin(), colour.end(), bin.ramp->colour.begin(), colour.begin(),
      [share](double from, double to) { return from + share * (to - from); });
  }
  return colour;
}

} // namespace

ColourScale MomentScale(const std::string& array, const ColourTable& table)
{
  ColourScale scale;
  scale.bins = table;
  scale.title = array;
  if (const auto moment = ParseMomentName(array))
  {
    scale.unit = UnitOf(*moment);
    scale.title = TitleOf(*moment);
    scale.title += IsRadialVelocity(*moment) ? ", positive away from the radar" : "";
    scale.openBelow = *moment != MomentName::REF;
  }
  return scale;
}

int FindBin(const ColourScale& scale, double value)
{
  const auto above = std::upper_bound(scale.bins.begin(), scale.bins.end(), ToBins(scale, value),
    [](double wanted, const ColourBin& bin) { return wanted < bin.from; });
  const int bin = static_cast<int>(above - scale.bins.begin()) - 1;
  return scale.openBelow ? std::max(bin, 0) : bin;
}

std::optional<Colour> ColourAt(const ColourScale& scale, double value)
{
  const int bin = FindBin(scale, value);
  return bin < 0 ? std::nullopt
                 : std::optional(
                     ColourIn(scale.bins[static_cast<std::size_t>(bin)], ToBins(scale, value)));
}

ColourScale WithoutRamps(const ColourScale& scale)
{
  constexpr int pieces = 32;
  ColourScale cut = scale;
  cut.bins.clear();
  for (const ColourBin& bin : scale.bins)
  {
    const int count = bin.ramp ? pieces : 1;
    const double width = bin.ramp ? (bin.ramp->at - bin.from) / count : 0.0;
    for (int i = 0; i < count; ++i)
    {
      cut.bins.push_back({bin.from + width * i, ColourIn(bin, bin.from + width * (i + 0.5))});
    }
  }
  return cut;
}

namespace
{

// Place of the bar in the picture, fractions.
constexpr double barWidth = 0.02;
constexpr double bottom = 0.10;
constexpr double top = 0.88;

// A word beside the bar, and how high.
struct BarLabel
{
  double place; ///< share of the bar, from below
  std::string text;
};

// Where the bins of a scale and their labels are along the bar.
struct BarLayout
{
  std::vector<double> edges; ///< of the bins, shares of the bar from below: one more than bins
  std::vector<BarLabel> labels;
};

double GapOf(const TextStyle& style)
{
  return 0.5 * style.size;
}

std::string NumberText(double value, int decimals)
{
  std::ostringstream text;
  if (decimals >= 0)
  {
    text << std::fixed << std::setprecision(decimals);
  }
  text << value;
  return text.str();
}

// Boxes of one height, with the values at which they begin, as many as there is room for.
BarLayout BoxLayout(const ColourScale& scale, double mostLabels)
{
  BarLayout layout;
  const std::size_t bins = scale.bins.size();
  const auto count = static_cast<double>(bins);
  const auto every = static_cast<std::size_t>(std::max(1.0, std::ceil(count / mostLabels)));
  for (std::size_t i = 0; i <= bins; ++i)
  {
    layout.edges.push_back(static_cast<double>(i) / count);
  }
  for (std::size_t i = 0; i < bins; i += every)
  {
    const bool named = !scale.labels.empty();
    layout.labels.push_back({layout.edges[i] + (named ? 0.5 / count : 0.0),
      named ? scale.labels[i] : NumberText(scale.bins[i].from, scale.decimals)});
  }
  return layout;
}

// From one label to the next beside ramps: 1, 2, 5, 10, … times the scale's step, or else times a
// power of ten.
double LabelStep(const ColourScale& scale, double span, double mostLabels)
{
  const double least = span / mostLabels;
  double decade = scale.step > 0.0 ? scale.step : std::pow(10.0, std::floor(std::log10(least)));
  for (;; decade *= 10.0)
  {
    for (const double factor : {1.0, 2.0, 5.0})
    {
      if (factor * decade >= least)
      {
        return factor * decade;
      }
    }
  }
}

// Bins as high as they are wide in values, with round values.
BarLayout ValueLayout(const ColourScale& scale, double mostLabels)
{
  BarLayout layout;
  const auto& bins = scale.bins;
  const ColourBin& last = bins.back();
  const double lowest = bins.front().from;
  const double highest = last.ramp ? last.ramp->at : 2.0 * last.from - bins[bins.size() - 2].from;
  const double span = highest - lowest;
  for (const ColourBin& bin : bins)
  {
    layout.edges.push_back((bin.from - lowest) / span);
  }
  layout.edges.push_back(1.0);
  const double step = LabelStep(scale, span, mostLabels);
  constexpr double rounding = 1e-9;
  for (double i = std::ceil(lowest / step - rounding); i <= highest / step + rounding; ++i)
  {
    layout.labels.push_back(
      {(i * step - lowest) / span, NumberText(i * step + 0.0, scale.decimals)});
  }
  return layout;
}

bool HasRamps(const ColourTable& table)
{
  return std::any_of(
    table.begin(), table.end(), [](const ColourBin& bin) { return bin.ramp.has_value(); });
}

BarLayout LayoutOf(const ColourScale& scale, const std::array<int, 2>& size, const TextStyle& style)
{
  constexpr double lineHeight = 1.15; // of labels, in letters
  const double mostLabels = std::max(1.0, (top - bottom) * size[1] / (lineHeight * style.size));
  return HasRamps(scale.bins) && scale.bins.size() > 1 ? ValueLayout(scale, 0.6 * mostLabels)
                                                       : BoxLayout(scale, mostLabels);
}

// The bar's right edge, a fraction of the width: the longest label stands beside it.
double RightEdge(const BarLayout& layout, const std::array<int, 2>& size, const TextStyle& style,
  TextPictures& pictures)
{
  int longest = 0;
  for (const BarLabel& label : layout.labels)
  {
    longest = std::max(longest, pictures.Get(label.text, style).Size()[0]);
  }
  return 1.0 - (longest + 2.0 * GapOf(style)) / size[0];
}

double HeightOf(double share)
{
  return bottom + (top - bottom) * share;
}

void AddColour(const Colour& colour, vtkUnsignedCharArray* colours)
{
  for (const double component : colour)
  {
    colours->InsertNextValue(ToByte(component));
  }
}

vtkSmartPointer<vtkActor2D> MakeBoxes(const ColourTable& table, const std::vector<double>& edges,
  const std::array<int, 2>& size, double right)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> boxes;
  vtkNew<vtkUnsignedCharArray> colours; // of the corners of each box
  colours->SetNumberOfComponents(3);
  const double left = right - barWidth;
  for (std::size_t i = 0; i < table.size(); ++i)
  {
    const double low = size[1] * HeightOf(edges[i]);
    const double high = size[1] * HeightOf(edges[i + 1]);
    const Colour& upper = table[i].ramp ? table[i].ramp->colour : table[i].colour;
    boxes->InsertNextCell(4);
    boxes->InsertCellPoint(points->InsertNextPoint(size[0] * left, low, 0.0));
    boxes->InsertCellPoint(points->InsertNextPoint(size[0] * right, low, 0.0));
    boxes->InsertCellPoint(points->InsertNextPoint(size[0] * right, high, 0.0));
    boxes->InsertCellPoint(points->InsertNextPoint(size[0] * left, high, 0.0));
    for (const Colour& corner : {table[i].colour, table[i].colour, upper, upper})
    {
      AddColour(corner, colours);
    }
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetPolys(boxes);
  data->GetPointData()->SetScalars(colours);
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputData(data);
  auto actor = vtkSmartPointer<vtkActor2D>::New();
  actor->SetMapper(mapper);
  return actor;
}

vtkSmartPointer<vtkActor2D> MakeEdge(
  const std::array<int, 2>& size, double right, const Colour& colour)
{
  const double left = right - barWidth;
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> line;
  line->InsertNextCell(5);
  for (const auto& [x, y] : {std::pair{left, bottom}, std::pair{right, bottom},
         std::pair{right, top}, std::pair{left, top}, std::pair{left, bottom}})
  {
    line->InsertCellPoint(
      points->InsertNextPoint(std::round(size[0] * x), std::round(size[1] * y), 0.0));
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetLines(line);
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputData(data);
  auto actor = vtkSmartPointer<vtkActor2D>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(colour[0], colour[1], colour[2]);
  return actor;
}

} // namespace

ColourBar MakeColourBar(const ColourScale& scale, const std::array<int, 2>& size,
  const TextStyle& style, const Colour& edge, TextPictures& pictures)
{
  const BarLayout layout = LayoutOf(scale, size, style);
  const double right = RightEdge(layout, size, style, pictures);
  const double unit = size[0] - GapOf(style) - pictures.Get(scale.unit, style).Size()[0];
  ColourBar bar;
  bar.left = std::min((right - barWidth) * size[0], unit);
  bar.props = {MakeBoxes(scale.bins, layout.edges, size, right), MakeEdge(size, right, edge)};
  for (const BarLabel& label : layout.labels)
  {
    bar.props.push_back(
      pictures.Get(label.text, style)
        .MakeCaption({right + GapOf(style) / size[0], HeightOf(label.place)}, LabelSide::Right));
  }
  bar.props.push_back(
    pictures.Get(scale.unit, style)
      .MakeCaption({bar.left / size[0], top + 0.9 * style.size / size[1]}, LabelSide::Right));
  return bar;
}

} // namespace nexrad::scene
