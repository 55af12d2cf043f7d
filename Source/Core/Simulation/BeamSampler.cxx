// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Simulation/BeamSampler.h"

#include "nexrad/Simulation/BeamPattern.h"
#include "nexrad/Simulation/GateLayout.h"

#include <algorithm>
#include <array>
#include <cmath>
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
      const double forward = point.groundDistance - middle;
      const BeamTrace::StraightTrack& track = straight[side];
      const PlanePoint place{track.start.x + forward * track.x, track.start.y + forward * track.y,
        point.height + trace.SiteAltitude()};
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

} // namespace nexrad
