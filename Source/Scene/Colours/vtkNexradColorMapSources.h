// SPDX-License-Identifier: BSD-3-Clause
// Where colour maps come from: files and presets.
#ifndef vtkNexradColorMapSources_h
#define vtkNexradColorMapSources_h

#include "vtkNexradColorMap.h"

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

/// Reads a file of a colour map by the ending of its name: .json, .pal or .csv. Returns an empty
/// string, or says what is wrong; then the map is of no use.
std::string vtkNexradReadColorMap(const std::filesystem::path& path, vtkNexradColorMap& map);

/// The presets, the default first.
const std::vector<vtkNexradColorMap>& vtkNexradTransferFunctionPresets();

/// An iso-value and the opacity of its surface, 0 to 1.
using vtkNexradIsoShell = std::pair<double, double>;

/// Nodes of opacity that make a shell about each of the values: the surface's opacity at it, 0 from
/// `halfWidth` away. Shells that would touch become one.
std::vector<vtkNexradColorMap::Node> vtkNexradIsoShells(
  std::vector<vtkNexradIsoShell> shells, double halfWidth);

#endif
