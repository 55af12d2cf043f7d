// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Quality/SpikeTest.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace nexrad
{

namespace
{

constexpr double nearest = 10'000.0;    // m, from where on spikes are looked for
constexpr std::size_t fewestGates = 40; // with a value
constexpr float ofAllGates = 0.6F;      // of the gates of a spike have a value
constexpr float ofOneValue = 0.9F;      // of the gates of a faulty ray
constexpr float steady = 3.0F;          // dB, of a spike's power
constexpr float ofSteady = 0.5F;        // of the gates are as steady
constexpr float over = 4.0F;            // dB, over both neighbours
constexpr float ofOver = 0.6F;          // of the gates are as much stronger

// 20·log10 of the range of each gate in km.
std::vector<float> FindSpreading(const EchoGrid& grid)
{
  std::vector<float> spreading;
  for (std::size_t gate = 0; gate < grid.Gates(); ++gate)
  {
    spreading.push_back(
      static_cast<float>(20.0 * std::log10(std::max(grid.RangeOf(gate), 100.0) / 1000.0)));
  }
  return spreading;
}

class SpikeSearch
{
public:
  SpikeSearch(const EchoGrid& theGrid, std::vector<EchoReason>& theReasons)
    : grid(theGrid)
    , reasons(theReasons)
    , spreading(FindSpreading(theGrid))
    , first(theGrid.GatesWithin(nearest))
  {
  }

  void Judge(std::size_t place)
  {
    const GateRange held = grid.Held(place);
    if (held.end < held.begin + fewestGates)
    {
      return;
    }
    const std::size_t far = std::clamp(first, held.begin, std::max(held.begin, held.end));
    values.clear();
    this->Collect(place, {held.begin, far});
    const std::size_t ofNear = values.size();
    this->Collect(place, {far, held.end});
    if (values.size() < fewestGates)
    {
      return;
    }
    if (this->IsOneValue())
    {
      this->Mark(place, EchoReason::ConstantValue, [](std::size_t) { return true; });
    }
    else if (this->IsFilled(values.size() - ofNear))
    {
      this->JudgePower(place);
    }
  }

  // The rays beside spikes, where the beam's edge sees less of the same power: single gates there
  // that have no echo behind them.
  void MarkEdges()
  {
    for (const auto& [place, power] : spikes)
    {
      for (const int step : {-2, -1, 1, 2})
      {
        this->MarkEdge(grid.Beside(place, step), grid.Beside(place, 2 * step), power);
      }
    }
  }

private:
  void MarkEdge(std::size_t place, std::size_t beyond, float power)
  {
    if (place >= grid.Rays())
    {
      return;
    }
    const float* row = grid.Row(place);
    this->Mark(place, EchoReason::ConstantPower,
      [&](std::size_t gate)
      {
        const bool inside = gate >= first && gate > 0 && gate + 1 < grid.Gates();
        return inside && !(this->HasEcho(place, gate - 1) && this->HasEcho(place, gate + 1)) &&
               !this->HasEcho(beyond, gate) && row[gate] - spreading[gate] - power <= steady;
      });
  }

  bool HasEcho(std::size_t place, std::size_t gate) const { return IsNumber(grid.At(place, gate)); }

  // Adds the values of some gates of a row.
  void Collect(std::size_t place, const GateRange& range)
  {
    if (range.IsEmpty())
    {
      return;
    }
    const float* row = grid.Row(place);
    std::size_t count = values.size();
    values.resize(count + range.end - range.begin);
    for (std::size_t gate = range.begin; gate < range.end; ++gate)
    {
      values[count] = row[gate]; // the next one takes its place where it is none
      count += IsNumber(row[gate]) ? 1 : 0;
    }
    values.resize(count);
  }

  // Whether so many gates from `first` on may be those of a spike.
  bool IsFilled(std::size_t count) const
  {
    const auto reach = static_cast<float>(grid.Gates() - std::min(first, grid.Gates()));
    return count >= fewestGates && static_cast<float>(count) >= ofAllGates * reach;
  }

  // Of a ray at one value, one of these three gates has it.
  bool IsOneValue() const
  {
    for (const std::size_t at : {values.size() / 4, values.size() / 2, 3 * values.size() / 4})
    {
      const auto same = std::count(values.begin(), values.end(), values[at]);
      if (static_cast<float>(same) >= ofOneValue * static_cast<float>(values.size()))
      {
        return true;
      }
    }
    return false;
  }

  void JudgePower(std::size_t place)
  {
    const float* row = grid.Row(place);
    const GateRange far = {std::max(first, grid.Held(place).begin), grid.Held(place).end};
    powers.clear();
    for (std::size_t gate = far.begin; gate < far.end; ++gate)
    {
      if (IsNumber(row[gate]))
      {
        powers.push_back(row[gate] - spreading[gate]);
      }
    }
    const auto middle = powers.begin() + static_cast<std::ptrdiff_t>(powers.size() / 2);
    std::nth_element(powers.begin(), middle, powers.end());
    const float power = *middle;
    // A spike is up to three rays wide: it is compared with three rays on each side.
    const std::array<std::size_t, 3> before = {
      grid.Beside(place, -1), grid.Beside(place, -2), grid.Beside(place, -3)};
    const std::array<std::size_t, 3> after = {
      grid.Beside(place, 1), grid.Beside(place, 2), grid.Beside(place, 3)};
    const auto isOverBoth = [&](std::size_t gate)
    {
      const auto isBelow = [&](std::size_t other)
      { return grid.At(other, gate) < row[gate] - over; };
      return std::any_of(before.begin(), before.end(), isBelow) &&
             std::any_of(after.begin(), after.end(), isBelow);
    };
    const auto isSteady = [&](std::size_t gate)
    { return std::abs(row[gate] - spreading[gate] - power) <= steady; };
    std::size_t alike = 0;
    std::size_t alone = 0;
    for (std::size_t gate = far.begin; gate < far.end; ++gate)
    {
      if (IsNumber(row[gate]) && isSteady(gate))
      {
        ++alike;
        alone += isOverBoth(gate) ? 1 : 0;
      }
    }
    if (static_cast<float>(alike) >= ofSteady * static_cast<float>(powers.size()) &&
        static_cast<float>(alone) >= ofOver * static_cast<float>(alike))
    {
      this->Mark(place, EchoReason::ConstantPower,
        [&](std::size_t gate)
        {
          const float above = row[gate] - spreading[gate] - power;
          return above <= steady && above >= -2.0F * steady;
        });
      spikes.emplace_back(place, power);
    }
  }

  template <typename Condition>
  void Mark(std::size_t place, EchoReason reason, const Condition& condition)
  {
    const float* row = grid.Row(place);
    const GateRange held = grid.Held(place);
    EchoReason* own = reasons.data() + grid.Index(place, 0);
    for (std::size_t gate = held.begin; gate < held.end; ++gate)
    {
      if (IsNumber(row[gate]) && condition(gate))
      {
        own[gate] = reason;
      }
    }
  }

  const EchoGrid& grid;
  std::vector<EchoReason>& reasons;
  std::vector<float> spreading;
  std::size_t first;
  std::vector<float> values;
  std::vector<float> powers;
  std::vector<std::pair<std::size_t, float>> spikes; // rows and their powers
};

} // namespace

void FindSpikes(const EchoGrid& grid, std::vector<EchoReason>& reasons)
{
  SpikeSearch search(grid, reasons);
  for (std::size_t place = 0; place < grid.Rays(); ++place)
  {
    search.Judge(place);
  }
  search.MarkEdges();
}

} // namespace nexrad
