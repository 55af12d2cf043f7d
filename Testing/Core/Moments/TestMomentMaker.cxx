// SPDX-License-Identifier: BSD-3-Clause
// The polar data of measured and of derived moments, of SYNTHETIC volumes.
#include "nexrad/Moments/MomentMaker.h"

#include "Scans/SimulatedVelocities.h"
#include "Scans/WindFrom.h"
#include "SweepMaker.h"
#include "nexrad/Geometry/Angles.h"
#include "nexrad/Velocity/Dealiasing.h"
#include "nexrad/Velocity/VelocityDerivatives.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace nexrad
{
namespace
{

using testing::NumbersOf;
using testing::NumberSweep;
using testing::SimulatedVelocities;

const SimulatedVelocities& Simulated()
{
  static const SimulatedVelocities volume = testing::SimulateVelocities("KLSX", 31);
  return volume;
}

VelocityVolume Unfolded()
{
  VelocityVolume velocities = Simulated().folded;
  Dealias(velocities);
  return velocities;
}

void ExpectSameCodes(const PolarVolume& a, const PolarVolume& b)
{
  ASSERT_EQ(a.sweeps.size(), b.sweeps.size());
  for (std::size_t i = 0; i < a.sweeps.size(); ++i)
  {
    EXPECT_EQ(a.sweeps[i].scale.base, b.sweeps[i].scale.base) << "sweep " << i;
    EXPECT_EQ(a.sweeps[i].scale.step, b.sweeps[i].scale.step) << "sweep " << i;
    const NumberSweep ours = NumbersOf(a.sweeps[i]);
    const NumberSweep theirs = NumbersOf(b.sweeps[i]);
    EXPECT_TRUE(ours.states == theirs.states) << "sweep " << i;
    for (std::size_t gate = 0; gate < ours.values.size(); ++gate)
    {
      if (ours.states[gate] == GateState::Valid)
      {
        ASSERT_EQ(ours.values[gate], theirs.values[gate]) << "sweep " << i;
      }
    }
  }
}

} // namespace

TEST(MomentMaker, LeavesMeasuredMomentsAsTheyAre)
{
  MomentOptions options;
  options.dealias = false;
  MomentMaker maker(Simulated().volume, options);
  for (const MomentName moment : {MomentName::REF, MomentName::VEL, MomentName::RHO})
  {
    const PolarVolume made = maker.Make(moment);
    EXPECT_EQ(made.moment, moment);
    ExpectSameCodes(made, MakePolarVolume(Simulated().volume, moment));
  }
  EXPECT_EQ(maker.Note(), "");
}

TEST(MomentMaker, UnfoldsVelocities)
{
  MomentMaker maker(Simulated().volume, {});
  const PolarVolume made = maker.Make(MomentName::VEL);
  const VelocityVolume expected = Unfolded();
  ASSERT_EQ(made.sweeps.size(), expected.sweeps.size());
  std::size_t beyond = 0;
  for (std::size_t i = 0; i < made.sweeps.size(); ++i)
  {
    const NumberSweep sweep = NumbersOf(made.sweeps[i]);
    const VelocitySweep& wanted = expected.sweeps[i];
    for (std::size_t gate = 0; gate < sweep.values.size(); ++gate)
    {
      ASSERT_EQ(int(sweep.states[gate]), int(wanted.states[gate]));
      if (sweep.states[gate] == GateState::Valid)
      {
        ASSERT_NEAR(sweep.values[gate], wanted.values[gate], 0.002F);
        beyond += std::abs(sweep.values[gate]) > sweep.rays[gate / sweep.gates].nyquist ? 1 : 0;
      }
    }
  }
  EXPECT_GT(beyond, 10'000U); // else nothing was folded
}

// A gate of its own far from all others, at half of the Nyquist velocity: nothing tells its fold.
TEST(MomentMaker, DoesNotSampleWhatHasNoFold)
{
  NumberSweep sweep = testing::MakeSweep(1, 0.5, 360, 200, 250.0);
  for (PolarRay& ray : sweep.rays)
  {
    ray.nyquist = 10.0F;
  }
  testing::SetGate(sweep, 90, 100, 9.0F);
  PolarVolume folded = testing::MakeVolume({38.7, -90.7, 200.0}, 0.0, {sweep});
  folded.moment = MomentName::VEL;
  const auto measured = [&folded](MomentName, const WantedRange&) { return folded; };
  MomentMaker maker(measured, {});
  const PolarVolume made = maker.Make(MomentName::VEL);
  EXPECT_EQ(NumbersOf(made.sweeps[0]).states[sweep.Index(90, 100)], GateState::NotSampled);
  EXPECT_EQ(NumbersOf(made.sweeps[0]).states[sweep.Index(90, 99)], GateState::BelowThreshold);
  MomentOptions asMeasured;
  asMeasured.dealias = false;
  ExpectSameCodes(MomentMaker(measured, asMeasured).Make(MomentName::VEL), folded);
}

TEST(MomentMaker, MakesStormRelativeVelocity)
{
  MomentOptions options;
  options.stormMotion = testing::WindFrom(240.0, 15.0);
  MomentMaker maker(Simulated().volume, options);
  const PolarVolume relative = maker.Make(MomentName::SRV);
  const PolarVolume velocity = maker.Make(MomentName::VEL);
  EXPECT_EQ(relative.moment, MomentName::SRV);
  std::size_t compared = 0;
  for (std::size_t i = 0; i < relative.sweeps.size(); ++i)
  {
    const NumberSweep ours = NumbersOf(relative.sweeps[i]);
    const NumberSweep all = NumbersOf(velocity.sweeps[i]);
    EXPECT_TRUE(ours.states == all.states);
    for (std::size_t gate = 0; gate < ours.values.size(); gate += 7)
    {
      const PolarRay& ray = ours.rays[gate / ours.gates];
      const double azimuth = static_cast<double>(ray.azimuth) * RadiansPerDegree;
      const double along = 15.0 * std::cos(azimuth - 60.0 * RadiansPerDegree) *
                           std::cos(static_cast<double>(ray.elevation) * RadiansPerDegree);
      if (ours.states[gate] == GateState::Valid)
      {
        ASSERT_NEAR(static_cast<double>(all.values[gate] - ours.values[gate]), along, 0.01);
        ++compared;
      }
    }
  }
  EXPECT_GT(compared, 10'000U);
  EXPECT_EQ(maker.Note(), "");
}

// One sweep of a few gates has no wind profile.
TEST(MomentMaker, SaysThatItHasNoStormMotion)
{
  NumberSweep sweep = testing::MakeSweep(1, 0.5, 360, 200, 250.0);
  testing::SetGate(sweep, 90, 100, 9.0F);
  PolarVolume folded = testing::MakeVolume({38.7, -90.7, 200.0}, 0.0, {sweep});
  MomentMaker maker([&folded](MomentName, const WantedRange&) { return folded; }, {});
  const PolarVolume made = maker.Make(MomentName::SRV);
  EXPECT_EQ(NumbersOf(made.sweeps[0]).states[sweep.Index(90, 100)], GateState::NotSampled);
  EXPECT_NE(maker.Note().find("SRV has no values"), std::string::npos) << maker.Note();
}

TEST(MomentMaker, MakesShearAndDivergenceOfUnfoldedVelocities)
{
  MomentOptions options;
  options.dealias = false; // of VEL alone
  MomentMaker maker(Simulated().volume, options);
  const VelocityVolume velocities = Unfolded();
  for (const MomentName moment : {MomentName::AZSHEAR, MomentName::DIV})
  {
    const PolarVolume made = maker.Make(moment);
    EXPECT_EQ(made.moment, moment);
    std::size_t compared = 0;
    std::size_t without = 0;
    for (const std::size_t i : {std::size_t(0), made.sweeps.size() - 1})
    {
      const NumberSweep sweep = NumbersOf(made.sweeps[i]);
      const VelocitySweep& own = velocities.sweeps[i];
      const std::vector<float> expected =
        moment == MomentName::AZSHEAR ? AzimuthalShear(own) : RadialDivergence(own);
      for (std::size_t gate = 0; gate < expected.size(); ++gate)
      {
        if (sweep.states[gate] == GateState::Valid)
        {
          ASSERT_NEAR(sweep.values[gate], expected[gate], 1e-5F);
          ++compared;
        }
        else if (own.states[gate] == GateState::Valid)
        {
          EXPECT_TRUE(std::isnan(expected[gate]));
          EXPECT_EQ(sweep.states[gate], GateState::NotSampled);
          ++without;
        }
      }
    }
    EXPECT_GT(compared, 1'000U);
    EXPECT_GT(without, 10U);
  }
}

TEST(MomentMaker, AppliesQualityControlToDerivedMomentsToo)
{
  MomentOptions options;
  const auto count = [&options](MomentName moment)
  {
    const PolarVolume made = MomentMaker(Simulated().volume, options).Make(moment);
    const NumberSweep sweep = NumbersOf(made.sweeps[0]);
    return std::count(sweep.states.begin(), sweep.states.end(), GateState::Valid);
  };
  const auto all = count(MomentName::DIV);
  options.quality.neighbours = 12;
  EXPECT_LT(count(MomentName::DIV), all);
}

} // namespace nexrad
