// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Simulation/StormPlane.h"
#include "nexrad/Simulation/StormWind.h"

#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace nexrad
{

constexpr double SecondsPerDay = 86'400.0;

/// Reflectivity where there is no echo, dBZ.
constexpr double NoReflectivity = -std::numeric_limits<double>::infinity();

/// Weakest reflectivity that the field has; what is weaker is no echo, dBZ.
constexpr double MinimumReflectivity = -15.0;

/// Most that the texture adds or takes away, dB.
constexpr double TextureAmplitude = 3.5;

/// What the bright band adds to the rain below it, dB.
constexpr double BrightBandGain = 6.0;

/// How an element's reflectivity changes with height.
enum class VerticalProfile
{
  Tower,     ///< constant up to `level`, then falling with the square of the height above it
  Layer,     ///< falling with the square of the height above or below `level`
  Stratiform ///< constant below the melting level `level`, a bright band there, linear above
};

/// One piece of a storm at one instant, in closed form: a peak in dBZ, less a drop that grows with
/// the normalised distance from a (tilted) axis, less a drop with height. A drop quadratic in dB is
/// a Gaussian in Z. A supercell is made of about a dozen.
struct StormElement
{
  double x = 0.0; ///< m, axis at height `level`
  double y = 0.0;
  double alongX = 1.0; ///< unit vector of the long half-axis
  double alongY = 0.0;
  double longAxis = 1.0;  ///< m, where the reflectivity has dropped by `edge`
  double shortAxis = 1.0; ///< m
  double tiltX = 0.0;     ///< m of shift of the axis a metre of height
  double tiltY = 0.0;
  double peak = 0.0;    ///< dBZ
  double edge = 12.0;   ///< dB lost at one half-axis
  bool plateau = false; ///< the drop grows with the fourth power, not the second: flat, steep edges
  VerticalProfile profile = VerticalProfile::Tower;
  double level = 0.0; ///< m, see VerticalProfile
  double depth = 1.0; ///< m, height over which `profile` loses `fall`
  double fall = 40.0; ///< dB

  /// Reflectivity in dBZ before texture; below MinimumReflectivity it does not count as echo.
  double Reflectivity(const PlanePoint& point) const
  {
    const double above = point.z - level;
    const double east = point.x - x - tiltX * above;
    const double north = point.y - y - tiltY * above;
    const double along = (east * alongX + north * alongY) / longAxis;
    const double across = (north * alongX - east * alongY) / shortAxis;
    const double distance = along * along + across * across;
    const double value = peak - edge * (plateau ? distance * distance : distance);
    // The vertical part is dearer, and adds at most the bright band.
    return value + BrightBandGain < MinimumReflectivity ? value
                                                        : value - this->VerticalDrop(point.z);
  }

private:
  double VerticalDrop(double z) const;
};

/// An upright box, turned along an element's axes, outside of which the element holds no echo.
struct ElementBounds
{
  double x, y;           ///< m, middle
  double alongX, alongY; ///< unit vector
  double halfLength;     ///< m, along that; negative: the element holds no echo at all
  double halfWidth;      ///< m, across
  double bottom, top;    ///< m above mean sea level

  /// False when no point of the cylinder lies in the box.
  bool Touch(const Cylinder& cylinder) const
  {
    const double east = cylinder.x - x;
    const double north = cylinder.y - y;
    return bottom <= cylinder.top && top >= cylinder.bottom &&
           std::abs(east * alongX + north * alongY) <= halfLength + cylinder.radius &&
           std::abs(north * alongX - east * alongY) <= halfWidth + cylinder.radius;
  }
};
ElementBounds BoundsOf(const StormElement& element);

/// The storm field at one instant.
class StormSnapshot
{
public:
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

  /// Numbers of the vortices that reach into a cylinder.
  void FindVortices(const Cylinder& within, std::vector<int>& found) const;
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
