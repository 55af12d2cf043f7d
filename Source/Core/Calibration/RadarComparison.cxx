// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Calibration/RadarComparison.h"

#include "nexrad/Geometry/SiteGeoreference.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <map>
#include <optional>
#include <string>
#include <utility>

namespace nexrad
{

namespace
{

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

// Whether some volume of the first radar has a value over a cell.
bool HasEcho(const std::vector<VolumePair>& volumes, int sector, int ring)
{
  return std::any_of(volumes.begin(), volumes.end(),
    [=](const VolumePair& pair) { return pair.first->HasValue(sector, ring); });
}

// The places that two radars see from like distances, one for each cell over which some volume of
// the first has a value.
std::vector<SharedPlace> FindSharedPlaces(const std::vector<VolumePair>& volumes)
{
  const SiteGeoreference here(*volumes.front().first->Radar().position);
  const SiteGeoreference there(*volumes.front().second->Radar().position);
  constexpr double farthest = LowEcho::Rings * LowEcho::RingWidth;
  std::vector<SharedPlace> places;
  for (int sector = 0; sector < LowEcho::Sectors; ++sector)
  {
    const double azimuth = (sector + 0.5) * 360.0 / LowEcho::Sectors;
    for (int ring = 0; ring < LowEcho::Rings; ++ring)
    {
      const double distance = MiddleOf(ring);
      if (distance < LowEcho::NearestGate || !HasEcho(volumes, sector, ring))
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
  { return std::chrono::abs(volume->MeanTime() - other.MeanTime()); };
  return *std::min_element(volumes.begin(), volumes.end(),
    [&apart](const LowEcho* a, const LowEcho* b) { return apart(a) < apart(b); });
}

// Adds the places where both volumes have a value.
void AddValues(const LowEcho& first, const LowEcho& second, const std::vector<SharedPlace>& places,
  std::vector<ValuePair>& values)
{
  const int begin = std::max(first.FirstLayer(), second.FirstLayer());
  const int end = std::min(first.EndLayer(), second.EndLayer());
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
        std::chrono::abs(volume->MeanTime() - other->MeanTime()) <= longestTime)
    {
      pairs.emplace_back(volume, other);
    }
  }
  return pairs;
}

BiasPair Compare(const RadarVolumes& first, const RadarVolumes& second)
{
  const Site& radar = first.front()->Radar();
  const Site& other = second.front()->Radar();
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
    if (!volume->Radar().name.empty())
    {
      radars[volume->Radar().name].push_back(volume.get());
    }
  }
  for (auto& [name, own] : radars)
  {
    std::sort(own.begin(), own.end(),
      [](const LowEcho* a, const LowEcho* b) { return a->Start() < b->Start(); });
  }
  return radars;
}

} // namespace

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

} // namespace nexrad
