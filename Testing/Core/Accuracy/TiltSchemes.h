// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "SweepMaker.h"
#include "nexrad/Geometry/Beam.h"
#include "nexrad/Gridding/BeamMerge.h"

#include <array>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace nexrad
{

/// Reflectivity over one place as a function of the elevation in degrees: dBZ at least 0, in which
/// no echo is 0 dBZ; nothing where the place was not seen.
using ElevationProfile = std::function<std::optional<double>(double elevation)>;

/// A way to tell the reflectivity between the tilts of a volume.
class TiltScheme
{
public:
  virtual ~TiltScheme() = default;

  /// The profile at an azimuth in degrees and a slant range in m.
  virtual ElevationProfile ProfileAt(double azimuth, double range) const = 0;
};

/// What a gate measured: dBZ at least 0, 0 below threshold; nothing in other states.
std::optional<double> MeasuredAt(
  const testing::NumberSweep& sweep, std::size_t ray, std::size_t gate);

/// One sweep of each tilt with its rays in the order of azimuth.
class SortedTilt
{
public:
  explicit SortedTilt(const PolarSweep& sweep);

  /// Azimuth in degrees, from −180 to 540 so that every direction has both its sides, and the ray.
  using Ray = std::pair<double, std::size_t>;
  const Ray& Nearest(double azimuth) const;
  /// Calls `visit` with the rays within `window` degrees.
  void Visit(double azimuth, double window, const std::function<void(const Ray&)>& visit) const;

  /// What the gates of a ray measured, as MeasuredAt gives it, but NaN for nothing.
  const float* Gates(std::size_t ray) const { return measured.data() + sweep.Index(ray, 0); }

  testing::NumberSweep sweep;
  double elevation; ///< degrees

private:
  std::vector<float> measured;
  std::vector<Ray> rays;
};

/// The nearest gate of all tilts.
class NearestScheme : public TiltScheme
{
public:
  explicit NearestScheme(const std::vector<SortedTilt>& tilts);
  ElevationProfile ProfileAt(double azimuth, double range) const override;

private:
  const std::vector<SortedTilt>& tilts;
};

/// Lengths over which the weight exp(−d²/κ²) falls to 1/e.
struct BarnesLengths
{
  double horizontal = 0.0; ///< m, along the tilt
  double vertical = 0.0;   ///< degrees of elevation
};

/// The Barnes mean of the gates about a place, on all tilts.
class BarnesScheme : public TiltScheme
{
public:
  BarnesScheme(const std::vector<SortedTilt>& tilts, const BarnesLengths& lengths);
  ElevationProfile ProfileAt(double azimuth, double range) const override;

private:
  struct TiltSum
  {
    double elevation;
    double values;
    double weights;
  };
  TiltSum SumOver(const SortedTilt& tilt, double azimuth, double range) const;

  const std::vector<SortedTilt>& tilts;
  const BarnesLengths lengths;
};

/// The merge `beam` on a grid of 1 km by 1 km by 250 m about the radar, interpolated between voxels
/// with no echo as 0 dBZ.
class MergedScheme : public TiltScheme
{
public:
  /// The grid reaches `farthest` m from the radar, and no higher than the beam at `highest` degrees
  /// there, or 18 km.
  MergedScheme(
    const PolarVolume& volume, const BeamMergeOptions& options, double farthest, double highest);
  ElevationProfile ProfileAt(double azimuth, double range) const override;

private:
  std::optional<double> At(const std::array<double, 3>& point) const;

  const BeamModel beam;
  const double altitude;
  GriddedVolume volume;
};

} // namespace nexrad
