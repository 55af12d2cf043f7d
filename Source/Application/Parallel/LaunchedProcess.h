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

  /// True for the one that speaks to the user.
  bool IsFirst() const { return rank == 0; }
};

LaunchedProcess FindLaunchedProcess();

} // namespace nexrad::application
