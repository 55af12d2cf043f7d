// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace nexrad::testing
{

/// Writes files of two hand-made radars 180 km apart, KONE and KTWO: a volume of each at
/// 2006-03-12T18:00, with a reflectivity of its own, dBZ, in all gates to 60 km, and 1 dB less from
/// there to 150 km. Returns their paths.
std::vector<std::filesystem::path> WriteTwoRadars(
  const std::filesystem::path& folder, double one, double two);

} // namespace nexrad::testing
