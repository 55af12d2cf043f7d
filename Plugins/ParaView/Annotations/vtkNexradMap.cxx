// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNexradMap.h"

#include "MapBuilder.h"
#include "Scene/Frame/VolumeInformation.h"
#include "Scene/Map/MapData.h"
#include "Scene/Map/MapLayer.h"
#include "Scene/Map/PlacedMap.h"
#include "Scene/SceneOptions.h"
#include "WholeVolume.h"

#include "vtkDataObject.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <array>

vtkStandardNewMacro(vtkNexradMap);

namespace
{

nexrad::scene::Colour SceneColor(int kind)
{
  const nexrad::scene::Theme& theme = ThemeOf(nexrad::scene::SceneOptions().theme);
  switch (kind)
  {
  case vtkNexradMap::RING:
    return theme.ring;
  case vtkNexradMap::RADAR:
    return theme.marker;
  case vtkNexradMap::TOWN:
    return theme.placeName;
  default:
    return ColourOf(static_cast<nexrad::scene::MapLineKind>(kind), theme);
  }
}

// The largest towns, as the scene writes them: small letters with much room about them.
void AddTowns(MapBuilder& builder, NameWriter& names, double letters)
{
  constexpr std::size_t most = 40;
  std::size_t count = 0;
  for (const nexrad::scene::MapName& town : nexrad::scene::EmbeddedTowns())
  {
    const auto place = builder.Frame().Place(town.longitude, town.latitude);
    if (count < most &&
        names.WriteWhereFree(town.name, place, 0.8 * letters, 2.0 * letters, vtkNexradMap::TOWN))
    {
      ++count;
    }
  }
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
  AskForOwnPart(input[0]->GetInformationObject(0), output->GetInformationObject(0));
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
  const auto volume = DescribeWhole(input[0]->GetInformationObject(0));
  const nexrad::scene::SceneFrame frame(volume, 1.0);
  MapBuilder builder(frame, SceneColor, map);
  this->AddLines(builder);
  this->AddNames(builder, volume);
  builder.Finish();
  return 1;
}

void vtkNexradMap::AddLines(MapBuilder& builder)
{
  const auto lines = nexrad::scene::PlaceMapLines(builder.Frame());
  const std::array<bool, 3> wanted = {
    true, this->States, this->Counties && ShowsCounties(builder.Frame())};
  for (const int kind : {COUNTY, STATE, COUNTRY}) // the more important lie above
  {
    for (const nexrad::scene::GroundLine& line : lines[static_cast<std::size_t>(kind)])
    {
      if (wanted[static_cast<std::size_t>(kind)])
      {
        builder.AddLine(line, kind);
      }
    }
  }
}

void vtkNexradMap::AddNames(MapBuilder& builder, vtkImageData* volume)
{
  const auto box = builder.Rectangle();
  const double letters = this->LetterHeight * std::max(box[1] - box[0], box[3] - box[2]);
  NameWriter names(builder);
  const auto sites = nexrad::scene::ReadVolumeInformation(volume).sites;
  for (const auto& site : nexrad::scene::PlaceSites(builder.Frame(), sites))
  {
    for (const auto& ring : nexrad::scene::PlaceRings(site.place, this->RingSpacing))
    {
      builder.AddClipped(ring, RING);
    }
    if (this->Radars && site.within)
    {
      names.Write(site.name, site.place, letters, RADAR);
    }
  }
  if (this->Towns && builder.Frame().HasMap())
  {
    AddTowns(builder, names, letters);
  }
}

void vtkNexradMap::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "States: " << this->States << "\n";
  os << indent << "Counties: " << this->Counties << "\n";
  os << indent << "Radars: " << this->Radars << "\n";
  os << indent << "Towns: " << this->Towns << "\n";
  os << indent << "RingSpacing: " << this->RingSpacing << "\n";
  os << indent << "LetterHeight: " << this->LetterHeight << "\n";
}
