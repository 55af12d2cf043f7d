// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNexradNetCDFGrid.h"

#include "vtkNexradNetCDFFile.h"

#include <array>
#include <charconv>
#include <string>
#include <vector>

namespace
{

using nexrad::GridAxes;
using nexrad::GridSpecification;

// What the CF conventions call an axis.
struct AxisTerms
{
  const char* Name;
  const char* StandardName;
  const char* LongName;
  const char* Units;
  const char* Letter;
};

AxisTerms TermsOf(GridAxes axes, std::size_t axis)
{
  constexpr AxisTerms projected[2] = {
    {"x", "projection_x_coordinate", "distance to the east of the projection's centre", "m", "X"},
    {"y", "projection_y_coordinate", "distance to the north of the projection's centre", "m", "Y"}};
  constexpr AxisTerms geographic[2] = {
    {"longitude", "longitude", "longitude on WGS84", "degrees_east", "X"},
    {"latitude", "latitude", "latitude on WGS84", "degrees_north", "Y"}};
  if (axis == 2)
  {
    return {"z", "altitude", "height above mean sea level", "m", "Z"};
  }
  return axes == GridAxes::Geographic ? geographic[axis] : projected[axis];
}

constexpr char SpacingName[] = "spacing";

void WriteAxis(
  const vtkNexradNetCDFFile& file, const GridSpecification& grid, std::size_t axis, int dimension)
{
  const AxisTerms terms = TermsOf(grid.axes, axis);
  int variable = -1;
  file.Check(nc_def_var(file.Id(), terms.Name, NC_DOUBLE, 1, &dimension, &variable), terms.Name);
  file.SetText(variable, "standard_name", terms.StandardName);
  file.SetText(variable, "long_name", terms.LongName);
  file.SetText(variable, "units", terms.Units);
  file.SetText(variable, "axis", terms.Letter);
  if (axis == 2)
  {
    file.SetText(variable, "positive", "up");
  }
  file.SetNumbers(variable, SpacingName, {grid.spacing[axis]});
  std::vector<double> centres;
  for (int i = 0; i < grid.dimensions[axis]; ++i)
  {
    centres.push_back(grid.Coordinate(static_cast<int>(axis), i));
  }
  file.Check(nc_put_var_double(file.Id(), variable, centres.data()), terms.Name);
}

// One of the two coordinates of each column; float, whose digits are less than a metre.
void WriteColumns(const vtkNexradNetCDFFile& file, const vtkNexradNetCDFDimensions& dimensions,
  const AxisTerms& terms, const std::vector<float>& values)
{
  const int plane[2] = {dimensions.Axes[1], dimensions.Axes[0]};
  int variable = -1;
  file.Check(nc_def_var(file.Id(), terms.Name, NC_FLOAT, 2, plane, &variable), terms.Name);
  file.Check(nc_def_var_deflate(file.Id(), variable, 1, 1, 4), terms.Name);
  file.SetText(variable, "standard_name", terms.StandardName);
  file.SetText(variable, "long_name", terms.LongName);
  file.SetText(variable, "units", terms.Units);
  file.Check(nc_put_var_float(file.Id(), variable, values.data()), terms.Name);
}

void WritePlaces(const vtkNexradNetCDFFile& file, const vtkNexradNetCDFDimensions& dimensions,
  const GridSpecification& grid)
{
  std::vector<float> longitudes;
  std::vector<float> latitudes;
  for (int y = 0; y < grid.dimensions[1]; ++y)
  {
    for (int x = 0; x < grid.dimensions[0]; ++x)
    {
      const auto place = grid.ToGeographic(grid.Coordinate(0, x), grid.Coordinate(1, y));
      longitudes.push_back(static_cast<float>(place[0]));
      latitudes.push_back(static_cast<float>(place[1]));
    }
  }
  WriteColumns(file, dimensions, TermsOf(GridAxes::Geographic, 0), longitudes);
  WriteColumns(file, dimensions, TermsOf(GridAxes::Geographic, 1), latitudes);
}

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
std::string WellKnownText(const GridSpecification& grid)
{
  const std::string datum = DatumText;
  if (grid.axes == GridAxes::Geographic)
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

void WriteProjection(const vtkNexradNetCDFFile& file, int variable, const GridSpecification& grid)
{
  const bool projected = grid.axes == GridAxes::Projected;
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

} // namespace

vtkNexradNetCDFDimensions vtkNexradWriteGrid(
  const vtkNexradNetCDFFile& file, const GridSpecification& grid)
{
  vtkNexradNetCDFDimensions dimensions;
  file.Check(nc_def_dim(file.Id(), "time", NC_UNLIMITED, &dimensions.Time), "time");
  for (std::size_t axis = 3; axis-- > 0;)
  {
    const char* const name = TermsOf(grid.axes, axis).Name;
    const auto length = static_cast<std::size_t>(grid.dimensions[axis]);
    file.Check(nc_def_dim(file.Id(), name, length, &dimensions.Axes[axis]), name);
  }
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    WriteAxis(file, grid, axis, dimensions.Axes[axis]);
  }
  int mapping = -1;
  file.Check(nc_def_var(file.Id(), vtkNexradGridMapping, NC_INT, 0, nullptr, &mapping),
    vtkNexradGridMapping);
  WriteProjection(file, mapping, grid);
  if (grid.axes == GridAxes::Projected)
  {
    WritePlaces(file, dimensions, grid);
  }
  return dimensions;
}
