// SPDX-License-Identifier: BSD-3-Clause
#include "Tables/Measurement.h"

#include "nexrad/System/Error.h"

#include <algorithm>
#include <chrono>
#include <iterator>

namespace nexrad::application
{

Measurement Summarize(std::vector<double> seconds)
{
  if (seconds.empty())
  {
    throw Error("nothing was measured; at least one run is needed");
  }
  std::sort(seconds.begin(), seconds.end());
  const std::size_t middle = seconds.size() / 2;
  const double median =
    seconds.size() % 2 == 1 ? seconds[middle] : 0.5 * (seconds[middle - 1] + seconds[middle]);
  return {median, seconds.front(), seconds.back()};
}

double SecondsOf(const std::function<void()>& work)
{
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

std::vector<Measurement> MeasureInTurn(
  const std::vector<std::function<void()>>& pieces, int runs, bool warmUp)
{
  if (warmUp)
  {
    for (const std::function<void()>& piece : pieces)
    {
      piece();
    }
  }
  std::vector<std::vector<double>> seconds(pieces.size());
  for (int run = 0; run < runs; ++run)
  {
    for (std::size_t index = 0; index < pieces.size(); ++index)
    {
      seconds[index].push_back(SecondsOf(pieces[index]));
    }
  }
  std::vector<Measurement> measurements;
  std::transform(seconds.begin(), seconds.end(), std::back_inserter(measurements), &Summarize);
  return measurements;
}

} // namespace nexrad::application
