// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace nexrad::application
{

/// What a launcher of several processes (mpiexec) says of this one in its environment. Without a
/// launcher it is one alone.
struct LaunchedProcess
{
  int rank = 0;  ///< from 0
  int count = 1; ///< of processes
  bool inherits =
    false; ///< the parent has the same in its environment: it may be what was launched

  /// True for one that speaks to the user: one of those that were launched together, and each that
  /// may be another program's child.
  bool Speaks() const { return rank == 0 || inherits; }
};

/// Environment variables that no launcher sets so (a rank that is no number, or not below the
/// count) are passed over.
LaunchedProcess FindLaunchedProcess();

/// Removes what FindLaunchedProcess reads: this process turned out to be alone.
void ForgetLauncher();

} // namespace nexrad::application
