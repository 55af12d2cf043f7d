// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

class vtkImageData;

namespace nexrad::scene
{

/// Age of the data of each radar of a merged volume, in the order of its `Sites`: the median, in
/// minutes, of the ancillary array `_age` over the voxels that this radar alone scanned. Nothing
/// for a radar without such voxels. Empty when the volume lacks the arrays that tell: `_age`, and
/// of several radars `_radars` and `_site` as well.
std::vector<std::optional<double>> AgesOfData(
  vtkImageData* volume, const std::string& array, std::size_t sites);

} // namespace nexrad::scene
