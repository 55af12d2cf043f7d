// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Level2/Messages/DecodedRay.h"

#include <cstddef>

namespace nexrad
{

/// What rays cost of a DecodingBudget beside RayCost, told from a ray and the one decoded before.
class RayCosts
{
public:
  /// The cost of the next ray: that of a sweep where it can begin one; of its gates
  /// that quality control or dealiasing judges; of its damage; and the bytes of its words that
  /// exceed the `newBytes` of its message, because moments share them, or because they belong to
  /// another message too.
  std::size_t Of(const DecodedRay& decoded, std::size_t newBytes);

private:
  bool MayBeginSweep(const Ray& ray);

  unsigned elevationNumber = 0; ///< of the ray before
  double azimuth = 0.0;         ///< degrees, of the ray before
  double turned = 0.0;          ///< degrees to and fro since the last sweep began, at least
};

} // namespace nexrad
