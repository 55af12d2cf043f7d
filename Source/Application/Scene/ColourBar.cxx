// SPDX-License-Identifier: BSD-3-Clause
#include "ColourBar.h"

#include "SceneText.h"

#include <vtkActor2D.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkTextActor.h>
#include <vtkUnsignedCharArray.h>

#include <cmath>
#include <sstream>

namespace nexrad::scene
{
namespace
{

constexpr Colour textColour = {0.88, 0.90, 0.93};
// Place of the bar in the picture, fractions.
constexpr double left = 0.925;
constexpr double right = 0.945;
constexpr double bottom = 0.10;
constexpr double top = 0.88;

vtkSmartPointer<vtkActor2D> MakeBoxes(const ColourTable& table, const std::array<int, 2>& size)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> boxes;
  vtkNew<vtkUnsignedCharArray> colours;
  colours->SetNumberOfComponents(3);
  const auto count = static_cast<double>(table.size());
  for (std::size_t i = 0; i < table.size(); ++i)
  {
    const auto bin = static_cast<double>(i);
    const double low = size[1] * (bottom + (top - bottom) * bin / count);
    const double high = size[1] * (bottom + (top - bottom) * (bin + 1.0) / count);
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

} // namespace

std::vector<vtkSmartPointer<vtkProp>> MakeColourBar(
  const ColourTable& table, const std::array<int, 2>& size, int textSize)
{
  std::vector<vtkSmartPointer<vtkProp>> props = {MakeBoxes(table, size)};
  const auto count = static_cast<double>(table.size());
  for (std::size_t i = 0; i < table.size(); ++i)
  {
    std::ostringstream label;
    label << table[i].from;
    const double height = bottom + (top - bottom) * static_cast<double>(i) / count;
    props.push_back(
      MakeCaption(label.str(), {right + 0.008, height}, textSize, textColour, LabelSide::Right));
  }
  props.push_back(MakeCaption(
    "dBZ", {left, top + 0.01 + 0.7 * textSize / size[1]}, textSize, textColour, LabelSide::Right));
  return props;
}

} // namespace nexrad::scene
