// SPDX-License-Identifier: BSD-3-Clause
// Echo that is not weather: each kind by itself, against what is true of each gate.
#include "ScannedStorm.h"
#include "Tolerance.h"
#include "nexrad/Model/SiteTable.h"
#include "nexrad/Simulation/AddedEcho.h"
#include "nexrad/Simulation/RadarSimulator.h"
#include "nexrad/Simulation/ScanStrategy.h"
#include "nexrad/System/Error.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

using namespace nexrad;
using namespace nexrad::testing;

namespace
{

// The storms and one kind more.
const TruthfulScan& ScanWith(EchoKind kind)
{
  static std::map<EchoKind, TruthfulScan> scans;
  const auto found = scans.find(kind);
  if (found != scans.end())
  {
    return found->second;
  }
  SimulatorOptions options;
  options.notWeather = {kind};
  return scans[kind] = Scan(options);
}

// Calls with each gate of REF: its sweep, its ray, its row, its number and its kind.
template <typename Visit>
void VisitReflectivity(const TruthfulScan& scan, const Visit& visit)
{
  for (std::size_t cut = 0; cut < scan.volume.sweeps.size(); ++cut)
  {
    const Sweep& sweep = scan.volume.sweeps[cut];
    for (std::size_t index = 0; index < sweep.rays.size(); ++index)
    {
      const std::vector<EchoKind>& kinds = scan.truth.sweeps[cut][index].reflectivityKinds;
      const MomentRow& row = sweep.rays[index].Row(MomentName::REF);
      ASSERT_EQ(kinds.size(), row.gates);
      for (std::size_t gate = 0; gate < kinds.size(); ++gate)
      {
        visit(cut, index, row, gate, kinds[gate]);
      }
    }
  }
}

double RangeOf(const MomentRow& row, std::size_t gate)
{
  return row.firstGate + double(row.gateSpacing) * static_cast<double>(gate);
}

std::map<EchoKind, std::size_t> CountKinds(const TruthfulScan& scan)
{
  std::map<EchoKind, std::size_t> counts;
  VisitReflectivity(scan, [&](auto, auto, const auto&, auto, EchoKind kind) { ++counts[kind]; });
  return counts;
}

// Velocities and widths of a kind: mean square and largest size.
struct Motions
{
  double squares = 0.0;
  double largest = 0.0;
  double width = 0.0;
  std::size_t count = 0;
};
Motions MotionsOf(const TruthfulScan& scan, EchoKind kind)
{
  Motions motions;
  for (std::size_t cut = 0; cut < scan.volume.sweeps.size(); ++cut)
  {
    const Sweep& sweep = scan.volume.sweeps[cut];
    for (std::size_t index = 0; index < sweep.rays.size(); ++index)
    {
      const RayTruth& truth = scan.truth.sweeps[cut][index];
      const MomentRow& row = sweep.rays[index].Row(MomentName::VEL);
      for (std::size_t gate = 0; gate < row.gates; ++gate)
      {
        if (truth.velocityKinds[gate] == kind && row.State(gate) == GateState::Valid)
        {
          const double velocity = row.Value(gate);
          motions.squares += velocity * velocity;
          motions.largest = std::max(motions.largest, std::abs(velocity));
          motions.width += sweep.rays[index].Row(MomentName::SW).Value(gate);
          ++motions.count;
        }
      }
    }
  }
  return motions;
}

// Mean squared difference of neighbouring gates along the range, dB², where both are of a kind.
double Texture(const TruthfulScan& scan, EchoKind kind)
{
  double sum = 0.0;
  std::size_t count = 0;
  bool before = false;
  VisitReflectivity(scan,
    [&](auto, auto, const MomentRow& row, std::size_t gate, EchoKind here)
    {
      const bool isKind = here == kind;
      if (isKind && before && gate > 0)
      {
        const double step = row.Value(gate) - row.Value(gate - 1);
        sum += step * step;
        ++count;
      }
      before = isKind;
    });
  return sum / static_cast<double>(std::max<std::size_t>(count, 1));
}

} // namespace

