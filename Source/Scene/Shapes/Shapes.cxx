// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/Shapes/Shapes.h"

#include <vtkActor.h>
#include <vtkActor2D.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCoordinate.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProperty.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace nexrad::scene
{

ScenePoint CornerOfBox(const std::array<double, 6>& box, int index)
{
  return {box[index & 1], box[2 + (index >> 1 & 1)], box[4 + (index >> 2)]};
}

LineBuilder::LineBuilder()
  : lines(vtkSmartPointer<vtkPolyData>::New())
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  lines->SetPoints(points);
  lines->SetLines(cells);
}

void LineBuilder::Add(const std::vector<ScenePoint>& points)
{
  lines->GetLines()->InsertNextCell(static_cast<int>(points.size()));
  for (const ScenePoint& point : points)
  {
    lines->GetLines()->InsertCellPoint(lines->GetPoints()->InsertNextPoint(point.data()));
  }
}

vtkSmartPointer<vtkActor> LineBuilder::MakeActor(
  const Colour& colour, double width, double opacity) const
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(lines);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  vtkProperty* property = actor->GetProperty();
  property->SetColor(colour[0], colour[1], colour[2]);
  property->SetLineWidth(static_cast<float>(width));
  property->SetOpacity(opacity);
  property->LightingOff();
  return actor;
}

// Liang and Barsky (1984): each edge of the rectangle shortens the interval of the segment's
// parameter.
bool ClipToRectangle(const std::array<double, 2>& from, const std::array<double, 2>& to,
  const std::array<double, 4>& rectangle, double& enters, double& leaves)
{
  enters = 0.0;
  leaves = 1.0;
  for (int edge = 0; edge < 4; ++edge)
  {
    const int axis = edge / 2;
    const double sign = edge % 2 == 0 ? -1.0 : 1.0;
    const double outward = sign * (to[axis] - from[axis]);
    const double room = sign * (rectangle[edge] - from[axis]);
    if (outward == 0.0)
    {
      if (room < 0.0)
      {
        return false;
      }
      continue;
    }
    const double crossing = room / outward;
    if (outward < 0.0)
    {
      enters = std::max(enters, crossing);
    }
    else
    {
      leaves = std::min(leaves, crossing);
    }
  }
  return enters < leaves;
}

namespace
{

void AddDisc(vtkPolyData* discs, vtkUnsignedCharArray* colours, double radius, const Colour& colour)
{
  constexpr int corners = 24;
  constexpr double pi = 3.14159265358979323846;
  discs->GetPolys()->InsertNextCell(corners);
  for (int i = 0; i < corners; ++i)
  {
    const double angle = 2.0 * pi * i / corners;
    discs->GetPolys()->InsertCellPoint(
      discs->GetPoints()->InsertNextPoint(radius * std::cos(angle), radius * std::sin(angle), 0.0));
  }
  for (const double component : colour)
  {
    colours->InsertNextValue(ToByte(component));
  }
}

} // namespace

vtkSmartPointer<vtkProp> MakeMarker(
  const ScenePoint& point, double radius, const Colour& colour, const Colour& rim)
{
  vtkNew<vtkPolyData> discs;
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  discs->SetPoints(points);
  discs->SetPolys(cells);
  vtkNew<vtkUnsignedCharArray> colours;
  colours->SetNumberOfComponents(3);
  AddDisc(discs, colours, radius + 1.5, rim);
  AddDisc(discs, colours, radius, colour);
  discs->GetCellData()->SetScalars(colours);
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputData(discs);
  auto actor = vtkSmartPointer<vtkActor2D>::New();
  actor->SetMapper(mapper);
  vtkCoordinate* coordinate = actor->GetPositionCoordinate();
  coordinate->SetCoordinateSystemToWorld();
  coordinate->SetValue(point[0], point[1], point[2]);
  return actor;
}

} // namespace nexrad::scene
