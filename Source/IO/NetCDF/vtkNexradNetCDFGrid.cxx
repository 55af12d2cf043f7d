// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNexradNetCDFGrid.h"

#include "vtkNexradNetCDFFile.h"
#include "vtkNexradNetCDFTerms.h"

#include "vtk_netcdf.h"

#include <cmath>
#include <limits>
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

// The number of a variable with one dimension, and its length.
std::pair<int, std::size_t> RequireAxis(const vtkNexradNetCDFFile& file, const std::string& name)
{
  const std::optional<int> variable = file.FindVariable(name);
  const std::vector<std::size_t> shape =
    variable ? file.ShapeOf(*variable) : std::vector<std::size_t>();
  if (shape.size() != 1 || shape[0] < 1)
  {
    file.Fail("has no coordinate variable " + name + ": it is no file of merged volumes");
  }
  return {*variable, shape[0]};
}

void ReadAxis(const vtkNexradNetCDFFile& file, std::size_t axis, GridSpecification& grid)
{
  const std::string name = TermsOf(grid.axes, axis).Name;
  const auto [variable, length] = RequireAxis(file, name);
  double ends[2] = {0.0, 0.0};
  const std::size_t last = length - 1;
  const std::size_t first = 0;
  file.Check(nc_get_var1_double(file.Id(), variable, &first, &ends[0]), name);
  file.Check(nc_get_var1_double(file.Id(), variable, &last, &ends[1]), name);
  const double between = last > 0 ? (ends[1] - ends[0]) / static_cast<double>(last) : 1.0;
  const double voxels = static_cast<double>(length) * static_cast<double>(grid.VoxelCount());
  if (voxels > std::numeric_limits<int>::max())
  {
    file.Fail("has more than 2^31 - 1 voxels");
  }
  grid.dimensions[axis] = static_cast<int>(length);
  grid.origin[axis] = ends[0];
  grid.spacing[axis] = file.Number(variable, SpacingName).value_or(between);
  if (!std::isfinite(ends[0]) || !std::isfinite(grid.spacing[axis]) || grid.spacing[axis] <= 0.0)
  {
    file.Fail("the coordinates " + name + " must be finite and ascend");
  }
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
  vtkNexradWriteProjection(file, mapping, grid);
  if (grid.axes == GridAxes::Projected)
  {
    WritePlaces(file, dimensions, grid);
  }
  return dimensions;
}

GridSpecification vtkNexradReadGrid(const vtkNexradNetCDFFile& file)
{
  GridSpecification grid;
  grid.dimensions = {1, 1, 1};
  const std::optional<int> mapping = file.FindVariable(vtkNexradGridMapping);
  const std::string name = mapping ? file.Text(*mapping, "grid_mapping_name").value_or("") : "";
  if (name != "azimuthal_equidistant" && name != "latitude_longitude")
  {
    file.Fail("the variable projection must have the grid_mapping_name azimuthal_equidistant or "
              "latitude_longitude, and has \"" +
              name + "\"");
  }
  const bool projected = name == "azimuthal_equidistant";
  grid.axes = projected ? GridAxes::Projected : GridAxes::Geographic;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    ReadAxis(file, axis, grid);
  }
  grid.centreLatitude =
    file.Number(*mapping, projected ? "latitude_of_projection_origin" : "centre_latitude")
      .value_or(0.0);
  grid.centreLongitude =
    file.Number(*mapping, projected ? "longitude_of_projection_origin" : "centre_longitude")
      .value_or(0.0);
  if (!(std::abs(grid.centreLatitude) <= 90.0) || !std::isfinite(grid.centreLongitude))
  {
    file.Fail("the centre of its projection is at no latitude and longitude");
  }
  return grid;
}
