// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkNexradTransferFunctionPresets_h
#define vtkNexradTransferFunctionPresets_h

#include "vtkNexradColorMap.h"

#include <string>
#include <vector>

/// Names of the presets, the default first.
const std::vector<const char*>& vtkNexradTransferFunctionPresetNames();

/// Names of the arrays that the presets are for, as "REF", in the same order.
const std::vector<const char*>& vtkNexradTransferFunctionPresetArrays();

/// A preset by its name; false when there is none of that name.
bool vtkNexradTransferFunctionPreset(const std::string& name, vtkNexradColorMap& map);

/// Nodes of opacity that make a shell about each of the values: `opacity` at it, 0 from `halfWidth`
/// away. Shells that would touch become one.
std::vector<vtkNexradColorMap::Node> vtkNexradIsoShells(
  std::vector<double> values, double opacity, double halfWidth);

#endif
