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

// How often each word occurs among rays of one scale and offset. Sweeps have one, but nothing in
// the format says so.
class WordCounts
{
public:
  explicit WordCounts(const MomentRow& row)
    : scale(row.scale)
    , offset(row.offset)
    , firstValue(row.firstValue)
    , counts(std::size_t(1) << 16)
  {
  }

  bool Fits(const MomentRow& row) const { return row.scale == scale && row.offset == offset; }
  void Add(const MomentRow& row)
  {
    for (std::size_t gate = 0; gate < row.gates; ++gate)
    {
      ++counts[row.Raw(gate)];
    }
  }
  // Adds the codes below the first value, and the values' count, extremes and sum.
  void AddTo(MomentSummary& summary, double& sum) const
  {
    for (std::size_t raw = 0; raw < firstValue; ++raw)
    {
      (firstValue > 2 ? summary.status
        : raw == 1    ? summary.rangeFolded
                      : summary.belowThreshold) += counts[raw];
    }
    std::uint64_t values = 0;
    std::uint64_t rawSum = 0;
    for (std::size_t raw = firstValue; raw < counts.size(); ++raw)
    {
      if (counts[raw] > 0)
      {
        values += counts[raw];
        rawSum += raw * counts[raw];
        const double value = (static_cast<double>(raw) - offset) / scale;
        summary.minimum = std::min(summary.minimum, value);
        summary.maximum = std::max(summary.maximum, value);
      }
    }
    summary.valid += values;
    sum += (static_cast<double>(rawSum) - static_cast<double>(values) * offset) / scale;
  }

private:
  double scale;
  double offset;
  std::size_t firstValue;
  std::vector<std::size_t> counts;
};

} // namespace

MomentSummary Summarize(const Sweep& sweep, MomentName moment)
{
  MomentSummary summary;
  std::vector<WordCounts> groups;
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
      groups.begin(), groups.end(), [&row](const WordCounts& each) { return each.Fits(row); });
    if (group == groups.end())
    {
      group = groups.emplace(groups.end(), row);
    }
    group->Add(row);
  }
  double sum = 0.0;
  summary.minimum = std::numeric_limits<double>::infinity();
  summary.maximum = -summary.minimum;
  for (const WordCounts& group : groups)
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
