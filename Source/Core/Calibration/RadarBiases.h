// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Calibration/LowEcho.h"

#include <cstddef>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace nexrad
{

/// How many dB too high each of some radars measures reflectivity, by their names. Radars that are
/// not named measure rightly.
using RadarBiases = std::map<std::string, double>;

/// The largest bias that a user can give, dB.
constexpr double LargestBias = 20.0;

/// Reads "KLSX:2,KILX:-1.5": names of radars, and dB that they measure too high. An equals sign may
/// stand in place of a colon. Throws Error for what is no such list.
RadarBiases ParseBiases(const std::string& text);

/// Throws Error when one of the biases is that of none of these radars.
void RequireRadars(const RadarBiases& biases, const std::vector<std::string>& radars);

/// What a user asks of the biases of radars.
struct BiasRequest
{
  bool measured = false; ///< take off what the comparison of the radars finds (Formulas Q6)
  RadarBiases given;     ///< take off these; empty when `measured`
};

/// Reads "off", "auto", or a list as ParseBiases does. Throws Error for other texts.
BiasRequest ParseBiasRequest(const std::string& text);

/// How much more one radar measures than another where both see the same places from like
/// distances (Formulas Q6).
struct BiasPair
{
  std::string first;          ///< name of a radar
  std::string second;         ///< name of another, later in the alphabet
  std::size_t volumes = 0;    ///< pairs of volumes near in time that were compared
  std::size_t cells = 0;      ///< pairs of values
  double median = 0.0;        ///< dB, of first − second
  double lowerQuartile = 0.0; ///< dB
  double upperQuartile = 0.0; ///< dB

  /// Whether the cells are FewestCells or more: fewer say too little. The cells of one hour are
  /// those of a few storms: on the SYNTHETIC storm day the median errs by 1.3 dB with 179 cells of
  /// an hour, by 0.3 dB with some 550, and by 0.01 dB with 2526 of six hours.
  bool IsStated() const { return cells >= FewestCells; }
  static constexpr std::size_t FewestCells = 100;
};

/// The biases of radars that agree best with the medians of the pairs that are stated: by least
/// squares, each pair with the number of its cells as weight. The pairs tell differences alone: in
/// each group of radars that pairs connect, the median of the biases is 0 (of an even number, the
/// mean of the two in the middle). Radars of no such pair are not named.
RadarBiases ReconcileBiases(const std::vector<BiasPair>& pairs);

/// What the comparison of radars found.
struct BiasReport
{
  std::vector<BiasPair> pairs;    ///< with one cell at least, by name
  RadarBiases biases;             ///< ReconcileBiases of them
  std::vector<std::string> alone; ///< names of the radars that no pair states a bias of

  bool IsEmpty() const { return pairs.empty() && alone.empty(); }
  /// The report as lines of text: a line for each pair, then one for each radar.
  std::vector<std::string> Lines() const;
};

/// What volumes of several radars have near the ground.
using LowEchoes = std::vector<std::shared_ptr<const LowEcho>>;

/// Compares the radars of some volumes with each other (Formulas Q6). The order of the volumes
/// makes no difference.
///
/// - Two radars are compared in cells of LowEcho that lie at the same place, in the same layer of
///   height, as far from one radar as from the other: the ratio of the distances is 0.8 to 1.25.
///   Both values must be above 15 dBZ.
/// - A volume is compared with the one of the other radar that is nearest to it in time, when it is
///   the nearest to that one too, and their times (LowEcho::time) differ by five minutes at
///   most. Echo is not moved from one time to the other.
/// - Of one radar the report is empty.
/// - Radars without a name are not compared: a bias could not be given to them.
BiasReport CompareRadars(const LowEchoes& volumes);

} // namespace nexrad
