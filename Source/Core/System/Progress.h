// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

namespace nexrad
{

/// Told how much of the work is done (0…1). Returns false to ask that the work stop;
/// the caller of the work then gets no result. An empty function means nobody listens.
using Progress = std::function<bool(double)>;

} // namespace nexrad
