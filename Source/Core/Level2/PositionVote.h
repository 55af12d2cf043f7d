// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Level2/Messages/DecodedRay.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace nexrad
{

/// Chooses the radar's position among those that the rays of a file state: a flipped bit in one ray
/// does not move the radar.
class PositionVote
{
public:
  /// Rays that state one position.
  struct Group
  {
    StoredPosition position;
    std::size_t rays = 0;
    std::uint64_t offset = 0; ///< of the first ray's message in the stored file
    std::size_t piece = 0;    ///< of the stored files, the one that has the first ray
  };

  void Add(const StoredPosition& position, std::uint64_t offset, std::size_t piece);

  /// The position that most rays state; of two that as many state, the one stated first. Empty when
  /// no ray states one.
  std::optional<StoredPosition> Winner() const;

  /// The rays that state other positions, as one group at the first of them; `rays` is 0 when there
  /// are none.
  Group Others() const;

private:
  const Group* Largest() const;

  std::vector<Group> groups; ///< in the order in which they were first stated
  std::size_t latest = 0;    ///< group of the ray before
};

} // namespace nexrad
