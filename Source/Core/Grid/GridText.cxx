// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Grid/GridText.h"

#include <locale>
#include <sstream>

namespace nexrad
{

std::string GridText(const GridSpecification& grid)
{
  const bool projected = grid.axes == GridAxes::Projected;
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << grid.dimensions[0] << 'x' << grid.dimensions[1] << 'x' << grid.dimensions[2]
       << " voxels of " << grid.spacing[0] << " x " << grid.spacing[1]
       << (projected ? " x " : " degrees x ") << grid.spacing[2] << " m";
  if (projected)
  {
    text << " about " << grid.centreLatitude << ", " << grid.centreLongitude;
  }
  return text.str();
}

} // namespace nexrad
