// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/Scales/ColourBar.h"

#include <vtkActor2D.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProperty2D.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <utility>

namespace nexrad::scene
{
namespace
{

// Place of the bar in the picture, fractions.
constexpr double barWidth = 0.02;
constexpr double bottom = 0.10;
constexpr double top = 0.88;

std::string LabelOf(const ColourScale& scale, std::size_t bin)
{
  std::ostringstream label;
  label << scale.bins[bin].from;
  return scale.labels.empty() ? label.str() : scale.labels[bin];
}

double GapOf(const TextStyle& style)
{
  return 0.5 * style.size;
}

// The bar's right edge, a fraction of the width: the longest label stands beside it.
double RightEdge(const ColourScale& scale, const std::array<int, 2>& size, const TextStyle& style,
  TextPictures& pictures)
{
  int longest = 0;
  for (std::size_t bin = 0; bin < scale.bins.size(); ++bin)
  {
    longest = std::max(longest, pictures.Get(LabelOf(scale, bin), style).Size()[0]);
  }
  return 1.0 - (longest + 2.0 * GapOf(style)) / size[0];
}

// Every how manieth label there is room for.
std::size_t LabelStep(const ColourScale& scale, const std::array<int, 2>& size, int letters)
{
  const double boxHeight = (top - bottom) * size[1] / static_cast<double>(scale.bins.size());
  return std::max<std::size_t>(1, static_cast<std::size_t>(std::ceil(1.15 * letters / boxHeight)));
}

double HeightOf(double bin, std::size_t bins)
{
  return bottom + (top - bottom) * bin / static_cast<double>(bins);
}

vtkSmartPointer<vtkActor2D> MakeBoxes(
  const ColourTable& table, const std::array<int, 2>& size, double right)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> boxes;
  vtkNew<vtkUnsignedCharArray> colours;
  colours->SetNumberOfComponents(3);
  const double left = right - barWidth;
  for (std::size_t i = 0; i < table.size(); ++i)
  {
    const auto bin = static_cast<double>(i);
    const double low = size[1] * HeightOf(bin, table.size());
    const double high = size[1] * HeightOf(bin + 1.0, table.size());
    boxes->InsertNextCell(4);
    boxes->InsertCellPoint(points->InsertNextPoint(size[0] * left, low, 0.0));
    boxes->InsertCellPoint(points->InsertNextPoint(size[0] * right, low, 0.0));
    boxes->InsertCellPoint(points->InsertNextPoint(size[0] * right, high, 0.0));
    boxes->InsertCellPoint(points->InsertNextPoint(size[0] * left, high, 0.0));
    for (const double component : table[i].colour)
    {
      colours->InsertNextValue(static_cast<unsigned char>(std::lround(255.0 * component)));
    }
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetPolys(boxes);
  data->GetCellData()->SetScalars(colours);
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

double LeftOfColourBar(const ColourScale& scale, const std::array<int, 2>& size,
  const TextStyle& style, TextPictures& pictures)
{
  const double bar = (RightEdge(scale, size, style, pictures) - barWidth) * size[0];
  const double unit = size[0] - GapOf(style) - pictures.Get(scale.unit, style).Size()[0];
  return std::min(bar, unit);
}

std::vector<vtkSmartPointer<vtkProp>> MakeColourBar(const ColourScale& scale,
  const std::array<int, 2>& size, const TextStyle& style, const Colour& edge,
  TextPictures& pictures)
{
  const double right = RightEdge(scale, size, style, pictures);
  std::vector<vtkSmartPointer<vtkProp>> props = {
    MakeBoxes(scale.bins, size, right), MakeEdge(size, right, edge)};
  const std::size_t step = LabelStep(scale, size, style.size);
  for (std::size_t i = 0; i < scale.bins.size(); i += step)
  {
    const double bin = static_cast<double>(i) + (scale.labels.empty() ? 0.0 : 0.5);
    props.push_back(
      pictures.Get(LabelOf(scale, i), style)
        .MakeCaption(
          {right + GapOf(style) / size[0], HeightOf(bin, scale.bins.size())}, LabelSide::Right));
  }
  const double left = LeftOfColourBar(scale, size, style, pictures) / size[0];
  props.push_back(pictures.Get(scale.unit, style)
                    .MakeCaption({left, top + 0.9 * style.size / size[1]}, LabelSide::Right));
  return props;
}

} // namespace nexrad::scene
