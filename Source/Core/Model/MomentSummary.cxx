// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Model/MomentSummary.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

namespace nexrad
{

namespace
{

// What Summarize needs of the words of rays of one scale and offset. Sweeps have one, but nothing
// in the format says so.
class WordSums
{
public:
  explicit WordSums(const MomentRow& row)
    : scale(row.scale)
    , offset(row.offset)
    , firstValue(row.firstValue)
  {
  }

  bool Fits(const MomentRow& row) const { return row.scale == scale && row.offset == offset; }
  void Add(const MomentRow& row)
  {
    gates += row.gates;
    const std::uint8_t* words = row.words;
    if (row.wordBits == 16)
    {
      this->AddWords(
        row.gates, [words](int gate) { return words[2 * gate] << 8 | words[2 * gate + 1]; });
    }
    else
    {
      this->AddWords(row.gates, [words](int gate) { return int(words[gate]); });
    }
  }
  // Adds the codes below the first value, and the values' count, extremes and sum.
  void AddTo(MomentSummary& summary, double& sum) const
  {
    if (firstValue > 2)
    {
      summary.status += gates - values;
    }
    else
    {
      summary.rangeFolded += ones;
      summary.belowThreshold += gates - values - ones;
    }
    for (const int raw : {least, most})
    {
      if (values > 0)
      {
        const double value = (static_cast<double>(raw) - offset) / scale;
        summary.minimum = std::min(summary.minimum, value);
        summary.maximum = std::max(summary.maximum, value);
      }
    }
    summary.valid += values;
    sum += (static_cast<double>(rawSum) - static_cast<double>(values) * offset) / scale;
  }

private:
  // Every word of every file passes here. The loop has no branch, and no number of it is a member,
  // which bytes could alias: so a compiler takes several words at a time. A ray has at most 65,535
  // gates of 65,535, whose sum fits 32 bits.
  template <class WordAt>
  void AddWords(int count, const WordAt& wordAt)
  {
    const auto first = static_cast<int>(firstValue);
    int valuesHere = 0;
    int onesHere = 0;
    std::uint32_t sumHere = 0;
    int leastHere = least;
    int mostHere = most;
    for (int gate = 0; gate < count; ++gate)
    {
      const int raw = wordAt(gate);
      const int below = (raw - first) >> 31; // all bits of a word that is no value
      valuesHere += 1 + below;
      onesHere += raw == 1 ? 1 : 0;
      sumHere += static_cast<std::uint32_t>(raw & ~below);
      leastHere = std::min(leastHere, raw | (below & noWord));
      mostHere = std::max(mostHere, raw);
    }
    values += static_cast<std::size_t>(valuesHere);
    ones += static_cast<std::size_t>(onesHere);
    rawSum += sumHere;
    least = leastHere;
    most = mostHere;
  }

  double scale;
  double offset;
  unsigned firstValue;
  std::size_t gates = 0;
  std::size_t values = 0;
  std::size_t ones = 0; // gates whose word is 1
  std::uint64_t rawSum = 0;
  static constexpr int noWord = 65'536;
  int least = noWord; // of the values
  int most = 0;
};

} // namespace

MomentSummary Summarize(const Sweep& sweep, MomentName moment)
{
  MomentSummary summary;
  std::vector<WordSums> groups;
  for (const Ray& ray : sweep.rays)
  {
    const MomentRow& row = ray.Row(moment);
    if (row.gates == 0)
    {
      continue;
    }
    if (summary.rays++ == 0)
    {
      summary.firstGate = row.firstGate;
      summary.gateSpacing = row.gateSpacing;
    }
    summary.gates = std::max<std::size_t>(summary.gates, row.gates);
    auto group = std::find_if(
      groups.begin(), groups.end(), [&row](const WordSums& each) { return each.Fits(row); });
    if (group == groups.end())
    {
      group = groups.emplace(groups.end(), row);
    }
    group->Add(row);
  }
  double sum = 0.0;
  summary.minimum = std::numeric_limits<double>::infinity();
  summary.maximum = -summary.minimum;
  for (const WordSums& group : groups)
  {
    group.AddTo(summary, sum);
  }
  if (summary.valid == 0)
  {
    summary.minimum = summary.maximum = 0.0;
    return summary;
  }
  summary.mean = sum / static_cast<double>(summary.valid);
  return summary;
}

} // namespace nexrad
