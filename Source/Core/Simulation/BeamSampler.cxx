// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Simulation/BeamSampler.h"

#include "nexrad/Geometry/Angles.h"
#include "nexrad/Simulation/BeamTrace.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>

namespace nexrad
{

namespace
{

constexpr double partLength = 40'000.0; // m, over which storms are looked for first
constexpr double blockLength = 4'000.0; // m, over which they are looked for among those

double ToZ(double decibel)
{
  constexpr double perDecibel = 0.23025850929940457; // ln(10)/10
  return std::exp(perDecibel * decibel);
}

// Sums over the beam: of Z, and of Z times the first and the second power of the elevation above
// the beam's middle.
struct SpreadSums
{
  double z = 0.0;
  double first = 0.0;
  double second = 0.0;

  void AddMoments(double position, double share)
  {
    first += position * share;
    second += position * position * share;
  }
  void Finish(EchoSpread& spread) const
  {
    if (z > 0.0)
    {
      const double lift = first / z;
      spread.lift = static_cast<float>(lift);
      spread.width = static_cast<float>(std::sqrt(std::max(second / z - lift * lift, 0.0)));
    }
  }
};

} // namespace

double BeamSampler::MeanStormZ(
  const StormSnapshot& snapshot, double range, double offset, EchoSpread& spread) const
{
  const double middle = trace.At(range, trace.Elevation()).groundDistance;
  const BeamTrace::GateTracks straight = trace.TracksAt(middle);
  const auto& layers = LayerNodes();
  SpreadSums sums;
  for (std::size_t up = 0; up < layers.size(); ++up)
  {
    const double direction = trace.Elevation() + layers[up].position * trace.Sigma();
    const std::array<PathPoint, 2> ends = {
      trace.At(range - offset, direction), trace.At(range + offset, direction)};
    const double before = sums.z;
    for (std::size_t side = 0; side < straight.size(); ++side)
    {
      // The two ranges take turns, like the colours of a chessboard.
      const PathPoint& point = ends[(up + side) % 2];
      const PlanePoint place =
        straight[side].At(point.groundDistance - middle, point.height + trace.SiteAltitude());
      const double share = layers[up].weight * SmoothNodes[side].weight *
                           ToZ(snapshot.Reflectivity(place, candidates));
      spread.shares[up][side] = static_cast<float>(share);
      sums.z += share;
    }
    sums.AddMoments(layers[up].position, sums.z - before);
  }
  sums.Finish(spread);
  spread.bySide = sums.z > 0.0;
  return sums.z;
}

double BeamSampler::MeanClearAirZ(
  const StormSnapshot& snapshot, double range, EchoSpread& spread) const
{
  SpreadSums sums;
  for (const QuadratureNode& up : SmoothNodes)
  {
    const PathPoint point = trace.At(range, trace.Elevation() + up.position * trace.Sigma());
    const double z = up.weight * ToZ(snapshot.Reflectivity(trace.Place(point), candidates));
    sums.z += z;
    sums.AddMoments(up.position, z);
  }
  sums.Finish(spread);
  return sums.z;
}

void BeamSampler::SampleBlock(const StormSnapshot& snapshot, const GateLayout& layout, int first,
  int end, std::vector<double>& reflectivity)
{
  const double half = layout.gateSpacing / 2.0;
  const Cylinder reach =
    trace.Span(std::max(layout.Range(first) - half, 0.0), layout.Range(end - 1) + half);
  snapshot.FindElements(reach, nearby, candidates);
  if (candidates.empty() && reach.bottom > StormSnapshot::ClearAirTop())
  {
    return;
  }
  for (int gate = first; gate < end; ++gate)
  {
    // The antenna itself is the nearest that a gate reaches.
    const double range = std::max(layout.Range(gate), half);
    EchoSpread& spread = spreads[static_cast<std::size_t>(gate)];
    const double z = candidates.empty() ? this->MeanClearAirZ(snapshot, range, spread)
                                        : this->MeanStormZ(snapshot, range, half / Root3, spread);
    reflectivity[static_cast<std::size_t>(gate)] = z > 0.0 ? 10.0 * std::log10(z) : NoReflectivity;
  }
}

void BeamSampler::Sample(
  const StormSnapshot& snapshot, const GateLayout& layout, std::vector<double>& reflectivity)
{
  reflectivity.assign(static_cast<std::size_t>(layout.gates), NoReflectivity);
  spreads.assign(static_cast<std::size_t>(layout.gates), {});
  const int partGates = std::max(1, static_cast<int>(partLength / layout.gateSpacing));
  const int blockGates = std::max(1, static_cast<int>(blockLength / layout.gateSpacing));
  for (int part = 0; part < layout.gates; part += partGates)
  {
    const int end = std::min(part + partGates, layout.gates);
    const Cylinder reach =
      trace.Span(std::max(layout.Range(part) - layout.gateSpacing, 0.0), layout.Range(end));
    snapshot.FindElements(reach, nearby);
    if (nearby.empty() && reach.bottom > StormSnapshot::ClearAirTop())
    {
      continue;
    }
    for (int first = part; first < end; first += blockGates)
    {
      this->SampleBlock(snapshot, layout, first, std::min(first + blockGates, end), reflectivity);
    }
  }
}

namespace
{

constexpr double windBlockLength = 4'000.0; // m, over which storms are looked for together
constexpr int blocksOfPart = 10;            // over which they are looked for first
constexpr double closeRadii = 1.5; // core radii from an axis within which the beam is averaged

// Mean and spread of weighted velocities, from their sums.
struct VelocitySums
{
  double weight = 0.0;
  double first = 0.0;
  double second = 0.0;

