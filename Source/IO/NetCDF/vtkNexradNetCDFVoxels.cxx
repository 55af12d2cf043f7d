// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNexradNetCDFVoxels.h"

#include "nexrad/Grid/GriddedVolume.h"
#include "nexrad/Grid/SiteGeometry.h"
#include "vtkNexradNetCDFFile.h"
#include "vtkNexradThreads.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

namespace
{

using nexrad::GriddedVolume;
using nexrad::MomentName;
using nexrad::VoxelState;

constexpr float NoValue = std::numeric_limits<float>::quiet_NaN();
constexpr short NoRadar = -1;
constexpr char StateMeanings[] = "echo no_echo range_folded not_scanned filtered";
constexpr char FillName[] = "no_echo_value"; // what volumes have where the state is not echo

std::string StateName(MomentName moment)
{
  return std::string(nexrad::ToString(moment)) + "_state";
}

// The standard name of a moment; empty: the table has none.
std::string StandardNameOf(MomentName moment)
{
  switch (moment)
  {
  case MomentName::REF:
    return "equivalent_reflectivity_factor";
  case MomentName::VEL:
    return "radial_velocity_of_scatterers_away_from_instrument";
  default:
    return {};
  }
}

// The unit of a moment as UDUNITS writes it.
std::string UnitsOf(MomentName moment)
{
  const std::string unit = nexrad::UnitOf(moment);
  return unit == "m/s"          ? "m s-1"
         : unit == "1/s"        ? "s-1"
         : unit == "dB"         ? "0.1 lg(re 1)" // UDUNITS has no name for it
         : unit == "degrees"    ? "degree"
         : unit == "degrees/km" ? "degree km-1"
         : unit.empty()         ? "1"
                                : unit;
}

// What the CF conventions call an ancillary array.
struct AncillaryTerms
{
  const char* Name; // as ForEachAncillaryArray has it
  const char* LongName;
  const char* Units; // nullptr: the numbers are names
};
constexpr AncillaryTerms AllAncillaryTerms[] = {
  {"age", "time between the volume's time and the nearest ray that was used", "s"},
  {"radars", "number of radars that scanned the voxel", "1"},
  {"weight", "sum of the weights of the radars that scanned the voxel", "1"},
  {"site", "nearest radar that scanned the voxel: its place along the dimension radar", nullptr}};

// The row of a table of terms that has the name.
template <class Terms, std::size_t Count>
const Terms& RowOf(const Terms (&table)[Count], const std::string& name)
{
  return *std::find_if(std::begin(table), std::end(table) - 1,
    [&name](const Terms& terms) { return name == terms.Name; });
}

// Whole layers of about a MiB, so that a layer is read without the others.
std::array<std::size_t, 4> LayersOf(const std::vector<std::size_t>& shape, std::size_t bytes)
{
  constexpr std::size_t largest = std::size_t(1) << 20;
  const std::size_t layer = shape[2] * shape[3] * bytes;
  return {1, std::clamp<std::size_t>(largest / layer, 1, shape[1]), shape[2], shape[3]};
}

// All layers of some rows: what is alike in all layers, as azimuths, is near to itself and deflates
// well.
std::array<std::size_t, 4> RowsOf(const std::vector<std::size_t>& shape, std::size_t bytes)
{
  constexpr std::size_t window = std::size_t(1) << 13; // a quarter of what deflate looks back over
  const std::size_t row = shape[3] * bytes;
  return {1, shape[1], std::clamp<std::size_t>(window / row, 1, shape[2]), shape[3]};
}

// How the radar's view is packed: the number is offset + scale × code.
struct ViewTerms
{
  const char* Name; // as ForEachArray has it
  const char* LongName;
  const char* Units;
  float Offset;
  float Scale;
};
constexpr ViewTerms AllViewTerms[] = {
  {"azimuth", "azimuth from the radar, clockwise from north", "degree", 180.0F, 0.01F},
  {"elevation", "elevation angle of the beam through the voxel", "degree", 0.0F, 0.01F},
  {"slant_range", "distance from the radar along the beam", "m", 0.0F, 10.0F}};

// The first of 1, 2, 4, … times the scale with which all values have a code.
float ScaleFor(const ViewTerms& terms, const std::vector<float>& values)
{
  float scale = terms.Scale;
  const float largest = *std::max_element(values.begin(), values.end()) - terms.Offset;
  while (largest / scale > static_cast<float>(std::numeric_limits<short>::max()))
  {
    scale *= 2.0F;
  }
  return scale;
}

// Where no radar scanned, the age of a voxel is unknown; a merge stores 0.
std::vector<float> AgesOf(const GriddedVolume& volume)
{
  std::vector<float> ages = volume.ancillary.age;
  const std::vector<std::uint8_t>& radars = volume.ancillary.radars;
  for (std::size_t i = 0; i < ages.size(); ++i)
  {
    const bool unseen =
      radars.empty() ? volume.states[i] == VoxelState::NotScanned : radars[i] == 0;
    ages[i] = unseen && ages[i] == 0.0F ? NoValue : ages[i];
  }
  return ages;
}

std::vector<short> ShortsOf(const std::string& name, const std::vector<std::uint8_t>& values,
  const std::vector<short>& places)
{
  std::vector<short> numbers(values.begin(), values.end());
  if (name == "site")
  {
    for (short& number : numbers)
    {
      const auto site = static_cast<std::size_t>(number);
      number = site < places.size() ? places[site] : NoRadar;
    }
  }
  return numbers;
}

} // namespace

