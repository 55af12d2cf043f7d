// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>

namespace nexrad
{

/// What decoding one file, or the chunks of one volume, may cost. A file of a few kilobytes can
/// hold millions of empty streams, messages or rays, so all that is made of a file is paid from one
/// sum: its memory in bytes, and its time as bytes that take as long. Each stored byte pays for
/// BytesForStored, and FreeBytes are free. Whole volumes of the archive cost up to 60 bytes for
/// each stored one. One whose data were mostly set to zero costs 67 MB, 86 % of its budget; all
/// other files of the tests cost at most 40 % of theirs.
class DecodingBudget
{
public:
  static constexpr std::size_t FreeBytes = std::size_t(64) << 20;
  static constexpr std::size_t BytesForStored = 100;

  /// Costs in bytes of what takes more than its own bytes. FreeBytes of any of these take less than
  /// 250 MB and about a second (TestDecodingCosts).
  static constexpr std::size_t CompressedByteCost = 16; ///< a few may hold tables of codes
  static constexpr std::size_t StreamCost = 4096;       ///< a record, or a further gzip stream
  static constexpr std::size_t RayCost = 1024;
  static constexpr std::size_t SweepCost = std::size_t(64) << 10;
  static constexpr std::size_t JudgedGateCost = 3; ///< of reflectivity or velocity, beside its word
  static constexpr std::size_t DamageCost = 512;

  /// A budget of `free` and what stored bytes bring, at most of `theMost`.
  explicit DecodingBudget(std::size_t theMost, std::size_t free = FreeBytes)
    : most(theMost)
    , granted(std::min(theMost, free))
  {
  }

  /// Bytes of a stored file that is going to be decoded.
  void AddStored(std::size_t bytes)
  {
    const std::size_t room = most - granted;
    granted += bytes < room / BytesForStored ? bytes * BytesForStored : room;
  }
  /// Takes a cost off. When less than that is left, returns false and takes off what is left.
  bool Spend(std::size_t cost)
  {
    const bool fits = cost <= this->Left();
    spent = fits ? spent + cost : granted;
    return fits;
  }

  std::size_t Left() const { return granted - spent; }
  /// Why something was left out: one line without the place.
  std::string Explain() const
  {
    return "decoding takes more than " + std::to_string(granted) +
           " bytes of memory, the most for a file of this size; the rest is left";
  }

private:
  std::size_t most;
  std::size_t granted;
  std::size_t spent = 0;
};

} // namespace nexrad
