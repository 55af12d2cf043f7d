// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/System/Processes.h"

#include <condition_variable>
#include <cstddef>
#include <future>
#include <mutex>
#include <string>
#include <vector>

namespace nexrad::testing
{

/// Stands for processes: each thread hands its bytes over and waits for those of the others.
class Meeting
{
public:
  explicit Meeting(std::size_t count)
    : parts(count)
  {
  }

  Processes At(std::size_t rank)
  {
    return {rank, parts.size(),
      [this, rank](const std::string& mine)
      {
        std::unique_lock<std::mutex> lock(mutex);
        parts[rank] = mine;
        const std::size_t own = turn;
        if (++arrived == parts.size())
        {
          exchanged = parts;
          arrived = 0;
          ++turn;
          changed.notify_all();
        }
        changed.wait(lock, [this, own] { return turn != own; });
        return exchanged;
      }};
  }

private:
  std::mutex mutex;
  std::condition_variable changed;
  std::vector<std::string> parts;
  std::vector<std::string> exchanged; // in the turn before
  std::size_t arrived = 0;
  std::size_t turn = 0;
};

/// Does some work as `count` processes would, each in a thread; what came out in each. Throws what
/// the first of them threw.
template <typename Work>
auto AsProcesses(std::size_t count, const Work& work)
{
  using Result = decltype(work(Processes()));
  Meeting meeting(count);
  std::vector<std::future<Result>> running;
  for (std::size_t rank = 0; rank < count; ++rank)
  {
    running.push_back(std::async(std::launch::async, work, meeting.At(rank)));
  }
  std::vector<Result> results;
  for (std::future<Result>& process : running)
  {
    results.push_back(process.get());
  }
  return results;
}

} // namespace nexrad::testing
