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

/// A .pal table of GRLevelX, after its published "Color Table File Specification": Color and Color4
/// are ramps up to the second colour or the next statement's, SolidColor and SolidColor4 one
/// colour; one without alpha is opaque where others have one. Of two at one value the later counts.
/// Units, Scale, Offset, Step and Decimals are of the colour bar, RF the colour of range folding. A
/// line that cannot be read is passed over, and named in the map. A table with a ramp goes from
/// colour to colour in straight lines; the colours of others are splines through the middles of
/// their boxes.
std::string ParsePalette(const std::string& text, vtkNexradColorMap& map);

/// The bins as a .pal table; without bins, ramps between the samples.
std::string FormatPalette(
  const vtkNexradColorMap& map, const std::vector<std::array<double, 5>>& samples);

/// Lines "dbz,#rrggbb" below a heading: the colour from that value up to the next.
std::string ParseTable(const std::string& text, vtkNexradColorMap& map);

} // namespace vtkNexradColorMapText

#endif
