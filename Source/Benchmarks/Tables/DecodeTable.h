// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Report/BenchTable.h"

#include <filesystem>
#include <string>
#include <vector>

namespace nexrad::application
{

/// For each file the time of decoding it whole, all moments, beside that of the bare decompression
/// of the same bytes on the same threads, and their ratio: medians of `runs`, turn by turn. A file
/// that cannot be compared goes to `problems`, a line each.
BenchTable MakeDecodeTable(
  const std::vector<std::filesystem::path>& files, int runs, std::vector<std::string>& problems);

} // namespace nexrad::application
