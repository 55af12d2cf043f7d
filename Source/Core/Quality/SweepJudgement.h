// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Quality/EchoClass.h"
#include "nexrad/Quality/EchoGrid.h"
#include "nexrad/Quality/GateEvidence.h"
#include "nexrad/Quality/SplitCuts.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace nexrad
{

/// Whether the evidence of a gate alone says that it is ground.
struct GroundSign
{
  static constexpr std::uint8_t None = 0;
  static constexpr std::uint8_t Likely = 1; ///< ground beside gates that surely are
  static constexpr std::uint8_t Sure = 2;
};

/// The same of birds and insects, by their depolarisation (Formulas Q2).
struct FlightSign
{
  static constexpr std::uint8_t None = 0;
  static constexpr std::uint8_t Likely = 1; ///< of birds or insects beside gates that surely are
  static constexpr std::uint8_t Sure = 2;
  static constexpr std::uint8_t UnderEcho = 3; ///< either, below echo where none of them fly
};

/// The gates of one sweep of reflectivity, judged one by one. Arrays of what gates are have the
/// places of the grid (EchoGrid::Index).
struct SweepJudgement
{
  std::unique_ptr<EchoGrid> grid;  ///< nullptr for a sweep without rays or gates
  const EchoGrid* above = nullptr; ///< the tilt of the vertical test; nullptr where there is none
  std::size_t judged = 0;          ///< gates of each ray that can be ground or biological echo
  std::vector<float> heights;      ///< of these gates, m above the antenna: the lower beam edge
  std::vector<float> limits;       ///< of these gates: interest from which on ground is sure
  std::vector<float> weakest;      ///< of these gates, dBZ: echo that is hardly stronger than noise
  /// FlightSign, of two polarisations; only FindFlight makes reasons of them.
  std::vector<std::uint8_t> flights;
  std::vector<std::uint8_t> signs; ///< GroundSign
  std::vector<std::uint8_t>
    speeds; ///< |V| in steps of 0.125 m/s and 1 more, at most 255; 0 unknown
  std::vector<std::int8_t> gradients; ///< dB a degree (GateEvidence)
  std::vector<EchoReason> reasons;    ///< weather where nothing else is known

  /// `sources`: whether the gates are judged, by two polarisations or one, or take their classes of
  /// another sweep.
  void Set(const PolarSweep& sweep, const SweepSources& sources);

  /// Whether ρ_hv and Z_DR are known of a sweep whose gates are judged.
  bool IsPolarimetric() const { return !flights.empty(); }

  /// The gates of a row that are held and can be ground or biological echo.
  GateRange Judged(std::size_t place) const { return Common(grid->Held(place), {0, judged}); }
  /// What the echo of any gate comes from.
  EchoReason ReasonAt(std::size_t place, std::size_t gate) const
  {
    return grid->Held(place).Holds(gate) ? reasons[grid->Index(place, gate)] : EchoReason::None;
  }
};

/// Biological echo is weaker, dBZ.
constexpr float StrongestBiologicalEcho = 35.0F;

/// A speed as SweepJudgement::speeds has it.
constexpr std::uint8_t SpeedCode(double metresPerSecond)
{
  return static_cast<std::uint8_t>(metresPerSecond < 31.75 ? 8.0 * metresPerSecond + 1.0 : 255.0);
}

/// Height of a beam above the antenna in m, at a slant range in m and an elevation in degrees
/// (Formulas B1, near the ground).
double BeamHeight(double range, double elevation);

/// Slant range in m of the gates that can be ground or biological echo, of a sweep at an elevation
/// in degrees: the lower beam edge is at most 15 km high there, or they are within 20 km. Side
/// lobes see mountains at such heights (Formulas Q1).
double JudgedRange(double elevation);

/// Judges the gates of a sweep that have a value, row by row. Rows that follow each other share
/// work.
class RowJudge
{
public:
  /// `wanted`: of each row the gates that are judged. All arguments must outlive this object.
  RowJudge(
    SweepJudgement& sweep, const SweepSources& sources, const std::vector<GateRange>& wanted);

  void Judge(std::size_t place);

private:
  SweepJudgement& sweep;
  EvidenceReader reader;
  EvidenceRow evidence;
};

} // namespace nexrad
