// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Quality/EchoGrid.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace nexrad
{

/// Gates of one row that follow each other, from `begin` up to `end`, and the region they are of.
struct GateRun
{
  std::uint32_t place = 0; ///< the row, as EchoGrid counts them
  std::uint32_t begin = 0;
  std::uint32_t end = 0;
  std::uint32_t region = 0;
};

/// The connected regions of some gates of a sweep. Gates are connected along the ray, and with the
/// three nearest ones of the neighbouring rays.
class GateRegions
{
public:
  /// `members`: rays × gates, in the order of the rays of the sweep; other than 0 for the gates
  /// that count.
  GateRegions(const EchoGrid& grid, const std::vector<std::uint8_t>& members);

  const std::vector<GateRun>& Runs() const { return runs; }
  std::size_t Count() const { return count; }

private:
  std::uint32_t RootOf(std::uint32_t run);
  void Join(std::size_t first, std::size_t second, const std::vector<std::size_t>& firstRuns);

  std::vector<GateRun> runs;
  std::vector<std::uint32_t> parents;
  std::size_t count = 0;
};

} // namespace nexrad
