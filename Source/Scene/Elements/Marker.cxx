// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/Elements/Marker.h"

#include <vtkActor2D.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCoordinate.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkUnsignedCharArray.h>

#include <cmath>

namespace nexrad::scene
{
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
    colours->InsertNextValue(static_cast<unsigned char>(std::lround(255.0 * component)));
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
