// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Simulation/StormElement.h"
#include "nexrad/Simulation/StormVortex.h"

#include <array>
#include <vector>

namespace nexrad
{

/// The storm field at one instant.
class StormSnapshot
{
public:
  StormSnapshot() = default;
  /// `seconds` after midnight UTC: the texture drifts with the storms, and repeats after a day.
  StormSnapshot(
    std::vector<StormElement> elements, std::vector<StormVortex> vortices, double seconds);

  /// Numbers of the elements that can hold echo in a cylinder.
  void FindElements(const Cylinder& within, std::vector<int>& found) const;
  /// Those of them that are among the elements found in a larger cylinder.
  void FindElements(
    const Cylinder& within, const std::vector<int>& among, std::vector<int>& found) const;

  /// dBZ; -infinity where there is no echo.
  double Reflectivity(const PlanePoint& point) const;
  /// The same, where only these elements (of FindElements) can reach.
  double Reflectivity(const PlanePoint& point, const std::vector<int>& candidates) const;

  /// The wind at a point: MeanWind and what the storms add to it.
  WindVector Wind(const PlanePoint& point) const;
  /// Adds to the wind at a point what these vortices (of FindVortices) add.
  void AddVortices(WindVector& wind, const PlanePoint& point, const std::vector<int>& among) const;
  /// Numbers of the vortices with an axis within a distance in m of a cylinder.
  void FindVortices(const Cylinder& within, double distance, std::vector<int>& found) const;
  const std::vector<StormVortex>& Vortices() const { return vortices; }

  /// Height above which there is no clear-air return, m.
  static double ClearAirTop();
  /// Strongest clear-air return, dBZ: always below 0.
  static double ClearAirMaximum();

private:
  std::vector<StormElement> elements;
  std::vector<ElementBounds> bounds;
  std::vector<StormVortex> vortices;
  std::array<double, 3> texturePhases{}; // turns

  double Texture(const PlanePoint& point) const;
};

} // namespace nexrad
