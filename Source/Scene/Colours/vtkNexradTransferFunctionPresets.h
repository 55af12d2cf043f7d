// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkNexradTransferFunctionPresets_h
#define vtkNexradTransferFunctionPresets_h

#include "vtkNexradColorMap.h"

#include <string>
#include <utility>
#include <vector>

/// Names of the presets, the default first, each with that of the array that it is for, as "REF".
const std::vector<std::pair<const char*, const char*>>& vtkNexradTransferFunctionPresetNames();

/// A preset by its name; false when there is none of that name.
bool vtkNexradTransferFunctionPreset(const std::string& name, vtkNexradColorMap& map);

/// An iso-value and the opacity of its surface, 0 to 1.
using vtkNexradIsoShell = std::pair<double, double>;

/// Nodes of opacity that make a shell about each of the values: the surface's opacity at it, 0 from
/// `halfWidth` away. Shells that would touch become one.
std::vector<vtkNexradColorMap::Node> vtkNexradIsoShells(
  std::vector<vtkNexradIsoShell> shells, double halfWidth);

#endif
