// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNexradMap.h"

#include "Scene/Frame/SceneFrame.h"
#include "Scene/Frame/VolumeInformation.h"
#include "Scene/Map/MapLines.h"
#include "Scene/Map/PlacedMap.h"
#include "nexrad/Geometry/Angles.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataObject.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVectorText.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>

vtkStandardNewMacro(vtkNexradMap);

namespace
{

using nexrad::scene::GroundLine;
using nexrad::scene::SceneFrame;

// Of the kinds; for a dark background, the more important the lighter.
constexpr std::array<std::array<unsigned char, 3>, 5> colors = {
  {{190, 196, 206}, {132, 140, 154}, {66, 72, 84}, {96, 118, 140}, {255, 214, 102}}};

// Collects lines and polygons of the scene as those of the volume, each with its colour.
class MapBuilder
{
public:
  MapBuilder(const SceneFrame& theFrame, vtkPolyData* theOutput)
    : frame(theFrame)
    , output(theOutput)
  {
    points->SetDataTypeToDouble();
    lineColors->SetNumberOfComponents(3);
    polygonColors->SetNumberOfComponents(3);
  }

  const SceneFrame& Frame() const { return frame; }
  std::array<double, 4> Rectangle() const
  {
    const auto& bounds = frame.Bounds();
    return {bounds[0], bounds[1], bounds[2], bounds[3]};
  }

  void AddLine(const GroundLine& line, int kind)
  {
    this->InsertCell(lines, line);
    this->Paint(kind, lineColors, lineKinds);
  }

  void AddPolygon(const GroundLine& corners, int kind)
  {
    this->InsertCell(polygons, corners);
    this->Paint(kind, polygonColors, polygonKinds);
  }

  // Polygons come after lines among the cells of polygonal data.
  void Finish()
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

private:
  void InsertCell(vtkCellArray* cells, const GroundLine& line)
  {
    cells->InsertNextCell(static_cast<int>(line.size()));
    for (const auto& [x, y] : line)
    {
      const auto place = frame.ToVolume({x, y, frame.Bounds()[4]});
      cells->InsertCellPoint(points->InsertNextPoint(place.data()));
    }
  }

  static void Paint(int kind, vtkUnsignedCharArray* color, vtkUnsignedCharArray* kinds)
  {
    color->InsertNextTypedTuple(colors[static_cast<std::size_t>(kind)].data());
    kinds->InsertNextValue(static_cast<unsigned char>(kind));
  }

  const SceneFrame& frame;
  vtkPolyData* output;
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkCellArray> polygons;
  vtkNew<vtkUnsignedCharArray> lineColors;
  vtkNew<vtkUnsignedCharArray> lineKinds;
  vtkNew<vtkUnsignedCharArray> polygonColors;
  vtkNew<vtkUnsignedCharArray> polygonKinds;
};

void AddDisc(MapBuilder& builder, const std::array<double, 2>& place, double radius)
{
  constexpr int corners = 24;
  GroundLine disc;
  for (int i = 0; i < corners; ++i)
  {
    const double angle = 2.0 * nexrad::Pi * i / corners;
    disc.push_back({place[0] + radius * std::cos(angle), place[1] + radius * std::sin(angle)});
  }
  builder.AddPolygon(disc, vtkNexradMap::RADAR);
}

// A name that begins at a place, in letters of a height in km, as they lie on the ground.
void AddName(
  MapBuilder& builder, const std::string& name, const std::array<double, 2>& begin, double height)
{
  vtkNew<vtkVectorText> text;
  text->SetText(name.c_str());
  text->Update();
  vtkPolyData* letters = text->GetOutput();
  vtkCellArray* cells = letters->GetPolys();
  vtkNew<vtkIdList> corners;
  cells->InitTraversal();
  while (cells->GetNextCell(corners))
  {
    GroundLine polygon;
    for (vtkIdType i = 0; i < corners->GetNumberOfIds(); ++i)
    {
      double point[3];
      letters->GetPoint(corners->GetId(i), point);
      polygon.push_back({begin[0] + height * point[0], begin[1] + height * point[1]});
    }
    builder.AddPolygon(polygon, vtkNexradMap::RADAR);
  }
}

void AddClipped(MapBuilder& builder, const GroundLine& line, int kind)
{
  for (const GroundLine& part : nexrad::scene::ClipLine(line, builder.Rectangle()))
  {
    builder.AddLine(part, kind);
  }
}

// The whole image of a pipeline, without voxels: its faces and its field data.
void DescribeWhole(vtkInformation* info, vtkImageData* image)
{
  vtkImageData* input = vtkImageData::GetData(info);
  image->SetExtent(info->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT()));
  image->SetOrigin(input->GetOrigin());
  image->SetSpacing(input->GetSpacing());
  image->SetFieldData(input->GetFieldData());
}

} // namespace

vtkNexradMap::vtkNexradMap() = default;

vtkNexradMap::~vtkNexradMap() = default;

int vtkNexradMap::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

int vtkNexradMap::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** input, vtkInformationVector* output)
{
  // The part of the volume that this process has anyway: its field data are those of the whole.
  vtkInformation* info = input[0]->GetInformationObject(0);
  vtkInformation* asked = output->GetInformationObject(0);
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  info->Set(Pipeline::UPDATE_NUMBER_OF_PIECES(), asked->Get(Pipeline::UPDATE_NUMBER_OF_PIECES()));
  info->Set(Pipeline::UPDATE_PIECE_NUMBER(), asked->Get(Pipeline::UPDATE_PIECE_NUMBER()));
  info->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
  return 1;
}

int vtkNexradMap::RequestData(
  vtkInformation*, vtkInformationVector** input, vtkInformationVector* output)
{
  vtkInformation* info = output->GetInformationObject(0);
  vtkPolyData* map = vtkPolyData::GetData(output);
  if (info->Get(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER()) > 0)
  {
    return 1;
  }
  vtkNew<vtkImageData> volume;
  DescribeWhole(input[0]->GetInformationObject(0), volume);
  const SceneFrame frame(volume, 1.0);
  MapBuilder builder(frame, map);
  const auto lines = nexrad::scene::PlaceMapLines(frame);
  const std::array<bool, 3> wanted = {true, this->States, this->Counties};
  for (const int kind : {COUNTY, STATE, COUNTRY}) // the more important lie above
  {
    for (const GroundLine& line : lines[static_cast<std::size_t>(kind)])
    {
      if (wanted[static_cast<std::size_t>(kind)])
      {
        builder.AddLine(line, kind);
      }
    }
  }
  const auto box = builder.Rectangle();
  const double letters = this->LetterHeight * std::max(box[1] - box[0], box[3] - box[2]);
  for (const nexrad::scene::PlacedSite& site :
    nexrad::scene::PlaceSites(frame, nexrad::scene::ReadVolumeInformation(volume).sites))
  {
    for (const GroundLine& ring : nexrad::scene::PlaceRings(site.place, this->RingSpacing))
    {
      AddClipped(builder, ring, RING);
    }
    if (this->Radars && site.within)
    {
      AddDisc(builder, site.place, letters / 4.0);
      AddName(builder, site.name, {site.place[0] + letters / 2.0, site.place[1] + letters / 4.0},
        letters);
    }
  }
  builder.Finish();
  return 1;
}

void vtkNexradMap::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "States: " << this->States << "\n";
  os << indent << "Counties: " << this->Counties << "\n";
  os << indent << "Radars: " << this->Radars << "\n";
  os << indent << "RingSpacing: " << this->RingSpacing << "\n";
  os << indent << "LetterHeight: " << this->LetterHeight << "\n";
}
