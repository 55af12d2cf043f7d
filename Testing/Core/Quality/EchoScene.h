// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "SweepMaker.h"
#include "nexrad/Quality/EchoClassification.h"

#include <cstddef>
#include <functional>
#include <limits>
#include <map>
#include <vector>

namespace nexrad::testing
{

/// What one gate of a scene is; NaN where a moment has no value.
struct SceneGate
{
  float reflectivity = std::numeric_limits<float>::quiet_NaN();
  float velocity = std::numeric_limits<float>::quiet_NaN();
  float width = 2.5F;
  float correlation = std::numeric_limits<float>::quiet_NaN();
  float ratio = 0.5F;
  float phase = 60.0F;
};

/// Noise from −1 to 1, even, the same for the same numbers.
float SceneNoise(std::size_t tilt, std::size_t ray, std::size_t gate, std::size_t kind);

/// A hand-made volume of four tilts (0.5°, 1.5°, 2.4°, 4.3°) of 360 rays and 150 gates of 1 km: all
/// moments in each.
class EchoScene
{
public:
  using Gates = std::function<SceneGate(std::size_t tilt, std::size_t ray, std::size_t gate)>;

  explicit EchoScene(const Gates& gates);

  PolarVolume Measured(MomentName moment) const;
  EchoClassification Classify(const RangeLoop& loop = {}) const;

  /// Removes a moment, of one tilt or of all.
  void Remove(MomentName moment);
  /// Makes the first tilt a split cut: a sweep without velocity, and one with nothing but
  /// reflectivity, velocity and width.
  void SplitFirstTilt();

private:
  std::map<MomentName, std::vector<NumberSweep>> moments;
};

/// Part of the gates of a sweep with a value, of those that `isMeant` names, that are of a class.
double ShareOf(const EchoScene& scene, const EchoClassification& found, std::size_t sweep,
  EchoClass echoClass, const std::function<bool(std::size_t ray, std::size_t gate)>& isMeant);

inline bool Everywhere(std::size_t, std::size_t)
{
  return true;
}

} // namespace nexrad::testing
