// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Level2/Assembly/SweepBuilder.h"

#include "nexrad/System/MessageText.h"

#include <cmath>
#include <cstdio>

namespace nexrad
{

namespace
{

// Thirty times as many as any file has. Each may be a cycle of its own, and so a volume.
constexpr std::size_t mostSweeps = 2'000;
constexpr double longestTurn = 400.0; // degrees in one sweep

// Follows the antenna through one sweep: how far it turned, and which of the numbered rays are
// missing.
class SweepWatch
{
public:
  // The next ray of the sweep; it must stay where it is.
  void Add(const ArrivedRay& arrived)
  {
    const Ray& ray = arrived.ray;
    const unsigned number = arrived.azimuthNumber;
    if (last == nullptr && number > 1 && !StartsCut(ray))
    {
      this->Count(number - 1, ray.azimuth, arrived);
    }
    else if (last != nullptr && number > last->azimuthNumber + 1)
    {
      this->Count(number - last->azimuthNumber - 1, last->ray.azimuth, arrived);
    }
    turned = this->TurnTo(ray.azimuth);
    last = &arrived;
  }

  // Degrees from the first ray to this azimuth, by the way that the antenna took.
  double TurnTo(float azimuth) const
  {
    // The remainder lies within -180 and 180 degrees: the antenna goes the short way between rays.
    return last == nullptr ? 0.0
                           : turned + std::remainder(static_cast<double>(azimuth) -
                                                       static_cast<double>(last->ray.azimuth),
                                        360.0);
  }

  // `next` is the first ray of the next sweep, or nullptr at the end of the volume.
  void Finish(const ArrivedRay* next, std::size_t index, ArrivedSweep& sweep,
    const ArrivedDamage& report) const
  {
    sweep.turned = turned;
    sweep.cutOff = this->IsCutOff();
    sweep.restarted = sweep.cutOff && next != nullptr && StartsCut(next->ray) &&
                      next->ray.elevationNumber == sweep.ElevationNumber();
    if (missing > 0)
    {
      report(*behindGap,
        CountText(missing, "ray") + " missing in " + NameOfSweep(index, sweep) + ", " +
          (gaps > 1 ? "in " + std::to_string(gaps) + " gaps, the first " : "") + this->GapText());
    }
  }

private:
  void Count(std::size_t lost, float from, const ArrivedRay& behind)
  {
    if (gaps == 0)
    {
      gapFrom = from;
      behindGap = &behind;
    }
    missing += lost;
    ++gaps;
  }

  // Whether the sweep stops before its end: no radial that ends it, and less than a full turn.
  bool IsCutOff() const
  {
    constexpr double almostFull = 358.0; // a full turn less one ray at each end
    return last->ray.radialStatus != RadialStatus::EndOfCut &&
           last->ray.radialStatus != RadialStatus::EndOfVolume && std::abs(turned) < almostFull;
  }

  // Where the first gap is.
  std::string GapText() const
  {
    const float gapTo = behindGap->ray.azimuth;
    char text[96];
    if (gapFrom == gapTo)
    {
      std::snprintf(text, sizeof text, "before azimuth %.2f degrees", double(gapTo));
    }
    else
    {
      std::snprintf(
        text, sizeof text, "between azimuth %.2f and %.2f degrees", double(gapFrom), double(gapTo));
    }
    return text;
  }

  double turned = 0.0;              // degrees from the first to the last ray
  const ArrivedRay* last = nullptr; // ray
  std::size_t missing = 0;          // rays between or before those that came
  std::size_t gaps = 0;
  float gapFrom = 0.0F;                  // degrees, of the first gap
  const ArrivedRay* behindGap = nullptr; // behind the first gap
};

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

} // namespace

std::string NameOfSweep(std::size_t index, const ArrivedSweep& sweep)
{
  return "sweep " + std::to_string(index) + " (elevation number " +
         std::to_string(sweep.ElevationNumber()) + ")";
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
      watch.Finish(next, sweeps.size() - 1, sweeps.back(), report);
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
      watch = SweepWatch();
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