  void Add(double share, double velocity)
  {
    weight += share;
    first += share * velocity;
    second += share * velocity * velocity;
  }
  BeamVelocity Moments() const
  {
    const double mean = first / weight;
    return {mean, std::sqrt(std::max(second / weight - mean * mean, 0.0))};
  }
};

} // namespace

VelocitySampler::VelocitySampler(const BeamTrace& trace, const StormSnapshot& snapshot)
  : beam(trace)
  , storms(snapshot)
{
  for (std::size_t side = 0; side < headings.size(); ++side)
  {
    const double azimuth = trace.Azimuth() + SmoothNodes[side].position * trace.Sigma() /
                                               std::cos(trace.Elevation() * RadiansPerDegree);
    headings[side] = {std::sin(azimuth * RadiansPerDegree), std::cos(azimuth * RadiansPerDegree)};
  }
  for (std::size_t up = 0; up < levels.size(); ++up)
  {
    levels[up] =
      std::cos((trace.Elevation() + LayerNodes()[up].position * trace.Sigma()) * RadiansPerDegree);
  }
}

void VelocitySampler::EnterBlock(int number)
{
  block = number;
  if (number / blocksOfPart != part)
  {
    part = number / blocksOfPart;
    constexpr double partLength = blocksOfPart * windBlockLength;
    storms.FindVortices(beam.Span(part * partLength, (part + 1) * partLength), nearby);
  }
  vortices.clear();
  isClose = false;
  if (nearby.empty())
  {
    return;
  }
  const Cylinder reach = beam.Span(number * windBlockLength, (number + 1) * windBlockLength);
  std::copy_if(nearby.begin(), nearby.end(), std::back_inserter(vortices),
    [&](int index)
    {
      const StormVortex& vortex = storms.Vortices()[static_cast<std::size_t>(index)];
      return vortex.Touches(reach, StormVortex::Reach);
    });
  isClose = std::any_of(vortices.begin(), vortices.end(),
    [&](int index)
    {
      const StormVortex& vortex = storms.Vortices()[static_cast<std::size_t>(index)];
      return vortex.Touches(reach, closeRadii * vortex.RadiusAt(reach.top));
    });
}

BeamVelocity VelocitySampler::AtCentre(double range, const EchoSpread& echo) const
{
  const double direction = beam.Elevation() + echo.lift * beam.Sigma();
  const double level = std::cos(direction * RadiansPerDegree);
  const PathPoint point = beam.At(range, direction);
  const double height = point.height + beam.SiteAltitude();
  const WindVector mean = MeanWind(height);
  WindVector wind = mean;
  if (!vortices.empty())
  {
    const PlanePoint place = beam.Place(point);
    for (const int index : vortices)
    {
      storms.Vortices()[static_cast<std::size_t>(index)].AddTo(wind, place);
    }
  }
  // What changes in the beam is the mean wind with height, and its component with the azimuth.
  const double rise = echo.width * beam.Sigma() * RadiansPerDegree * range * level;
  const WindVector above = MeanWind(height + rise);
  const WindVector below = MeanWind(height - rise);
  const Heading& ahead = headings[1];
  const double upwards =
    level * (ahead.east * (above.east - below.east) + ahead.north * (above.north - below.north)) /
    2.0;
  const double sideways =
    beam.Sigma() * RadiansPerDegree * (ahead.north * mean.east - ahead.east * mean.north);
  return {level * (ahead.east * wind.east + ahead.north * wind.north),
    std::sqrt(upwards * upwards + sideways * sideways)};
}

std::array<WindVector, 3> VelocitySampler::WindsAcross(
  const std::array<PlanePoint, 3>& places, double height) const
{
  const WindVector mean = MeanWind(height);
  std::array<WindVector, 3> winds = {mean, mean, mean};
  for (const int index : vortices)
  {
    const VortexSlice slice = storms.Vortices()[static_cast<std::size_t>(index)].At(height);
    if (slice.IsStill())
    {
      continue;
    }
    for (std::size_t side = 0; side < winds.size(); ++side)
    {
      slice.AddTo(winds[side], places[side].x, places[side].y);
    }
  }
  return winds;
}

BeamVelocity VelocitySampler::OverBeam(double range, const EchoSpread& echo) const
{
  const double middle = beam.At(range, beam.Elevation()).groundDistance;
  const BeamTrace::GateTracks straight = beam.TracksAt(middle);
  const auto& layers = LayerNodes();
  VelocitySums sums;
  for (std::size_t up = 0; up < layers.size(); ++up)
  {
    const PathPoint point = beam.At(range, beam.Elevation() + layers[up].position * beam.Sigma());
    const double forward = point.groundDistance - middle;
    const double height = point.height + beam.SiteAltitude();
    std::array<PlanePoint, 3> places;
    for (std::size_t side = 0; side < places.size(); ++side)
    {
      places[side] = straight[side].At(forward, height);
    }
    const std::array<WindVector, 3> winds = this->WindsAcross(places, height);
    for (std::size_t side = 0; side < winds.size(); ++side)
    {
      sums.Add(static_cast<double>(echo.shares[up][side]),
        levels[up] *
          (headings[side].east * winds[side].east + headings[side].north * winds[side].north));
    }
  }
  return sums.Moments();
}

BeamVelocity VelocitySampler::Sample(double range, const EchoSpread& echo)
{
  const int number = std::max(static_cast<int>(range / windBlockLength), 0);
  if (number != block)
  {
    this->EnterBlock(number);
  }
  return isClose && echo.bySide ? this->OverBeam(range, echo) : this->AtCentre(range, echo);
}

} // namespace nexrad
