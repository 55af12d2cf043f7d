// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Level2/Assembly/SweepBuilder.h"

#include <cmath>
#include <utility>

namespace nexrad
{

namespace
{

// Thirty times as many as any file has. Each may be a cycle of its own, and so a volume.
constexpr std::size_t mostSweeps = 2'000;
constexpr double longestTurn = 400.0; // degrees in one sweep

// Whether a ray has a lower number than the ray before it, and the ray behind it goes on from
// there: the cut starts again, and its first rays are lost. One wrong number is no start.
bool NumbersStartAgain(const RayList& rays, std::size_t index)
{
  const ArrivedRay& before = *rays[index - 1];
  const ArrivedRay& ray = *rays[index];
  const ArrivedRay* after = index + 1 < rays.size() ? rays[index + 1] : nullptr;
  return ray.azimuthNumber < before.azimuthNumber && after != nullptr &&
         after->ray.elevationNumber == ray.ray.elevationNumber &&
         after->azimuthNumber > ray.azimuthNumber && after->azimuthNumber <= before.azimuthNumber;
}

bool BeginsSweep(const RayList& rays, std::size_t index, const SweepWatch& watch)
{
  const Ray& ray = rays[index]->ray;
  return index == 0 || rays[index - 1]->ray.elevationNumber != ray.elevationNumber ||
         StartsCut(ray) || std::abs(watch.TurnTo(ray.azimuth)) > longestTurn ||
         NumbersStartAgain(rays, index);
}

// `next` is the first ray of the next sweep, or nullptr at the end of the volume.
void FinishSweep(const SweepWatch& watch, const ArrivedRay* next, std::size_t index,
  ArrivedSweep& sweep, const ArrivedDamage& report)
{
  sweep.turned = watch.Turned();
  sweep.cutOff = watch.IsCutOff();
  sweep.restarted = sweep.cutOff && next != nullptr && StartsCut(next->ray) &&
                    next->ray.elevationNumber == sweep.rays.front()->ray.elevationNumber;
  if (watch.Missing() > 0)
  {
    report(*watch.BehindGap(), watch.Describe(index, sweep.rays.front()->ray.elevationNumber));
  }
}

} // namespace

std::string NameOfSweep(std::size_t index, const ArrivedSweep& sweep)
{
  return "sweep " + std::to_string(index) + " (elevation number " +
         std::to_string(sweep.rays.front()->ray.elevationNumber) + ")";
}

std::vector<ArrivedSweep> BuildSweeps(
  const RayList& rays, const ArrivedDamage& report, std::vector<std::string>& notes)
{
  std::vector<ArrivedSweep> sweeps;
  SweepWatch watch;
  const auto finish = [&](const ArrivedRay* next)
  {
    if (!sweeps.empty())
    {
      FinishSweep(watch, next, sweeps.size() - 1, sweeps.back(), report);
    }
  };
  for (std::size_t index = 0; index < rays.size(); ++index)
  {
    if (BeginsSweep(rays, index, watch))
    {
      finish(rays[index]);
      if (sweeps.size() == mostSweeps)
      {
        report(
          *rays[index], "more than " + std::to_string(mostSweeps) + " sweeps; the rest is left");
        return sweeps;
      }
      sweeps.emplace_back();
      watch.Begin();
    }
    watch.Add(*rays[index]);
    sweeps.back().rays.push_back(rays[index]);
  }
  finish(nullptr);
  for (std::size_t index = 0; index < sweeps.size(); ++index)
  {
    if (sweeps[index].restarted)
    {
      notes.push_back(NameOfSweep(index, sweeps[index]) + " was interrupted and restarted");
    }
  }
  return sweeps;
}

} // namespace nexrad
