// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Scene/SceneOptions.h"

#include <vtkSmartPointer.h>

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <string>
#include <vector>

class vtkNexradTransferFunction;

namespace nexrad::application
{

/// Decimals of a part of a colour, or of an opacity that stands alone, in the page.
constexpr int ColourDigits = 4;

struct PageCode;

/// One of the presets that a page offers.
struct PagePreset
{
  std::string name;
  vtkSmartPointer<vtkNexradTransferFunction> function;
};

/// The presets of a moment ("REF"), and which of them the page shows first.
struct PagePresets
{
  std::vector<PagePreset> all; ///< at least one
  std::size_t first = 0;
};

/// The presets of the moment and, before them, "own" where the options have colours, opacities or
/// iso-values of their own. Throws Error as scene::MakeTransferFunction does.
PagePresets PresetsOf(const scene::SceneOptions& options, const std::string& array);

/// The least value at which a preset has an opacity above 0, or the least of its iso-values.
double LeastVisible(vtkNexradTransferFunction* function);

/// The least value that the preset of the options shows, or the first preset of its moment.
double LeastVisible(const PagePresets& presets);

/// The presets as the page's script takes them; without those that show values below the floor of
/// the code.
nlohmann::ordered_json MakePresetsJson(
  const PagePresets& presets, const std::string& array, const PageCode& code);

} // namespace nexrad::application
