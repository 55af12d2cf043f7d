// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Filters/Series/BackgroundSeries.h"

#include <QElapsedTimer>
#include <QFileSystemWatcher>
#include <QObject>
#include <QStringList>
#include <QTimer>

#include <cstddef>
#include <deque>
#include <future>
#include <memory>
#include <optional>
#include <vector>

namespace nexrad::viewer
{

/// Which time of a series is shown, and its playing. The volumes are opened and loaded on another
/// thread; nothing here waits for it.
class Playback : public QObject
{
  Q_OBJECT

public:
  explicit Playback(QObject* parent = nullptr);
  /// Waits for the threads of all series that were opened.
  ~Playback() override;

  /// Opens a series in place of the one that is open, whose thread is asked to stop. `wake` and
  /// `drawsFirst` of the options are set here. The first step is shown when it is loaded.
  /// `first`: the time that is shown first; empty: the first step.
  void Open(BackgroundSeriesOptions options, std::optional<Time> first = std::nullopt);

  /// Watches these files and folders in place of those before, for files that are added to them or
  /// grow: then the inputs are opened once more (Refresh), after a second without a change, because
  /// a file that is being written changes often.
  void Watch(const QStringList& paths);

  bool HasSeries() const { return series != nullptr; }
  /// Of the series: what is new comes with Changed.
  const BackgroundSeries::State& State() const { return state; }
  /// The step that is shown, or will be as soon as it is loaded.
  std::size_t Step() const { return step; }
  /// The volume of a step, which is not shown for that. Nothing as long as it is not loaded; then
  /// it is loaded next. Throws Error when it cannot be loaded.
  vtkSmartPointer<vtkImageData> Volume(std::size_t wanted);
  /// Loads a box of the domain in finer voxels for each step, until another series is opened or
  /// nothing is set. BoxLoaded gives the box of each step that is shown.
  void SetBox(const std::optional<BoxRequest>& wanted);
  bool HasBox() const { return box.has_value(); }
  /// The box that is set.
  const std::optional<BoxRequest>& Box() const { return box; }
  /// Loads what the window shows as such a box, as long as SetBox sets none.
  void SetSeen(const std::optional<BoxRequest>& wanted);
  /// The box that SetSeen set.
  const std::optional<BoxRequest>& Seen() const { return seen; }
  /// The box of a step, as Volume; nothing also where none is set.
  vtkSmartPointer<vtkImageData> VolumeOfBox(std::size_t wanted) const;
  /// Whether that step is still being loaded.
  bool IsWaiting() const { return waiting; }
  bool IsPlaying() const { return playing; }
  bool Loops() const { return loops; }
  int Interval() const { return interval; }
  /// Steps a second that were shown lately while playing; 0 when it does not play.
  double StepsPerSecond() const;

public slots:
  void GoTo(std::size_t wanted);
  /// A step on (or back, if below 0), to the other end after the last one.
  void Move(int by);
  void Play(bool on);
  void SetLoops(bool on);
  /// Milliseconds from one step to the next in playing.
  void SetInterval(int milliseconds);
  /// Stops what is loaded but not shown; lets it go on.
  void PauseLoading(bool paused);
  /// Opens the inputs once more for what was added to them. The time that is shown stays; where it
  /// was the last one and nothing plays, the new last one is shown.
  void Refresh();

signals:
  /// The state, the step or the playing changed.
  void Changed();
  /// A volume is to be shown.
  void Loaded(vtkImageData* volume);
  /// The box of the step that is shown; nullptr as long as it is not merged.
  void BoxLoaded(vtkImageData* box);
  /// A step or a box cannot be loaded, or the series not be opened.
  void Failed(const QString& why);

private:
  void TakeNews();
  void FollowTimes(const std::vector<Time>& before);
  void Show();
  void ShowBox();
  void Tick();
  void Dismiss();
  void FindFirst();
  void RenewWatch();

  std::unique_ptr<BackgroundSeries> series;
  std::vector<std::future<void>> ending; ///< of series that are not shown any more
  BackgroundSeries::State state;
  unsigned generation = 0;   ///< of the series: news of an older one are not heard
  std::optional<Time> begin; ///< the time that is shown first, until the series is open
  std::size_t step = 0;
  bool waiting = false;
  std::optional<BoxRequest> box;
  std::optional<BoxRequest> seen; ///< none where there is `box`
  bool boxWaiting = false;        ///< that of the step is not shown yet
  bool playing = false;
  bool loops = true;
  int interval = 500; // ms
  QTimer clock;
  QElapsedTimer time;
  std::deque<qint64> shownAt; ///< ms, of the latest steps in playing
  QStringList inputs;         ///< that are watched
  QFileSystemWatcher watcher;
  QTimer quiet; ///< since the last change of the inputs
};

} // namespace nexrad::viewer
