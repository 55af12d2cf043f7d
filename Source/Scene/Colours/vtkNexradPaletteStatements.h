// SPDX-License-Identifier: BSD-3-Clause
// The statements of a .pal table, line by line.
#ifndef vtkNexradPaletteStatements_h
#define vtkNexradPaletteStatements_h

#include "vtkNexradColorMap.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

/// A colour statement of a table.
struct vtkNexradPaletteStatement
{
  using Color = std::array<double, 4>; ///< red, green, blue, opacity

  double From = 0.0; ///< unit of the table
  Color Lower{};
  std::optional<Color> Towards; ///< what the ramp ends in; empty: the next colour
  bool Solid = false;
  bool HasOpacity = false;
  int Line = 0; ///< of the file, from 1 on
};

/// What the lines of a .pal table say.
struct vtkNexradPaletteStatements
{
  std::vector<vtkNexradPaletteStatement> Colors; ///< in the order of the file
  vtkNexradColorMap::Labels Labels;
  std::optional<vtkNexradColorMap::Color> RangeFolded;
  std::vector<std::string> PassedOver; ///< lines that cannot be read, as in vtkNexradColorMap
};

/// Reads the lines; in any order, keys in any case, text behind a semicolon is a comment.
vtkNexradPaletteStatements vtkNexradReadPaletteStatements(const std::string& text);

/// A text of a table without the blanks at its ends.
std::string vtkNexradTrimmed(const std::string& text);

/// The finite numbers of such a text; empty when it holds anything else.
std::optional<std::vector<double>> vtkNexradReadNumbers(const std::string& text);

/// "line 3: what".
std::string vtkNexradPaletteLine(int number, const std::string& what);

#endif
