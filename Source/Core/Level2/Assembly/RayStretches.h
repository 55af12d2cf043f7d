// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Level2/Assembly/ArrivedRay.h"

#include <cstddef>
#include <unordered_map>
#include <vector>

namespace nexrad
{

/// The order scanned: by time, cut and azimuth number. Some radars have times of whole seconds.
bool IsScannedBefore(const ArrivedRay& a, const ArrivedRay& b);

/// Rays of a list that stand one behind the other.
struct RayStretch
{
  std::size_t Size() const { return end - begin; }

  std::size_t begin = 0; ///< the first ray
  std::size_t end = 0;   ///< behind the last ray
};

/// Cuts a list where the time goes back, or on by more than LongestStep.
std::vector<RayStretch> CutStretches(const RayList& rays);

/// The places that the rays of a list have in the order scanned.
class ScanPlaces
{
public:
  explicit ScanPlaces(const RayList& rays);

  /// True when a stretch of the list may stand where its times are: no other ray is between its
  /// rays, and their cuts and numbers go on from the ray before to the ray behind them, one of them
  /// without a loss or both within LongestStep.
  bool Fit(const RayList& rays, const RayStretch& stretch) const;

private:
  RayList ordered;
  std::unordered_map<const ArrivedRay*, std::size_t> places; ///< in `ordered`
};

} // namespace nexrad
