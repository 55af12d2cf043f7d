// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Model/Time.h"

#include <chrono>
#include <optional>

namespace nexrad::application
{

/// A feed that is played again from its records.
struct ReplayRequest
{
  Time begin{};       ///< what the clock shows at the start
  double speed = 1.0; ///< how many times as fast as the real clock it runs; above 0
};

/// The clock by which the ages of data are told and chunks are waited for.
class LiveClock
{
public:
  explicit LiveClock(const std::optional<ReplayRequest>& theReplay)
    : replay(theReplay)
  {
  }

  /// The time in UTC. It jumps as the clock of the machine does.
  Time Now() const
  {
    return replay ? replay->begin + this->Elapsed()
                  : std::chrono::time_point_cast<Duration>(std::chrono::system_clock::now());
  }
  /// Time since the start; it never jumps.
  Duration Elapsed() const
  {
    const std::chrono::duration<double> real = std::chrono::steady_clock::now() - begun;
    return DurationOf(real.count() * (replay ? replay->speed : 1.0));
  }

private:
  const std::optional<ReplayRequest> replay;
  const std::chrono::steady_clock::time_point begun = std::chrono::steady_clock::now();
};

} // namespace nexrad::application
