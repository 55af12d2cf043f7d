// SPDX-License-Identifier: BSD-3-Clause
// What Formulas G9 is worth on real volumes, whose truth nobody knows: each tilt but the lowest and
// the highest is left out in turn, and foretold from the merge of the others.
#include "Geometry/Angles.h"
#include "Gridding/BeamMerge.h"
#include "Level2/Level2File.h"
#include "Model/Elevation.h"
#include "TestData.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

using namespace nexrad;

namespace
{

constexpr double nearest = 20'000.0; // m, of the gates that count: nearer ones see the ground

double ElevationOf(const PolarSweep& sweep)
{
  double sum = 0.0;
  for (const PolarRay& ray : sweep.rays)
  {
    sum += ray.elevation;
  }
  return sum / static_cast<double>(sweep.rays.size());
}

bool IsAt(const PolarSweep& sweep, double tilt)
{
  return std::abs(ElevationOf(sweep) - tilt) < SameTilt;
}

std::vector<double> TiltsOf(const PolarVolume& volume)
{
  std::vector<double> tilts;
  for (const PolarSweep& sweep : volume.sweeps)
  {
    const auto same = [&sweep](double tilt) { return IsAt(sweep, tilt); };
    if (std::none_of(tilts.begin(), tilts.end(), same))
    {
      tilts.push_back(ElevationOf(sweep));
    }
  }
  std::sort(tilts.begin(), tilts.end());
  return tilts;
}

// 180 km about the radar and 18 km high.
GridSpecification GridAbout(const Position& site)
{
  GridSpecification grid;
  grid.dimensions = {241, 241, 72};
  grid.spacing = {1'500.0, 1'500.0, 250.0};
  grid.origin = {-180'000.0, -180'000.0, site.altitude + 125.0};
  grid.centreLatitude = site.latitude;
  grid.centreLongitude = site.longitude;
  return grid;
}

// What a radar in the middle of a grid would see of a volume.
class Foretelling
{
public:
  explicit Foretelling(const GriddedVolume& merged, const Position& site)
    : volume(merged)
    , altitude(site.altitude)
  {
  }

  // The mean of Z over the two-way pattern of the beam, upwards and downwards, dBZ, at least 0.
  // Nothing where the middle of the beam was not seen.
  std::optional<double> GateAt(const PolarRay& ray, double range) const
  {
    const double sigma = 0.95 / std::sqrt(16.0 * std::log(2.0));
    double sum = 0.0;
    double weights = 0.0;
    for (int node = -3; node <= 3; ++node)
    {
      const double off = 0.8 * node; // standard deviations
      const std::optional<double> value =
        this->At(ray.azimuth, beam.Locate(range, ray.elevation + off * sigma));
      if (node == 0 && !value)
      {
        return std::nullopt;
      }
      const double weight = std::exp(-0.5 * off * off);
      sum += value && *value > 0.0 ? weight * std::pow(10.0, *value / 10.0) : 0.0;
      weights += weight;
    }
    return std::max(10.0 * std::log10(std::max(sum / weights, 1.0)), 0.0);
  }

private:
  // The nearest voxel of the column, over the four columns about the point, as no echo is 0 dBZ.
  std::optional<double> At(double azimuth, const BeamPoint& point) const
  {
    const GridSpecification& grid = volume.grid;
    const double angle = azimuth * RadiansPerDegree;
    const double x = (point.groundDistance * std::sin(angle) - grid.origin[0]) / grid.spacing[0];
    const double y = (point.groundDistance * std::cos(angle) - grid.origin[1]) / grid.spacing[1];
    const long z = std::lround((point.height + altitude - grid.origin[2]) / grid.spacing[2]);
    if (z < 0 || z >= grid.dimensions[2])
    {
      return std::nullopt;
    }
    double sum = 0.0;
    for (int corner = 0; corner < 4; ++corner)
    {
      const auto column = static_cast<int>(x) + corner % 2;
      const auto row = static_cast<int>(y) + corner / 2;
      const std::size_t at = grid.VoxelCount() / static_cast<std::size_t>(grid.dimensions[2]) *
                               static_cast<std::size_t>(z) +
                             static_cast<std::size_t>(row * grid.dimensions[0] + column);
      const VoxelState state = volume.states[at];
      if (state != VoxelState::Echo && state != VoxelState::NoEcho)
      {
        return std::nullopt;
      }
      const double weight = (1.0 - std::abs(x - column)) * (1.0 - std::abs(y - row));
      sum += state == VoxelState::Echo ? weight * std::max<double>(volume.values[at], 0.0) : 0.0;
    }
    return sum;
  }

