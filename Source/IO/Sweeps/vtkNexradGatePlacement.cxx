// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNexradGatePlacement.h"

#include "nexrad/System/Error.h"

#include "vtkMath.h"

#include <algorithm>
#include <cmath>

namespace
{

constexpr double NodeSpacing = 20'000.0; // m

// Node k stands at (k - 1) * NodeSpacing, so that a cubic has a node on either side of its piece.
std::array<double, 2> Interpolate(
  const std::vector<std::array<double, 2>>& nodes, double groundDistance)
{
  const double position = groundDistance / NodeSpacing;
  const auto piece = static_cast<std::size_t>(
    std::clamp(std::floor(position), 0.0, static_cast<double>(nodes.size()) - 4.0));
  const double t = position - static_cast<double>(piece);
  // Lagrange's polynomials on -1, 0, 1, 2.
  const std::array<double, 4> weights = {-t * (t - 1.0) * (t - 2.0) / 6.0,
    (t + 1.0) * (t - 1.0) * (t - 2.0) / 2.0, -(t + 1.0) * t * (t - 2.0) / 2.0,
    (t + 1.0) * t * (t - 1.0) / 6.0};
  std::array<double, 2> result = {0.0, 0.0};
  for (std::size_t i = 0; i < weights.size(); ++i)
  {
    result[0] += weights[i] * nodes[piece + i][0];
    result[1] += weights[i] * nodes[piece + i][1];
  }
  return result;
}

} // namespace

vtkNexradGatePlacement::vtkNexradGatePlacement(const nexrad::Site& theSite,
  vtkNexradCoordinates theCoordinates, const std::optional<std::array<double, 2>>& center,
  double effectiveRadiusFactor)
  : beam(effectiveRadiusFactor)
  , coordinates(theCoordinates)
{
  if (coordinates != vtkNexradCoordinates::Local && !theSite.position)
  {
    throw nexrad::Error("the position of site \"" + theSite.name +
                        "\" is unknown: set it, or ask for local coordinates");
  }
  site = theSite.position.value_or(nexrad::Position{});
  projection.centreLatitude = center ? (*center)[0] : site.latitude;
  projection.centreLongitude = center ? (*center)[1] : site.longitude;
}

vtkNexradGatePlacement::Nodes vtkNexradGatePlacement::MakeNodes(
  double azimuth, double farthest) const
{
  const nexrad::SiteGeoreference ground(site);
  const auto count = static_cast<std::size_t>(std::max(0.0, farthest) / NodeSpacing) + 4;
  Nodes nodes(count);
  for (std::size_t k = 0; k < count; ++k)
  {
    // Behind the antenna the geodesic goes on at the opposite azimuth.
    const double distance = (static_cast<double>(k) - 1.0) * NodeSpacing;
    const std::array<double, 2> place =
      distance < 0.0 ? ground.Locate({std::fmod(azimuth + 180.0, 360.0), -distance})
                     : ground.Locate({azimuth, distance});
    if (coordinates == vtkNexradCoordinates::Projected)
    {
      nodes[k] = projection.FromGeographic(place[0], place[1]);
    }
    else
    {
      // Longitudes count on across the antimeridian.
      nodes[k] = {site.longitude + std::remainder(place[0] - site.longitude, 360.0), place[1]};
    }
  }
  return nodes;
}

void vtkNexradGatePlacement::PlaceRay(
  const nexrad::Ray& ray, double firstGate, double spacing, std::size_t gates, double* points) const
{
  const bool local = coordinates == vtkNexradCoordinates::Local;
  const double lastGate = firstGate + spacing * static_cast<double>(gates);
  const Nodes nodes = local ? Nodes() : this->MakeNodes(ray.azimuth, lastGate);
  const double azimuth = vtkMath::RadiansFromDegrees(static_cast<double>(ray.azimuth));
  const double east = std::sin(azimuth);
  const double north = std::cos(azimuth);
  for (std::size_t gate = 0; gate < gates; ++gate, points += 3)
  {
    const nexrad::BeamPoint point =
      beam.Locate(firstGate + spacing * static_cast<double>(gate), ray.elevation);
    const std::array<double, 2> place =
      local ? std::array<double, 2>{point.groundDistance * east, point.groundDistance * north}
            : Interpolate(nodes, point.groundDistance);
    points[0] = place[0];
    points[1] = place[1];
    points[2] = local ? point.height : site.altitude + point.height;
  }
}
