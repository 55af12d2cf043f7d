// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/Series/ReadAhead.h"

#include <vtkImageData.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>

namespace nexrad::scene
{
namespace
{

using Volume = vtkSmartPointer<vtkImageData>;

// A volume that was loaded ahead, or why it could not be.
struct Loaded
{
  Volume volume;
  std::exception_ptr failure;
};

std::size_t BytesOf(const Loaded& loaded)
{
  constexpr std::size_t kibibyte = 1024;
  return loaded.volume ? kibibyte * loaded.volume->GetActualMemorySize() : 0;
}

class ReadAheadSeries : public VolumeSeries
{
public:
  ReadAheadSeries(std::unique_ptr<VolumeSeries> source, ReadAheadOptions readAheadOptions)
    : series(std::move(source))
    , options(std::move(readAheadOptions))
    , problems(series->Problems())
    , thread([this] { this->Run(); })
  {
  }

  ~ReadAheadSeries() override
  {
    {
      const std::lock_guard<std::mutex> lock(mutex);
      ended = true;
      interrupted = true;
    }
    changed.notify_all();
    thread.join();
  }

  const std::vector<Time>& Times() const override { return series->Times(); }

  std::vector<std::string> Problems() const override
  {
    const std::lock_guard<std::mutex> lock(mutex);
    return problems;
  }

  Volume Load(std::size_t index, const Progress& progress) override
  {
    std::unique_lock<std::mutex> lock(mutex);
    const std::size_t places = this->PlacesAhead(index);
    if (places >= ahead.size() + (loading ? 1 : 0))
    {
      return this->LoadHere(index, progress, lock);
    }
    // Those before it are passed over; it may be the one that is being loaded.
    const std::size_t passed = std::min(places, ahead.size());
    ahead.erase(ahead.begin(), ahead.begin() + static_cast<std::ptrdiff_t>(passed));
    last = (last + passed) % options.order.size();
    while (ahead.empty())
    {
      changed.wait_for(lock, std::chrono::milliseconds(50));
      if (ahead.empty() && progress && !progress(fraction))
      {
        return nullptr;
      }
    }
    const Loaded loaded = std::move(ahead.front());
    ahead.pop_front();
    last = (last + 1) % options.order.size();
    lock.unlock();
    changed.notify_all();
    if (loaded.failure)
    {
      std::rethrow_exception(loaded.failure);
    }
    return loaded.volume;
  }

  // What is loaded ahead stays.
  Volume LoadCoarse(std::size_t index) override
  {
    std::unique_lock<std::mutex> lock(mutex);
    const bool goesOn = std::exchange(started, false);
    changed.wait(lock, [this] { return !loading; });
    lock.unlock();
    Loaded loaded;
    try
    {
      loaded.volume = series->LoadCoarse(index);
    }
    catch (...)
    {
      loaded.failure = std::current_exception();
    }
    lock.lock();
    started = goesOn;
    lock.unlock();
    changed.notify_all();
    if (loaded.failure)
    {
      std::rethrow_exception(loaded.failure);
    }
    return loaded.volume;
  }

private:
  // How many of the order come between the volume asked for last and this one.
  std::size_t PlacesAhead(std::size_t index) const
  {
    const std::size_t count = options.order.size();
    std::size_t places = 0;
    while (places < count && options.order[(last + 1 + places) % count] != index)
    {
      ++places;
    }
    return places;
  }

  // What is loaded ahead is of no use: the order goes on from here.
  Volume LoadHere(std::size_t index, const Progress& progress, std::unique_lock<std::mutex>& lock)
  {
    interrupted = true;
    started = false;
    changed.wait(lock, [this] { return !loading; });
    ahead.clear();
    lock.unlock();
    const Volume volume = this->LoadPrepared(index, nullptr, progress);
    lock.lock();
    interrupted = false;
    const auto place = std::find(options.order.begin(), options.order.end(), index);
    if (volume && place != options.order.end())
    {
      last = static_cast<std::size_t>(place - options.order.begin());
      bytesOfOne = BytesOf({volume, nullptr});
      newest = volume;
      started = true;
      lock.unlock();
      changed.notify_all();
    }
    return volume;
  }

  bool HasRoom() const
  {
    std::size_t bytes = bytesOfOne;
    for (const Loaded& loaded : ahead)
    {
      bytes += BytesOf(loaded);
    }
    // The one asked for last is not loaded again.
    return ahead.empty() || (bytes <= options.memory && ahead.size() + 1 < options.order.size());
  }

  // The other thread.
  void Run()
  {
    std::unique_lock<std::mutex> lock(mutex);
    while (!ended)
    {
      if (started && !this->HasRoom() && options.full)
      {
        options.full();
      }
      changed.wait(lock, [this] { return ended || (started && this->HasRoom()); });
      if (ended)
      {
        return;
      }
      const std::size_t index = options.order[(last + 1 + ahead.size()) % options.order.size()];
      loading = true;
      fraction = 0.0;
      const Volume before = newest;
      lock.unlock();
      Loaded loaded = this->LoadAhead(index, before);
      lock.lock();
      loading = false;
      if (!interrupted)
      {
        bytesOfOne = std::max(bytesOfOne, BytesOf(loaded));
        newest = loaded.volume;
        ahead.push_back(std::move(loaded));
      }
      changed.notify_all();
    }
  }

  Volume LoadPrepared(std::size_t index, const Volume& before, const Progress& progress)
  {
    Volume volume = series->Load(index, progress);
    {
      const std::lock_guard<std::mutex> lock(mutex);
      problems = series->Problems();
    }
    if (volume && options.prepare)
    {
      options.prepare(volume, before);
    }
    return volume;
  }

  Loaded LoadAhead(std::size_t index, const Volume& before)
  {
    Loaded loaded;
    try
    {
      const auto goOn = [this](double done)
      {
        fraction = done;
        return !interrupted;
      };
      loaded.volume = this->LoadPrepared(index, before, goOn);
    }
    catch (...)
    {
      loaded.failure = std::current_exception();
    }
    return loaded;
  }

  std::unique_ptr<VolumeSeries> series; // one thread at a time
  const ReadAheadOptions options;
  mutable std::mutex mutex; // of all that follows
  mutable std::condition_variable changed;
  std::vector<std::string> problems;     // those of the series, after the last volume
  std::size_t last = 0;                  // place in the order of the volume asked for last
  std::deque<Loaded> ahead;              // those that follow it
  Volume newest;                         // the one loaded last; nullptr after a failure
  std::size_t bytesOfOne = 0;            // the largest volume so far
  bool started = false;                  // there is a volume asked for last
  bool loading = false;                  // the other thread works
  bool ended = false;                    // it shall end
  std::atomic<bool> interrupted = false; // what it loads is not wanted any more
  std::atomic<double> fraction = 0.0;    // of what it loads
  std::thread thread;
};

} // namespace

std::unique_ptr<VolumeSeries> ReadAhead(
  std::unique_ptr<VolumeSeries> series, ReadAheadOptions options)
{
  if (!series->CanLoadAhead() || options.order.size() < 2)
  {
    return series;
  }
  return std::make_unique<ReadAheadSeries>(std::move(series), std::move(options));
}

} // namespace nexrad::scene
