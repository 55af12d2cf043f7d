// SPDX-License-Identifier: BSD-3-Clause
#include "FoldScore.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace nexrad::testing
{

namespace
{

// Gates connected with one that is wrong, which are then marked as seen.
std::size_t PatchSize(std::vector<char>& wrong, std::size_t first, std::size_t gates)
{
  std::vector<std::size_t> open = {first};
  wrong[first] = 0;
  std::size_t size = 0;
  const auto visit = [&](std::size_t index)
  {
    if (wrong[index] != 0)
    {
      wrong[index] = 0;
      open.push_back(index);
    }
  };
  while (!open.empty())
  {
    const std::size_t index = open.back();
    open.pop_back();
    ++size;
    if (index % gates > 0)
    {
      visit(index - 1);
    }
    if (index % gates + 1 < gates)
    {
      visit(index + 1);
    }
    visit((index + gates) % wrong.size());
    visit((index + wrong.size() - gates) % wrong.size());
  }
  return size;
}

// Whether seven of the eight gates about a gate have velocities within half a Nyquist velocity of
// its. Of noise, which has any velocity, one gate in 2,600 does.
bool IsSmooth(const VelocitySweep& truth, std::size_t index, float nyquist)
{
  const std::size_t size = truth.values.size();
  const std::size_t gate = index % truth.gates;
  if (gate == 0 || gate + 1 == truth.gates)
  {
    return false;
  }
  int like = 0;
  for (const std::size_t row : {index + size - truth.gates, index + size, index + truth.gates})
  {
    for (const std::size_t other : {(row - 1) % size, row % size, (row + 1) % size})
    {
      const bool near = truth.states[other] == GateState::Valid &&
                        std::abs(truth.values[other] - truth.values[index]) < 0.5F * nyquist;
      like += near ? 1 : 0;
    }
  }
  return like > 7; // itself among them
}

void AddSweep(const VelocitySweep& truth, const VelocitySweep& result, FoldScore& score)
{
  std::vector<char> wrong(truth.values.size(), 0);
  for (std::size_t index = 0; index < truth.values.size(); ++index)
  {
    if (truth.states[index] != GateState::Valid)
    {
      continue;
    }
    const bool known = result.states[index] == GateState::Valid;
    const bool right = known && std::abs(result.values[index] - truth.values[index]) < 1.0F;
    wrong[index] = known && !right ? 1 : 0;
    score.unknown += known ? 0 : 1;
    score.right += right ? 1 : 0;
    score.wrong += known && !right ? 1 : 0;
    if (known && IsSmooth(truth, index, result.rays[index / truth.gates].nyquist))
    {
      score.smooth += 1;
      score.smoothRight += right ? 1 : 0;
    }
  }
  for (std::size_t index = 0; index < wrong.size(); ++index)
  {
    if (wrong[index] != 0)
    {
      score.largestPatch = std::max(score.largestPatch, PatchSize(wrong, index, truth.gates));
    }
  }
}

void CountJump(float a, float b, float nyquist, JumpCounts& counts)
{
  const float difference = std::abs(a - b);
  if (nyquist > 0.0F && !std::isnan(difference))
  {
    ++counts.pairs;
    counts.jumps += difference > nyquist ? 1 : 0;
  }
}

} // namespace

double FoldScore::RightShare() const
{
  return 100.0 * static_cast<double>(right) / static_cast<double>(right + wrong);
}

double FoldScore::SmoothRightShare() const
{
  return 100.0 * static_cast<double>(smoothRight) / static_cast<double>(smooth);
}

double FoldScore::UnknownShare() const
{
  return 100.0 * static_cast<double>(unknown) / static_cast<double>(right + wrong + unknown);
}

FoldScore CompareFolds(const VelocityVolume& truth, const VelocityVolume& result)
{
  FoldScore score;
  for (std::size_t sweep = 0; sweep < truth.sweeps.size(); ++sweep)
  {
    AddSweep(truth.sweeps[sweep], result.sweeps.at(sweep), score);
  }
  return score;
}

double JumpCounts::Share() const
{
  return pairs == 0 ? 0.0 : 100.0 * static_cast<double>(jumps) / static_cast<double>(pairs);
}

JumpCounts CountJumps(const VelocityVolume& volume)
{
  JumpCounts counts;
  for (const VelocitySweep& sweep : volume.sweeps)
  {
    const SweepRing ring = MakeSweepRing(sweep);
    for (std::size_t row = 0; row < ring.rows; ++row)
    {
      const float* here = &ring.velocity[row * ring.gates];
      const float* next = &ring.velocity[ring.NextRow(row) * ring.gates];
      for (std::size_t gate = 0; gate < ring.gates; ++gate)
      {
        if (gate + 1 < ring.gates)
        {
          CountJump(here[gate], here[gate + 1], ring.nyquist[row], counts);
        }
        if (ring.beside[row] != 0)
        {
          CountJump(here[gate], next[gate], ring.nyquist[row], counts);
        }
      }
    }
  }
  return counts;
}

} // namespace nexrad::testing
