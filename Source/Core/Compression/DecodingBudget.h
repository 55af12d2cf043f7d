// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>

namespace nexrad
{

/// What decoding one file, or the chunks of one volume, may cost. A file of a few kilobytes can
/// hold millions of empty streams, messages or rays, so all that is made of a file is paid from one
/// sum: its memory in bytes, and its time as bytes that take as long. Each stored byte pays for
/// BytesForStored, and FreeBytes are free. Volumes of the archive cost 2 to 60 bytes for each
/// stored one, small pieces of them up to 1400; all of these cost less than 45 MiB.
class DecodingBudget
{
public:
  static constexpr std::size_t FreeBytes = std::size_t(64) << 20;
  static constexpr std::size_t BytesForStored = 100;

  /// The costs of what is not memory alone, in bytes. Each is at least the memory, and takes at
  /// most a second for FreeBytes.
  static constexpr std::size_t CompressedByteCost = 16; ///< tables of codes in a few bytes
  static constexpr std::size_t StreamCost = 4096;       ///< that has bytes of its own kind
  static constexpr std::size_t RayCost = 1024;
  static constexpr std::size_t SweepCost = std::size_t(64) << 10;
  static constexpr std::size_t JudgedGateCost = 3; ///< a gate of reflectivity, beside its word
  static constexpr std::size_t DamageCost = 512;

  /// A budget of `free` and what stored bytes bring, at most of `most`.
  explicit DecodingBudget(std::size_t most, std::size_t free = FreeBytes);

  /// Bytes of a stored file that is going to be decoded.
  void AddStored(std::size_t bytes);
  /// Takes a cost off. When less than that is left, returns false and takes off what is left.
  bool Spend(std::size_t cost);

  std::size_t Left() const { return granted - spent; }
  /// Why something was left out: one line without the place.
  std::string Explain() const;

private:
  std::size_t most;
  std::size_t granted;
  std::size_t spent = 0;
};

} // namespace nexrad
