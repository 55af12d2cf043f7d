// SPDX-License-Identifier: BSD-3-Clause
#include "SyntheticStorm.h"

#include "nexrad/Grid/MakeGrid.h"
#include "nexrad/Model/SiteTable.h"
#include "nexrad/Model/Time.h"
#include "nexrad/Simulation/SimulatedDay.h"
#include "nexrad/Simulation/StormField.h"

#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace nexrad::benchmarks
{
namespace
{

constexpr double NoEcho = -33.0;
constexpr double Width = 64.0;
constexpr double Stretch = 8.0;

GridSpecification DefaultGrid(const std::array<int, 3>& dimensions)
{
  std::vector<Position> sites;
  for (const SimulatedSite& site : SimulatedDayOptions::DefaultSites())
  {
    sites.push_back(FindSite(site.name)->position);
  }
  GridRequest request;
  request.dimensions = dimensions;
  return MakeGrid(request, sites);
}

/// Writes dBZ of one column of the grid, every `stride`-th value.
void SampleColumn(const GridSpecification& grid, const StormSnapshot& snapshot, int x, int y,
  std::vector<int>& candidates, float* values, std::size_t stride)
{
  const std::array<double, 2> degrees =
    grid.ToGeographic(grid.Coordinate(0, x), grid.Coordinate(1, y));
  PlanePoint point = StormPlane::FromGeographic(degrees[0], degrees[1], 0.0);
  snapshot.FindElements(
    {point.x, point.y, 0.0, grid.Coordinate(2, 0), grid.Coordinate(2, grid.dimensions[2] - 1)},
    candidates);
  for (int z = 0; z < grid.dimensions[2]; ++z)
  {
    point.z = grid.Coordinate(2, z);
    values[static_cast<std::size_t>(z) * stride] =
      static_cast<float>(std::max(NoEcho, snapshot.Reflectivity(point, candidates)));
  }
}

vtkSmartPointer<vtkDataArray> SampleStorm(const GridSpecification& grid)
{
  const StormSnapshot snapshot = StormField(1).At(*ParseIso8601("2006-03-12T18:10"));
  auto scalars = vtkSmartPointer<vtkFloatArray>::New();
  scalars->SetNumberOfTuples(static_cast<vtkIdType>(grid.VoxelCount()));
  float* values = scalars->GetPointer(0);
  const auto columns = static_cast<std::size_t>(grid.dimensions[0]);
  const auto rows = static_cast<std::size_t>(grid.dimensions[1]);
  vtkSMPTools::For(0, grid.dimensions[1],
    [&](vtkIdType begin, vtkIdType end)
    {
      std::vector<int> candidates;
      for (auto y = static_cast<int>(begin); y < static_cast<int>(end); ++y)
      {
        for (int x = 0; x < grid.dimensions[0]; ++x)
        {
          float* column = values + static_cast<std::size_t>(y) * columns + x;
          SampleColumn(grid, snapshot, x, y, candidates, column, columns * rows);
        }
      }
    });
  return scalars;
}

vtkSmartPointer<vtkDataArray> ToBytes(vtkDataArray* scalars)
{
  auto bytes = vtkSmartPointer<vtkUnsignedCharArray>::New();
  bytes->SetNumberOfTuples(scalars->GetNumberOfTuples());
  for (vtkIdType id = 0; id < scalars->GetNumberOfTuples(); ++id)
  {
    bytes->SetValue(
      id, static_cast<unsigned char>(std::lround(scalars->GetComponent(id, 0) - NoEcho)));
  }
  return bytes;
}

} // namespace

vtkSmartPointer<vtkImageData> MakeSyntheticStorm(
  const std::array<int, 3>& dimensions, int scalarType)
{
  const GridSpecification grid = DefaultGrid(dimensions);
  const double scale = Width / (grid.spacing[0] * (grid.dimensions[0] - 1));
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(dimensions.data());
  image->SetSpacing(
    grid.spacing[0] * scale, grid.spacing[1] * scale, grid.spacing[2] * scale * Stretch);
  vtkSmartPointer<vtkDataArray> scalars = SampleStorm(grid);
  image->GetPointData()->SetScalars(scalarType == VTK_UNSIGNED_CHAR ? ToBytes(scalars) : scalars);
  return image;
}

} // namespace nexrad::benchmarks
