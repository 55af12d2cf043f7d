// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Velocity/FoldSupport.h"

#include "nexrad/Geometry/Angles.h"
#include "nexrad/Geometry/Beam.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace nexrad
{

namespace
{

constexpr float alike = 0.5F;       // of the Nyquist velocity, between neighbours of one patch
constexpr float besideBroad = 1.0F; // the same, of narrow patches beside broad ones
constexpr double broadest = 5.0;    // degrees of azimuth that a beam and a transmitter can fill
constexpr std::size_t fewestFileGates = 10;  // one in so many gates of a broad patch has fold 0
constexpr std::size_t fewestBorderGates = 3; // one in so many of a narrow patch is at a broad one
constexpr float nearOthers = 12.0F;          // m/s from velocities of other sweeps, and
constexpr float closeOthers = 0.25F;         // at least this mean closeness to them
constexpr double reachOfProfile =
  4'000.0;                          // m above and below the profile that its ends tell something
constexpr float nearWind = 14.0F;   // m/s from the profile's wind, in the mean of a patch
constexpr float nearEnds = 10.0F;   // m/s from that of the profile's end, where it does not reach
constexpr float leastOthers = 0.1F; // mean weight of other sweeps at a patch

// A patch: connected gates of one sweep with like unfolded velocities, all of them broad or none.
struct Patch
{
  std::size_t gates = 0;
  std::size_t moved = 0;  // whose fold is not 0
  std::size_t border = 0; // beside a broad gate of a like velocity
  std::size_t inWind = 0; // gates where the profile tells a wind
  float away = 0.0F;      // their differences from it, each in units of what is near
};

// Gates of one patch whose folds are in doubt, and these folds.
struct DoubtfulGates
{
  std::vector<std::size_t> gates;
  std::vector<Fold> folds; // once they are taken out
  bool othersAgree = false;
};

bool IsMoved(Fold fold)
{
  return fold != NoFold && fold != 0;
}

class PatchFinder
{
public:
  PatchFinder(const SweepFolds& theSweep, const WindProfile& profile)
    : sweep(theSweep)
    , ring(theSweep.ring)
    , unfolded(ring.velocity.size())
    , broad(ring.velocity.size(), 0)
    , connected(ring.velocity.size())
  {
    for (std::size_t row = 0; row < ring.rows; ++row)
    {
      for (std::size_t gate = 0; gate < ring.gates; ++gate)
      {
        unfolded[row * ring.gates + gate] = sweep.Unfolded(row, gate);
      }
    }
    this->FindWinds(profile);
  }

  std::vector<DoubtfulGates> Find()
  {
    this->FindBroadGates();
    this->Connect();
    this->Describe();
    return this->Collect();
  }

private:
  static constexpr std::int32_t None = -1;

  // The wind at the place of each gate of a ray.
  struct GateWind
  {
    double height = 0.0; // m above the antenna
    float east = 0.0F;
    float north = 0.0F;
    float nearby = 0.0F; // m/s from it that are near; 0 without a wind
  };

  void FindWinds(const WindProfile& profile)
  {
    const BeamModel beam;
    const double level = std::cos(ring.elevation * RadiansPerDegree);
    for (std::size_t gate = 0; gate < ring.gates; ++gate)
    {
      GateWind wind;
      wind.height = beam.Locate(ring.RangeOf(gate), ring.elevation).height;
      if (const std::optional<Wind> there = profile.At(wind.height, reachOfProfile))
      {
        wind.east = static_cast<float>(level * there->east);
        wind.north = static_cast<float>(level * there->north);
        wind.nearby = profile.At(wind.height) ? nearWind : nearEnds;
      }
      winds.push_back(wind);
    }
  }

  // The difference of two velocities; NaN where there is none.
  float Difference(std::size_t a, std::size_t b) const
  {
    return std::abs(unfolded[a] - unfolded[b]);
  }

  // Rays that are more than `broadest` wide.
  std::uint8_t RowsOfBroad() const
  {
    std::vector<double> steps;
    for (std::size_t row = 0; row < ring.rows; ++row)
    {
      steps.push_back(std::abs(AngleDifference(static_cast<double>(ring.azimuth[row]),
        static_cast<double>(ring.azimuth[ring.NextRow(row)]))));
    }
    const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
    std::nth_element(steps.begin(), middle, steps.end());
    return static_cast<std::uint8_t>(
      std::clamp(std::floor(broadest / std::max(*middle, 0.1)) + 1.0, 3.0, 100.0));
  }

  // Of each gate the number of rays in a chain of like velocities that ends there; a ray without a
  // velocity may be between two. `step`: from which side the chain comes.
  std::vector<std::uint8_t> ChainLengths(int step) const
  {
    constexpr std::size_t turn = 100; // the rows with which the turn begins are done again
    std::vector<std::uint8_t> lengths(unfolded.size(), 0);
    for (std::size_t count = 0; count < ring.rows + std::min(ring.rows, turn); ++count)
    {
      const std::size_t row =
        step > 0 ? count % ring.rows : (2 * ring.rows - 1 - count % ring.rows) % ring.rows;
      const std::size_t before = this->Beside(row, -step);
      const std::size_t second = before < ring.rows ? this->Beside(before, -step) : ring.rows;
      const float limit = alike * ring.nyquist[row];
      for (std::size_t gate = 0; gate < ring.gates; ++gate)
      {
        const std::size_t index = row * ring.gates + gate;
        if (std::isnan(unfolded[index]))
        {
          continue;
        }
        const std::size_t last = before * ring.gates + gate;
        const bool isGap = before < ring.rows && std::isnan(unfolded[last]);
        const std::size_t other = isGap ? second * ring.gates + gate : last;
        const bool goesOn = other < unfolded.size() && this->Difference(index, other) < limit;
        lengths[index] =
          static_cast<std::uint8_t>(goesOn ? std::min(100, lengths[other] + (isGap ? 2 : 1)) : 1);
      }
    }
    return lengths;
  }

  // rows where no ray is beside the row.
  std::size_t Beside(std::size_t row, int step) const
  {
    const std::size_t other = step > 0 ? ring.NextRow(row) : ring.PreviousRow(row);
    return ring.beside[step > 0 ? row : other] != 0 ? other : ring.rows;
  }

  void FindBroadGates()
  {
    const std::vector<std::uint8_t> before = this->ChainLengths(1);
    const std::vector<std::uint8_t> after = this->ChainLengths(-1);
    const int rows = this->RowsOfBroad();
    for (std::size_t index = 0; index < broad.size(); ++index)
    {
      broad[index] = before[index] + after[index] > rows ? 1 : 0; // the gate itself counts twice
    }
  }

  template <typename Work>
  void ForNeighbours(const Work& work)
  {
    for (std::size_t row = 0; row < ring.rows; ++row)
    {
      const std::size_t next = this->Beside(row, 1);
      for (std::size_t gate = 0; gate < ring.gates; ++gate)
      {
        const std::size_t index = row * ring.gates + gate;
        if (gate + 1 < ring.gates)
        {
          work(row, index, index + 1);
        }
        if (next < ring.rows)
        {
          work(row, index, next * ring.gates + gate);
        }
      }
    }
  }

  void Connect()
  {
    atBroad.assign(broad.size(), 0);
    this->ForNeighbours(
      [this](std::size_t row, std::size_t a, std::size_t b)
      {
        const float difference = this->Difference(a, b) / ring.nyquist[row];
        if (broad[a] == broad[b] && difference < alike)
        {
          connected.Join(a, b);
        }
        if (broad[a] != broad[b] && difference < besideBroad)
        {
          atBroad[broad[a] != 0 ? b : a] = 1;
        }
      });
  }

  void AddWind(std::size_t index, Patch& patch) const
  {
    const GateWind& wind = winds[index % ring.gates];
    if (wind.nearby > 0.0F)
    {
      const double azimuth =
        static_cast<double>(ring.azimuth[index / ring.gates]) * RadiansPerDegree;
      const float expected = wind.east * static_cast<float>(std::sin(azimuth)) +
                             wind.north * static_cast<float>(std::cos(azimuth));
      ++patch.inWind;
      patch.away += std::abs(unfolded[index] - expected) / wind.nearby;
    }
  }

  // The patches that have gates whose fold is not 0.
  void Describe()
  {
    numbers.assign(unfolded.size(), None);
    for (std::size_t index = 0; index < unfolded.size(); ++index)
    {
      if (IsMoved(sweep.gateFold[index]))
      {
        std::int32_t& number = this->NumberOf(index);
        if (number == None)
        {
          number = static_cast<std::int32_t>(patches.size());
          patches.emplace_back();
        }
        Patch& patch = patches[std::size_t(number)];
        ++patch.moved;
        patch.border += atBroad[index];
        this->AddWind(index, patch);
      }
    }
    for (std::size_t index = 0; index < unfolded.size(); ++index)
    {
      const std::int32_t number = std::isnan(unfolded[index]) ? None : this->NumberOf(index);
      if (number != None)
      {
        ++patches[std::size_t(number)].gates;
      }
    }
  }

  std::int32_t& NumberOf(std::size_t index)
  {
    return numbers[std::size_t(connected.Find(std::int32_t(index)))];
  }

  // Whether the rays of a patch vouch for it.
  bool HoldsTogether(const Patch& patch, bool isBroad) const
  {
    return isBroad ? fewestFileGates * (patch.gates - patch.moved) >= patch.gates
                   : fewestBorderGates * patch.border >= patch.moved;
  }

  // The wind of storms differs from the mean wind: of a broad patch by up to twice as much.
  static bool IsNearWind(const Patch& patch, bool isBroad)
  {
    return 2 * patch.inWind >= patch.moved &&
           patch.away <= (isBroad ? 1.5F : 1.0F) * static_cast<float>(patch.inWind);
  }

  std::vector<DoubtfulGates> Collect()
  {
    std::vector<DoubtfulGates> doubtful(patches.size());
    for (std::size_t index = 0; index < unfolded.size(); ++index)
    {
      if (!IsMoved(sweep.gateFold[index]))
      {
        continue;
      }
      const auto number = std::size_t(this->NumberOf(index));
      const Patch& patch = patches[number];
      const bool isNearWind = IsNearWind(patch, broad[index] != 0);
      if (!this->HoldsTogether(patch, broad[index] != 0) &&
          !(isNearWind && std::abs(static_cast<double>(unfolded[index])) <=
                            FastestWind(winds[index % ring.gates].height)))
      {
        doubtful[number].gates.push_back(index);
      }
    }
    doubtful.erase(std::remove_if(doubtful.begin(), doubtful.end(),
                     [](const DoubtfulGates& patch) { return patch.gates.empty(); }),
      doubtful.end());
    return doubtful;
  }

  const SweepFolds& sweep;
  const SweepRing& ring;
  std::vector<float> unfolded;
  std::vector<GateWind> winds;       // of each gate of a ray
  std::vector<std::uint8_t> broad;   // of each gate: whether a chain through it is broad
  std::vector<std::uint8_t> atBroad; // of each gate that is not: whether it is beside one that is
  ConnectedGates connected;
  std::vector<std::int32_t> numbers; // of each first gate of a patch: its place in `patches`
  std::vector<Patch> patches;
};

// Whether other sweeps have velocities near to those of a patch, at its place.
bool OthersAgree(
  const SweepFolds& sweep, const ExpectedVelocities& expected, const DoubtfulGates& patch)
{
  float agree = 0.0F;
  float most = 0.0F;
  for (std::size_t each = 0; each < patch.gates.size(); ++each)
  {
    const std::size_t row = patch.gates[each] / sweep.ring.gates;
    const std::size_t gate = patch.gates[each] % sweep.ring.gates;
    FoldVotes all;
    FoldVotes ofWind;
    most += expected.AddVotes(row, gate, true, all) - expected.AddVotes(row, gate, false, ofWind);
    agree += all.Of(patch.folds[each]) - ofWind.Of(patch.folds[each]);
  }
  const float nyquist = sweep.ring.nyquist[patch.gates.front() / sweep.ring.gates];
  const float least = std::max(closeOthers, 1.0F - nearOthers / nyquist);
  return most >= leastOthers * static_cast<float>(patch.gates.size()) && agree >= least * most;
}

} // namespace

void RemoveUnsupportedFolds(
  std::vector<SweepFolds>& sweeps, const WindProfile& wind, const RangeLoop& loop)
{
  // Step by step over all sweeps: what a sweep reads of others must not change meanwhile.
  std::vector<std::vector<DoubtfulGates>> doubts(sweeps.size());
  RunEach(loop, sweeps.size(),
    [&](std::size_t index)
    {
      const std::vector<Fold>& folds = sweeps[index].gateFold;
      if (std::any_of(folds.begin(), folds.end(), IsMoved))
      {
        doubts[index] = PatchFinder(sweeps[index], wind).Find();
      }
    });
  RunEach(loop, sweeps.size(),
    [&](std::size_t index)
    {
      for (DoubtfulGates& patch : doubts[index])
      {
        for (const std::size_t gate : patch.gates)
        {
          patch.folds.push_back(sweeps[index].gateFold[gate]);
          sweeps[index].gateFold[gate] = NoFold;
        }
      }
    });
  RunEach(loop, sweeps.size(),
    [&](std::size_t index)
    {
      if (!doubts[index].empty())
      {
        const ExpectedVelocities expected(sweeps, index, wind);
        for (DoubtfulGates& patch : doubts[index])
        {
          patch.othersAgree = OthersAgree(sweeps[index], expected, patch);
        }
      }
    });
  RunEach(loop, sweeps.size(),
    [&](std::size_t index)
    {
      for (const DoubtfulGates& patch : doubts[index])
      {
        for (std::size_t each = 0; patch.othersAgree && each < patch.gates.size(); ++each)
        {
          sweeps[index].gateFold[patch.gates[each]] = patch.folds[each];
        }
      }
    });
}

double FastestWind(double height)
{
  return std::clamp(60.0 + 40.0 * (height - 5'000.0) / 5'000.0, 60.0, 100.0);
}

} // namespace nexrad
