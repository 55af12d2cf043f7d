// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <vector>

namespace nexrad::application
{

/// Times of several runs of one piece of work, in seconds.
struct Measurement
{
  double median = 0.0; ///< of an even number of runs the mean of the middle two
  double least = 0.0;
  double most = 0.0;
};

/// The median and the extremes of some times. Throws Error without any.
Measurement Summarize(std::vector<double> seconds);

/// Seconds by the clock on the wall that one run of the work takes.
double SecondsOf(const std::function<void()>& work);

/// Runs several pieces of work turn by turn, `runs` times each, so that what else the machine does
/// meets all of them alike. One measurement a piece, in their order. With `warmUp` each piece runs
/// once before, unmeasured, so that files and memory are as warm for the first as for the last.
std::vector<Measurement> MeasureInTurn(
  const std::vector<std::function<void()>>& pieces, int runs, bool warmUp = true);

} // namespace nexrad::application
