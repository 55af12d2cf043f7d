// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Merging/BoxFollower.h"

#include <algorithm>
#include <utility>

namespace nexrad
{

namespace
{

// Short beside the time between two volumes, and the way in it beside a box.
constexpr Duration step = std::chrono::minutes(1);

} // namespace

BoxFollower::BoxFollower(const GridSpecification& theDomain, const BeamModel& beam,
  const RangeLoop& theLoop, const std::optional<Velocity>& givenMotion, EchoAbout theEcho)
  : domain(theDomain)
  , given(givenMotion)
  , echo(std::move(theEcho))
  , loop(theLoop)
  , tracker(theDomain, beam)
{
}

std::optional<Velocity> BoxFollower::VelocityAt(Time time, const Way& way, const Progress& progress)
{
  if (given)
  {
    return given;
  }
  const std::optional<BeamVolumes> volumes = echo(time, progress);
  if (!volumes)
  {
    return std::nullopt;
  }
  GridArea area = box->faces;
  for (std::size_t face = 0; face < area.size(); ++face)
  {
    area[face] += way[face / 2];
  }
  return tracker.FindWithin(area, *volumes, time, loop).value_or(Velocity());
}

BoxFollower::Way BoxFollower::Move(const Way& way, const Velocity& velocity, double seconds) const
{
  const double middleY = 0.5 * (box->faces[2] + box->faces[3]) + way[1];
  const std::array<double, 2> voxel =
    VoxelExtent(domain, (middleY - domain.origin[1]) / domain.spacing[1]);
  const std::array<double, 2> metres = {velocity.east * seconds, velocity.north * seconds};
  Way moved{};
  for (const std::size_t axis : {0U, 1U})
  {
    moved[axis] = std::clamp(way[axis] + metres[axis] / voxel[axis] * domain.spacing[axis],
      room[2 * axis], room[2 * axis + 1]);
  }
  return moved;
}

std::optional<std::array<double, 2>> BoxFollower::WayTo(
  Time time, const BoxRequest& wanted, const Progress& progress)
{
  if (!wanted.followedFrom)
  {
    return Way{0.0, 0.0};
  }
  if (!box || !(*box == wanted))
  {
    box = wanted;
    room = RoomToMove(domain, wanted);
    forwards = {};
    backwards = {};
  }
  const bool back = time < *wanted.followedFrom;
  const int sign = back ? -1 : 1;
  const Duration total = sign * (time - *wanted.followedFrom);
  Path& path = back ? backwards : forwards;
  const auto steps = static_cast<std::size_t>(total / step);
  for (std::size_t i = std::min(path.ways.size() - 1, steps);; ++i)
  {
    const Duration before = static_cast<int>(i) * step;
    if (path.velocities.size() <= i)
    {
      // The motion in the middle of the step, of the echo where the box is at its beginning.
      const std::optional<Velocity> velocity =
        this->VelocityAt(*wanted.followedFrom + sign * (before + step / 2), path.ways[i],
          ShareOf(progress, i, steps + 1));
      if (!velocity)
      {
        return std::nullopt;
      }
      path.velocities.push_back(*velocity);
    }
    const Duration part = i == steps ? total - before : step;
    const double seconds = std::chrono::duration<double>(part).count();
    const Way end = this->Move(path.ways[i], path.velocities[i], sign * seconds);
    if (i == steps)
    {
      return end;
    }
    if (path.ways.size() == i + 1)
    {
      path.ways.push_back(end);
    }
  }
}

} // namespace nexrad
