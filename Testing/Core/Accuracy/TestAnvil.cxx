// SPDX-License-Identifier: BSD-3-Clause
// Echo tops of anvils: between tilts that stand kilometres apart, a smooth top must come out smooth
// (Formulas G11, G12) and not as a saw's teeth that follow the tilts.
#include "BeamScene.h"
#include "TestData.h"
#include "Tolerance.h"
#include "nexrad/Geometry/Angles.h"
#include "nexrad/Level2/Level2File.h"
#include "nexrad/Simulation/ScanStrategy.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

using namespace nexrad;
using namespace nexrad::testing;

namespace
{

constexpr double threshold = 5.0; // dBZ, of the echo tops

// Heights of 5 dBZ above mean sea level, m (Formulas P2: linear between two levels, from above); no
// echo is 0 dBZ. Nothing under a column's highest voxel that was scanned when that has 5 dBZ.
std::optional<double> EchoTop(const GriddedVolume& volume, std::size_t column)
{
  const GridSpecification& grid = volume.grid;
  const std::size_t columns =
    static_cast<std::size_t>(grid.dimensions[0]) * static_cast<std::size_t>(grid.dimensions[1]);
  std::optional<double> above;
  for (int level = grid.dimensions[2] - 1; level >= 0; --level)
  {
    const std::size_t at = static_cast<std::size_t>(level) * columns + column;
    const VoxelState state = volume.states[at];
    if (state != VoxelState::Echo && state != VoxelState::NoEcho)
    {
      above.reset();
      continue;
    }
    const double here = state == VoxelState::Echo ? std::max<double>(volume.values[at], 0.0) : 0.0;
    if (here >= threshold)
    {
      return above ? std::optional<double>(grid.Coordinate(2, level) +
                                           grid.spacing[2] * (here - threshold) / (here - *above))
                   : std::nullopt;
    }
    above = here;
  }
  return std::nullopt;
}

struct Top
{
  double distance = 0.0; // m
  double error = 0.0;    // m, or the height where no truth is known
};

// Root mean square about the parabola in distance that fits best, m.
double RippleOf(const std::vector<Top>& tops)
{
  std::array<std::array<double, 4>, 3> rows{}; // normal equations, of distances in 100 km
  for (const Top& top : tops)
  {
    const double x = top.distance / 1e5;
    const std::array<double, 3> powers = {1.0, x, x * x};
    for (std::size_t i = 0; i < 3; ++i)
    {
      for (std::size_t j = 0; j < 3; ++j)
      {
        rows[i][j] += powers[i] * powers[j];
      }
      rows[i][3] += powers[i] * top.error;
    }
  }
  for (std::size_t pivot = 0; pivot < 3; ++pivot)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      const double factor = i == pivot ? 0.0 : rows[i][pivot] / rows[pivot][pivot];
      for (std::size_t j = 0; j < 4; ++j)
      {
        rows[i][j] -= factor * rows[pivot][j];
      }
    }
  }
  double squares = 0.0;
  for (const Top& top : tops)
  {
    const double x = top.distance / 1e5;
    const double fit =
      rows[0][3] / rows[0][0] + x * (rows[1][3] / rows[1][1] + x * rows[2][3] / rows[2][2]);
    squares += (top.error - fit) * (top.error - fit);
  }
  return std::sqrt(squares / static_cast<double>(tops.size()));
}

double BiasOf(const std::vector<Top>& tops)
{
  double sum = 0.0;
  for (const Top& top : tops)
  {
    sum += top.error;
  }
  return sum / static_cast<double>(tops.size());
}

// An anvil of 25 dBZ, whose edges pass 5 dBZ at its top and at its base within some hundred metres.
struct Anvil
{
  const char* name = "";
  double slope = 0.0; // of the top, m fallen for each m to the east
  double end = 1e9;   // m to the east, where it ends within some kilometres

