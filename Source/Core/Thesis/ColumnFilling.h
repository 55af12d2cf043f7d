// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace nexrad
{

/// Fills the gaps of the columns `begin` to `end` − 1 of a grid (Formulas T7): between two known
/// voxels linearly in height, below the lowest known one with its value; above the highest nothing
/// is filled. NaN marks a voxel that is not known. A column's number is x + y × width; columns do
/// not touch each other, so ranges of them can be filled side by side. Throws nothing.
void FillColumns(std::vector<float>& values, const std::array<int, 3>& dimensions,
  std::size_t begin, std::size_t end);

} // namespace nexrad
