// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Level2/Assembly/ArrivedRay.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

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

/// Rays that one turn of the antenna gave, and how they end.
struct ArrivedSweep
{
  RayList rays;           ///< never empty
  double turned = 0.0;    ///< degrees from the first to the last ray
  bool cutOff = false;    ///< no radial ends it, and it is less than a full turn
  bool restarted = false; ///< cut off, and the next sweep is the same cut from its start
};

/// Makes sweeps of rays in the order scanned. A sweep begins where the cut changes or starts again,
/// or after 400 degrees. At most 2000 sweeps are made; the rest is left, and reported. Rays that
/// are missing in a sweep are reported, and where a sweep is scanned again a note is made.
std::vector<ArrivedSweep> BuildSweeps(
  const RayList& rays, const ArrivedDamage& report, std::vector<std::string>& notes);

/// "sweep 2 (elevation number 3)".
std::string NameOfSweep(std::size_t index, const ArrivedSweep& sweep);

} // namespace nexrad
