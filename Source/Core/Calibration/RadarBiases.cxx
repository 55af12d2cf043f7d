// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Calibration/RadarBiases.h"

#include "nexrad/Geometry/SiteGeoreference.h"
#include "nexrad/System/Error.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <optional>
#include <utility>

namespace nexrad
{

namespace
{

constexpr char separators[] = ":="; // between the name of a radar and its bias

using Matrix = std::vector<std::vector<double>>;

// "KLSX:2"; throws Error.
std::pair<std::string, double> ParseBias(const std::string& text)
{
  const std::size_t sign = text.find_first_of(separators);
  const std::string number = sign == std::string::npos ? "" : text.substr(sign + 1);
  char* end = nullptr;
  const double bias = std::strtod(number.c_str(), &end);
  if (sign == 0 || number.empty() || end != number.c_str() + number.size() ||
      !(std::abs(bias) <= LargestBias))
  {
    throw Error(
      "'" + text + "' is no bias of a radar; write its name and -20 to 20 dB, as in KLSX:2");
  }
  return {text.substr(0, sign), bias};
}

// Solves a system whose matrix is symmetric and positive definite, by elimination.
std::vector<double> Solve(Matrix matrix, std::vector<double> right)
{
  const std::size_t size = right.size();
  for (std::size_t i = 0; i < size; ++i)
  {
    for (std::size_t row = i + 1; row < size; ++row)
    {
      const double factor = matrix[row][i] / matrix[i][i];
      for (std::size_t column = i; column < size; ++column)
      {
        matrix[row][column] -= factor * matrix[i][column];
      }
      right[row] -= factor * right[i];
    }
  }
  for (std::size_t i = size; i-- > 0;)
  {
    for (std::size_t column = i + 1; column < size; ++column)
    {
      right[i] -= matrix[i][column] * right[column];
    }
    right[i] /= matrix[i][i];
  }
  return right;
}

double MedianOfBiases(std::vector<double> biases)
{
  std::sort(biases.begin(), biases.end());
  const std::size_t half = biases.size() / 2;
  return biases.size() % 2 == 1 ? biases[half] : 0.5 * (biases[half - 1] + biases[half]);
}

// The radars that stated pairs connect, in groups by the first of their radars, each in the order
// of the alphabet.
std::map<std::string, std::vector<std::string>> FindGroups(const std::vector<BiasPair>& pairs)
{
  std::map<std::string, std::string> leaders; // the first radar of the group of each
  for (const BiasPair& pair : pairs)
  {
    leaders.emplace(pair.first, pair.first);
    leaders.emplace(pair.second, pair.second);
    const std::string first = leaders[pair.first];
    const std::string second = leaders[pair.second];
    for (auto& [site, leader] : leaders)
    {
      leader = leader == std::max(first, second) ? std::min(first, second) : leader;
    }
  }
  std::map<std::string, std::vector<std::string>> groups;
  for (const auto& [site, leader] : leaders)
  {
    groups[leader].push_back(site);
  }
  return groups;
}

// The biases of one group, which the pairs connect.
std::vector<double> SolveGroup(
  const std::vector<std::string>& sites, const std::vector<BiasPair>& pairs)
{
  const auto indexOf = [&sites](const std::string& site)
  {
    return static_cast<std::size_t>(
      std::lower_bound(sites.begin(), sites.end(), site) - sites.begin());
  };
  // Normal equations. That the sum be 0 is one more equation, which makes the solution unique.
  Matrix matrix(sites.size(), std::vector<double>(sites.size(), 1.0));
  std::vector<double> right(sites.size(), 0.0);
  for (const BiasPair& pair : pairs)
  {
    if (std::binary_search(sites.begin(), sites.end(), pair.first)) // and so is the second
    {
      const std::size_t first = indexOf(pair.first);
      const std::size_t second = indexOf(pair.second);
      const auto weight = static_cast<double>(pair.cells);
      matrix[first][first] += weight;
      matrix[second][second] += weight;
      matrix[first][second] -= weight;
      matrix[second][first] -= weight;
      right[first] += weight * pair.median;
      right[second] -= weight * pair.median;
    }
  }
  std::vector<double> biases = Solve(matrix, right);
  const double middle = MedianOfBiases(biases);
  std::transform(
    biases.begin(), biases.end(), biases.begin(), [middle](double bias) { return bias - middle; });
  return biases;
}

template <typename... Values>
std::string Print(const char* format, Values... values)
{
  char text[200];
  std::snprintf(text, sizeof text, format, values...);
  return text;
}

// The comparison of volumes.

constexpr double leastRatio = 0.8; // of the distances of two radars; the largest is its inverse
constexpr double leastEcho = 15.0; // dBZ
constexpr Duration longestTime = std::chrono::minutes(5); // between two volumes

// The volumes of one radar, by time.
using RadarVolumes = std::vector<const LowEcho*>;

// A place that two radars see from like distances: the cell of each above it.
struct SharedPlace
{
  int sector;
  int ring;
  int sectorOfOther;
  int ringOfOther;
};

// Values that two radars have of one place, hundredths of dBZ.
using ValuePair = std::pair<int, int>;

int SectorOf(double azimuth)
{
  return std::min(static_cast<int>(azimuth * LowEcho::Sectors / 360.0), LowEcho::Sectors - 1);
}

double MiddleOf(int ring)
{
  return (ring + 0.5) * LowEcho::RingWidth;
}

// Two volumes of two radars that are near in time.
using VolumePair = std::pair<const LowEcho*, const LowEcho*>;

// The places that two radars see from like distances, one for each cell over which some volume of
// the first has a value.
std::vector<SharedPlace> FindSharedPlaces(const std::vector<VolumePair>& volumes)
{
  const SiteGeoreference here(*volumes.front().first->site.position);
  const SiteGeoreference there(*volumes.front().second->site.position);
  constexpr double farthest = LowEcho::Rings * LowEcho::RingWidth;
  std::vector<SharedPlace> places;
  for (int sector = 0; sector < LowEcho::Sectors; ++sector)
  {
    const double azimuth = (sector + 0.5) * 360.0 / LowEcho::Sectors;
    for (int ring = 0; ring < LowEcho::Rings; ++ring)
    {
      const double distance = MiddleOf(ring);
      const auto hasValue = [sector, ring](const VolumePair& pair)
      { return pair.first->HasValue(sector, ring); };
      if (distance < LowEcho::NearestGate || std::none_of(volumes.begin(), volumes.end(), hasValue))
      {
        continue;
      }
      const std::array<double, 2> place = here.Locate({azimuth, distance});
      const GroundDirection other = there.Look(place[0], place[1]);
      const double ratio = distance / other.groundDistance;
      if (ratio >= leastRatio && ratio <= 1.0 / leastRatio && other.groundDistance < farthest)
      {
        places.push_back({sector, ring, SectorOf(other.azimuth),
          static_cast<int>(other.groundDistance / LowEcho::RingWidth)});
      }
    }
  }
  return places;
}

// Whether the circles within which two radars have cells overlap.
bool AreNeighbours(const Position& first, const Position& second)
{
  constexpr double farthest = LowEcho::Rings * LowEcho::RingWidth;
  return SiteGeoreference(first).Look(second.longitude, second.latitude).groundDistance <=
         2.0 * farthest;
}

// The volume nearest to another in time; the earlier of two that are equally near.
const LowEcho* NearestInTime(const RadarVolumes& volumes, const LowEcho& other)
{
  const auto apart = [&other](const LowEcho* volume)
  { return std::chrono::abs(volume->time - other.time); };
  return *std::min_element(volumes.begin(), volumes.end(),
    [&apart](const LowEcho* a, const LowEcho* b) { return apart(a) < apart(b); });
}

// Adds the places where both volumes have a value.
void AddValues(const LowEcho& first, const LowEcho& second, const std::vector<SharedPlace>& places,
  std::vector<ValuePair>& values)
{
  const int begin = std::max(first.firstLayer, second.firstLayer);
  const int end = std::min(first.firstLayer + first.layers, second.firstLayer + second.layers);
  for (const SharedPlace& place : places)
  {
    for (int layer = begin; layer < end; ++layer)
    {
      const std::optional<int> own = first.At(layer, place.sector, place.ring);
      const std::optional<int> other =
        own ? second.At(layer, place.sectorOfOther, place.ringOfOther) : std::nullopt;
      if (other)
      {
        values.emplace_back(*own, *other);
      }
    }
  }
}

// The value below which a share of the differences lies, dB.
double QuantileOf(std::vector<int>& differences, double share)
{
  const auto place = differences.begin() +
                     static_cast<std::ptrdiff_t>(share * static_cast<double>(differences.size()));
  std::nth_element(differences.begin(), place, differences.end());
  return 0.01 * *place;
}

// Differences of the values that are above 15 dBZ when half of the bias is taken off each of them.
// Without that, of weak echo too few values of the lower radar would count.
std::vector<int> DifferencesOf(const std::vector<ValuePair>& values, double bias)
{
  std::vector<int> differences;
  for (const auto& [first, second] : values)
  {
    if (0.01 * first - 0.5 * bias > leastEcho && 0.01 * second + 0.5 * bias > leastEcho)
    {
      differences.push_back(first - second);
    }
  }
  return differences;
}

void SetQuantiles(const std::vector<ValuePair>& values, BiasPair& pair)
{
  constexpr int passes = 3; // then the bias by which values are chosen is the one that is found
  for (int pass = 0; pass < passes; ++pass)
  {
    std::vector<int> differences = DifferencesOf(values, pair.median);
    pair.cells = differences.size();
    if (differences.empty())
    {
      return;
    }
    pair.median = QuantileOf(differences, 0.5);
    pair.lowerQuartile = QuantileOf(differences, 0.25);
    pair.upperQuartile = QuantileOf(differences, 0.75);
  }
}

// Each volume of one radar with the one of another that is nearest to it in time, where it is the
// nearest to that one too.
std::vector<VolumePair> PairInTime(const RadarVolumes& first, const RadarVolumes& second)
{
  std::vector<VolumePair> pairs;
  for (const LowEcho* volume : first)
  {
    const LowEcho* other = NearestInTime(second, *volume);
    if (NearestInTime(first, *other) == volume &&
        std::chrono::abs(volume->time - other->time) <= longestTime)
    {
      pairs.emplace_back(volume, other);
    }
  }
  return pairs;
}

BiasPair Compare(const RadarVolumes& first, const RadarVolumes& second)
{
  const Site& radar = first.front()->site;
  const Site& other = second.front()->site;
  BiasPair pair{radar.name, other.name};
  const std::vector<VolumePair> volumes = AreNeighbours(*radar.position, *other.position)
                                            ? PairInTime(first, second)
                                            : std::vector<VolumePair>();
  if (volumes.empty())
  {
    return pair;
  }
  pair.volumes = volumes.size();
  const std::vector<SharedPlace> places = FindSharedPlaces(volumes);
  std::vector<ValuePair> values;
  for (const VolumePair& each : volumes)
  {
    AddValues(*each.first, *each.second, places, values);
  }
  SetQuantiles(values, pair);
  return pair;
}

// The volumes of each radar with a name.
std::map<std::string, RadarVolumes> GroupByRadar(const LowEchoes& volumes)
{
  std::map<std::string, RadarVolumes> radars;
  for (const std::shared_ptr<const LowEcho>& volume : volumes)
  {
    if (!volume->site.name.empty())
    {
      radars[volume->site.name].push_back(volume.get());
    }
  }
  for (auto& [name, own] : radars)
  {
    std::sort(own.begin(), own.end(),
      [](const LowEcho* a, const LowEcho* b) { return a->start < b->start; });
  }
  return radars;
}

} // namespace

RadarBiases ParseBiases(const std::string& text)
{
  RadarBiases biases;
  for (std::size_t begin = 0; begin <= text.size();)
  {
    const std::size_t comma = std::min(text.find(',', begin), text.size());
    const auto [site, bias] = ParseBias(text.substr(begin, comma - begin));
    if (!biases.emplace(site, bias).second)
    {
      throw Error("radar " + site + " has two biases in '" + text + "'; give one");
    }
    begin = comma + 1;
  }
  return biases;
}

BiasRequest ParseBiasRequest(const std::string& text)
{
  if (text == "auto" || text == "off")
  {
    return {text == "auto", {}};
  }
  if (text.find_first_of(separators) == std::string::npos)
  {
    throw Error("'" + text +
                "' is no bias; write auto, off, or radars and how many dB they measure too high, "
                "as in KLSX:2,KILX:-1.5");
  }
  return {false, ParseBiases(text)};
}

void RequireRadars(const RadarBiases& biases, const std::vector<std::string>& radars)
{
  const auto stray = std::find_if(biases.begin(), biases.end(),
    [&](const auto& each)
    { return std::find(radars.begin(), radars.end(), each.first) == radars.end(); });
  if (stray == biases.end())
  {
    return;
  }
  std::string names;
  for (const std::string& name : radars)
  {
    names += (names.empty() ? "" : ", ") + name;
  }
  throw Error("a bias is given for " + stray->first +
              ", which none of the inputs is of; they are of " + names);
}

RadarBiases ReconcileBiases(const std::vector<BiasPair>& pairs)
{
  std::vector<BiasPair> stated;
  std::copy_if(pairs.begin(), pairs.end(), std::back_inserter(stated),
    [](const BiasPair& pair) { return pair.IsStated(); });
  RadarBiases biases;
  for (const auto& [leader, sites] : FindGroups(stated))
  {
    const std::vector<double> solved = SolveGroup(sites, stated);
    for (std::size_t i = 0; i < sites.size(); ++i)
    {
      biases[sites[i]] = solved[i];
    }
  }
  return biases;
}

BiasReport CompareRadars(const LowEchoes& volumes)
{
  const std::map<std::string, RadarVolumes> radars = GroupByRadar(volumes);
  BiasReport report;
  if (radars.size() < 2)
  {
    return report;
  }
  for (auto first = radars.begin(); first != radars.end(); ++first)
  {
    for (auto second = std::next(first); second != radars.end(); ++second)
    {
      BiasPair pair = Compare(first->second, second->second);
      if (pair.cells > 0)
      {
        report.pairs.push_back(std::move(pair));
      }
    }
  }
  report.biases = ReconcileBiases(report.pairs);
  for (const auto& [name, own] : radars)
  {
    if (report.biases.count(name) == 0)
    {
      report.alone.push_back(name);
    }
  }
  return report;
}

std::vector<std::string> BiasReport::Lines() const
{
  std::vector<std::string> lines;
  for (const BiasPair& pair : pairs)
  {
    const std::string names = pair.first + " - " + pair.second + ": ";
    lines.push_back(
      pair.IsStated()
        ? names +
            Print("median %+.2f dB, quartiles %+.2f and %+.2f dB, %zu places in %zu %s of volumes",
              pair.median, pair.lowerQuartile, pair.upperQuartile, pair.cells, pair.volumes,
              pair.volumes == 1 ? "pair" : "pairs")
        : names + Print("%zu places are too few to tell a difference", pair.cells));
  }
  for (const auto& [site, bias] : biases)
  {
    lines.push_back(site + Print(": bias %+.2f dB", bias));
  }
  for (const std::string& site : alone)
  {
    lines.push_back(site + ": no other radar tells its bias");
  }
  return lines;
}

} // namespace nexrad
