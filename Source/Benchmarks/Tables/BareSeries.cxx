// SPDX-License-Identifier: BSD-3-Clause
#include "Tables/BareSeries.h"

#include <algorithm>
#include <atomic>
#include <functional>
#include <future>
#include <optional>

namespace nexrad::application
{
namespace
{

// Works through [0, count) on some threads. Throws what the work threw first.
void ForEach(std::size_t count, unsigned threads, const std::function<void(std::size_t)>& work)
{
  std::atomic<std::size_t> next{0};
  const auto run = [&]
  {
    for (std::size_t index = next++; index < count; index = next++)
    {
      work(index);
    }
  };
  std::vector<std::future<void>> running;
  for (unsigned thread = 0; thread < std::max(1U, threads); ++thread)
  {
    running.push_back(std::async(std::launch::async, run));
  }
  for (std::future<void>& each : running)
  {
    each.wait();
  }
  for (std::future<void>& each : running)
  {
    each.get();
  }
}

} // namespace

BareSeries::BareSeries(const std::vector<std::filesystem::path>& files, unsigned threadCount)
  : threads(threadCount)
{
  std::vector<std::optional<BareDecompression>> opened(files.size());
  ForEach(files.size(), threads,
    [&](std::size_t index)
    {
      opened[index].emplace(files[index]);
      opened[index]->Unload();
    });
  for (std::optional<BareDecompression>& stream : opened)
  {
    streams.push_back(std::move(*stream));
  }
}

void BareSeries::Run()
{
  ForEach(streams.size(), threads,
    [this](std::size_t index)
    {
      streams[index].Load();
      streams[index].Run(1);
      streams[index].Unload();
    });
}

double BareSeries::StoredBytes() const
{
  double bytes = 0.0;
  for (const BareDecompression& stream : streams)
  {
    bytes += static_cast<double>(stream.StoredBytes());
  }
  return bytes;
}

} // namespace nexrad::application
