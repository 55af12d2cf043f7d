// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Scene/SceneOptions.h"
#include "Scene/Series/VolumeSeries.h"

#include <cstddef>
#include <memory>
#include <vector>

namespace nexrad::scene
{

/// The same series for playing these steps in their order, over and over: while a step is drawn,
/// the next ones are loaded, as codes where the mapper of the options can draw these, and prepared
/// for it.
std::unique_ptr<VolumeSeries> PlayAhead(std::unique_ptr<VolumeSeries> series,
  const std::vector<std::size_t>& steps, const SceneOptions& options);

} // namespace nexrad::scene
