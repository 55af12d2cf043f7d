// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/Scales/ColourBar.h"

#include "Scene/Elements/SceneText.h"

#include <vtkActor2D.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkTextActor.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>

namespace nexrad::scene
{
namespace
{

constexpr Colour textColour = {0.88, 0.90, 0.93};
// Place of the bar in the picture, fractions.
constexpr double barWidth = 0.02;
constexpr double bottom = 0.10;
constexpr double top = 0.88;

// The bar's right edge: four letters and more stand beside it.
double RightEdge(const std::array<int, 2>& size, int textSize)
{
  return 1.0 - std::max(0.055, 4.2 * textSize / size[0]);
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

std::string LabelOf(const ColourScale& scale, std::size_t bin)
{
  std::ostringstream label;
  label << scale.bins[bin].from;
  return scale.labels.empty() ? label.str() : scale.labels[bin];
}

} // namespace

double LeftOfColourBar(const std::array<int, 2>& size, int textSize)
{
  return RightEdge(size, textSize) - barWidth;
}

std::vector<vtkSmartPointer<vtkProp>> MakeColourBar(
  const ColourScale& scale, const std::array<int, 2>& size, int textSize)
{
  const double right = RightEdge(size, textSize);
  std::vector<vtkSmartPointer<vtkProp>> props = {MakeBoxes(scale.bins, size, right)};
  for (std::size_t i = 0; i < scale.bins.size(); ++i)
  {
    const double bin = static_cast<double>(i) + (scale.labels.empty() ? 0.0 : 0.5);
    props.push_back(MakeCaption(LabelOf(scale, i),
      {right + 0.008, HeightOf(bin, scale.bins.size())}, textSize, textColour, LabelSide::Right));
  }
  props.push_back(MakeCaption(scale.unit, {right - barWidth, top + 0.01 + 0.7 * textSize / size[1]},
    textSize, textColour, LabelSide::Right));
  return props;
}

} // namespace nexrad::scene
