// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Scene/Plan/PlanView.h"
#include "Scene/Scales/ColourScale.h"

#include <string>
#include <vector>

namespace nexrad::scene
{

/// The scale for the map of one of a volume's arrays: for the moment, its own; for an ancillary
/// array, one that reaches to the largest value of the map: age in minutes, weight, a colour for
/// each number of radars and for each of the volume's sites.
ColourScale ScaleFor(const PlanView& view, const std::string& array,
  const std::vector<std::string>& sites, const ColourScale& moment);

/// The scale of a plan: of echo tops in km, of liquid in kg/m² and of its density in g/m³ one that
/// is the same for all volumes, else that for the map of its array.
ColourScale ScaleFor(const PlanView& view, const PlanOptions& plan,
  const std::vector<std::string>& sites, const ColourScale& moment);

/// The same for values of which the largest is known.
ColourScale ScaleFor(double largest, const std::string& array,
  const std::vector<std::string>& sites, const ColourScale& moment);

} // namespace nexrad::scene
