// SPDX-License-Identifier: BSD-3-Clause
// ParaView's colour maps.
#ifndef vtkNexradColorMapJSON_h
#define vtkNexradColorMapJSON_h

#include "vtkNexradColorMap.h"

#include <array>
#include <string>
#include <vector>

/// Reads and writes the text of colour maps. A reader returns an empty string, or says what is
/// wrong and what would be right; then the map is of no use. Numbers are read the same in any
/// locale.
namespace vtkNexradColorMapText
{

/// ParaView's JSON (an array of maps, of which the first is taken, or one map). RGBPoints, and
/// Points for the opacity, become nodes; colour spaces other than RGB, and opacities with midpoints
/// or sharpness, are sampled eight times between points. Nodes, bins and iso-values written by
/// FormatJSON come back as they were.
std::string ParseJSON(const std::string& text, vtkNexradColorMap& map);

/// The same as ParaView reads it, sampled finely enough to look alike, with the nodes
/// themselves, the bins and the iso-values under keys that ParaView passes over. `samples`: dBZ,
/// red, green, blue, opacity.
std::string FormatJSON(
  const vtkNexradColorMap& map, const std::vector<std::array<double, 5>>& samples);

} // namespace vtkNexradColorMapText

#endif
