// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Level2/Messages/DecodedRay.h"

#include <cstddef>
#include <cstdint>
#include <string>

namespace nexrad
{

/// Follows the antenna through one sweep: how far it turned, and which of the numbered rays are
/// missing.
class SweepWatch
{
public:
  /// Forgets the last sweep.
  void Begin() { *this = SweepWatch(); }
  /// The next ray of the sweep, and the offset of its message in the stored file.
  void Add(const DecodedRay& decoded, std::uint64_t offset);

  /// Degrees from the first ray to this azimuth, by the way that the antenna took.
  double TurnTo(float azimuth) const;

  /// Rays missing between or before those that came.
  std::size_t Missing() const { return missing; }
  /// True when the sweep stops before its end: no radial that ends it, and less than a full turn.
  bool IsCutOff() const;
  /// Where the first missing ray should be.
  std::uint64_t MissingOffset() const { return missingOffset; }
  std::uint64_t LastOffset() const { return lastOffset; }
  /// One line on the missing rays of that sweep; "" when none is missing.
  std::string Describe(std::size_t sweepIndex, int elevationNumber) const;

private:
  void Count(std::size_t lost, float from, float to, std::uint64_t offset);

  std::size_t rays = 0;
  double turned = 0.0;
  float lastAzimuth = 0.0F;
  unsigned lastNumber = 0;
  std::uint8_t lastStatus = 0;
  std::uint64_t lastOffset = 0;
  std::size_t missing = 0;
  std::size_t gaps = 0;
  float gapFrom = 0.0F;
  float gapTo = 0.0F;
  std::uint64_t missingOffset = 0;
};

} // namespace nexrad
