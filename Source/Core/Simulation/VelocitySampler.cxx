// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Simulation/VelocitySampler.h"

#include "nexrad/Simulation/Beam/BeamPattern.h"

#include <algorithm>
#include <cmath>

namespace nexrad
{

namespace
{

constexpr double degree = 3.14159265358979323846 / 180.0;
constexpr double blockLength = 4'000.0; // m, over which storms are looked for together
constexpr double closeRadii = 2.0;      // core radii from an axis within which the beam is averaged

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
                                               std::cos(trace.Elevation() * degree);
    headings[side] = {std::sin(azimuth * degree), std::cos(azimuth * degree)};
  }
  for (std::size_t up = 0; up < levels.size(); ++up)
  {
    levels[up] = std::cos((trace.Elevation() + LayerNodes()[up].position * trace.Sigma()) * degree);
  }
}

void VelocitySampler::EnterBlock(int number)
{
  block = number;
  const Cylinder reach = beam.Span(number * blockLength, (number + 1) * blockLength);
  storms.FindVortices(reach, StormVortex::Reach, vortices);
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
  const double level = std::cos(direction * degree);
  const PathPoint point = beam.At(range, direction);
  const double height = point.height + beam.SiteAltitude();
  const WindVector mean = MeanWind(height);
  const WindVector wind = vortices.empty() ? mean : storms.Wind(beam.Place(point), vortices);
  // What changes in the beam is the mean wind with height, and its component with the azimuth.
  const double rise = echo.width * beam.Sigma() * degree * range * level;
  const WindVector above = MeanWind(height + rise);
  const WindVector below = MeanWind(height - rise);
  const Heading& ahead = headings[1];
  const double upwards =
    level * (ahead.east * (above.east - below.east) + ahead.north * (above.north - below.north)) /
    2.0;
  const double sideways =
    beam.Sigma() * degree * (ahead.north * mean.east - ahead.east * mean.north);
  return {level * (ahead.east * wind.east + ahead.north * wind.north),
    std::sqrt(upwards * upwards + sideways * sideways)};
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
    for (std::size_t side = 0; side < straight.size(); ++side)
    {
      const BeamTrace::StraightTrack& track = straight[side];
      const PlanePoint place{track.start.x + forward * track.x, track.start.y + forward * track.y,
        point.height + beam.SiteAltitude()};
      const WindVector wind = storms.Wind(place, vortices);
      sums.Add(static_cast<double>(echo.shares[up][side]),
        levels[up] * (headings[side].east * wind.east + headings[side].north * wind.north));
    }
  }
  return sums.Moments();
}

BeamVelocity VelocitySampler::Sample(double range, const EchoSpread& echo)
{
  const int number = std::max(static_cast<int>(range / blockLength), 0);
  if (number != block)
  {
    this->EnterBlock(number);
  }
  return isClose && echo.bySide ? this->OverBeam(range, echo) : this->AtCentre(range, echo);
}

} // namespace nexrad
