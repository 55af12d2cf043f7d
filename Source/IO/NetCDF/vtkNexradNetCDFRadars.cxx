// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNexradNetCDFRadars.h"

#include "nexrad/Grid/GriddedVolume.h"
#include "nexrad/Model/SiteTable.h"
#include "vtkNexradNetCDFFile.h"

#include "vtk_netcdf.h"

#include <algorithm>
#include <limits>

namespace
{

constexpr char NamesName[] = "radar_name";
constexpr char UsedName[] = "radar_used";

struct CoordinateTerms
{
  const char* Name;
  const char* StandardName;
  const char* LongName;
  const char* Units;
};
constexpr CoordinateTerms Coordinates[3] = {
  {"radar_latitude", "latitude", "latitude of the radar", "degrees_north"},
  {"radar_longitude", "longitude", "longitude of the radar", "degrees_east"},
  {"radar_altitude", "altitude", "height of the antenna above mean sea level", "m"}};

// A variable that grows along the dimension `radar`.
int DefineVariable(const vtkNexradNetCDFFile& file, const std::string& name, nc_type type,
  const std::vector<int>& dimensions)
{
  // As many as the radars of the continent.
  const std::vector<std::size_t> chunk(dimensions.size(), 256);
  int variable = -1;
  file.Check(nc_def_var(file.Id(), name.c_str(), type, static_cast<int>(dimensions.size()),
               dimensions.data(), &variable),
    name);
  file.Check(nc_def_var_chunking(file.Id(), variable, NC_CHUNKED, chunk.data()), name);
  return variable;
}

} // namespace

vtkNexradNetCDFRadars::vtkNexradNetCDFRadars(const vtkNexradNetCDFFile& file, int time)
  : File(file)
{
  int radar = -1;
  file.Check(nc_def_dim(file.Id(), "radar", NC_UNLIMITED, &radar), "radar");
  this->NameVariable = DefineVariable(file, NamesName, NC_STRING, {radar});
  file.SetText(this->NameVariable, "long_name", "identifier of the radar");
  for (std::size_t i = 0; i < 3; ++i)
  {
    this->PositionVariables[i] = DefineVariable(file, Coordinates[i].Name, NC_DOUBLE, {radar});
    const int variable = this->PositionVariables[i];
    file.SetText(variable, "standard_name", Coordinates[i].StandardName);
    file.SetText(variable, "long_name", Coordinates[i].LongName);
    file.SetText(variable, "units", Coordinates[i].Units);
    file.SetNumbers(variable, "_FillValue", {std::numeric_limits<double>::quiet_NaN()});
  }
  file.SetText(this->PositionVariables[2], "positive", "up");
  this->UsedVariable = DefineVariable(file, UsedName, NC_BYTE, {time, radar});
  file.SetText(this->UsedVariable, "long_name", "whether the radar's data are in the volume");
  file.SetBytes(this->UsedVariable, "flag_values", {0, 1});
  file.SetText(this->UsedVariable, "flag_meanings", "no yes");
}

void vtkNexradNetCDFRadars::AddRadar(const std::string& name, const nexrad::Position* position)
{
  const std::size_t place = this->Known.size();
  const char* text = name.c_str();
  this->File.Check(
    nc_put_var1_string(this->File.Id(), this->NameVariable, &place, &text), NamesName);
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  const double numbers[3] = {position ? position->latitude : unknown,
    position ? position->longitude : unknown, position ? position->altitude : unknown};
  for (std::size_t i = 0; i < 3; ++i)
  {
    this->File.Check(
      nc_put_var1_double(this->File.Id(), this->PositionVariables[i], &place, &numbers[i]),
      Coordinates[i].Name);
  }
  this->Known.push_back(name);
}

void vtkNexradNetCDFRadars::WriteUse(std::size_t index, std::size_t radar, bool used)
{
  const std::size_t start[2] = {index, radar};
  const auto flag = static_cast<signed char>(used ? 1 : 0);
  this->File.Check(nc_put_var1_schar(this->File.Id(), this->UsedVariable, start, &flag), UsedName);
}

std::vector<short> vtkNexradNetCDFRadars::Add(
  const nexrad::GriddedVolume& volume, std::size_t index)
{
  const bool placed = volume.sitePositions.size() == volume.sites.size();
  std::vector<short> places;
  for (std::size_t i = 0; i < volume.sites.size(); ++i)
  {
    const std::string& name = volume.sites[i];
    const auto known = std::find(this->Known.begin(), this->Known.end(), name);
    places.push_back(static_cast<short>(known - this->Known.begin()));
    if (known == this->Known.end())
    {
      const nexrad::KnownSite* listed = nexrad::FindSite(name);
      this->AddRadar(name, placed   ? &volume.sitePositions[i]
                           : listed ? &listed->position
                                    : nullptr);
      for (std::size_t before = 0; before < index; ++before)
      {
        this->WriteUse(before, this->Known.size() - 1, false);
      }
    }
  }
  for (std::size_t radar = 0; radar < this->Known.size(); ++radar)
  {
    const auto place = static_cast<short>(radar);
    this->WriteUse(index, radar, std::find(places.begin(), places.end(), place) != places.end());
  }
  return places;
}
