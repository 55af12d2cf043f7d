// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Velocity/FoldedWind.h"

#include "nexrad/Geometry/Angles.h"
#include "nexrad/Geometry/Beam.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace nexrad
{

namespace
{

constexpr double layerDepth = 400.0; // m
constexpr std::size_t layerCount = 40;
constexpr std::size_t sectorCount = 36;
constexpr double nearest = 5'000.0; // m: closer in, the beam's side lobes see the ground
constexpr double farthest = 120'000.0;
constexpr float fewestGatesOfSector = 6.0F; // of a sector
constexpr float enoughGates = 40.0F;
constexpr float leastRays = 0.6F;     // of the rays of a sector: interference fills a few degrees
constexpr double highestSpeed = 80.0; // m/s
constexpr double coarseStep = 4.0;    // m/s
constexpr std::size_t mostCandidates = 12;

// The mean velocity of one sector of a layer in one sweep, as an angle of the circle on which
// velocities fold.
struct SectorPhase
{
  float east;   // change of the angle for 1 m/s of wind to the east, turns of the circle
  float north;  // and to the north
  float phase;  // turns
  float weight; // 0…1
};

using Layer = std::vector<SectorPhase>;

struct WindCandidate
{
  Wind wind;
  float score = 0.0F;
};

struct PhaseSum
{
  float cosine = 0.0F;
  float sine = 0.0F;
  float count = 0.0F;
  float rays = 0.0F; // with a velocity
  std::size_t lastRow = 0;
};

// The layer of each gate; layerCount for gates that are not used.
std::vector<std::size_t> LayersOfGates(const SweepRing& ring)
{
  const BeamModel beam;
  std::vector<std::size_t> layers(ring.gates, layerCount);
  for (std::size_t gate = 0; gate < ring.gates; ++gate)
  {
    const double range = ring.RangeOf(gate);
    if (range >= nearest && range <= farthest)
    {
      const double height = beam.Locate(range, ring.elevation).height;
      layers[gate] =
        std::min(layerCount, std::size_t(std::max(0.0, std::floor(height / layerDepth))));
    }
  }
  return layers;
}

// Adds the sectors of one sweep whose rays have one Nyquist velocity.
void AddSectors(const SweepRing& ring, float nyquist, std::vector<Layer>& layers)
{
  const std::vector<std::size_t> layerOf = LayersOfGates(ring);
  std::vector<PhaseSum> sums(layerCount * sectorCount);
  std::array<float, sectorCount> rays{}; // of each sector
  for (std::size_t row = 0; row < ring.rows; ++row)
  {
    if (ring.nyquist[row] != nyquist)
    {
      continue;
    }
    const auto sector = std::min(sectorCount - 1, std::size_t(ring.azimuth[row] / 10.0F));
    rays[sector] += 1.0F;
    for (std::size_t gate = row % 2; gate < ring.gates; gate += 2) // half of them are plenty
    {
      const float value = ring.velocity[row * ring.gates + gate];
      if (layerOf[gate] < layerCount && !std::isnan(value))
      {
        PhaseSum& sum = sums[layerOf[gate] * sectorCount + sector];
        const float angle = static_cast<float>(Pi) * value / nyquist;
        sum.cosine += std::cos(angle);
        sum.sine += std::sin(angle);
        sum.count += 1.0F;
        sum.rays += sum.lastRow == row + 1 ? 0.0F : 1.0F;
        sum.lastRow = row + 1;
      }
    }
  }
  const double turnsAMetre = std::cos(ring.elevation * RadiansPerDegree) / (2.0 * double(nyquist));
  for (std::size_t place = 0; place < sums.size(); ++place)
  {
    const PhaseSum& sum = sums[place];
    if (sum.count < fewestGatesOfSector || sum.rays < leastRays * rays[place % sectorCount])
    {
      continue;
    }
    const double azimuth =
      (static_cast<double>(place % sectorCount) + 0.5) * 10.0 * RadiansPerDegree;
    const float coherence = std::hypot(sum.cosine, sum.sine) / sum.count;
    layers[place / sectorCount].push_back({static_cast<float>(turnsAMetre * std::sin(azimuth)),
      static_cast<float>(turnsAMetre * std::cos(azimuth)),
      std::atan2(sum.sine, sum.cosine) / static_cast<float>(2.0 * Pi),
      coherence * std::min(1.0F, sum.count / enoughGates)});
  }
}

// The cosine of an angle in turns; to 0.2 %.
class CosineTable
{
public:
  CosineTable()
  {
    for (std::size_t index = 0; index < size; ++index)
    {
      values[index] = static_cast<float>(
        std::cos(2.0 * Pi * (static_cast<double>(index) + 0.5) / static_cast<double>(size)));
    }
  }
  float Of(float turns) const
  {
    const int index = static_cast<int>(turns * float(size) + 64.0F * float(size));
    return values[std::size_t(index) % size];
  }

private:
  static constexpr std::size_t size = 1024;
  std::array<float, size> values{};
};

float ScoreOf(const Layer& layer, const Wind& wind, const CosineTable& cosine)
{
  const auto east = static_cast<float>(wind.east);
  const auto north = static_cast<float>(wind.north);
  float score = 0.0F;
  for (const SectorPhase& sector : layer)
  {
    score += sector.weight * cosine.Of(sector.east * east + sector.north * north - sector.phase);
  }
  return score;
}

void Climb(const Layer& layer, const CosineTable& cosine, WindCandidate& candidate)
{
  double step = 0.5 * coarseStep;
  while (step >= 0.4)
  {
    const Wind centre = candidate.wind;
    for (int place = 0; place < 9; ++place)
    {
      const int column = place % 3 - 1;
      const int row = place / 3 - 1;
      const Wind wind = {centre.east + step * column, centre.north + step * row};
      const float score = ScoreOf(layer, wind, cosine);
      if (score > candidate.score)
      {
        candidate = {wind, score};
      }
    }
    step *= 0.5;
  }
}

// The winds that agree with a layer best: maxima of the score.
std::vector<WindCandidate> FindCandidates(const Layer& layer, const CosineTable& cosine)
{
  constexpr int reach = static_cast<int>(highestSpeed / coarseStep);
  constexpr int width = 2 * reach + 1;
  const auto indexOf = [](int x, int y)
  { return std::size_t(y) * std::size_t(width) + std::size_t(x); };
  std::vector<float> scores(indexOf(0, width), -1.0e9F);
  for (int y = 0; y < width; ++y)
  {
    for (int x = 0; x < width; ++x)
    {
      const Wind wind = {coarseStep * (x - reach), coarseStep * (y - reach)};
      if (wind.Speed() <= highestSpeed)
      {
        scores[indexOf(x, y)] = ScoreOf(layer, wind, cosine);
      }
    }
  }
  std::vector<WindCandidate> candidates;
  for (int y = 1; y + 1 < width; ++y)
  {
    for (int x = 1; x + 1 < width; ++x)
    {
      const float score = scores[indexOf(x, y)];
      bool highest = score > 0.0F;
      for (int place = 0; place < 9 && highest; ++place)
      {
        highest = scores[indexOf(x + place % 3 - 1, y + place / 3 - 1)] <= score;
      }
      if (highest)
      {
        candidates.push_back({{coarseStep * (x - reach), coarseStep * (y - reach)}, score});
        Climb(layer, cosine, candidates.back());
      }
    }
  }
  std::stable_sort(candidates.begin(), candidates.end(),
    [](const WindCandidate& a, const WindCandidate& b) { return a.score > b.score; });
  candidates.resize(std::min(candidates.size(), mostCandidates));
  return candidates;
}

// A layer with its candidates on the way from the lowest to the highest.
struct LayerChoice
{
  std::size_t layer;
  std::vector<WindCandidate> candidates;
  std::vector<float> sums; // the best way that ends at each candidate
  std::vector<std::size_t> from;
};

float Worth(const WindCandidate& candidate, float weight)
{
  // Of two winds that agree alike the weaker one.
  constexpr float strongIsRare = 0.02F;
  return 20.0F * candidate.score / weight -
         strongIsRare * static_cast<float>(candidate.wind.Speed());
}

float Cost(const Wind& a, const Wind& b, std::size_t layers)
{
  constexpr double usual = 5.0; // m/s from one layer to the next
  constexpr double most = 15.0;
  const double change = std::hypot(a.east - b.east, a.north - b.north) / usual;
  return static_cast<float>(std::min(most, 0.5 * change * change / static_cast<double>(layers)));
}

float WeightOf(const Layer& layer)
{
  float weight = 0.0F;
  for (const SectorPhase& sector : layer)
  {
    weight += sector.weight;
  }
  return weight;
}

// The standard deviation of the score of a layer whose phases are random.
float DeviationOf(const Layer& layer)
{
  float squares = 0.0F;
  for (const SectorPhase& sector : layer)
  {
    squares += sector.weight * sector.weight;
  }
  return std::sqrt(0.5F * squares);
}

// Sectors that some sweep of the layer has.
std::size_t DirectionsOf(const Layer& layer)
{
  std::array<bool, sectorCount> seen{};
  for (const SectorPhase& sector : layer)
  {
    const double azimuth = std::atan2(double(sector.east), double(sector.north)) / RadiansPerDegree;
    seen[std::size_t((azimuth < 0.0 ? azimuth + 360.0 : azimuth) / 10.0) % sectorCount] = true;
  }
  return std::size_t(std::count(seen.begin(), seen.end(), true));
}

// The sectors of each layer as one sweep has them.
std::vector<Layer> LayersOf(const SweepRing& ring)
{
  constexpr std::size_t mostNyquists = 8; // a sweep with more is no radar's
  std::vector<Layer> layers(layerCount);
  std::vector<float> nyquists = ring.nyquist;
  std::sort(nyquists.begin(), nyquists.end());
  nyquists.erase(std::unique(nyquists.begin(), nyquists.end()), nyquists.end());
  for (std::size_t each = 0; each < std::min(mostNyquists, nyquists.size()); ++each)
  {
    if (nyquists[each] > 0.0F)
    {
      AddSectors(ring, nyquists[each], layers);
    }
  }
  return layers;
}

std::vector<Layer> LayersOf(const std::vector<const SweepRing*>& sweeps, const RangeLoop& loop)
{
  std::vector<std::vector<Layer>> parts(sweeps.size());
  RunEach(loop, sweeps.size(), [&](std::size_t index) { parts[index] = LayersOf(*sweeps[index]); });
  std::vector<Layer> layers(layerCount);
  for (const std::vector<Layer>& part : parts)
  {
    for (std::size_t layer = 0; layer < layerCount; ++layer)
    {
      layers[layer].insert(layers[layer].end(), part[layer].begin(), part[layer].end());
    }
  }
  return layers;
}

// The layers that are seen from enough directions, with their candidates.
std::vector<LayerChoice> FindChoices(const std::vector<Layer>& layers, const RangeLoop& loop)
{
  constexpr std::size_t fewestDirections = 6;
  const CosineTable cosine;
  std::vector<LayerChoice> choices;
  for (std::size_t layer = 0; layer < layerCount; ++layer)
  {
    if (DirectionsOf(layers[layer]) >= fewestDirections)
    {
      choices.push_back({layer, {}, {}, {}});
    }
  }
  RunEach(loop, choices.size(),
    [&](std::size_t index)
    { choices[index].candidates = FindCandidates(layers[choices[index].layer], cosine); });
  choices.erase(std::remove_if(choices.begin(), choices.end(),
                  [](const LayerChoice& choice) { return choice.candidates.empty(); }),
    choices.end());
  return choices;
}

void FindWays(const std::vector<Layer>& layers, std::vector<LayerChoice>& choices)
{
  for (std::size_t index = 0; index < choices.size(); ++index)
  {
    LayerChoice& choice = choices[index];
    const float weight = WeightOf(layers[choice.layer]);
    for (const WindCandidate& candidate : choice.candidates)
    {
      float best = index == 0 ? 0.0F : -1.0e9F;
      std::size_t from = 0;
      for (std::size_t each = 0; index > 0 && each < choices[index - 1].candidates.size(); ++each)
      {
        const LayerChoice& before = choices[index - 1];
        const float sum = before.sums[each] - Cost(before.candidates[each].wind, candidate.wind,
                                                choice.layer - before.layer);
        if (sum > best)
        {
          best = sum;
          from = each;
        }
      }
      choice.sums.push_back(best + Worth(candidate, weight));
      choice.from.push_back(from);
    }
  }
}

} // namespace

WindProfile FindFoldedWind(const std::vector<const SweepRing*>& sweeps, const RangeLoop& loop)
{
  constexpr float leastAgreement = 0.5F;
  constexpr float leastDeviations = 3.5F;
  const std::vector<Layer> layers = LayersOf(sweeps, loop);
  std::vector<LayerChoice> choices = FindChoices(layers, loop);
  WindProfile profile;
  if (choices.empty())
  {
    return profile;
  }
  FindWays(layers, choices);
  const std::vector<float>& sums = choices.back().sums;
  auto chosen = std::size_t(std::max_element(sums.begin(), sums.end()) - sums.begin());
  for (std::size_t index = choices.size(); index-- > 0;)
  {
    const LayerChoice& choice = choices[index];
    const WindCandidate& candidate = choice.candidates[chosen];
    const Layer& layer = layers[choice.layer];
    if (candidate.score >= leastAgreement * WeightOf(layer) &&
        candidate.score >= leastDeviations * DeviationOf(layer))
    {
      profile.levels.push_back({(static_cast<double>(choice.layer) + 0.5) * layerDepth,
        candidate.wind, 0.0, layer.size()});
    }
    chosen = choice.from[chosen];
  }
  std::reverse(profile.levels.begin(), profile.levels.end());
  return profile;
}

} // namespace nexrad
