// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

namespace nexrad::application
{

/// What became of the files that arrived of one radar, chunks or whole volumes. Each file that
/// arrived counts once among those that are used, repeated, replacing, refused or old, or it waits.
struct ArrivalCounts
{
  std::size_t used = 0;        ///< decoded, or waiting for a missing chunk before them
  std::size_t late = 0;        ///< of these, came after a chunk with a higher number
  std::size_t cut = 0;         ///< of these, never became whole: what could be read of them is used
  std::size_t repeated = 0;    ///< came again with the same bytes
  std::size_t replaced = 0;    ///< came again with other bytes, which took the place of the first
  std::size_t refused = 0;     ///< cannot be used; standard error says why
  std::size_t old = 0;         ///< of a volume that no time step may use any more
  std::size_t halfWritten = 0; ///< were seen before they were whole, however they went on
  std::size_t missing = 0;     ///< numbers of chunks that never came, of volumes that are finished

  ArrivalCounts& operator+=(const ArrivalCounts& other)
  {
    used += other.used;
    late += other.late;
    cut += other.cut;
    repeated += other.repeated;
    replaced += other.replaced;
    refused += other.refused;
    old += other.old;
    halfWritten += other.halfWritten;
    missing += other.missing;
    return *this;
  }
};

} // namespace nexrad::application