vtkNexradNetCDFVoxels::vtkNexradNetCDFVoxels(const vtkNexradNetCDFFile& file,
  const vtkNexradNetCDFDimensions& dimensions, const GriddedVolume& volume)
  : File(file)
  , Dimensions(dimensions)
  , Shape({1, static_cast<std::size_t>(volume.grid.dimensions[2]),
      static_cast<std::size_t>(volume.grid.dimensions[1]),
      static_cast<std::size_t>(volume.grid.dimensions[0])})
  , Placed(volume.grid.axes == nexrad::GridAxes::Projected)
{
  this->Define(volume);
  for (const GriddedVolume& further : volume.further)
  {
    this->Define(further);
  }
  if (volume.ofOneRadar && volume.sitePositions.size() == 1)
  {
    this->DefineView(volume);
  }
}

void vtkNexradNetCDFVoxels::DefineView(const GriddedVolume& volume)
{
  const nexrad::RadarView view =
    nexrad::MakeRadarView(volume.grid, volume.sitePositions.front(), vtkNexradRangeLoop());
  const auto define = [this](const char* name, const std::vector<float>& values)
  {
    const ViewTerms& terms = RowOf(AllViewTerms, name);
    const int variable = this->DefineVariable(name, NC_SHORT, RowsOf(this->Shape, sizeof(short)));
    const float scale = ScaleFor(terms, values);
    this->File.SetText(variable, "long_name", terms.LongName);
    this->File.SetText(variable, "units", terms.Units);
    this->File.SetNumbers<float>(variable, "scale_factor", {scale});
    this->File.SetNumbers<float>(variable, "add_offset", {terms.Offset});
    std::vector<short>& codes = this->View[variable];
    for (const float value : values)
    {
      codes.push_back(static_cast<short>(std::lround((value - terms.Offset) / scale)));
    }
  };
  nexrad::ForEachArray(view, define);
}

// The grid is the same at all times, and so is the view; other programs look for it at each.
void vtkNexradNetCDFVoxels::WriteView(std::size_t index)
{
  const std::size_t start[4] = {index, 0, 0, 0};
  for (const auto& [variable, codes] : this->View)
  {
    this->File.Check(
      nc_put_vara_short(this->File.Id(), variable, start, this->Shape.data(), codes.data()),
      "the radar's view");
  }
}

int vtkNexradNetCDFVoxels::DefineVariable(
  const std::string& name, int type, const std::array<std::size_t, 4>& chunk)
{
  constexpr int level = 2; // higher ones take twice the time for 2 % fewer bytes
  const int dimensions[4] = {this->Dimensions.Time, this->Dimensions.Axes[2],
    this->Dimensions.Axes[1], this->Dimensions.Axes[0]};
  int variable = -1;
  const int id = this->File.Id();
  this->File.Check(nc_def_var(id, name.c_str(), type, 4, dimensions, &variable), name);
  this->File.Check(nc_def_var_chunking(id, variable, NC_CHUNKED, chunk.data()), name);
  this->File.Check(nc_def_var_deflate(id, variable, 1, 1, level), name);
  this->File.SetText(variable, "grid_mapping", vtkNexradGridMapping);
  if (this->Placed)
  {
    this->File.SetText(variable, "coordinates", "latitude longitude");
  }
  this->Variables[name] = variable;
  return variable;
}

void vtkNexradNetCDFVoxels::DefineAncillary(const GriddedVolume& moment, std::string& names)
{
  const auto define = [&](const char* name, const auto& values)
  {
    if (values.empty())
    {
      return;
    }
    const std::string full = nexrad::AncillaryArrayName(moment.moment, name);
    const AncillaryTerms& terms = RowOf(AllAncillaryTerms, name);
    const bool real = sizeof(values[0]) == sizeof(float);
    const int variable =
      this->DefineVariable(full, real ? NC_FLOAT : NC_SHORT, LayersOf(this->Shape, real ? 4 : 2));
    this->File.SetText(variable, "long_name", terms.LongName);
    if (terms.Units != nullptr)
    {
      this->File.SetText(variable, "units", terms.Units);
    }
    if (real)
    {
      this->File.SetNumbers<float>(variable, "_FillValue", {NoValue});
    }
    else
    {
      this->File.SetNumbers<short>(variable, "_FillValue", {NoRadar});
    }
    names += ' ' + full;
  };
  nexrad::ForEachAncillaryArray(moment.ancillary, define);
}

