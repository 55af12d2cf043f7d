// SPDX-License-Identifier: BSD-3-Clause
#include "Tolerance.h"
#include "nexrad/Geometry/Angles.h"
#include "nexrad/Geometry/Beam.h"
#include "nexrad/Model/SiteTable.h"
#include "nexrad/Simulation/BeamSampler.h"
#include "nexrad/Simulation/StormField.h"

#include <GeographicLib/Geodesic.hpp>
#include <gtest/gtest.h>

#include <cmath>

using namespace nexrad;

namespace
{

// Formulas B1 as a textbook has it, for an atmosphere of effective radius factor k.
double HeightByFormula(double range, double elevation, double factor)
{
  const double radius = factor * 6'371'000.0;
  return std::sqrt(range * range + radius * radius +
                   2.0 * range * radius * std::sin(elevation * RadiansPerDegree)) -
         radius;
}

// The mean of Z over the beam by brute force: directions on a fine square lattice over ±3 standard
// deviations of the two-way pattern, five ranges in the gate, and the geometry of BeamModel.
double BruteForceMean(const StormSnapshot& snapshot, const Position& site, double azimuth,
  double elevation, double range, double spacing)
{
  constexpr int half = 9;
  const double sigma = 0.95 / std::sqrt(16.0 * std::log(2.0));
  const double step = 3.0 * sigma / half;
  double sum = 0.0;
  double weights = 0.0;
  for (int up = -half; up <= half; ++up)
  {
    for (int side = -half; side <= half; ++side)
    {
      const double weight =
        std::exp(-0.5 * (up * up + side * side) * step * step / (sigma * sigma));
      for (int part = 0; part < 5; ++part)
      {
        const double distance = range + spacing * ((part + 0.5) / 5.0 - 0.5);
        const BeamPoint point = BeamModel().Locate(distance, elevation + up * step);
        double latitude = 0.0;
        double longitude = 0.0;
        GeographicLib::Geodesic::WGS84().Direct(site.latitude, site.longitude,
          azimuth + side * step / std::cos(elevation * RadiansPerDegree), point.groundDistance,
          latitude, longitude);
        const double value = snapshot.Reflectivity(
          StormPlane::FromGeographic(longitude, latitude, point.height + site.altitude));
        sum += weight * std::pow(10.0, value / 10.0);
        weights += weight;
      }
    }
  }
  return 10.0 * std::log10(sum / weights);
}

} // namespace

