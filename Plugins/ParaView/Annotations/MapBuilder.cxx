// SPDX-License-Identifier: BSD-3-Clause
#include "MapBuilder.h"

#include "nexrad/Geometry/Angles.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkIdList.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVectorText.h"

#include <algorithm>
#include <cmath>
#include <utility>

using nexrad::scene::GroundLine;

namespace
{

void Paint(int kind, const nexrad::scene::Colour& color, vtkUnsignedCharArray* colors,
  vtkUnsignedCharArray* kinds)
{
  std::array<unsigned char, 3> bytes{};
  std::transform(color.begin(), color.end(), bytes.begin(),
    [](double part) { return static_cast<unsigned char>(std::lround(255.0 * part)); });
  colors->InsertNextTypedTuple(bytes.data());
  kinds->InsertNextValue(static_cast<unsigned char>(kind));
}

GroundLine DiscAt(const std::array<double, 2>& place, double radius)
{
  constexpr int corners = 24;
  GroundLine disc;
  for (int i = 0; i < corners; ++i)
  {
    const double angle = 2.0 * nexrad::Pi * i / corners;
    disc.push_back({place[0] + radius * std::cos(angle), place[1] + radius * std::sin(angle)});
  }
  return disc;
}

} // namespace

MapBuilder::MapBuilder(
  const nexrad::scene::SceneFrame& theFrame, ColourOfKind theColours, vtkPolyData* theOutput)
  : frame(theFrame)
  , colours(std::move(theColours))
  , output(theOutput)
{
  points->SetDataTypeToDouble();
  lineColors->SetNumberOfComponents(3);
  polygonColors->SetNumberOfComponents(3);
}

MapBuilder::~MapBuilder() = default;

std::array<double, 4> MapBuilder::Rectangle() const
{
  const auto& bounds = frame.Bounds();
  return {bounds[0], bounds[1], bounds[2], bounds[3]};
}

void MapBuilder::AddLine(const GroundLine& line, int kind)
{
  this->InsertCell(lines, line);
  Paint(kind, colours(kind), lineColors, lineKinds);
}

void MapBuilder::AddClipped(const GroundLine& line, int kind)
{
  for (const GroundLine& part : nexrad::scene::ClipLine(line, this->Rectangle()))
  {
    this->AddLine(part, kind);
  }
}

void MapBuilder::AddPolygon(const GroundLine& corners, int kind)
{
  this->InsertCell(polygons, corners);
  Paint(kind, colours(kind), polygonColors, polygonKinds);
}

// Polygons come after lines among the cells of polygonal data.
void MapBuilder::Finish()
{
  output->SetPoints(points);
  output->SetLines(lines);
  output->SetPolys(polygons);
  vtkNew<vtkUnsignedCharArray> color;
  color->SetName("MapColor");
  color->SetNumberOfComponents(3);
  vtkNew<vtkUnsignedCharArray> kind;
  kind->SetName("MapKind");
  for (vtkUnsignedCharArray* part : {lineColors.Get(), polygonColors.Get()})
  {
    color->InsertTuples(color->GetNumberOfTuples(), part->GetNumberOfTuples(), 0, part);
  }
  for (vtkUnsignedCharArray* part : {lineKinds.Get(), polygonKinds.Get()})
  {
    kind->InsertTuples(kind->GetNumberOfTuples(), part->GetNumberOfTuples(), 0, part);
  }
  output->GetCellData()->SetScalars(color);
  output->GetCellData()->AddArray(kind);
}

void MapBuilder::InsertCell(vtkCellArray* cells, const GroundLine& line)
{
  cells->InsertNextCell(static_cast<int>(line.size()));
  for (const auto& [x, y] : line)
  {
    const auto place = frame.ToVolume({x, y, frame.Bounds()[4]});
    cells->InsertCellPoint(points->InsertNextPoint(place.data()));
  }
}

struct NameWriter::Name
{
  vtkSmartPointer<vtkPolyData> letters; // of a height of 1, from their lower left corner
  std::array<double, 2> place{};
  std::array<double, 2> begin{};
  double height = 0.0;

  Name(const std::string& text, const std::array<double, 2>& beside, double ofLetters)
    : place(beside)
    , height(ofLetters)
  {
    vtkNew<vtkVectorText> writer;
    writer->SetText(text.c_str());
    writer->Update();
    letters = writer->GetOutput();
    begin = {place[0] + 0.5 * height, place[1] + 0.25 * height};
  }

  double Width() const { return height * letters->GetBounds()[1]; }

  std::array<double, 4> Box() const
  {
    return {std::min(begin[0], place[0]), std::max(begin[0] + Width(), place[0]), place[1],
      begin[1] + height};
  }
};

void NameWriter::Add(const Name& name, int kind)
{
  builder.AddPolygon(DiscAt(name.place, 0.25 * name.height), kind);
  vtkCellArray* cells = name.letters->GetPolys();
  vtkNew<vtkIdList> corners;
  cells->InitTraversal();
  while (cells->GetNextCell(corners))
  {
    GroundLine polygon;
    for (const vtkIdType corner : *corners)
    {
      const double* point = name.letters->GetPoint(corner);
      polygon.push_back(
        {name.begin[0] + name.height * point[0], name.begin[1] + name.height * point[1]});
    }
    builder.AddPolygon(polygon, kind);
  }
  written.push_back(name.Box());
}

bool NameWriter::IsFree(const Name& name, double room) const
{
  const auto box = name.Box();
  const auto [west, east, south, north] = builder.Rectangle();
  return box[0] > west && box[1] < east && box[2] > south && box[3] < north &&
         std::none_of(written.begin(), written.end(),
           [&](const auto& other)
           {
             return box[0] < other[1] + room && other[0] < box[1] + room &&
                    box[2] < other[3] + room && other[2] < box[3] + room;
           });
}

void NameWriter::Write(
  const std::string& name, const std::array<double, 2>& place, double height, int kind)
{
  this->Add(Name(name, place, height), kind);
}

bool NameWriter::WriteWhereFree(
  const std::string& name, const std::array<double, 2>& place, double height, double room, int kind)
{
  const auto [west, east, south, north] = builder.Rectangle();
  if (place[0] < west || place[0] > east || place[1] < south || place[1] > north)
  {
    return false;
  }
  const Name right(name, place, height);
  Name left = right;
  left.begin[0] = place[0] - 0.5 * height - left.Width();
  for (const Name& each : {right, left})
  {
    if (this->IsFree(each, room))
    {
      this->Add(each, kind);
      return true;
    }
  }
  return false;
}
