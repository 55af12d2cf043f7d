// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Level2/Assembly/ArrivedRay.h"

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
  /// The next ray of the sweep; it must stay where it is.
  void Add(const ArrivedRay& arrived);

  /// Degrees from the first ray to this azimuth, by the way that the antenna took.
  double TurnTo(float azimuth) const;

  /// Rays missing between or before those that came.
  std::size_t Missing() const { return missing; }
  /// True when the sweep stops before its end: no radial that ends it, and less than a full turn.
  bool IsCutOff() const;
  /// Degrees that the antenna turned from the first to the last ray.
  double Turned() const { return turned; }
  /// The ray behind the first gap; nullptr when no ray is missing.
  const ArrivedRay* BehindGap() const { return behindGap; }
  /// The first and the last ray; nullptr without rays.
  const ArrivedRay* First() const { return first; }
  const ArrivedRay* Last() const { return last; }
  /// One line on the missing rays of that sweep; "" when none is missing.
  std::string Describe(std::size_t sweepIndex, int elevationNumber) const;

private:
  void Count(std::size_t lost, float from, const ArrivedRay& behind);

  double turned = 0.0;
  const ArrivedRay* first = nullptr;
  const ArrivedRay* last = nullptr;
  std::size_t missing = 0;
  std::size_t gaps = 0;
  float gapFrom = 0.0F;
  float gapTo = 0.0F;
  const ArrivedRay* behindGap = nullptr; // of the first gap
};

} // namespace nexrad
