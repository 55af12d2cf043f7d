// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNexradNetCDFTerms.h"

#include "nexrad/Grid/GriddedVolume.h"
#include "vtkNexradNetCDFFile.h"

#include "vtk_netcdf.h"

#include <array>
#include <charconv>

namespace
{

// Of WGS84, as EPSG 7030 has them.
constexpr double SemiMajorAxis = 6'378'137.0; // m
constexpr double InverseFlattening = 298.257223563;

constexpr char DatumText[] =
  R"(["WGS 84",DATUM["World Geodetic System 1984",ELLIPSOID["WGS 84",6378137,298.257223563,)"
  R"(LENGTHUNIT["metre",1]]],PRIMEM["Greenwich",0,ANGLEUNIT["degree",0.0174532925199433]])";

// The shortest text that reads back as the same number, independent of the locale.
std::string ToText(double value)
{
  std::array<char, 32> text{};
  const auto result = std::to_chars(text.data(), text.data() + text.size(), value);
  return {text.data(), result.ptr};
}

// A parameter of the projection; `rest` is its unit and its number in the register of EPSG.
std::string Parameter(const std::string& name, double value, const std::string& rest)
{
  return "PARAMETER[\"" + name + "\"," + ToText(value) + "," + rest + "],";
}

// The projection as well-known text 2 (ISO 19162:2015).
std::string WellKnownText(const nexrad::GridSpecification& grid)
{
  const std::string datum = DatumText;
  if (grid.axes == nexrad::GridAxes::Geographic)
  {
    return "GEODCRS" + datum +
           R"(,CS[ellipsoidal,2],AXIS["longitude",east,ORDER[1]],AXIS["latitude",north,ORDER[2]],)"
           R"(ANGLEUNIT["degree",0.0174532925199433]])";
  }
  const std::string degree = R"(ANGLEUNIT["degree",0.0174532925199433],ID["EPSG",)";
  const std::string metre = R"(LENGTHUNIT["metre",1],ID["EPSG",)";
  const std::string conversion =
    R"(CONVERSION["unnamed",METHOD["Modified Azimuthal Equidistant",ID["EPSG",9832]],)" +
    Parameter("Latitude of natural origin", grid.centreLatitude, degree + "8801]") +
    Parameter("Longitude of natural origin", grid.centreLongitude, degree + "8802]") +
    Parameter("False easting", 0.0, metre + "8806]") +
    Parameter("False northing", 0.0, metre + "8807]");
  return R"(PROJCRS["Azimuthal equidistant about the centre of the grid",BASEGEODCRS)" + datum +
         "]," + conversion.substr(0, conversion.size() - 1) +
         R"(],CS[Cartesian,2],AXIS["easting",east,ORDER[1]],AXIS["northing",north,)"
         R"(ORDER[2]],LENGTHUNIT["metre",1]])";
}

std::string Joined(const std::vector<std::string>& names)
{
  std::string text;
  for (const std::string& name : names)
  {
    text += (text.empty() ? "" : ", ") + name;
  }
  return text;
}

} // namespace

std::string vtkNexradStandardName(nexrad::MomentName moment)
{
  switch (moment)
  {
  case nexrad::MomentName::REF:
    return "equivalent_reflectivity_factor";
  case nexrad::MomentName::VEL:
    return "radial_velocity_of_scatterers_away_from_instrument";
  default:
    return {};
  }
}

std::string vtkNexradUnitsOf(nexrad::MomentName moment)
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

void vtkNexradWriteProjection(
  const vtkNexradNetCDFFile& file, int variable, const nexrad::GridSpecification& grid)
{
  const bool projected = grid.axes == nexrad::GridAxes::Projected;
  file.SetText(
    variable, "grid_mapping_name", projected ? "azimuthal_equidistant" : "latitude_longitude");
  file.SetText(variable, "long_name",
    projected ? "azimuthal equidistant projection of WGS84 about the centre of the grid"
              : "longitude and latitude on WGS84");
  if (projected)
  {
    file.SetNumbers(variable, "latitude_of_projection_origin", {grid.centreLatitude});
    file.SetNumbers(variable, "longitude_of_projection_origin", {grid.centreLongitude});
    file.SetNumbers(variable, "false_easting", {0.0});
    file.SetNumbers(variable, "false_northing", {0.0});
  }
  else // for a reader of this project alone
  {
    file.SetNumbers(variable, "centre_latitude", {grid.centreLatitude});
    file.SetNumbers(variable, "centre_longitude", {grid.centreLongitude});
  }
  file.SetNumbers(variable, "semi_major_axis", {SemiMajorAxis});
  file.SetNumbers(variable, "inverse_flattening", {InverseFlattening});
  file.SetNumbers(variable, "longitude_of_prime_meridian", {0.0});
  file.SetText(variable, "crs_wkt", WellKnownText(grid));
  file.SetText(variable, "proj4", grid.Projection());
}

void vtkNexradWriteProvenance(
  const vtkNexradNetCDFFile& file, const nexrad::GriddedVolume& volume, const std::string& history)
{
  const std::string radars = Joined(volume.sites);
  const auto set = [&file](const char* name, const std::string& text)
  { file.SetText(NC_GLOBAL, name, text); };
  set("Conventions", "CF-1.8");
  set("title",
    std::string(volume.synthetic ? "SYNTHETIC: " : "") + "weather radar volumes on a regular grid");
  set("institution", volume.synthetic
                       ? "none: the radar data are SYNTHETIC, made by nexrad3d simulate"
                       : "radar data: the weather radars of the United States (NEXRAD, TDWR)");
  set("source", std::string(volume.synthetic ? "SYNTHETIC radar files" : "NEXRAD Level II files") +
                  (radars.empty() ? "" : " of " + radars) +
                  ", gridded by vtk-nexrad with the method " + volume.method);
  set("history", history);
  set("references",
    "vtk-nexrad, Documentation/Formats/netcdf.md; cfconventions.org (CF Metadata Conventions 1.8)");
  set("comment",
    "Where there is no value, the variable of a moment whose name ends in _state says why: no "
    "echo, range folded, not scanned, or filtered.");
  set("method", volume.method);
  if (volume.ofOneRadar)
  {
    set("one_radar", "yes");
  }
  set("synthetic", volume.synthetic ? "yes" : "no");
  set("sharpened", volume.sharpened ? "yes" : "no");
  file.SetNumbers(NC_GLOBAL, vtkNexradNetCDFVersionName, {vtkNexradNetCDFVersion});
}
