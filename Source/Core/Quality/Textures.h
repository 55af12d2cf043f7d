// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Model/RadarVolume.h"
#include "nexrad/Quality/EchoGrid.h"

#include <cstddef>
#include <vector>

namespace nexrad
{

/// Where the gates of a row of reflectivity lie.
struct RowGeometry
{
  std::size_t gates = 0;
  double firstGate = 0.0; ///< m
  double spacing = 0.0;   ///< m

  /// Gates to either side of a window along the ray: 2 of 1 km, 4 of 250 m (Formulas Q1).
  std::size_t HalfWindow() const;
};

/// Sums over the windows about the gates of one row: what textures are made of. Rows of
/// neighbouring rays are added up.
struct ReflectivitySums
{
  std::vector<float> pairs;   ///< neighbouring gates with values
  std::vector<float> squares; ///< of their differences, dB², each at most 400
  std::vector<float> turns;   ///< gates where the differences change their sign, by over 2 dB

  /// `row` as EchoGrid::Row.
  void Set(const float* row, const RowGeometry& geometry);
};

/// The same of velocity and spectrum width, which are finer than reflectivity in old files: those
/// of the gates within each gate of reflectivity. Each gate's own beside the windows'.
struct VelocitySums
{
  std::vector<float> ownCount;
  std::vector<float> ownStill; ///< gates with |V| < 1.3 m/s and a width below 1.8 m/s
  std::vector<float> ownSpeed; ///< sum of |V|, m/s
  std::vector<float> ownWidth; ///< sum of the spectrum widths, m/s
  std::vector<float> count;
  std::vector<float> still;
  std::vector<float> speed;
  std::vector<float> width;

  /// `ray` may be nullptr: nothing is known.
  void Set(const Ray* ray, const RowGeometry& geometry);
};

/// The same of the moments of two polarisations. `row` says which gates have reflectivity.
struct PolarimetricSums
{
  std::vector<float> count;          ///< gates with ρ_hv
  std::vector<float> correlation;    ///< sum of ρ_hv
  std::vector<float> ratio;          ///< sum of Z_DR, dB
  std::vector<float> pairs;          ///< neighbouring gates with Z_DR and Φ_DP
  std::vector<float> ratioSquares;   ///< of the differences of Z_DR, dB²
  std::vector<float> phaseSquares;   ///< of the differences of Φ_DP, degrees²
  std::vector<float> ownCorrelation; ///< of the gate; NoNumber where there is none
  std::vector<float> ownRatio;       ///< dB; NoNumber where there is none

  /// `ray` may be nullptr: nothing is known.
  void Set(const Ray* ray, const float* row, const RowGeometry& geometry);
};

/// Values of a moment at the gates of a row: of the nearest gate; NoNumber where it has none.
void ReadMoment(const Ray* ray, MomentName moment, const RowGeometry& geometry, float* values);

} // namespace nexrad
