// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNexradSweepLayout.h"

#include <algorithm>
#include <cmath>

namespace
{

int FirstGateKept(const nexrad::MomentRow& row)
{
  return row.firstGate + static_cast<int>(vtkNexradNegativeGates(row)) * row.gateSpacing;
}

} // namespace

std::size_t vtkNexradNegativeGates(const nexrad::MomentRow& row)
{
  if (row.firstGate >= 0 || row.gateSpacing <= 0)
  {
    return 0;
  }
  const int negative = (-row.firstGate + row.gateSpacing - 1) / row.gateSpacing;
  return std::min(static_cast<std::size_t>(negative), static_cast<std::size_t>(row.gates));
}

bool vtkNexradBelongsTo(const nexrad::MomentRow& row, const vtkNexradGateGrid& grid)
{
  return row.gates > vtkNexradNegativeGates(row) && row.gateSpacing == grid.GateSpacing &&
         FirstGateKept(row) == grid.FirstGate;
}

std::vector<vtkNexradGateGrid> vtkNexradLayOutSweep(
  const nexrad::Sweep& sweep, const std::vector<nexrad::MomentName>& moments)
{
  std::vector<vtkNexradGateGrid> grids;
  for (const nexrad::MomentName moment : moments)
  {
    for (const nexrad::Ray& ray : sweep.rays)
    {
      const nexrad::MomentRow& row = ray.Row(moment);
      const std::size_t gates = row.gates - vtkNexradNegativeGates(row);
      if (gates == 0 || row.gateSpacing <= 0)
      {
        continue;
      }
      auto grid = std::find_if(grids.begin(), grids.end(),
        [&row](const vtkNexradGateGrid& each) { return vtkNexradBelongsTo(row, each); });
      if (grid == grids.end())
      {
        grids.push_back({FirstGateKept(row), row.gateSpacing, 0, {}});
        grid = grids.end() - 1;
      }
      grid->Gates = std::max(grid->Gates, gates);
      if (grid->Moments.empty() || grid->Moments.back() != moment)
      {
        grid->Moments.push_back(moment);
      }
    }
  }
  return grids;
}

bool vtkNexradIsFullCircle(const nexrad::Sweep& sweep)
{
  std::vector<double> steps;
  double turned = 0.0;
  for (std::size_t i = 1; i < sweep.rays.size(); ++i)
  {
    const double step =
      std::remainder(static_cast<double>(sweep.rays[i].azimuth) - sweep.rays[i - 1].azimuth, 360.0);
    turned += step;
    steps.push_back(std::abs(step));
  }
  if (steps.size() < 2)
  {
    return false;
  }
  std::nth_element(
    steps.begin(), steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2), steps.end());
  return 360.0 - std::abs(turned) <= 1.5 * steps[steps.size() / 2];
}
