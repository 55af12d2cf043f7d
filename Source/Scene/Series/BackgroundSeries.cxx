// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/Series/BackgroundSeries.h"

#include "nexrad/System/Error.h"

#include <vtkImageData.h>

#include <algorithm>
#include <chrono>
#include <exception>
#include <numeric>
#include <utility>

namespace nexrad::scene
{
namespace
{

std::size_t BytesOf(vtkImageData* volume)
{
  constexpr std::size_t kibibyte = 1024;
  return volume != nullptr ? kibibyte * volume->GetActualMemorySize() : 0;
}

} // namespace

BackgroundSeries::BackgroundSeries(BackgroundSeriesOptions theOptions)
  : options(std::move(theOptions))
  , thread([this] { this->Run(); })
{
}

BackgroundSeries::~BackgroundSeries()
{
  {
    const std::lock_guard<std::mutex> lock(mutex);
    ended = true;
  }
  changed.notify_all();
  thread.join();
}

BackgroundSeries::State BackgroundSeries::Get() const
{
  const std::lock_guard<std::mutex> lock(mutex);
  return state;
}

vtkSmartPointer<vtkImageData> BackgroundSeries::Show(std::size_t step)
{
  const std::lock_guard<std::mutex> lock(mutex);
  shown = step;
  const auto found = kept.find(step);
  interrupted = found == kept.end() && state.loads && *state.loads != step;
  changed.notify_all(); // what follows the step may be another than before
  if (found == kept.end())
  {
    return nullptr;
  }
  if (!found->second.volume)
  {
    throw Error(found->second.failure);
  }
  return found->second.volume;
}

void BackgroundSeries::SetBox(const std::optional<BoxRequest>& wanted)
{
  {
    const std::lock_guard<std::mutex> lock(mutex);
    box = wanted;
    ++boxNumber;
    for (auto& [step, each] : kept)
    {
      bytes -= BytesOf(each.box);
      each.bytes -= BytesOf(each.box);
      each.box = nullptr;
      each.boxFailure.clear();
    }
    interrupted = state.loads && kept.count(shown) > 0; // the box of what is shown comes first
  }
  changed.notify_all();
}

vtkSmartPointer<vtkImageData> BackgroundSeries::Box(std::size_t step) const
{
  const std::lock_guard<std::mutex> lock(mutex);
  const auto found = kept.find(step);
  if (found == kept.end())
  {
    return nullptr;
  }
  if (!found->second.boxFailure.empty())
  {
    throw Error(found->second.boxFailure);
  }
  return found->second.box;
}

void BackgroundSeries::Pause(bool paused)
{
  {
    const std::lock_guard<std::mutex> lock(mutex);
    state.paused = paused;
    interrupted = paused && state.loads && *state.loads != shown;
  }
  changed.notify_all();
}

void BackgroundSeries::Wake()
{
  if (options.wake)
  {
    options.wake();
  }
}

// Takes over how far the work is, and stops what is not wanted any more.
Progress BackgroundSeries::ReportTo()
{
  using Clock = std::chrono::steady_clock;
  static constexpr auto shortest = std::chrono::milliseconds(20);
  return [this, last = Clock::now()](double fraction) mutable
  {
    bool goOn = false;
    {
      const std::lock_guard<std::mutex> lock(mutex);
      state.fraction = fraction;
      const bool stopsOpening = state.phase == Phase::Opening && state.paused;
      goOn = !ended && !interrupted && !stopsOpening;
    }
    const auto now = Clock::now();
    if (now - last >= shortest)
    {
      last = now;
      this->Wake();
    }
    return goOn;
  };
}

bool BackgroundSeries::Open()
{
  State opened;
  try
  {
    series = options.open(this->ReportTo());
    if (options.choose)
    {
      order = options.choose(*series);
    }
    else
    {
      order.resize(series->Times().size());
      std::iota(order.begin(), order.end(), std::size_t(0));
    }
    for (const std::size_t index : order)
    {
      opened.times.push_back(series->Times()[index]);
    }
    opened.loaded.assign(order.size(), false);
    opened.damage = series->Problems();
    opened.phase = Phase::Open;
  }
  catch (const std::exception& error)
  {
    opened.failure = error.what();
    opened.phase = Phase::Failed;
  }
  {
    const std::lock_guard<std::mutex> lock(mutex);
    opened.paused = state.paused;
    if (opened.paused && opened.phase == Phase::Open) // too late to stop it
    {
      opened = State();
      opened.phase = Phase::Failed;
      opened.failure = "stopped before it was opened";
    }
    state = opened;
  }
  this->Wake();
  return opened.phase == Phase::Open;
}

// Whether a step, or the box of it, is to be loaded.
bool BackgroundSeries::Lacks(std::size_t step) const
{
  const auto found = kept.find(step);
  return found == kept.end() ||
         (box && found->second.volume && !found->second.box && found->second.boxFailure.empty());
}

// The step to load next; nothing where all are loaded, or there is no memory for more.
std::optional<std::size_t> BackgroundSeries::NextStep() const
{
  const std::size_t count = order.size();
  if (shown < count && this->Lacks(shown))
  {
    return shown;
  }
  std::size_t largest = 0;
  for (const auto& [step, each] : kept)
  {
    largest = std::max(largest, each.bytes);
  }
  std::size_t following = 0; // bytes of the step that is shown and of those after it
  for (std::size_t i = 0; i < count && !state.paused; ++i)
  {
    const std::size_t step = (shown + i) % count;
    const auto found = kept.find(step);
    if (following + largest > options.memory)
    {
      return std::nullopt;
    }
    if (this->Lacks(step))
    {
      return step;
    }
    following += found->second.bytes;
  }
  return std::nullopt;
}

BackgroundSeries::Kept BackgroundSeries::Load(std::size_t step)
{
  Kept loaded;
  try
  {
    loaded.volume = series->Load(order[step], this->ReportTo());
    if (loaded.volume && options.prepare)
    {
      options.prepare(loaded.volume);
    }
    loaded.bytes = BytesOf(loaded.volume);
  }
  catch (const std::exception& error)
  {
    loaded.failure = error.what();
  }
  return loaded;
}

// The box of a step whose volume is kept.
BackgroundSeries::Kept BackgroundSeries::LoadBox(std::size_t step, const BoxRequest& request)
{
  Kept loaded;
  try
  {
    loaded.box = series->LoadBox(order[step], request, this->ReportTo());
    if (loaded.box && options.prepare)
    {
      options.prepare(loaded.box);
    }
    loaded.bytes = BytesOf(loaded.box);
  }
  catch (const std::exception& error)
  {
    loaded.boxFailure = error.what();
  }
  return loaded;
}

// Takes over a volume, or a box of a volume that is kept; nothing after a stop.
void BackgroundSeries::Keep(std::size_t step, Kept loaded)
{
  this->MakeRoom(loaded.bytes);
  if (loaded.volume || !loaded.failure.empty())
  {
    bytes += loaded.bytes;
    state.loaded[step] = loaded.volume != nullptr;
    kept[step] = std::move(loaded);
    return;
  }
  const auto found = kept.find(step);
  if (found != kept.end())
  {
    bytes += loaded.bytes;
    found->second.bytes += loaded.bytes;
    found->second.box = loaded.box;
    found->second.boxFailure = loaded.boxFailure;
  }
}

// Forgets the volumes that are shown last until so many bytes fit; not the one that is shown.
void BackgroundSeries::MakeRoom(std::size_t wanted)
{
  const std::size_t count = order.size();
  for (std::size_t i = count; i-- > 1 && bytes + wanted > options.memory;)
  {
    const auto found = kept.find((shown + i) % count);
    if (found != kept.end())
    {
      bytes -= found->second.bytes;
      state.loaded[found->first] = false;
      kept.erase(found);
    }
  }
}

void BackgroundSeries::Run()
{
  if (!this->Open())
  {
    return;
  }
  std::unique_lock<std::mutex> lock(mutex);
  while (!ended)
  {
    const std::optional<std::size_t> step = this->NextStep();
    if (!step)
    {
      changed.wait(lock);
      continue;
    }
    state.loads = step;
    state.fraction = 0.0;
    const std::optional<BoxRequest> wantedBox = kept.count(*step) > 0 ? box : std::nullopt;
    const unsigned wantedNumber = boxNumber;
    lock.unlock();
    Kept loaded = wantedBox ? this->LoadBox(*step, *wantedBox) : this->Load(*step);
    std::vector<std::string> damage = series->Problems();
    lock.lock();
    state.loads.reset();
    state.damage = std::move(damage);
    interrupted = false;
    if (!wantedBox || wantedNumber == boxNumber)
    {
      this->Keep(*step, std::move(loaded));
    }
    lock.unlock();
    this->Wake();
    lock.lock();
  }
}

} // namespace nexrad::scene
