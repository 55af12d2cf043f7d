// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Live/LiveIntake.h"
#include "nexrad/Model/Time.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace nexrad::application
{

/// How long after the last byte of a sweep the volume with it was there, real time.
struct LiveDelays
{
  double last = 0.0;    ///< s
  double largest = 0.0; ///< s
  double sum = 0.0;     ///< s
  std::size_t count = 0;

  void Add(double seconds);
};

/// One radar of a series that grows.
struct RadarStatus
{
  std::optional<Time> newest; ///< last ray that is used
  bool live = false;          ///< that is not older than the longest age
  ArrivingRadar arriving;
};

/// All that a series that grows says of itself.
struct LiveStatus
{
  std::string state = "running"; ///< running, or stopped
  std::string reason;            ///< why it stopped
  Time written{};                ///< by the clock
  Duration staleAge{};           ///< a radar whose newest ray is older is STALE
  std::optional<Time> newest;    ///< time of the newest volume
  std::string newestFile;
  std::string pictureFile; ///< empty without a picture
  std::optional<Time> pictureTime;
  std::vector<Time> steps; ///< of the series
  std::map<std::string, RadarStatus> radars;
  std::size_t problems = 0;
  std::size_t heldBytes = 0; ///< that the held volumes take
  LiveDelays delays;
  std::vector<std::string> notes;
};

/// The text of status.json (Documentation/Formats/status.md).
std::string StatusJson(const LiveStatus& status);

/// One line for a person: "18:05:21Z KEAX LIVE 12 s, KLSX STALE 15 min".
std::string StatusLine(const LiveStatus& status);

} // namespace nexrad::application
