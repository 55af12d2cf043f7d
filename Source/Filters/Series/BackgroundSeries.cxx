// SPDX-License-Identifier: BSD-3-Clause
#include "Filters/Series/BackgroundSeries.h"

#include "nexrad/System/Error.h"

#include <vtkImageData.h>

#include <algorithm>
#include <chrono>
#include <exception>
#include <numeric>
#include <utility>

namespace nexrad
{
namespace
{

std::vector<Time> TimesOf(const VolumeSeries& series, const std::vector<std::size_t>& order)
{
  std::vector<Time> times;
  for (const std::size_t index : order)
  {
    times.push_back(series.Times()[index]);
  }
  return times;
}

} // namespace

vtkSmartPointer<vtkImageData> BackgroundSeries::Loaded::Get() const
{
  if (!image && !failure.empty())
  {
    throw Error(failure);
  }
  return image;
}

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
  awaited = found == kept.end();
  interrupted = awaited && state.loads && *state.loads != step;
  changed.notify_all(); // what follows the step may be another than before
  return found == kept.end() ? nullptr : found->second.volume.Get();
}

// Whether there is nothing to wait for any more.
bool BackgroundSeries::IsDone(std::size_t step) const
{
  return state.phase == Phase::Failed || (state.phase == Phase::Open && !this->Lacks(step));
}

vtkSmartPointer<vtkImageData> BackgroundSeries::Wait(std::size_t step, const Progress& progress)
{
  constexpr auto pause = std::chrono::milliseconds(50); // between reports
  std::unique_lock<std::mutex> lock(mutex);
  const auto found = kept.find(step);
  if (found != kept.end() && !found->second.volume.image)
  {
    kept.erase(found); // it is tried again
  }
  lock.unlock();
  this->Show(step);
  lock.lock();
  while (!changed.wait_for(lock, pause, [this, step] { return this->IsDone(step); }))
  {
    const double fraction = state.fraction;
    lock.unlock();
    if (progress && !progress(fraction))
    {
      return nullptr;
    }
    lock.lock();
  }
  if (state.phase == Phase::Failed)
  {
    throw Error(state.failure);
  }
  lock.unlock();
  this->Box(step); // throws why there is none
  return this->Show(step);
}

void BackgroundSeries::SetBox(const std::optional<BoxRequest>& wanted)
{
  {
    const std::lock_guard<std::mutex> lock(mutex);
    box = wanted;
    ++boxNumber;
    for (auto& [step, each] : kept)
    {
      bytes -= each.box.bytes;
      each.box = {};
    }
    interrupted = state.loads && kept.count(shown) > 0; // the box of what is shown comes first
  }
  changed.notify_all();
}

vtkSmartPointer<vtkImageData> BackgroundSeries::Box(std::size_t step) const
{
  const std::lock_guard<std::mutex> lock(mutex);
  const auto found = kept.find(step);
  return found == kept.end() ? nullptr : found->second.box.Get();
}