  const GriddedVolume& volume;
  const double altitude;
  const BeamModel beam;
};

struct Score
{
  double squares = 0.0;
  std::size_t gates = 0;
  double sum = 0.0;

  void Add(double foretold, double measured)
  {
    if (std::max(foretold, measured) >= 10.0)
    {
      squares += (foretold - measured) * (foretold - measured);
      sum += foretold - measured;
      ++gates;
    }
  }
  double Rmse() const { return std::sqrt(squares / static_cast<double>(gates)); }
};

void ScoreSweep(const Foretelling& foretelling, const PolarSweep& sweep, Score& score)
{
  constexpr double farthest = 178'000.0; // m, within the grid
  const auto step = static_cast<std::size_t>(std::max(1.0, 1000.0 / sweep.gateSpacing));
  for (std::size_t ray = 0; ray < sweep.rays.size(); ++ray)
  {
    for (std::size_t gate = 0; gate < sweep.gates; gate += step)
    {
      const double range = sweep.firstGate + sweep.gateSpacing * static_cast<double>(gate);
      const std::size_t at = sweep.Index(ray, gate);
      const bool echo = sweep.states[at] == GateState::Valid;
      if (range < nearest || range > farthest ||
          !(echo || sweep.states[at] == GateState::BelowThreshold))
      {
        continue;
      }
      if (const auto foretold = foretelling.GateAt(sweep.rays[ray], range))
      {
        score.Add(*foretold, echo ? std::max<double>(sweep.values[at], 0.0) : 0.0);
      }
    }
  }
}

Score LeaveTiltsOut(const PolarVolume& whole, bool sharpen)
{
  const std::vector<double> tilts = TiltsOf(whole);
  BeamMergeOptions options;
  options.sharpen = sharpen;
  BeamMerger merger(GridAbout(*whole.site.position), options);
  Score score;
  for (std::size_t tilt = 1; tilt + 1 < tilts.size(); ++tilt)
  {
    PolarVolume others = whole;
    const PolarSweep* left = nullptr;
    others.sweeps.clear();
    for (const PolarSweep& sweep : whole.sweeps)
    {
      if (!IsAt(sweep, tilts[tilt]))
      {
        others.sweeps.push_back(sweep);
      }
      else if (left == nullptr) // of a split cut, the surveillance half comes first
      {
        left = &sweep;
      }
    }
    others.start += Duration(static_cast<Duration::rep>(tilt)); // not the volume that was kept
    const auto merged = merger.Merge({&others}, others.start, ThreadLoop(2));
    ScoreSweep(Foretelling(*merged, *whole.site.position), *left, score);
  }
  return score;
}

struct RealVolume
{
  const char* file;
  double largest; // of the RMSE with sharpening, as a part of that without
};

class LeftOutTilt : public ::testing::TestWithParam<RealVolume>
{
};

} // namespace

TEST_P(LeftOutTilt, IsForetoldBetterBySharpenedTilts)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  const PolarVolume volume =
    MakePolarVolume(ReadLevel2(data / "level2" / GetParam().file), MomentName::REF);
  const Score measured = LeaveTiltsOut(volume, false);
  const Score sharpened = LeaveTiltsOut(volume, true);
  for (const auto& [name, score] : {std::pair("as measured", measured), {"sharpened", sharpened}})
  {
    std::printf("%s %-11s RMSE %5.2f dBZ  bias %+5.2f dBZ  (%zu gates)\n", volume.site.name.c_str(),
      name, score.Rmse(), score.sum / static_cast<double>(score.gates), score.gates);
  }
  EXPECT_GT(measured.gates, 10'000u);
  EXPECT_LT(sharpened.Rmse(), GetParam().largest * measured.Rmse());
}

// The last has shallow echo, in the two lowest tilts and next to none above: with one of them left
// out there is no slope to know, and the row must do no harm.
INSTANTIATE_TEST_SUITE_P(Volumes, LeftOutTilt,
  ::testing::Values(RealVolume{"run-kbgm-20050821/KBGM20050821_025458.gz", 0.99},
    RealVolume{"legacy/KTLX19990503_235621.gz", 0.97},
    RealVolume{"superres/KBLX20090603_004417_V03.gz", 0.98},
    RealVolume{"multisite-20100911/KENX20100911_011108_V03.gz", 1.01}),
  [](const auto& parameter)
  {
    const std::string file = parameter.param.file;
    return file.substr(file.find('/') + 1, 4);
  });
