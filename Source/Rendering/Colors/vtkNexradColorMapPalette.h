// SPDX-License-Identifier: BSD-3-Clause
// .pal tables and plain tables of colours.
#ifndef vtkNexradColorMapPalette_h
#define vtkNexradColorMapPalette_h

#include "vtkNexradColorMap.h"

#include <array>
#include <string>
#include <vector>

/// Reads and writes the text of colour maps. A reader returns an empty string, or says what is
/// wrong and what would be right; then the map is of no use. Numbers are read the same in any
/// locale.
namespace vtkNexradColorMapText
{

/// A .pal table of GRLevelX and its kin: Color, Color4, SolidColor, SolidColor4, Scale, Offset;
/// other statements are passed over.
std::string ParsePalette(const std::string& text, vtkNexradColorMap& map);

/// The bins as a .pal table; without bins, ramps between the samples.
std::string FormatPalette(
  const vtkNexradColorMap& map, const std::vector<std::array<double, 5>>& samples);

/// Lines "dbz,#rrggbb" below a heading: the colour from that value up to the next.
std::string ParseTable(const std::string& text, vtkNexradColorMap& map);

} // namespace vtkNexradColorMapText

#endif
