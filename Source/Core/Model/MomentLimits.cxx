// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Model/MomentLimits.h"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <limits>

namespace nexrad
{

namespace
{

// Radars state the Nyquist velocity more coarsely than they fold velocities.
constexpr float nyquistTolerance = 1.0F; // m/s

struct Limits
{
  float least;
  float most;
};

// The least and the largest of a row's words that are values; none when the least is above the
// largest.
struct WordRange
{
  unsigned least;
  unsigned most;
};

// Every ray of every file is looked through: the loop has no branch, and the compiler can put words
// side by side. The codes before the first value turn into the largest words.
template <class Word, class WordAt>
WordRange FindWordRange(std::size_t gates, Word firstValue, const WordAt& wordAt)
{
  Word least = std::numeric_limits<Word>::max();
  Word most = 0;
  for (std::size_t gate = 0; gate < gates; ++gate)
  {
    const Word word = wordAt(gate);
    const auto place = static_cast<Word>(word - firstValue);
    least = place < least ? place : least;
    most = word > most ? word : most;
  }
  return {least + unsigned(firstValue), most};
}

WordRange FindWordRange(const MomentRow& row, std::size_t gates)
{
  const std::uint8_t* words = row.words;
  if (row.wordBits == 16)
  {
    return FindWordRange<std::uint16_t>(gates, row.firstValue,
      [words](std::size_t gate)
      { return static_cast<std::uint16_t>(words[2 * gate] << 8 | words[2 * gate + 1]); });
  }
  return FindWordRange<std::uint8_t>(
    gates, row.firstValue, [words](std::size_t gate) { return words[gate]; });
}

// Gates whose word is a value outside the limits. Nearly always there is none, as the ends of the
// words tell: values rise or fall with them.
std::vector<std::size_t> GatesOutside(const MomentRow& row, const Limits& limits, std::size_t gates)
{
  gates = std::min<std::size_t>(gates, row.gates);
  const auto isOutside = [&](unsigned word)
  {
    const float value = row.ValueOf(word);
    return value < limits.least || value > limits.most;
  };
  std::vector<std::size_t> outside;
  const WordRange range = FindWordRange(row, gates);
  if (range.least > range.most || !(isOutside(range.least) || isOutside(range.most)))
  {
    return outside;
  }
  for (std::size_t gate = 0; gate < gates; ++gate)
  {
    if (row.Raw(gate) >= row.firstValue && isOutside(row.Raw(gate)))
    {
      outside.push_back(gate);
    }
  }
  return outside;
}

std::vector<std::size_t> NegativeWidths(const Ray& ray, std::size_t gates)
{
  return GatesOutside(
    ray.Row(MomentName::SW), {0.0F, std::numeric_limits<float>::infinity()}, gates);
}

std::vector<std::size_t> ImpossibleVelocities(const Ray& ray, std::size_t gates)
{
  const MomentRow& row = ray.Row(MomentName::VEL);
  std::vector<std::size_t> folded;
  if (ray.nyquist > 0.0F)
  {
    const float most = ray.nyquist + nyquistTolerance;
    folded = GatesOutside(row, {-most, most}, gates);
  }
  if (!row.HasGatesOf(ray.Row(MomentName::SW)))
  {
    return folded;
  }
  std::vector<std::size_t> beside = NegativeWidths(ray, gates);
  beside.erase(std::remove_if(beside.begin(), beside.end(),
                 [&row](std::size_t gate) { return row.State(gate) != GateState::Valid; }),
    beside.end());
  std::vector<std::size_t> both;
  std::set_union(
    folded.begin(), folded.end(), beside.begin(), beside.end(), std::back_inserter(both));
  return both;
}

std::size_t CountGates(const std::vector<Sweep>& sweeps, MomentName moment)
{
  std::size_t count = 0;
  for (const Sweep& sweep : sweeps)
  {
    for (const Ray& ray : sweep.rays)
    {
      count += ImpossibleGates(ray, moment).size();
    }
  }
  return count;
}

} // namespace

std::vector<std::size_t> ImpossibleGates(const Ray& ray, MomentName moment, std::size_t gates)
{
  switch (moment)
  {
  case MomentName::VEL:
    return ImpossibleVelocities(ray, gates);
  case MomentName::SW:
    return NegativeWidths(ray, gates);
  default:
    return {};
  }
}

std::string DescribeImpossibleGates(const std::vector<Sweep>& sweeps)
{
  const std::size_t widths = CountGates(sweeps, MomentName::SW);
  const std::size_t velocities = CountGates(sweeps, MomentName::VEL);
  if (widths + velocities == 0)
  {
    return "";
  }
  return std::to_string(widths) + " gates have a spectrum width below 0 m/s, " +
         std::to_string(velocities) +
         " a velocity beside such a width or beyond the Nyquist velocity: no measurement gives "
         "these, and merging leaves them out";
}

} // namespace nexrad
