// SPDX-License-Identifier: BSD-3-Clause
// Formulas Q1: clear-air echo of hand-made sweeps without dual polarisation ends where it ends, not
// at an arc where the beam reaches some height.
#include "EchoScene.h"

#include <gtest/gtest.h>

using namespace nexrad;
using namespace nexrad::testing;

namespace
{

// Weak echo in the two lowest tilts, up to `last` gates of 1 km in the second.
EchoScene WeakEcho(std::size_t last)
{
  return EchoScene(
    [last](std::size_t tilt, std::size_t ray, std::size_t gate)
    {
      SceneGate echo;
      if ((tilt < 2 && gate < last) || gate < 5)
      {
        echo.reflectivity = 12.0F + 2.0F * SceneNoise(tilt, ray, gate, 0);
        echo.velocity = 9.0F + SceneNoise(tilt, ray, gate, 1);
      }
      return echo;
    });
}

double BiologicalBeyond85Kilometres(const EchoScene& scene)
{
  return ShareOf(scene, scene.Classify(), 1, EchoClass::Biological,
    [](std::size_t, std::size_t gate) { return gate >= 85; });
}

} // namespace

// The beam of 1.5° is 2.5 km high at 80 km.
TEST(ClearAir, ReachesBeyondTheHeightThatTellsIt)
{
  EXPECT_EQ(BiologicalBeyond85Kilometres(WeakEcho(105)), 1.0);
}

// Of a layer that lies mostly higher nothing is taken for birds and insects.
TEST(ClearAir, IsNotAHighLayer)
{
  const EchoScene scene = WeakEcho(150);
  EXPECT_EQ(ShareOf(scene, scene.Classify(), 1, EchoClass::Biological,
              [](std::size_t, std::size_t) { return true; }),
    0.0);
}
