// SPDX-License-Identifier: BSD-3-Clause
#include "Level2/ParallelBunzip.h"

#include <algorithm>
#include <atomic>
#include <future>
#include <thread>

namespace nexrad
{

std::vector<Bunzipped> BunzipInParallel(
  const std::vector<LdmRecord>& records, std::size_t maximumRecordBytes)
{
  std::vector<Bunzipped> results(records.size());
  std::atomic<std::size_t> next{0};
  const auto work = [&]
  {
    for (std::size_t index = next++; index < records.size(); index = next++)
    {
      results[index] = DecompressBzip2(records[index].compressed, maximumRecordBytes);
    }
  };
  const std::size_t cores = std::max(1U, std::thread::hardware_concurrency());
  std::vector<std::future<void>> helpers;
  for (std::size_t count = 1; count < std::min(cores, records.size()); ++count)
  {
    helpers.push_back(std::async(std::launch::async, work));
  }
  work();
  for (std::future<void>& helper : helpers)
  {
    helper.get(); // hands on what was thrown there
  }
  return results;
}

} // namespace nexrad
