// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Model/RadarVolume.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace nexrad
{

/// Takes one piece of damage as it is found, so that whoever finds it keeps no list.
using DamageReceiver = std::function<void(std::size_t offset, const std::string& what)>;

/// Gathers what is wrong in a file, and keeps the list readable: equal damage one after the other
/// is one entry with a count, and after a thousand entries only the number of places is kept.
class DamageList
{
public:
  static constexpr std::size_t mostEntries = 1000;

  void Add(std::uint64_t offset, const std::string& what);

  /// The list; `byOffset` orders it, which makes sense when all offsets are of one file.
  std::vector<Damage> Take(bool byOffset);

private:
  void FinishEntry();

  std::vector<Damage> entries;
  std::string lastWhat;
  std::size_t repeated = 0;         ///< how often the last damage came again
  std::uint64_t repeatedOffset = 0; ///< where it came last
  std::size_t leftOut = 0;
  std::uint64_t leftOutOffset = 0; ///< of the first that was left out
};

} // namespace nexrad
