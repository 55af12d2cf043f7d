// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Geometry/GridSpecification.h"
#include "Gridding/BeamColumn.h"
#include "Gridding/MotionField.h"
#include "Model/Moment.h"
#include "Model/Time.h"

#include <cstddef>
#include <optional>
#include <string>

namespace CLI
{
class App;
}

namespace nexrad::application
{

/// Along which motion the method beam interpolates in time.
struct MotionChoice
{
  bool none = false;             ///< linear in time
  std::optional<Velocity> given; ///< in place of the motion found from reflectivity
};

/// Time between two volumes when nobody says otherwise.
constexpr Duration DefaultStep = std::chrono::minutes(5);

/// What a user asks of merged volumes.
struct GridOptions
{
  GridRequest grid;
  bool ownRange = false;        ///< the user gave grid.range; else SeriesScan::Range replaces it
  std::optional<Duration> step; ///< empty: DefaultStep; of one volume alone, its middle
  std::optional<Time> begin;    ///< in place of the first step at or after the first ray
  std::optional<Time> end;      ///< in place of the last step at or before the last ray; inclusive
  std::optional<Time> time;     ///< this time alone, between the first and the last ray
  Duration maximumGap = std::chrono::minutes(15);
  MomentName moment = MomentName::REF;
  std::string method = "beam"; ///< a name that ParseMergeMethod knows
  int despeckle = 0;           ///< QualityOptions::neighbours
  std::string siteName;        ///< in place of the names in the files; empty: as the files say
  std::size_t memory = std::size_t(1) << 30; ///< bytes for rays that are kept, packed, for later
                                             ///< steps; 0 keeps none

  // What follows is of the method "beam".
  OverlapStrategy overlap = OverlapStrategy::Distance;
  double overlapLength = 100'000.0; ///< m, of OverlapStrategy::Distance; above 0
  bool fill = false;                ///< fill columns between and below what was scanned
  bool linearReflectivity = false;  ///< interpolate and average Z in place of dBZ; of REF
  bool sharpen = true;              ///< take the beam's width back from REF in dBZ (Formulas G9)
  bool companions = false;          ///< add age, number of radars, weight and nearest site
  MotionChoice motion;
};

/// Adds the options of merging to a command, all in one group of its help. They store into
/// `options`, which must outlive the parsing.
void AddGridOptions(CLI::App& command, GridOptions& options);

} // namespace nexrad::application
