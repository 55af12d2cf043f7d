// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace nexrad
{

/// Checks the values of an ancillary array of a volume of `sites` sites; `name` as
/// ForEachAncillaryArray has it. Throws Error, naming the voxel, for an age or weight that is
/// negative or not finite, and for a site that the volume does not have.
void CheckAncillaryArray(
  const std::string& name, const std::vector<float>& values, std::size_t sites);
void CheckAncillaryArray(
  const std::string& name, const std::vector<std::uint8_t>& values, std::size_t sites);

} // namespace nexrad
