// SPDX-License-Identifier: BSD-3-Clause
// Velocities of hand-made rays as numbers, and folding.
#include "HandMadeVolume.h"
#include "nexrad/System/Error.h"
#include "nexrad/Velocity/VelocityVolume.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace nexrad;
using namespace nexrad::testing;

namespace
{

// Words 0, 1, 66, 68 and 255: below threshold, range folded, 0 m/s, 1 m/s, and 94.5 m/s.
HandMadeVolume Example()
{
  HandMadeVolume volume;
  HandMadeSweep sweep;
  sweep.nyquist = 25.0F;
  HandMadeMoment velocity;
  velocity.name = MomentName::VEL;
  velocity.gates = 5;
  velocity.firstGate = 500;
  velocity.gateSpacing = 250;
  velocity.word = [](int, int gate)
  {
    constexpr std::uint8_t words[] = {0, 1, 66, 68, 255};
    return words[gate];
  };
  sweep.moments = {velocity};
  volume.sweeps = {sweep};
  return volume;
}

} // namespace

TEST(VelocityVolume, HoldsNumbersAndStates)
{
  const VelocityVolume volume =
    MakeVelocityVolume(MakePolarVolume(MakeRadarVolume(Example()), MomentName::VEL));
  ASSERT_EQ(volume.sweeps.size(), 1u);
  const VelocitySweep& sweep = volume.sweeps[0];
  ASSERT_EQ(sweep.rays.size(), 360u);
  EXPECT_EQ(sweep.gates, 5u);
  EXPECT_EQ(sweep.RangeOf(2), 1000.0);
  EXPECT_EQ(sweep.rays[7].nyquist, 25.0F);
  const std::size_t first = sweep.Index(7, 0);
  EXPECT_EQ(sweep.states[first], GateState::BelowThreshold);
  EXPECT_EQ(sweep.states[first + 1], GateState::RangeFolded);
  EXPECT_EQ(sweep.values[first + 2], 0.0F);
  EXPECT_EQ(sweep.values[first + 3], 1.0F);
  // Nothing measures 94.5 m/s at a Nyquist velocity of 25 m/s.
  EXPECT_EQ(sweep.states[first + 4], GateState::NotSampled);
  EXPECT_TRUE(std::isnan(sweep.values[first + 4]));
}