TEST(AddedEcho, NoneOfItIsThereByDefault)
{
  const TruthfulScan& plain = PlainScan();
  const std::map<EchoKind, std::size_t> counts = CountKinds(plain);
  for (const auto& [kind, count] : counts)
  {
    EXPECT_TRUE(kind == EchoKind::None || kind == EchoKind::Weather || kind == EchoKind::Biological)
      << ToString(kind) << ' ' << count;
  }
  EXPECT_AT_LEAST(counts.at(EchoKind::Weather), 50'000U, "gates of weather");
  VisitReflectivity(plain, [](auto, auto, const MomentRow& row, std::size_t gate, EchoKind kind)
    { ASSERT_EQ(row.State(gate) == GateState::Valid, kind != EchoKind::None); });
}

TEST(AddedEcho, EachKindComesAloneAndLeavesTheRestAsItIs)
{
  const TruthfulScan& plain = PlainScan();
  for (const EchoKind kind : AddableEchoKinds())
  {
    const TruthfulScan& scan = ScanWith(kind);
    std::size_t echoes = 0;
    std::size_t added = 0;
    VisitReflectivity(scan,
      [&](std::size_t cut, std::size_t ray, const MomentRow& row, std::size_t gate, EchoKind here)
      {
        echoes += here == EchoKind::None ? 0 : 1;
        added += here == kind ? 1 : 0;
        if (here == EchoKind::None)
        {
          ASSERT_EQ(
            plain.volume.sweeps[cut].rays[ray].Row(MomentName::REF).Raw(gate), row.Raw(gate));
        }
      });
    std::printf("%s: %.2f %% of %zu gates with echo\n", ToString(kind),
      100.0 * static_cast<double>(added) / static_cast<double>(echoes), echoes);
    EXPECT_AT_LEAST(added, 300U, "gates of an added kind");
    EXPECT_EQ(CountKinds(scan).size(), kind == EchoKind::Biological ? 3U : 4U) << ToString(kind);
  }
}

TEST(AddedEcho, IsTheSameEveryTime)
{
  SimulatorOptions options;
  options.notWeather = AddableEchoKinds();
  const TruthfulScan first = Scan(options);
  const TruthfulScan second = Scan(options);
  EXPECT_TRUE(std::equal(first.volume.buffers.begin(), first.volume.buffers.end(),
    second.volume.buffers.begin(),
    [](const auto& one, const auto& other) { return *one == *other; }));
  EXPECT_EQ(CountKinds(first), CountKinds(second));
}

TEST(GroundEcho, HasHighTextureAndNoVelocity)
{
  for (const EchoKind kind : {EchoKind::Clutter, EchoKind::AnomalousPropagation})
  {
    const TruthfulScan& scan = ScanWith(kind);
    EXPECT_AT_LEAST(Texture(scan, kind), 60.0, "texture of ground echo, dB²");
    EXPECT_AT_MOST(Texture(scan, EchoKind::Weather), 8.0, "texture of weather, dB²");
    const Motions motions = MotionsOf(scan, kind);
    ASSERT_AT_LEAST(motions.count, 5'000U, "velocities of ground echo");
    EXPECT_AT_MOST(motions.largest, 1.5, "largest velocity of ground echo, m/s");
    EXPECT_AT_MOST(motions.width / static_cast<double>(motions.count), 1.0,
      "mean spectrum width of ground echo, m/s");
  }
}

TEST(GroundEcho, ClutterFallsWithThePattern)
{
  const GroundEcho ground(7, 0.95);
  std::size_t targets = 0;
  for (double azimuth = 0.5; azimuth < 360.0; azimuth += 1.0)
  {
    for (double range = 2'000.0; range < 100'000.0; range += 250.0)
    {
      const double low = ground.Clutter({azimuth, 0.483, range});
      if (std::isfinite(low))
      {
        ++targets;
        // Higher up the pattern loses more of the same target.
        EXPECT_GT(low, ground.Clutter({azimuth, 1.45, range}));
        EXPECT_GT(low + 45.0, ground.Clutter({azimuth, 0.0, range}));
      }
    }
  }
  EXPECT_AT_LEAST(targets, 12'000U, "cells with clutter");
}

// The same places have clutter in two volumes, whose rays lie elsewhere.
TEST(GroundEcho, ClutterStandsStill)
{
  SimulatorOptions options;
  options.notWeather = {EchoKind::Clutter};
  const auto places = [](const TruthfulScan& scan)
  {
    std::set<std::pair<int, std::size_t>> cells;
    for (std::size_t index = 0; index < scan.volume.sweeps[0].rays.size(); ++index)
    {
      const std::vector<EchoKind>& kinds = scan.truth.sweeps[0][index].reflectivityKinds;
      for (std::size_t gate = 0; gate < kinds.size(); ++gate)
      {
        if (kinds[gate] == EchoKind::Clutter)
        {
          cells.insert({static_cast<int>(scan.volume.sweeps[0].rays[index].azimuth), gate});
        }
      }
    }
    return cells;
  };
  const auto first = places(ScanWith(EchoKind::Clutter));
  const auto second = places(Scan(options, 32, start + std::chrono::minutes(10)));
  std::size_t both = 0;
  for (const auto& place : first)
  {
    both += second.count(place);
  }
  EXPECT_AT_LEAST(static_cast<double>(both) / static_cast<double>(first.size()), 0.8,
    "share of the places with clutter that have it ten minutes later");
}

TEST(GroundEcho, AnomalousPropagationVanishesTwoTiltsUp)
{
  std::map<double, std::size_t> counts;
  const TruthfulScan& scan = ScanWith(EchoKind::AnomalousPropagation);
  VisitReflectivity(scan,
    [&](std::size_t cut, auto, auto, auto, EchoKind kind)
    {
      counts[scan.volume.coveragePattern->cuts[cut].elevation] +=
        kind == EchoKind::AnomalousPropagation ? 1 : 0;
    });
  EXPECT_AT_LEAST(counts.at(0.483), 1'300U, "gates of ground in the lowest cut");
  EXPECT_EQ(counts.at(1.494), 0U);
  EXPECT_EQ(counts.at(2.505), 0U);
}

TEST(AddedEcho, TheBloomIsLowAndFliesByItself)
{
  const TruthfulScan& scan = ScanWith(EchoKind::Biological);
  const StormField field;
  std::size_t count = 0;
  double squares = 0.0;
  for (std::size_t cut = 4; cut < scan.volume.sweeps.size(); ++cut)
  {
    const Sweep& sweep = scan.volume.sweeps[cut];
    for (std::size_t index = 0; index < sweep.rays.size(); index += 9)
    {
      const Ray& ray = sweep.rays[index];
      const MomentRow& row = ray.Row(MomentName::VEL);
      const RayTruth& truth = scan.truth.sweeps[cut][index];
      for (std::size_t gate = 20; gate < row.gates; gate += 5)
      {
        const double range = RangeOf(row, gate);
        const double height = range * std::sin(ray.elevation / 57.2957795) +
                              range * range / (2.0 * 4.0 / 3.0 * 6'371'000.0);
        if (truth.velocityKinds[gate] != EchoKind::Biological ||
            row.State(gate) != GateState::Valid || height > 800.0)
        {
          continue;
        }
        // Below 800 m the bloom is everywhere stronger than the clear air of every day.
        const double wind = TrueRadialVelocity(field, *TestSite().position, ray.time, ray.azimuth,
          ray.elevation, range, row.gateSpacing);
        const WindVector flight = AddedEcho::OwnFlight();
        const double azimuth = ray.azimuth / 57.2957795;
        const double own = (flight.east * std::sin(azimuth) + flight.north * std::cos(azimuth)) *
                           std::cos(ray.elevation / 57.2957795);
        const double error = truth.velocity[gate] - wind - own;
        squares += error * error;
        ++count;
      }
    }
  }
  ASSERT_AT_LEAST(count, 500U, "velocities of the bloom");
  EXPECT_AT_MOST(std::sqrt(squares / static_cast<double>(count)), 0.011,
    "velocity of the bloom against wind and flight, RMS, m/s");
  VisitReflectivity(scan,
    [&](std::size_t cut, auto, const MomentRow& row, std::size_t gate, EchoKind kind)
    {
      if (kind == EchoKind::Biological && cut >= 4)
      {
        ASSERT_LE(RangeOf(row, gate) * std::sin(2.3 / 57.2957795), 3'000.0);
      }
    });
}

TEST(AddedEcho, SpikesHaveOnePowerAtAllRanges)
{
  for (const EchoKind kind : {EchoKind::Sun, EchoKind::Interference})
  {
    const TruthfulScan& scan = ScanWith(kind);
    std::map<std::pair<std::size_t, std::size_t>, std::vector<double>> rays;
    VisitReflectivity(scan,
      [&](std::size_t cut, std::size_t ray, const MomentRow& row, std::size_t gate, EchoKind here)
      {
        if (here == kind)
        {
          rays[{cut, ray}].push_back(row.Value(gate) - 20.0 * std::log10(RangeOf(row, gate)));
        }
      });
    std::size_t lowest = 0;
    for (const auto& [place, powers] : rays)
    {
      lowest += place.first == 0 ? 1 : 0;
      if (powers.size() < 100)
      {
        continue; // the edge of the sun, where noise alone lifts some gates over the threshold
      }
      double mean = 0.0;
      for (const double power : powers)
      {
        mean += power / static_cast<double>(powers.size());
      }
      double squares = 0.0;
      for (const double power : powers)
      {
        squares += (power - mean) * (power - mean) / static_cast<double>(powers.size());
      }
      EXPECT_AT_MOST(std::sqrt(squares), 2.2, "deviation of a spike's power, dB");
    }
    EXPECT_GE(lowest, 1U) << ToString(kind);
    EXPECT_LE(lowest, kind == EchoKind::Sun ? 3U : 1U) << ToString(kind);
  }
}

TEST(AddedEcho, TestPatternsFillRaysWithOneValue)
{
  const TruthfulScan& scan = ScanWith(EchoKind::TestPattern);
  std::size_t rays = 0;
  for (std::size_t cut = 0; cut < scan.volume.sweeps.size(); ++cut)
  {
    for (std::size_t index = 0; index < scan.volume.sweeps[cut].rays.size(); ++index)
    {
      const std::vector<EchoKind>& kinds = scan.truth.sweeps[cut][index].reflectivityKinds;
      const MomentRow& row = scan.volume.sweeps[cut].rays[index].Row(MomentName::REF);
      if (kinds.empty() || kinds.front() != EchoKind::TestPattern)
      {
        continue;
      }
      ++rays;
      for (std::size_t gate = 0; gate < row.gates; ++gate)
      {
        ASSERT_EQ(row.Value(gate), 35.0F);
        ASSERT_EQ(kinds[gate], EchoKind::TestPattern);
      }
    }
  }
  EXPECT_EQ(rays, 4U); // two in the first and the seventh cut; the fourth has no REF
}

TEST(AddedEcho, SpecklesStandAlone)
{
  const TruthfulScan& scan = ScanWith(EchoKind::Speckle);
  std::size_t speckles = 0;
  std::size_t neighbours = 0;
  std::size_t gates = 0;
  bool before = false;
  VisitReflectivity(scan,
    [&](auto, auto, auto, std::size_t gate, EchoKind kind)
    {
      const bool isSpeckle = kind == EchoKind::Speckle;
      speckles += isSpeckle ? 1 : 0;
      neighbours += isSpeckle && before && gate > 0 ? 1 : 0;
      gates += kind == EchoKind::None || isSpeckle ? 1 : 0;
      before = isSpeckle;
    });
  EXPECT_WITHIN(1250.0 * static_cast<double>(speckles) / static_cast<double>(gates), 1.0, 0.2,
    "share of speckle, times 1250");
  EXPECT_LE(neighbours, speckles / 20);
}

TEST(AddedEcho, ABiasLiftsEveryValue)
{
  SimulatorOptions options;
  options.bias = 2.0;
  const TruthfulScan& plain = PlainScan();
  const TruthfulScan biased = Scan(options);
  std::size_t count = 0;
  VisitReflectivity(biased,
    [&](std::size_t cut, std::size_t ray, const MomentRow& row, std::size_t gate, EchoKind kind)
    {
      const MomentRow& other = plain.volume.sweeps[cut].rays[ray].Row(MomentName::REF);
      ASSERT_EQ(other.State(gate), row.State(gate));
      if (kind == EchoKind::Weather)
      {
        ASSERT_EQ(row.Value(gate), other.Value(gate) + 2.0F);
        ++count;
      }
    });
  EXPECT_AT_LEAST(count, 50'000U, "gates of weather");
}

TEST(EchoKind, IsReadAsItIsWritten)
{
  for (const EchoKind kind : AddableEchoKinds())
  {
    EXPECT_EQ(ParseEchoKinds(ToString(kind)), std::set<EchoKind>{kind});
  }
  EXPECT_EQ(ParseEchoKinds("clutter,sun"), (std::set<EchoKind>{EchoKind::Clutter, EchoKind::Sun}));
  EXPECT_EQ(ParseEchoKinds("all"), AddableEchoKinds());
  for (const char* wrong : {"", "weather", "clutter,", "rain", "none"})
  {
    EXPECT_THROW(ParseEchoKinds(wrong), Error) << wrong;
  }
}
