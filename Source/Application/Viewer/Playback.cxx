// SPDX-License-Identifier: BSD-3-Clause
#include "Viewer/Playback.h"

#include <vtkImageData.h>

#include <QDir>
#include <QFileInfo>
#include <QMetaObject>

#include <algorithm>
#include <chrono>
#include <exception>
#include <utility>

namespace nexrad::viewer
{

Playback::Playback(QObject* parent)
  : QObject(parent)
{
  clock.setSingleShot(true);
  clock.setTimerType(Qt::PreciseTimer);
  time.start();
  connect(&clock, &QTimer::timeout, this, &Playback::Tick);
  constexpr int quietTime = 1000; // ms
  quiet.setSingleShot(true);
  quiet.setInterval(quietTime);
  const auto wait = [this] { quiet.start(); };
  connect(&watcher, &QFileSystemWatcher::fileChanged, this, wait);
  connect(&watcher, &QFileSystemWatcher::directoryChanged, this, wait);
  connect(&quiet, &QTimer::timeout, this,
    [this]
    {
      this->RenewWatch();
      this->Refresh();
    });
}

Playback::~Playback() = default; // a future of std::async waits for its thread

// The thread may take a while to stop, so another one waits for it.
void Playback::Dismiss()
{
  if (!series)
  {
    return;
  }
  const auto isDone = [](const std::future<void>& each)
  { return each.wait_for(std::chrono::seconds(0)) == std::future_status::ready; };
  ending.erase(std::remove_if(ending.begin(), ending.end(), isDone), ending.end());
  ending.push_back(
    std::async(std::launch::async, [old = std::move(series)]() mutable { old.reset(); }));
}

void Playback::Open(BackgroundSeriesOptions options, std::optional<Time> first)
{
  this->Dismiss();
  begin = first;
  const unsigned own = ++generation;
  options.wake = [this, own]
  {
    // Queued: this is called on the other thread. Playback waits for it before it ends.
    QMetaObject::invokeMethod(
      this,
      [this, own]
      {
        if (own == generation)
        {
          this->TakeNews();
        }
      },
      Qt::QueuedConnection);
  };
  playing = false;
  clock.stop();
  shownAt.clear();
  step = 0;
  waiting = true;
  box.reset();
  seen.reset();
  boxWaiting = false;
  emit BoxLoaded(nullptr);
  state = {};
  options.drawsFirst = true;
  series = std::make_unique<BackgroundSeries>(std::move(options));
  emit Changed();
}

void Playback::TakeNews()
{
  const BackgroundSeries::State before = std::exchange(state, series->Get());
  if (before.phase == BackgroundSeries::Phase::Open && before.times != state.times)
  {
    this->FollowTimes(before.times);
  }
  if (state.phase == BackgroundSeries::Phase::Failed && before.phase != state.phase)
  {
    waiting = false;
    emit Failed(QString::fromStdString(state.failure));
  }
  if (state.phase == BackgroundSeries::Phase::Open && waiting)
  {
    this->FindFirst();
    this->Show();
    return; // which says that it changed
  }
  if (boxWaiting && state.phase == BackgroundSeries::Phase::Open)
  {
    this->ShowBox();
  }
  emit Changed();
}

// The series has other times than before.
void Playback::FollowTimes(const std::vector<Time>& before)
{
  const bool newest = !playing && step + 1 == before.size();
  const auto same = std::find(state.times.begin(), state.times.end(), before[step]);
  step = same != state.times.end() ? static_cast<std::size_t>(same - state.times.begin()) : 0;
  if (newest)
  {
    step = state.times.size() - 1;
  }
  waiting = true;
}

vtkSmartPointer<vtkImageData> Playback::Volume(std::size_t wanted)
{
  series->GoOn(); // nothing is drawn for it
  return series->Show(wanted);
}

vtkSmartPointer<vtkImageData> Playback::VolumeOfBox(std::size_t wanted) const
{
  return box ? series->Box(wanted) : nullptr;
}

void Playback::FindFirst()
{
  if (!begin)
  {
    return;
  }
  const auto found = std::find(state.times.begin(), state.times.end(), *begin);
  if (found != state.times.end())
  {
    step = static_cast<std::size_t>(found - state.times.begin());
  }
  else
  {
    emit Failed("there is no volume at " + QString::fromStdString(FormatIso8601(*begin)) +
                "; the first one is shown");
  }
  begin.reset();
}

void Playback::SetBox(const std::optional<BoxRequest>& wanted)
{
  box = series != nullptr ? wanted : std::nullopt;
  seen.reset();
  boxWaiting = box.has_value();
  if (series)
  {
    series->SetBox(wanted);
  }
  emit BoxLoaded(nullptr);
}

// What is shown in finer voxels stays until the next is there.
void Playback::SetSeen(const std::optional<BoxRequest>& wanted)
{
  if (!series || box || wanted == seen)
  {
    return;
  }
  seen = wanted;
  boxWaiting = seen.has_value();
  series->SetBox(seen);
  if (!seen)
  {
    emit BoxLoaded(nullptr);
  }
}

void Playback::ShowBox()
{
  try
  {
    const vtkSmartPointer<vtkImageData> image = series->Box(step);
    boxWaiting = image == nullptr;
    emit BoxLoaded(image); // none in place of one of another time
  }
  catch (const std::exception& error)
  {
    boxWaiting = false;
    if (box)
    {
      this->SetBox(std::nullopt);
    }
    emit Failed(QString::fromStdString(error.what()));
  }
}

void Playback::Show()
{
  vtkSmartPointer<vtkImageData> volume;
  try
  {
    volume = series->Show(step);
    waiting = volume == nullptr;
  }
  catch (const std::exception& error)
  {
    waiting = false;
    playing = false;
    emit Failed(QString::fromStdString(error.what()));
  }
  if (volume)
  {
    emit Loaded(volume);
    boxWaiting = box || seen;
    if (boxWaiting)
    {
      this->ShowBox();
    }
    if (playing)
    {
      constexpr std::size_t rateOver = 10; // steps
      shownAt.push_back(time.elapsed());
      if (shownAt.size() > rateOver)
      {
        shownAt.pop_front();
      }
      const qint64 drawing = time.elapsed() - shownAt.back();
      clock.start(static_cast<int>(std::max<qint64>(0, interval - drawing)));
    }
  }
  if (!waiting)
  {
    // The picture is drawn by an event that waits already.
    QTimer::singleShot(0, this, [this] { series->GoOn(); });
  }
  emit Changed();
}

double Playback::StepsPerSecond() const
{
  if (!playing || shownAt.size() < 2 || shownAt.back() == shownAt.front())
  {
    return 0.0;
  }
  return 1000.0 * static_cast<double>(shownAt.size() - 1) /
         static_cast<double>(shownAt.back() - shownAt.front());
}

void Playback::GoTo(std::size_t wanted)
{
  if (!series || wanted >= state.times.size())
  {
    return;
  }
  step = wanted;
  waiting = true;
  this->Show();
}

void Playback::Move(int by)
{
  const auto count = static_cast<int>(state.times.size());
  if (count > 0)
  {
    const int next = (static_cast<int>(step) + by % count + count) % count;
    this->GoTo(static_cast<std::size_t>(next));
  }
}

void Playback::Play(bool on)
{
  playing = on && state.times.size() > 1;
  shownAt.clear();
  clock.stop();
  if (playing)
  {
    clock.start(interval);
  }
  emit Changed();
}

void Playback::Tick()
{
  if (!playing || waiting)
  {
    return; // once the step is loaded, the clock goes on
  }
  if (!loops && step + 1 == state.times.size())
  {
    this->Play(false);
    return;
  }
  this->Move(1);
}

void Playback::SetLoops(bool on)
{
  loops = on;
  emit Changed();
}

void Playback::SetInterval(int milliseconds)
{
  interval = milliseconds;
  emit Changed();
}

void Playback::PauseLoading(bool paused)
{
  if (series)
  {
    series->Pause(paused);
    state = series->Get();
    emit Changed();
  }
}

void Playback::Refresh()
{
  if (series)
  {
    series->Reopen();
  }
}

void Playback::Watch(const QStringList& paths)
{
  inputs = paths;
  quiet.stop();
  this->RenewWatch();
}

// A folder tells of files that come and go, but not of a file that grows, so the newest files are
// watched themselves. A file that was replaced has to be watched anew.
void Playback::RenewWatch()
{
  constexpr int newest = 16;
  QStringList paths;
  for (const QString& input : inputs)
  {
    const QFileInfo info(input);
    if (info.exists())
    {
      paths << info.absoluteFilePath();
    }
    if (info.isDir())
    {
      const QFileInfoList files = QDir(input).entryInfoList(QDir::Files, QDir::Time);
      for (const QFileInfo& file : files.mid(0, newest))
      {
        paths << file.absoluteFilePath();
      }
    }
  }
  const QStringList old = watcher.files() + watcher.directories();
  if (!old.isEmpty())
  {
    watcher.removePaths(old);
  }
  if (!paths.isEmpty())
  {
    watcher.addPaths(paths);
  }
}

} // namespace nexrad::viewer