void vtkNexradNetCDFVoxels::Define(const GriddedVolume& moment)
{
  const std::string name = nexrad::ToString(moment.moment);
  const std::string standardName = StandardNameOf(moment.moment);
  const int values = this->DefineVariable(name, NC_FLOAT, LayersOf(this->Shape, 4));
  const int states =
    this->DefineVariable(StateName(moment.moment), NC_BYTE, LayersOf(this->Shape, 1));
  std::string others = StateName(moment.moment);
  this->DefineAncillary(moment, others);
  if (!standardName.empty())
  {
    this->File.SetText(values, "standard_name", standardName);
    this->File.SetText(states, "standard_name", standardName + " status_flag");
  }
  this->File.SetText(values, "long_name", nexrad::TitleOf(moment.moment));
  this->File.SetText(values, "units", UnitsOf(moment.moment));
  this->File.SetText(values, "ancillary_variables", others);
  this->File.SetNumbers<float>(values, "_FillValue", {NoValue});
  this->File.SetNumbers<float>(values, FillName, {moment.fill});
  this->File.SetText(
    states, "long_name", std::string("state of ") + nexrad::TitleOf(moment.moment));
  this->File.SetNumbers<signed char>(states, "flag_values", {0, 1, 2, 3, 4});
  this->File.SetText(states, "flag_meanings", StateMeanings);
}

int vtkNexradNetCDFVoxels::VariableOf(const std::string& name) const
{
  const auto found = this->Variables.find(name);
  if (found == this->Variables.end())
  {
    this->File.Fail("the first volume has no array " + name + ", and a later one has");
  }
  return found->second;
}

void vtkNexradNetCDFVoxels::WriteMoment(
  const GriddedVolume& moment, std::size_t index, const std::vector<short>& places)
{
  const int id = this->File.Id();
  const std::size_t start[4] = {index, 0, 0, 0};
  const std::size_t* const shape = this->Shape.data();
  const std::string name = nexrad::ToString(moment.moment);
  std::vector<float> values = moment.values;
  std::vector<signed char> states;
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    states.push_back(static_cast<signed char>(moment.states[i]));
    values[i] = moment.states[i] == VoxelState::Echo ? values[i] : NoValue;
  }
  this->File.Check(
    nc_put_vara_float(id, this->VariableOf(name), start, shape, values.data()), name);
  const std::string stateName = StateName(moment.moment);
  this->File.Check(
    nc_put_vara_schar(id, this->VariableOf(stateName), start, shape, states.data()), stateName);
  const auto write = [&](const char* ancillary, const auto& numbers)
  {
    const std::string full = nexrad::AncillaryArrayName(moment.moment, ancillary);
    if (numbers.empty())
    {
      return;
    }
    const int variable = this->VariableOf(full);
    if constexpr (sizeof(numbers[0]) == sizeof(float))
    {
      const std::vector<float> known = full == name + "_age" ? AgesOf(moment) : numbers;
      this->File.Check(nc_put_vara_float(id, variable, start, shape, known.data()), full);
    }
    else
    {
      const std::vector<short> shorts = ShortsOf(ancillary, numbers, places);
      this->File.Check(nc_put_vara_short(id, variable, start, shape, shorts.data()), full);
    }
  };
  nexrad::ForEachAncillaryArray(moment.ancillary, write);
}

void vtkNexradNetCDFVoxels::Write(
  const GriddedVolume& volume, std::size_t index, const std::vector<short>& places)
{
  this->WriteMoment(volume, index, places);
  this->WriteView(index);
  for (const GriddedVolume& further : volume.further)
  {
    this->WriteMoment(further, index, places);
  }
}

void vtkNexradNetCDFVoxels::NameRadars(const std::vector<std::string>& names) const
{
  std::vector<short> numbers;
  std::string meanings;
  for (const std::string& name : names)
  {
    numbers.push_back(static_cast<short>(numbers.size()));
    meanings += (meanings.empty() ? "" : " ") + name;
  }
  for (const auto& [name, variable] : this->Variables)
  {
    const std::string ending = "_site";
    const bool radars = name.size() > ending.size() &&
                        name.compare(name.size() - ending.size(), ending.size(), ending) == 0;
    if (radars && !numbers.empty())
    {
      this->File.SetNumbers(variable, "flag_values", numbers);
      this->File.SetText(variable, "flag_meanings", meanings);
    }
  }
}
