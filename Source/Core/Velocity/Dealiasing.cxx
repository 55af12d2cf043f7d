// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Velocity/Dealiasing.h"

#include "nexrad/Velocity/FoldPlacement.h"
#include "nexrad/Velocity/FoldSupport.h"
#include "nexrad/Velocity/FoldedWind.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace nexrad
{

namespace
{

constexpr int turns = 4;
constexpr float leastShareAbout = 0.6F; // of the votes of the gates about one
// How near a gate is to those about it, 1 for the same velocity and 0 for one a Nyquist velocity
// away: in the mean of all, or in a smaller mean when it is as near to one beside it on its ray. In
// a vortex most are farther.
constexpr float nearMean = 0.4F;
constexpr float farMean = 0.25F;

struct OpenGate
{
  std::size_t row;
  std::size_t gate;
};

// The votes of the gates about one, and how many there would be if all had its velocity.
struct NeighbourVotes
{
  FoldVotes votes;
  float most = 0.0F;
  FoldVotes beside; // how near the nearer of the two gates beside it on its ray is: 1 … 0
};

void AddNeighbour(const SweepFolds& sweep, const OpenGate& open, std::size_t row, std::size_t gate,
  float weight, NeighbourVotes& about)
{
  const float expected = sweep.Unfolded(row, gate);
  if (!std::isnan(expected))
  {
    const float nyquist = sweep.ring.nyquist[open.row];
    const float velocity = sweep.ring.velocity[open.row * sweep.ring.gates + open.gate];
    const float away = (expected - velocity) / (2.0F * nyquist);
    const float fold = std::nearbyint(away);
    const float closeness = 1.0F - 2.0F * std::abs(away - fold);
    about.votes.Add(int(fold), weight * closeness);
    about.most += weight;
    if (row == open.row && (gate + 1 == open.gate || gate == open.gate + 1))
    {
      about.beside.Raise(int(fold), closeness);
    }
  }
}

// Whether the rays on both sides of a gate differ by more than half the Nyquist velocity: then they
// say little of the gates between (Formulas V2).
bool IsSheared(const SweepFolds& sweep, const OpenGate& open)
{
  const float before = sweep.Unfolded(sweep.ring.PreviousRow(open.row), open.gate);
  const float after = sweep.Unfolded(sweep.ring.NextRow(open.row), open.gate);
  return std::abs(after - before) > 0.5F * sweep.ring.nyquist[open.row];
}

void AddRow(const SweepFolds& sweep, const OpenGate& open, std::size_t row, float weight,
  NeighbourVotes& votes)
{
  const std::size_t first = open.gate == 0 ? 0 : open.gate - 1;
  const std::size_t end = std::min(open.gate + 2, sweep.ring.gates);
  for (std::size_t gate = first; gate < end; ++gate)
  {
    AddNeighbour(sweep, open, row, gate, weight, votes);
  }
}

// Gates along the ray count most (Formulas V2).
NeighbourVotes VotesAbout(const SweepFolds& sweep, const OpenGate& open)
{
  constexpr std::size_t reach = 3;
  NeighbourVotes votes;
  for (std::size_t step = 1; step <= reach; ++step)
  {
    const float weight = 4.0F / static_cast<float>(step);
    if (open.gate >= step)
    {
      AddNeighbour(sweep, open, open.row, open.gate - step, weight, votes);
    }
    if (open.gate + step < sweep.ring.gates)
    {
      AddNeighbour(sweep, open, open.row, open.gate + step, weight, votes);
    }
  }
  const float weight = IsSheared(sweep, open) ? 0.1F : 1.0F;
  const std::size_t before = sweep.ring.PreviousRow(open.row);
  if (sweep.ring.beside[before] != 0)
  {
    AddRow(sweep, open, before, weight, votes);
  }
  if (sweep.ring.beside[open.row] != 0)
  {
    AddRow(sweep, open, sweep.ring.NextRow(open.row), weight, votes);
  }
  return votes;
}

Fold ClearFold(const NeighbourVotes& about)
{
  const int best = about.votes.Best();
  const float votes = about.votes.Of(best);
  const bool isNear = votes >= nearMean * about.most ||
                      (votes >= farMean * about.most && about.beside.Of(best) >= nearMean);
  return votes > 0.0F && votes >= leastShareAbout * about.votes.Total() && isNear ? Fold(best)
                                                                                  : NoFold;
}

std::vector<OpenGate> FindOpenGates(const SweepFolds& sweep)
{
  std::vector<OpenGate> open;
  for (std::size_t row = 0; row < sweep.ring.rows; ++row)
  {
    for (std::size_t gate = 0; gate < sweep.ring.gates; ++gate)
    {
      const std::size_t index = row * sweep.ring.gates + gate;
      if (sweep.gateFold[index] == NoFold && sweep.ring.HasValue(index))
      {
        open.push_back({row, gate});
      }
    }
  }
  return open;
}

// Finds the folds of the gates of a sweep that are of no region, or of one that was not placed:
// those to which the gates about them are near, in several turns. A gate that agrees with none of
// its neighbours stays without a fold.
void FillFolds(SweepFolds& sweep)
{
  std::vector<OpenGate> open = FindOpenGates(sweep);
  std::vector<Fold> found;
  for (int turn = 0; turn < turns; ++turn)
  {
    found.clear();
    for (const OpenGate& each : open)
    {
      found.push_back(ClearFold(VotesAbout(sweep, each)));
    }
    std::vector<OpenGate> left;
    for (std::size_t each = 0; each < open.size(); ++each)
    {
      sweep.gateFold[open[each].row * sweep.ring.gates + open[each].gate] = found[each];
      if (found[each] == NoFold)
      {
        left.push_back(open[each]);
      }
    }
    open = std::move(left);
  }
}

// The folds of all gates of a sweep: those that it has, and those of gates without any neighbour of
// known fold that are within half a Nyquist velocity of what the wind profile and the sweeps below
// and above lead to expect. The others stay without a fold (Formulas V4).
std::vector<Fold> PlaceLoneGates(const SweepFolds& sweep, const ExpectedVelocities& expected)
{
  constexpr float halfway = 0.5F; // half a Nyquist velocity from what is expected
  std::vector<Fold> folds = sweep.gateFold;
  for (const OpenGate& open : FindOpenGates(sweep))
  {
    if (VotesAbout(sweep, open).votes.Total() > 0.0F)
    {
      continue; // its neighbours did not agree
    }
    FoldVotes votes;
    const float most = expected.AddVotes(open.row, open.gate, true, votes);
    const int best = votes.Best();
    if (most > 0.0F && votes.Of(best) >= halfway * most)
    {
      folds[open.row * sweep.ring.gates + open.gate] = Fold(best);
    }
  }
  return folds;
}

std::vector<SweepFolds> FindClusters(const VelocityVolume& volume, const RangeLoop& loop)
{
  std::vector<std::optional<SweepFolds>> found(volume.sweeps.size());
  RunEach(
    loop, found.size(), [&](std::size_t index) { found[index].emplace(volume.sweeps[index]); });
  std::vector<SweepFolds> sweeps;
  for (std::optional<SweepFolds>& sweep : found)
  {
    sweeps.push_back(std::move(*sweep));
  }
  return sweeps;
}

// The profile, with levels of another one at heights where it has none.
WindProfile Complete(WindProfile profile, const WindProfile& other)
{
  const WindProfile own = profile;
  for (const ProfileLevel& level : other.levels)
  {
    if (!own.At(level.height))
    {
      profile.levels.push_back(level);
    }
  }
  std::sort(profile.levels.begin(), profile.levels.end(),
    [](const ProfileLevel& a, const ProfileLevel& b) { return a.height < b.height; });
  return profile;
}

WindProfile ProfileFor(const std::vector<SweepFolds>& sweeps, const DealiasOptions& options)
{
  if (!options.wind.levels.empty())
  {
    return options.wind;
  }
  std::vector<const SweepRing*> rings;
  for (const SweepFolds& sweep : sweeps)
  {
    rings.push_back(&sweep.ring);
  }
  return Complete(FindFoldedWind(rings, options.loop), options.before);
}

DealiasCounts SetVelocities(const SweepFolds& folds, VelocitySweep& sweep)
{
  DealiasCounts counts;
  // Before they change: also those of rays without a Nyquist velocity, which the ring leaves out.
  counts.measured = static_cast<std::size_t>(std::count_if(
    sweep.values.begin(), sweep.values.end(), [](float value) { return !std::isnan(value); }));
  for (std::size_t row = 0; row < folds.ring.rows; ++row)
  {
    const std::size_t first = sweep.Index(folds.ring.ray[row], 0);
    for (std::size_t gate = 0; gate < folds.ring.gates; ++gate)
    {
      const std::size_t index = row * folds.ring.gates + gate;
      if (!folds.ring.HasValue(index))
      {
        continue;
      }
      const bool known = folds.gateFold[index] != NoFold;
      counts.unknown += known ? 0 : 1;
      counts.unfolded += known && folds.gateFold[index] != 0 ? 1 : 0;
      sweep.values[first + gate] = folds.Unfolded(row, gate); // NaN when not known
      sweep.states[first + gate] = known ? GateState::Valid : GateState::NotSampled;
    }
  }
  return counts;
}

} // namespace

DealiasCounts Dealias(VelocityVolume& volume, const DealiasOptions& options)
{
  std::vector<SweepFolds> sweeps = FindClusters(volume, options.loop);
  const WindProfile wind = ProfileFor(sweeps, options);
  PlaceClusters(sweeps, wind, options.loop);
  RunEach(options.loop, sweeps.size(), [&](std::size_t index) { FillFolds(sweeps[index]); });
  std::vector<std::vector<Fold>> folds(sweeps.size()); // apart: sweeps are read by others
  RunEach(options.loop, sweeps.size(),
    [&](std::size_t index)
    { folds[index] = PlaceLoneGates(sweeps[index], ExpectedVelocities(sweeps, index, wind)); });
  RunEach(options.loop, sweeps.size(),
    [&](std::size_t index) { sweeps[index].gateFold = std::move(folds[index]); });
  RemoveUnsupportedFolds(sweeps, wind, options.loop);
  std::vector<DealiasCounts> counts(sweeps.size());
  RunEach(options.loop, sweeps.size(),
    [&](std::size_t index) { counts[index] = SetVelocities(sweeps[index], volume.sweeps[index]); });
  DealiasCounts sum;
  for (const DealiasCounts& each : counts)
  {
    sum.measured += each.measured;
    sum.unfolded += each.unfolded;
    sum.unknown += each.unknown;
  }
  return sum;
}

} // namespace nexrad