TEST(RefractedPath, FollowsTheEffectiveEarth)
{
  for (const double factor : {4.0 / 3.0, 1.21})
  {
    const RefractedPath path(factor, -0.5, 20.5, 300'000.0);
    for (const double elevation : {0.5, 1.45, 6.0, 19.5})
    {
      for (double range = 0.0; range <= 230'000.0; range += 5'300.0)
      {
        const PathPoint point = path.At(range, elevation);
        if (point.height < 18'000.0)
        {
          // The formula is an approximation of the traced ray, good to some tens of metres.
          EXPECT_WITHIN(point.height, HeightByFormula(range, elevation, factor), 1.3,
            "height of the traced ray, m");
          EXPECT_WITHIN(point.groundDistance,
            BeamModel(factor).Locate(range, elevation).groundDistance, 60.0,
            "distance of the traced ray along the ground, m");
        }
      }
    }
  }
}

TEST(RefractedPath, IsStraightWithoutRefraction)
{
  const RefractedPath path(1.0, 0.0, 2.0, 200'000.0);
  constexpr double radius = 6'371'000.0;
  for (double range = 10'000.0; range <= 190'000.0; range += 17'300.0)
  {
    const double up = radius + range * std::sin(1.0 * RadiansPerDegree);
    const double out = range * std::cos(1.0 * RadiansPerDegree);
    const PathPoint point = path.At(range, 1.0);
    EXPECT_WITHIN(
      point.height, std::hypot(up, out) - radius, 0.038, "height of the straight ray, m");
    EXPECT_WITHIN(point.groundDistance, radius * std::atan2(out, up), 0.003,
      "distance of the straight ray along the ground, m");
  }
}

// At 0.5 degrees and 230 km the beam stands at 5119 m with 4/3 and 5436 m with 1.21 (by B1).
TEST(RefractedPath, RefractionMovesTheBeam)
{
  const RefractedPath standard(4.0 / 3.0, 0.0, 1.0, 240'000.0);
  const RefractedPath weaker(1.21, 0.0, 1.0, 240'000.0);
  EXPECT_WITHIN(
    standard.At(230'000.0, 0.5).height, 5'119.0, 0.11, "height of the handbook's beam, m");
  EXPECT_WITHIN(weaker.At(230'000.0, 0.5).height, HeightByFormula(230'000.0, 0.5, 1.21), 0.5,
    "height of the beam at k = 1.21, m");
  EXPECT_AT_LEAST(weaker.At(230'000.0, 0.5).height - standard.At(230'000.0, 0.5).height, 250.0,
    "height that a weaker refraction adds, m");
}

TEST(BeamSampler, CentreLiesOnTheGeodesic)
{
  const Position site = FindSite("KLSX")->position;
  BeamSampler beam(site, 0.5, 460'000.0, {});
  const RefractedPath path(4.0 / 3.0, 0.0, 1.0, 460'000.0);
  for (const double azimuth : {0.0, 77.0, 181.5, 300.0})
  {
    beam.Point(azimuth, 0.5);
    for (const double range : {500.0, 40'000.0, 150'000.0, 300'000.0, 455'000.0})
    {
      const PathPoint point = path.At(range, 0.5);
      double latitude = 0.0;
      double longitude = 0.0;
      GeographicLib::Geodesic::WGS84().Direct(
        site.latitude, site.longitude, azimuth, point.groundDistance, latitude, longitude);
      const PlanePoint truth = StormPlane::FromGeographic(longitude, latitude, 0.0);
      const PlanePoint place = beam.Trace().Centre(range);
      EXPECT_WITHIN(place.x, truth.x, 0.17, "place of the beam's centre along x, m")
        << azimuth << ' ' << range;
      EXPECT_WITHIN(place.y, truth.y, 0.17, "place of the beam's centre along y, m")
        << azimuth << ' ' << range;
    }
  }
}

TEST(BeamSampler, AgreesWithBruteForce)
{
  const Position site = FindSite("KLSX")->position;
  const StormSnapshot snapshot = StormField().At(*ParseIso8601("2006-03-12T18:10"));
  double squares = 0.0;
  int count = 0;
  double worst = 0.0;
  for (const double elevation : {0.48, 2.4, 6.0})
  {
    BeamSampler beam(site, elevation, 231'000.0, {});
    std::vector<double> gates;
    for (double azimuth = 4.0; azimuth < 360.0; azimuth += 19.0)
    {
      const GateLayout layout{231, 0, 1'000};
      beam.Point(azimuth, elevation);
      beam.Sample(snapshot, layout, gates);
      for (int gate = 7; gate < layout.gates; gate += 13)
      {
        const double sampled = gates[static_cast<std::size_t>(gate)];
        const double truth =
          BruteForceMean(snapshot, site, azimuth, elevation, layout.Range(gate), 1'000.0);
        if (truth > 5.0)
        {
          const double error = sampled - truth;
          squares += error * error;
          worst = std::max(worst, std::abs(error));
          ++count;
        }
        else
        {
          EXPECT_AT_MOST(sampled, 8.0, "sampled value where brute force sees none, dBZ");
        }
      }
    }
  }
  ASSERT_AT_LEAST(count, 100, "gates compared");
  const double rootMeanSquare = std::sqrt(squares / count);
  std::printf(
    "%d gates over 5 dBZ: RMS error %.2f dB, worst %.2f dB\n", count, rootMeanSquare, worst);
  EXPECT_AT_MOST(rootMeanSquare, 0.4, "RMS error of the samples, dB");
  EXPECT_AT_MOST(worst, 1.5, "largest error of the samples, dB");
}

TEST(BeamSampler, SeesNothingWhereNothingIs)
{
  BeamSampler beam(FindSite("KLSX")->position, 10.0, 100'000.0, {});
  std::vector<double> gates;
  beam.Point(10.0, 10.0);
  beam.Sample(StormSnapshot({}, {}, 0.0), {100, 0, 1'000}, gates);
  EXPECT_TRUE(std::isfinite(gates[5])); // clear air, 1 km above the antenna
  EXPECT_FALSE(std::isfinite(gates[40]));
}
