// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Compression/Container.h"
#include "nexrad/Compression/LdmRecords.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace nexrad
{

/// Takes what a record holds; false to stop, and then no further record comes.
using RecordReceiver = std::function<bool(std::size_t index, Bunzipped&& content)>;

/// Decompresses records that do not depend on each other, on `threads` threads, this one among them
/// (0: as many as the machine has cores), and hands them to `receive` on this thread, in their
/// order, each as soon as it and those before it are there. At most sixteen records are in memory
/// before they are received. A record gives at most `maximumRecordBytes`, and no more than 4 MiB
/// and a hundred times its stored bytes. What `receive` throws, or a decompressor for want of
/// memory, ends the work and is thrown here.
void BunzipInParallel(const std::vector<LdmRecord>& records, std::size_t maximumRecordBytes,
  const RecordReceiver& receive, unsigned threads = 0);

} // namespace nexrad
