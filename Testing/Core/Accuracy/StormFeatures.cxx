// SPDX-License-Identifier: BSD-3-Clause
#include "StormFeatures.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace nexrad::testing
{

namespace
{

// A volume's columns, with 0 dBZ for all that is no echo or that no beam saw.
class Columns
{
public:
  Columns(const Truth& truth, std::vector<float> theValues)
    : grid(truth.grid)
    , values(std::move(theValues))
  {
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      values[i] = truth.counts[i] != 0 ? std::max(values[i], 0.0F) : 0.0F;
    }
  }

  std::size_t Count() const
  {
    return static_cast<std::size_t>(grid.dimensions[0]) *
           static_cast<std::size_t>(grid.dimensions[1]);
  }

  float At(std::size_t column, int level) const
  {
    return values[static_cast<std::size_t>(level) * this->Count() + column];
  }

  std::optional<double> EchoTop(std::size_t column, float threshold) const
  {
    for (int level = grid.dimensions[2] - 1; level >= 0; --level)
    {
      const float here = this->At(column, level);
      if (here >= threshold)
      {
        const float above = level + 1 < grid.dimensions[2] ? this->At(column, level + 1) : here;
        const float part = here > above ? (here - threshold) / (here - above) : 0.0F;
        return grid.Coordinate(2, level) + static_cast<double>(part) * grid.spacing[2];
      }
    }
    return std::nullopt;
  }

  std::vector<float> Maxima() const
  {
    std::vector<float> maxima(this->Count(), 0.0F);
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      float& largest = maxima[i % this->Count()];
      largest = std::max(largest, values[i]);
    }
    return maxima;
  }

private:
  const GridSpecification& grid;
  std::vector<float> values;
};

// The largest value within `radius` m of a column, and the distance to where it stands.
struct Peak
{
  float value = 0.0F;
  double distance = 0.0;
};

Peak FindPeak(
  const std::vector<float>& maxima, const GridSpecification& grid, int x, int y, double radius)
{
  Peak peak;
  const int reachX = static_cast<int>(radius / grid.spacing[0]);
  const int reachY = static_cast<int>(radius / grid.spacing[1]);
  for (int j = std::max(0, y - reachY); j <= std::min(grid.dimensions[1] - 1, y + reachY); ++j)
  {
    for (int i = std::max(0, x - reachX); i <= std::min(grid.dimensions[0] - 1, x + reachX); ++i)
    {
      const double distance = std::hypot((i - x) * grid.spacing[0], (j - y) * grid.spacing[1]);
      const float value =
        maxima[static_cast<std::size_t>(j) * static_cast<std::size_t>(grid.dimensions[0]) +
               static_cast<std::size_t>(i)];
      if (distance <= radius && value > peak.value)
      {
        peak = {value, distance};
      }
    }
  }
  return peak;
}

} // namespace

EchoTopScore CompareEchoTops(const GriddedVolume& result, const Truth& truth)
{
  constexpr float threshold = 18.0F;
  const Columns got(truth, result.values);
  const Columns wanted(truth, truth.values);
  EchoTopScore score;
  for (std::size_t column = 0; column < got.Count(); ++column)
  {
    const auto top = got.EchoTop(column, threshold);
    const auto trueTop = wanted.EchoTop(column, threshold);
    if (top && trueTop)
    {
      ++score.columns;
      score.meanError += *top - *trueTop;
      score.meanAbsoluteError += std::abs(*top - *trueTop);
    }
  }
  const auto columns = static_cast<double>(std::max<std::size_t>(score.columns, 1));
  score.meanError /= columns;
  score.meanAbsoluteError /= columns;
  return score;
}

CoreScore CompareCores(const GriddedVolume& result, const Truth& truth)
{
  const std::vector<float> got = Columns(truth, result.values).Maxima();
  const std::vector<float> wanted = Columns(truth, truth.values).Maxima();
  CoreScore score;
  std::size_t column = 0;
  for (int y = 0; y < truth.grid.dimensions[1]; ++y)
  {
    for (int x = 0; x < truth.grid.dimensions[0]; ++x, ++column)
    {
      const bool isCore = wanted[column] >= 50.0F &&
                          FindPeak(wanted, truth.grid, x, y, 15'000.0).value <= wanted[column];
      if (isCore)
      {
        const Peak peak = FindPeak(got, truth.grid, x, y, 10'000.0);
        ++score.cores;
        score.found += peak.value >= 45.0F ? 1 : 0;
        score.meanDistance += peak.value >= 45.0F ? peak.distance : 0.0;
      }
    }
  }
  score.meanDistance /= static_cast<double>(std::max<std::size_t>(score.found, 1));
  return score;
}

} // namespace nexrad::testing
