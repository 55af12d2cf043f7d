// SPDX-License-Identifier: BSD-3-Clause
// The synthetic storm day as three radars scanned it, for tests that hold a merge against the
// truth.
#pragma once

#include "Comparison/TruthComparison.h"
#include "nexrad/Simulation/SimulatedDay.h"
#include "nexrad/Thesis/ThesisMerge.h"

#include <array>
#include <functional>
#include <string>
#include <vector>

namespace nexrad::testing
{

/// 18:05 UTC on the synthetic day.
Time Evening();

/// The volumes of the three radars around a time, as gridding takes them.
class ScannedDay
{
public:
  /// `options` are those of the simulated radars and their atmosphere.
  explicit ScannedDay(Time time, const SimulatorOptions& options = {});

  const StormField& Field() const { return field; }
  Time At() const { return time; }

  /// Of each site the volumes that start just before and just after the time.
  std::vector<SiteBracket> Brackets() const;
  std::vector<Position> Positions() const;
  /// Those of the brackets.
  std::vector<const PolarVolume*> BracketVolumes() const;
  /// All that hold the rays just before and just after the time.
  std::vector<const PolarVolume*> Volumes() const;

  void ChangeRays(const std::function<void(PolarRay&)>& change);

private:
  struct Scanned
  {
    std::vector<PolarVolume> volumes; // of one site, by time
    std::size_t before;               // index in it
    std::size_t after;
  };

  void AddSite(const std::vector<SimulatedVolume>& plan);

  StormField field;
  Time time;
  SimulatorOptions options;
  std::vector<Scanned> sites;
};

/// Scanned once for all tests of a program.
const ScannedDay& EveningDay();

/// What the radars' sky really held, on a grid, and which voxels some beam saw.
struct Truth
{
  GridSpecification grid;
  std::vector<float> values;
  std::vector<std::uint8_t> counts;
};

GridSpecification GridOf(const ScannedDay& day, const std::array<int, 3>& dimensions);
Truth TruthOn(const ScannedDay& day, const std::array<int, 3>& dimensions);

/// "256x256x128".
std::string ToText(const std::array<int, 3>& dimensions);
void Print(const std::string& method, const Truth& truth, const TruthScore& score);

} // namespace nexrad::testing
