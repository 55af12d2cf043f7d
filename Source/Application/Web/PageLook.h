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

struct PageCode;

/// One of the looks that a page offers.
struct PageLook
{
  std::string name;
  vtkSmartPointer<vtkNexradTransferFunction> function;
};

/// The looks of a moment ("REF"), and which of them the page shows first.
struct PageLooks
{
  std::vector<PageLook> all; ///< at least one
  std::size_t first = 0;
};

/// The presets of the moment and, before them, "own" where the options have colours, opacities or
/// iso-values of their own. Throws Error as scene::MakeTransferFunction does.
PageLooks LooksOf(const scene::SceneOptions& options, const std::string& array);

/// The least value at which a look has an opacity above 0, or the least of its iso-values.
double LeastVisible(vtkNexradTransferFunction* function);

/// The least value that the look of the options shows, or the first preset of its moment.
double LeastVisible(const PageLooks& looks);

/// The looks as the page's script takes them; without those that show values below the floor of the
/// code.
nlohmann::ordered_json MakeLooksJson(
  const PageLooks& looks, const std::string& array, const PageCode& code);

} // namespace nexrad::application