  // Above the antenna, m.
  double TopAt(double east) const { return 13'500.0 - slope * std::max(east, 0.0); }

  double At(double east, double height) const // dBZ
  {
    constexpr double base = 8'000.0;
    constexpr double edge = 500.0;
    const double outside = std::max(height - this->TopAt(east), base - height) / edge;
    const double beyond = std::max((east - end) / 4'000.0, -30.0);
    return threshold - 20.0 * std::tanh(std::max(outside, beyond));
  }
};

// The mean of Z over the two-way pattern of a beam, upwards and downwards, dBZ.
double SampleAnvil(const Anvil& anvil, double elevation, double sine, double range)
{
  const BeamModel beam;
  const double sigma = 0.95 / std::sqrt(16.0 * std::log(2.0));
  double sum = 0.0;
  double weights = 0.0;
  for (int node = -6; node <= 6; ++node)
  {
    const double off = 0.5 * node; // standard deviations
    const BeamPoint point = beam.Locate(range, elevation + off * sigma);
    const double weight = std::exp(-0.5 * off * off);
    sum += weight * std::pow(10.0, 0.1 * anvil.At(point.groundDistance * sine, point.height));
    weights += weight;
  }
  return 10.0 * std::log10(sum / weights);
}

// Gates of 1 km up to where the beam is 19.5 km high: real ones end there or a little higher.
std::size_t GatesOf(double elevation)
{
  const BeamModel beam;
  std::size_t gates = 60;
  while (gates < 260 && beam.Locate(1000.0 * static_cast<double>(gates), elevation).height < 19.5e3)
  {
    ++gates;
  }
  return gates;
}

// What a radar of 0 dBZ sensitivity measures of it, in steps of half a dBZ, in an instant.
PolarVolume Scan(const Anvil& anvil, int pattern)
{
  std::vector<NumberSweep> sweeps;
  double last = -1.0;
  for (const ScanCut& cut : *FindScanStrategy(pattern))
  {
    if (cut.cut.elevation == last)
    {
      continue; // the Doppler half of a split cut
    }
    last = cut.cut.elevation;
    NumberSweep sweep = MakeSweep(static_cast<int>(sweeps.size()) + 1, last, 360, GatesOf(last));
    for (std::size_t ray = 0; ray < sweep.rays.size(); ++ray)
    {
      sweep.rays[ray].time = sceneTime;
      const double sine = std::sin(sweep.rays[ray].azimuth * RadiansPerDegree);
      for (std::size_t gate = 0; gate < sweep.gates; ++gate)
      {
        const double range = sweep.firstGate + sweep.gateSpacing * static_cast<double>(gate);
        const double value = SampleAnvil(anvil, last, sine, range);
        if (value >= 0.0)
        {
          SetGate(sweep, ray, gate, static_cast<float>(0.5 * std::round(2.0 * value)));
        }
      }
    }
    sweeps.push_back(std::move(sweep));
  }
  return VolumeOf(std::move(sweeps));
}

// A strip to the east of the radar, 1 km × 0.25 km.
GridSpecification Strip()
{
  GridSpecification grid;
  grid.dimensions = {211, 5, 80};
  grid.spacing = {1'000.0, 1'000.0, 250.0};
  grid.origin = {0.0, -2'000.0, centralSite.altitude + 125.0};
  grid.centreLatitude = centralSite.latitude;
  grid.centreLongitude = centralSite.longitude;
  return grid;
}

// Errors of the tops along the middle of the strip.
std::vector<Top> ErrorsOf(const Anvil& anvil, const GriddedVolume& volume, double from, double to)
{
  const GridSpecification& grid = volume.grid;
  std::vector<Top> tops;
  for (int x = 0; x < grid.dimensions[0]; ++x)
  {
    const double east = grid.Coordinate(0, x);
    const std::size_t column =
      2u * static_cast<std::size_t>(grid.dimensions[0]) + static_cast<std::size_t>(x);
    const auto top = EchoTop(volume, column);
    if (east >= from && east < to && top)
    {
      tops.push_back({east, *top - centralSite.altitude - anvil.TopAt(east)});
    }
  }
  return tops;
}

struct AnvilCase
{
  const char* name;
  int pattern;
  Anvil anvil;
  double farthest; // m
  double bound;    // m, of the ripple
};

class AnvilTops : public ::testing::TestWithParam<AnvilCase>
{
};

// Bias and ripple over all distances; by distance they are printed.
std::array<double, 2> Measure(const AnvilCase& scene, const PolarVolume& scanned, bool trend)
{
  BeamMergeOptions options;
  options.trend = trend;
  const GriddedVolume merged = MergeAt({scanned}, 0.0, options, Strip());
  std::printf("%-18s %-6s", scene.name, trend ? "trend" : "linear");
  for (double from = 40e3; from < scene.farthest; from += 40e3)
  {
    const auto part = ErrorsOf(scene.anvil, merged, from, std::min(from + 40e3, scene.farthest));
    std::printf("  %3.0f km: %+5.0f, %4.0f", from / 1e3, BiasOf(part), RippleOf(part));
  }
  const std::vector<Top> all = ErrorsOf(scene.anvil, merged, 40e3, scene.farthest);
  const std::array<double, 2> figures = {BiasOf(all), RippleOf(all)};
  std::printf("  all: %+5.0f, %4.0f m (%zu)\n", figures[0], figures[1], all.size());
  EXPECT_AT_LEAST(all.size(), 80u, "columns of the anvil compared");
  return figures;
}

// 1 km × 0.25 km about a radar.
GridSpecification GridAbout(const Position& site)
{
  GridSpecification grid;
  grid.dimensions = {401, 401, 80};
  grid.spacing = {1'000.0, 1'000.0, 250.0};
  grid.origin = {-200'000.0, -200'000.0, site.altitude + 125.0};
  grid.centreLatitude = site.latitude;
  grid.centreLongitude = site.longitude;
  return grid;
}

// Tops along one azimuth, from 55 to 185 km.
std::vector<Top> TopsAlong(const GriddedVolume& volume, double azimuth)
{
  const GridSpecification& grid = volume.grid;
  std::vector<Top> tops;
  for (double distance = 55e3; distance <= 185e3; distance += 1e3)
  {
    const double angle = azimuth * RadiansPerDegree;
    const long x = std::lround((distance * std::sin(angle) - grid.origin[0]) / grid.spacing[0]);
    const long y = std::lround((distance * std::cos(angle) - grid.origin[1]) / grid.spacing[1]);
    const auto top = EchoTop(volume, static_cast<std::size_t>(y * grid.dimensions[0] + x));
    if (top)
    {
      tops.push_back({distance, *top});
    }
  }
  return tops;
}

// Root mean square over the azimuths, about one parabola for all or for each azimuth.
std::array<double, 2> RippleBetween(const GriddedVolume& volume, int from, int to)
{
  std::vector<Top> all;
  double squares = 0.0;
  for (int azimuth = from; azimuth <= to; ++azimuth)
  {
    const std::vector<Top> tops = TopsAlong(volume, azimuth);
    const double ripple = RippleOf(tops);
    squares += ripple * ripple * static_cast<double>(tops.size());
    all.insert(all.end(), tops.begin(), tops.end());
  }
  return {std::sqrt(squares / static_cast<double>(all.size())), RippleOf(all)};
}

} // namespace

TEST_P(AnvilTops, RippleAThirdOfLinear)
{
  const PolarVolume scanned = Scan(GetParam().anvil, GetParam().pattern);
  const auto linear = Measure(GetParam(), scanned, false);
  const auto trend = Measure(GetParam(), scanned, true);
  EXPECT_AT_MOST(trend[1] / linear[1], 1.0 / 3.0,
    "ripple of the anvil's top, part of that of the linear interpolation",
    "one claim for all patterns: a third");
  EXPECT_AT_MOST(trend[1], GetParam().bound, "ripple of the anvil's top, m");
}

INSTANTIATE_TEST_SUITE_P(Patterns, AnvilTops,
  ::testing::Values(AnvilCase{"VCP11flat", 11, {"flat"}, 200e3, 170.0},
    AnvilCase{"VCP21flat", 21, {"flat"}, 200e3, 300.0},
    AnvilCase{"VCP212flat", 212, {"flat"}, 200e3, 190.0},
    AnvilCase{"VCP11sloping", 11, {"sloping", 0.01}, 200e3, 160.0},
    AnvilCase{"VCP21sloping", 21, {"sloping", 0.01}, 200e3, 290.0},
    AnvilCase{"VCP212sloping", 212, {"sloping", 0.01}, 200e3, 130.0},
    AnvilCase{"VCP11ending", 11, {"ending", 0.0, 150e3}, 140e3, 120.0},
    AnvilCase{"VCP21ending", 21, {"ending", 0.0, 150e3}, 140e3, 520.0},
    AnvilCase{"VCP212ending", 212, {"ending", 0.0, 150e3}, 140e3, 170.0}),
  [](const auto& parameter) { return std::string(parameter.param.name); });

TEST(RealAnvil, TopsOfAnAnvilDoNotFollowTheTilts)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  // The tops of the second rise and fall by themselves, between cells.
  for (const auto& [file, bound] :
    {std::pair("KTLX19910605_162126.gz", 400.0), {"KTLX19990503_235621.gz", 600.0}})
  {
    double linear = 0.0;
    const PolarVolume volume =
      MakePolarVolume(ReadLevel2(data / "level2" / "legacy" / file), MomentName::REF);
    const GridSpecification grid = GridAbout(*volume.site.position);
    const Time time = volume.start + (volume.end - volume.start) / 2;
    for (const bool trend : {false, true})
    {
      BeamMergeOptions options;
      options.trend = trend;
      BeamMerger merger(grid, options);
      const auto merged = MergePolar(merger, {&volume}, time, ThreadLoop(2));
      const auto ripple = RippleBetween(*merged, 40, 56);
      std::printf(
        "%s at %s %-6s ripple %4.0f m about a parabola for each azimuth, %4.0f m about one\n", file,
        FormatIso8601(time).c_str(), trend ? "trend" : "linear", ripple[0], ripple[1]);
      if (trend)
      {
        EXPECT_LT(ripple[1], linear);
        EXPECT_AT_MOST(ripple[1], bound, std::string(file) + ": ripple of the anvil's top, m");
      }
      linear = ripple[1];
    }
  }
}