void BackgroundSeries::GoOn()
{
  {
    const std::lock_guard<std::mutex> lock(mutex);
    draws = false;
  }
  changed.notify_all();
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

void BackgroundSeries::Reopen()
{
  {
    const std::lock_guard<std::mutex> lock(mutex);
    reopens = true;
  }
  changed.notify_all();
}

BackgroundSeries::Opened BackgroundSeries::OpenInputs()
{
  Opened inputs;
  inputs.series = options.open(this->ReportTo());
  if (options.choose)
  {
    inputs.order = options.choose(*inputs.series);
  }
  else
  {
    inputs.order.resize(inputs.series->Times().size());
    std::iota(inputs.order.begin(), inputs.order.end(), std::size_t(0));
  }
  return inputs;
}

// Sets what of the state is said of a series that is open.
void BackgroundSeries::Describe(State& series) const
{
  series.times = TimesOf(*opened.series, opened.order);
  series.moments = opened.series->Moments();
  series.makesAncillary = opened.series->MakesAncillaryArrays();
  series.leavesOutFiner = opened.series->LeavesOutFiner(opened.order.front());
}

bool BackgroundSeries::Open()
{
  State news;
  try
  {
    opened = this->OpenInputs();
    this->Describe(news);
    news.loaded.assign(opened.order.size(), false);
    news.damage = this->Damage();
    news.phase = Phase::Open;
  }
  catch (const std::exception& error)
  {
    news.failure = error.what();
    news.phase = Phase::Failed;
  }
  {
    const std::lock_guard<std::mutex> lock(mutex);
    news.paused = state.paused;
    if (news.paused && news.phase == Phase::Open) // too late to stop it
    {
      news = State();
      news.phase = Phase::Failed;
      news.failure = "stopped before it was opened";
    }
    state = news;
  }
  changed.notify_all();
  this->Wake();
  return news.phase == Phase::Open;
}

void BackgroundSeries::OpenAgain(std::unique_lock<std::mutex>& lock)
{
  reopens = false;
  lock.unlock();
  Opened again;
  reopenFailure.clear();
  try
  {
    again = this->OpenInputs();
  }
  catch (const std::exception& error)
  {
    reopenFailure = error.what();
  }
  lock.lock();
  if (reopenFailure.empty())
  {
    this->TakeOver(std::move(again));
  }
  state.damage = this->Damage();
}

// Exchanges the steps; the step that is shown stays the one of its time.
void BackgroundSeries::TakeOver(Opened again)
{
  std::map<std::string, std::size_t> before;
  for (const auto& [step, each] : kept)
  {
    before[each.contents] = step;
  }
  const std::vector<Time> times = TimesOf(*again.series, again.order);
  if (shown < state.times.size())
  {
    const auto same = std::find(times.begin(), times.end(), state.times[shown]);
    shown = same != times.end() ? static_cast<std::size_t>(same - times.begin()) : 0;
  }
  std::map<std::size_t, Kept> still;
  bytes = 0;
  state.loaded.assign(times.size(), false);
  for (std::size_t step = 0; step < times.size(); ++step)
  {
    const std::string contents = again.series->Contents(again.order[step]);
    const auto found = contents.empty() ? before.end() : before.find(contents);
    if (found != before.end())
    {
      Kept& each = still[step] = std::move(kept[found->second]);
      bytes += each.Bytes();
      state.loaded[step] = each.volume.image != nullptr;
    }
  }
  kept = std::move(still);
  opened = std::move(again);
  this->Describe(state);
}

std::vector<std::string> BackgroundSeries::Damage() const
{
  std::vector<std::string> lines = opened.series->Problems();
  if (!reopenFailure.empty())
  {
    lines.push_back(reopenFailure);
  }
  return lines;
}

// Whether a step, or the box of it, is to be loaded.
bool BackgroundSeries::Lacks(std::size_t step) const
{
  const auto found = kept.find(step);
  return found == kept.end() || (box && found->second.volume.image && !found->second.box.IsThere());
}

// The step to load next; nothing where all are loaded, there is no memory for more, or the one that
// is shown is drawn first.
std::optional<std::size_t> BackgroundSeries::NextStep() const
{
  const std::size_t count = opened.order.size();
  if (shown < count && this->Lacks(shown))
  {
    return shown;
  }
  std::size_t largest = 0;
  for (const auto& [step, each] : kept)
  {
    largest = std::max(largest, each.Bytes());
  }
  std::size_t following = 0; // bytes of the step that is shown and of those after it
  for (std::size_t i = 0; i < count && !state.paused && !draws; ++i)
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
    following += found->second.Bytes();
  }
  return std::nullopt;
}

// The volume of a step; or a box of it.
BackgroundSeries::Loaded BackgroundSeries::Load(
  std::size_t step, const std::optional<BoxRequest>& wantedBox)
{
  constexpr std::size_t kibibyte = 1024;
  const std::size_t index = opened.order[step];
  Loaded loaded;
  try
  {
    loaded.image = wantedBox ? opened.series->LoadBox(index, *wantedBox, this->ReportTo())
                             : opened.series->Load(index, this->ReportTo());
    if (loaded.image && options.prepare)
    {
      options.prepare(loaded.image);
    }
    loaded.bytes = loaded.image ? kibibyte * loaded.image->GetActualMemorySize() : 0;
  }
  catch (const std::exception& error)
  {
    loaded.failure = error.what();
  }
  return loaded;
}

// Forgets the volumes that are shown last until so many bytes fit; not the one that is shown.
void BackgroundSeries::MakeRoom(std::size_t wanted)
{
  const std::size_t count = opened.order.size();
  for (std::size_t i = count; i-- > 1 && bytes + wanted > options.memory;)
  {
    const auto found = kept.find((shown + i) % count);
    if (found != kept.end())
    {
      bytes -= found->second.Bytes();
      state.loaded[found->first] = false;
      kept.erase(found);
    }
  }
}

void BackgroundSeries::LoadNext(std::size_t step, std::unique_lock<std::mutex>& lock)
{
  state.loads = step;
  state.fraction = 0.0;
  const std::optional<BoxRequest> wantedBox = kept.count(step) > 0 ? box : std::nullopt;
  const unsigned wantedNumber = boxNumber;
  lock.unlock();
  const std::string contents = opened.series->Contents(opened.order[step]); // may change meanwhile
  Loaded loaded = this->Load(step, wantedBox);
  std::vector<std::string> damage = this->Damage();
  lock.lock();
  state.loads.reset();
  state.damage = std::move(damage);
  interrupted = false;
  if (wantedBox && wantedNumber != boxNumber)
  {
    return;
  }
  this->MakeRoom(loaded.bytes);
  const auto found = kept.find(step);
  if (!loaded.IsThere() || (wantedBox && found == kept.end())) // stopped, or there was no room
  {
    return;
  }
  bytes += loaded.bytes;
  if (wantedBox)
  {
    found->second.box = std::move(loaded);
    return;
  }
  state.loaded[step] = loaded.image != nullptr;
  kept[step] = {contents, std::move(loaded), {}};
  draws = options.drawsFirst && awaited && step == shown;
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
    if (reopens)
    {
      this->OpenAgain(lock);
    }
    else if (step)
    {
      this->LoadNext(*step, lock);
    }
    else
    {
      changed.wait(lock);
      continue;
    }
    lock.unlock();
    changed.notify_all(); // those who wait for a step
    this->Wake();
    lock.lock();
  }
}

} // namespace nexrad
