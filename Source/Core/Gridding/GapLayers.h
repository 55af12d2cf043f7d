// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Gridding/BeamTilts.h"
#include "Gridding/EchoLayers.h"

#include <vector>

namespace nexrad
{

/// How much the echo between two neighbouring tilts of a radar lies in layers at the time of the
/// merge: the mean of what its volumes about that time say, the nearer ones counting more.
class GapLayers
{
public:
  /// 0…1 (EchoLayers::ShareAt).
  float ShareAt(const ColumnDirection& column) const;

  /// Of each gap between the tilts, from the lowest. `volumes` must outlive the result.
  static std::vector<GapLayers> Find(
    const std::vector<const BeamVolume*>& volumes, const std::vector<BeamTilt>& tilts, Time time);

private:
  struct Part
  {
    const EchoLayers* layers;
    const EchoLayers::Gap* gap;
    float weight;
  };
  std::vector<Part> parts; // weights add up to 1
};

} // namespace nexrad
