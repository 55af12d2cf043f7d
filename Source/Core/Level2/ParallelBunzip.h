// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Level2/Container.h"
#include "Level2/LdmRecords.h"

#include <cstddef>
#include <vector>

namespace nexrad
{

/// Decompresses records that do not depend on each other, on as many threads as the machine has
/// cores. The results stand in the order of the records, whatever the threads did.
std::vector<Bunzipped> BunzipInParallel(
  const std::vector<LdmRecord>& records, std::size_t maximumRecordBytes);

} // namespace nexrad
