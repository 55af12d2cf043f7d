// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Grid/FinerBox.h"
#include "nexrad/Motion/MotionTracker.h"
#include "nexrad/System/Progress.h"
#include "nexrad/System/RangeLoop.h"

#include <array>
#include <functional>
#include <optional>
#include <vector>

namespace nexrad
{

/// Finds where a box is that moves with the echo in it. From the time at which its faces are those
/// of the request it goes on in steps of a minute, both ways: in each, it moves as the echo moves
/// that is in it (MotionTracker::FindWithin), where that is known; else it stays. It does not leave
/// the domain. Its place depends on the box, the volumes and the time alone, not on the times asked
/// for before. The steps are kept, so that each is made once.
class BoxFollower
{
public:
  /// Gives volumes of reflectivity about a time (their composites are enough); empty when the
  /// progress asked to stop.
  using EchoAbout = std::function<std::optional<BeamVolumes>(Time time, const Progress& progress)>;

  /// `given`: the motion of all echo, in place of one that is searched.
  BoxFollower(const GridSpecification& domain, const BeamModel& beam, const RangeLoop& loop,
    const std::optional<Velocity>& given, EchoAbout echo);

  /// How far the box has moved along x and y of the domain at a time, in the domain's units; 0
  /// where it follows nothing. Empty when `progress` asked to stop: then the steps that were made
  /// are kept.
  std::optional<std::array<double, 2>> WayTo(
    Time time, const BoxRequest& box, const Progress& progress = {});

private:
  using Way = std::array<double, 2>;
  // The steps one way from the time of the box's faces.
  struct Path
  {
    std::vector<Way> ways = {Way{0.0, 0.0}}; // at the beginnings of the steps
    std::vector<Velocity> velocities;        // in the steps; of the last one, maybe not yet
  };

  std::optional<Velocity> VelocityAt(Time time, const Way& way, const Progress& progress);
  Way Move(const Way& way, const Velocity& velocity, double seconds) const;

  const GridSpecification domain;
  const std::optional<Velocity> given;
  const EchoAbout echo;
  const RangeLoop loop;
  MotionTracker tracker;
  std::optional<BoxRequest> box; // that the paths are of
  std::array<double, 4> room{};  // that it has to move
  Path forwards;
  Path backwards;
};

} // namespace nexrad
