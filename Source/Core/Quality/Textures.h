// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Quality/EchoGrid.h"
#include "nexrad/Quality/SplitCuts.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace nexrad
{

/// Where the gates of a row of reflectivity lie.
struct RowGeometry
{
  std::size_t gates = 0;  ///< the first ones that count
  double firstGate = 0.0; ///< m
  double spacing = 0.0;   ///< m

  /// Gates to either side of a window along the ray: 2 of 1 km, 4 of 250 m (Formulas Q1).
  std::size_t HalfWindow() const;
};

/// |V| in m/s from which on SumOf::Still counts nothing.
constexpr float MovingSpeed = 1.5F;

/// What is summed over the gates of a window, of reflectivity and velocity. Neighbouring rays are
/// added up.
enum class SumOf : std::uint8_t
{
  Pairs,      ///< neighbouring gates with reflectivity
  Squares,    ///< of their differences, dB², each at most 400
  Turns,      ///< gates where the differences change their sign, by over 2 dB
  Velocities, ///< gates with a velocity
  Still,      ///< how near 0 they are: 1 at 0.25 m/s, falling to 0 at 1.5 m/s
  Velocity,   ///< m/s, with its sign
  Speed,      ///< |V|, m/s
  Width       ///< spectrum width, m/s
};

/// The same of two polarisations.
enum class PolarimetricSumOf : std::uint8_t
{
  Correlations, ///< gates with ρ_hv and Z_DR
  Correlation,  ///< ρ_hv
  Ratio,        ///< Z_DR, dB
  RatioPairs,   ///< neighbouring gates with Z_DR and Φ_DP
  RatioSquares, ///< of the differences of Z_DR, dB²
  PhaseSquares  ///< of the differences of Φ_DP, degrees², each at most 3600
};

/// The sums of one gate, of either kind.
constexpr std::size_t SumCount = 8;
using GateSums = std::array<float, SumCount>;

template <class Which>
float& At(GateSums& sums, Which which)
{
  return sums[static_cast<std::size_t>(which)];
}
template <class Which>
float At(const GateSums& sums, Which which)
{
  return sums[static_cast<std::size_t>(which)];
}

/// The sums of the gates of a row.
struct RowSums
{
  std::vector<GateSums> own;     ///< of each gate alone
  std::vector<GateSums> windows; ///< of the window about it, up to half a window behind the last
};

/// 0 at `from`, 1 at `to`, linear between and constant beyond.
inline float Ramp(float value, float from, float to)
{
  const float part = (value - from) * (1.0F / (to - from)); // a constant where the ends are
  return std::min(std::max(part, 0.0F), 1.0F);
}

/// Sums over the windows about the gates of one ray.
class RayTextures
{
public:
  /// Reads a row of reflectivity, as EchoGrid::Row, and what its sources tell of the gates up to
  /// `geometry.gates`, behind which nothing counts.
  void Set(
    const float* row, const SweepSources& sources, std::size_t ray, const RowGeometry& geometry);

  /// By SumOf.
  const RowSums& Sums() const { return sums; }
  /// By PolarimetricSumOf; empty where the ray has but one polarisation.
  const RowSums& PolarimetricSums() const { return polarimetricSums; }

private:
  void AddReflectivity(const float* row, std::size_t gates);
  void AddVelocity(const SweepSources& sources, std::size_t ray, const RowGeometry& geometry);
  void AddPolarimetry(
    const float* row, const SweepSources& sources, std::size_t ray, const RowGeometry& geometry);

  RowSums sums;
  RowSums polarimetricSums;
  std::vector<GateSums> prefix;
  std::vector<std::uint16_t> codes;
  std::vector<std::uint16_t> widthCodes;
  std::vector<float> correlation;
  std::vector<float> ratio;
  std::vector<float> phase;
};

/// Of the gates of a row those from the first to behind the last that has a value and, beside or in
/// it, a velocity of less than MovingSpeed; empty without any. `row[gate]` are the values of the
/// gates of `held`; others have none. `codes` is room that is used.
GateRange StillGates(const float* row, const GateRange& held, const MomentSource& velocity,
  std::size_t ray, const RowGeometry& geometry, std::vector<std::uint16_t>& codes);

/// Values of a moment at the gates of a row: of the nearest gate; NoNumber where it has none.
/// `codes` is room that is used.
void ReadMoment(const MomentSource& source, std::size_t ray, const RowGeometry& geometry,
  std::vector<std::uint16_t>& codes, std::vector<float>& values);

} // namespace nexrad
