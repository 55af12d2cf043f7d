// SPDX-License-Identifier: BSD-3-Clause
#include "Output/BiasOutput.h"

#include "nexrad/Merging/MergeOptions.h"
#include "nexrad/Moments/MomentMaker.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <ostream>

namespace nexrad::application
{

namespace
{

using Json = nlohmann::ordered_json;

bool CanBeCompared(const RadarVolume& volume)
{
  return volume.site.position && !volume.site.name.empty() &&
         std::any_of(volume.sweeps.begin(), volume.sweeps.end(),
           [](const Sweep& sweep) { return sweep.Has(MomentName::REF); });
}

// What a pair of radars has, seen from the first or, with sign -1, from the second.
Json MakeDifference(const BiasPair& pair, double sign)
{
  const bool turned = sign < 0.0;
  const auto orNull = [&pair](double value) { return pair.IsStated() ? Json(value) : Json(); };
  return {{"places", pair.cells}, {"pairs_of_volumes", pair.volumes},
    {"median_db", orNull(sign * pair.median)},
    {"lower_quartile_db", orNull(sign * (turned ? pair.upperQuartile : pair.lowerQuartile))},
    {"upper_quartile_db", orNull(sign * (turned ? pair.lowerQuartile : pair.upperQuartile))}};
}

} // namespace

void AddLowEchoes(const RadarVolume& file, LowEchoes& echoes)
{
  for (const RadarVolume& volume : SplitCycles(file))
  {
    if (CanBeCompared(volume))
    {
      MomentMaker maker(volume, MomentOptionsOf(MergeRules())); // as grid does without options
      echoes.push_back(std::make_shared<const LowEcho>(maker.Make(MomentName::REF)));
    }
  }
}

void PrintBiases(const BiasReport& report, const RadarBiases& takenOff, std::ostream& out)
{
  if (!report.IsEmpty())
  {
    out << "reflectivity of the radars where two see the same places:\n";
  }
  for (const std::string& line : report.Lines())
  {
    out << "  " << line << '\n';
  }
  for (const auto& [radar, bias] : takenOff)
  {
    char text[40];
    std::snprintf(text, sizeof text, ": %+.2f dB taken off\n", bias);
    out << "  " << radar << text;
  }
}

Json MakeBiasJson(const BiasReport& report, const RadarBiases& takenOff)
{
  Json pairs = Json::array();
  for (const BiasPair& pair : report.pairs)
  {
    Json object = {{"first", pair.first}, {"second", pair.second}};
    object.update(MakeDifference(pair, 1.0));
    pairs.push_back(object);
  }
  return {{"pairs", pairs}, {"biases_db", report.biases}, {"alone", report.alone},
    {"taken_off_db", takenOff}};
}

void AddBiasOf(const std::string& radar, const BiasReport& report, Json& object)
{
  const auto bias = report.biases.find(radar);
  object["bias_db"] = bias == report.biases.end() ? Json() : Json(bias->second);
  object["neighbours"] = Json::array();
  for (const BiasPair& pair : report.pairs)
  {
    if (pair.first == radar || pair.second == radar)
    {
      const bool first = pair.first == radar;
      Json neighbour = {{"site", first ? pair.second : pair.first}};
      neighbour.update(MakeDifference(pair, first ? 1.0 : -1.0));
      object["neighbours"].push_back(neighbour);
    }
  }
}

} // namespace nexrad::application
