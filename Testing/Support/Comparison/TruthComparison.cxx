// SPDX-License-Identifier: BSD-3-Clause
#include "Comparison/TruthComparison.h"

#include "nexrad/System/Error.h"

#include <algorithm>
#include <cmath>

namespace nexrad
{

namespace
{

double PartOf(std::size_t part, std::size_t whole)
{
  return whole == 0 ? 0.0 : static_cast<double>(part) / static_cast<double>(whole);
}

} // namespace

double TruthScore::MissedFraction() const
{
  return PartOf(missed, trueEcho);
}

double TruthScore::FalseFraction() const
{
  return PartOf(falseEcho, trueEcho);
}

TruthScore CompareWithTruth(const GriddedVolume& result, const std::vector<float>& truth,
  const std::vector<std::uint8_t>& counts)
{
  const std::size_t size = result.values.size();
  if (result.states.size() != size || truth.size() != size || counts.size() != size)
  {
    throw Error("the result, the truth and the mask must have the same number of voxels");
  }
  TruthScore score;
  double sum = 0.0;
  double squares = 0.0;
  for (std::size_t i = 0; i < size; ++i)
  {
    if (counts[i] == 0)
    {
      continue;
    }
    ++score.voxels;
    const bool echo = result.states[i] == VoxelState::Echo;
    const float got = echo ? std::max(result.values[i], 0.0F) : 0.0F;
    const float wanted = std::max(truth[i], 0.0F);
    const bool wantedEcho = wanted >= TruthScore::EchoThreshold;
    const bool gotEcho = got >= TruthScore::EchoThreshold;
    score.trueEcho += wantedEcho ? 1 : 0;
    score.missed += wantedEcho && got == 0.0F ? 1 : 0;
    score.falseEcho += gotEcho && wanted == 0.0F ? 1 : 0;
    if (wantedEcho || gotEcho)
    {
      const double difference = static_cast<double>(got) - static_cast<double>(wanted);
      ++score.compared;
      sum += difference;
      squares += difference * difference;
    }
  }
  if (score.compared > 0)
  {
    score.bias = sum / static_cast<double>(score.compared);
    score.rmse = std::sqrt(squares / static_cast<double>(score.compared));
  }
  return score;
}

} // namespace nexrad
