// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <string>

namespace CLI
{
class App;
} // namespace CLI

namespace nexrad::application
{

/// From now on the first SIGINT (Ctrl+C), SIGTERM or SIGHUP (a terminal that closes) asks the
/// program to stop where it is, in order; a second one ends it at once. A SIGHUP that is ignored
/// stays so. Who waits in a call of the system has to look at IsStopAsked, or wait with poll or
/// nanosleep, which the signal ends.
void WatchStopSignals();

/// True when such a signal came.
bool IsStopAsked();

/// Adds --quiet to a command that can take long.
void AddQuietOption(CLI::App& command, bool& quiet);

/// A line on standard error that says how much of the work is done. It appears only on a terminal,
/// only when the work takes more than two seconds, is drawn anew at most ten times a second, and is
/// wiped at the end.
class ProgressBar
{
public:
  /// `what` names the work, as in "gridding". `quiet`: never draw.
  ProgressBar(std::string what, bool quiet);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// Says that `fraction` (0…1) of the work is done. It can serve as a nexrad::Progress: returns
  /// false when a signal asked the program to stop (IsStopAsked).
  bool Update(double fraction);

  /// Wipes the line, so that other output can follow.
  void Clear();

private:
  using Clock = std::chrono::steady_clock;

  void Draw(double fraction);

  std::string what;
  bool enabled;
  bool visible = false;
  Clock::time_point start = Clock::now();
  Clock::time_point drawn = start;
};

} // namespace nexrad::application
