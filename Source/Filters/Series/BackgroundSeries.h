// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Filters/Series/VolumeSeries.h"

#include <condition_variable>
#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace nexrad
{

struct BackgroundSeriesOptions
{
  /// Opens the series, on the other thread, as OpenInputs does. As long as the other thread is
  /// there, nobody else may use the series.
  std::function<std::shared_ptr<VolumeSeries>(const Progress& progress)> open;
  /// Indices of the volumes that take part, in the order in which they are shown, asked for on the
  /// other thread once the series is open. Empty: all.
  std::function<std::vector<std::size_t>(const VolumeSeries& series)> choose;
  /// Done with each volume on the other thread, before it can be shown. May be empty.
  std::function<void(vtkImageData* volume)> prepare;
  /// Called on the other thread when there is something new to ask for, at most every 20 ms while
  /// it works. It must not use the series; it may post an event to the thread that does. May be
  /// empty.
  std::function<void()> wake;
  /// Bytes that the volumes may take together; but one is always kept.
  std::size_t memory = std::size_t(1) << 30;
  /// After a step that was waited for, others are loaded only from GoOn on: until then the picture
  /// of that step has the processors.
  bool drawsFirst = false;
};

/// A series that another thread opens and loads. A window must not wait: no call waits for more
/// than a mutex that is held for a moment, apart from Wait and the end. A step is a place in the
/// order in which the volumes are shown. The step that is shown is loaded first, then those that
/// follow it, the first after the last, as long as there is memory for them.
class BackgroundSeries
{
public:
  /// Begins to open the series.
  explicit BackgroundSeries(BackgroundSeriesOptions options);
  /// Asks the other thread to stop, and waits for it.
  ~BackgroundSeries();
  BackgroundSeries(const BackgroundSeries&) = delete;
  BackgroundSeries& operator=(const BackgroundSeries&) = delete;

  enum class Phase
  {
    Opening,
    Open,
    Failed ///< it could not be opened
  };
  struct State
  {
    Phase phase = Phase::Opening;
    std::string failure;              ///< why it could not be opened
    std::vector<Time> times;          ///< of the steps, once the series is open
    std::vector<MomentName> moments;  ///< that the inputs hold, as far as they are known
    bool makesAncillary = false;      ///< VolumeSeries::MakesAncillaryArrays
    bool leavesOutFiner = false;      ///< VolumeSeries::LeavesOutFiner, of the first step
    std::vector<std::string> damage;  ///< inputs that were damaged or left out so far, a line each
    std::vector<bool> loaded;         ///< which of the steps are in memory
    std::optional<std::size_t> loads; ///< the step that is being loaded
    double fraction = 0.0;            ///< of the opening, or of that step, 0 to 1
    bool paused = false;              ///< only the step that is shown is loaded
  };
  State Get() const;

  /// The volume of a step. Nothing as long as it is not loaded; then it is loaded next, and `wake`
  /// is called when it is there. Throws Error when it cannot be loaded.
  vtkSmartPointer<vtkImageData> Show(std::size_t step);

  /// The same, waited for, with its box where one is set. Nothing when `progress`, which is told
  /// how far the loading is, asked to stop. Throws Error also when the series, or the box, cannot
  /// be made.
  vtkSmartPointer<vtkImageData> Wait(std::size_t step, const Progress& progress = {});

  /// Merges a box of the domain again for each step, after its volume; nothing: of none any more.
  /// The box of the step that is shown comes first. `wake` is called when it is there.
  void SetBox(const std::optional<BoxRequest>& box);
  /// The box of a step. Nothing as long as it is not merged, or no box is set. Throws Error when it
  /// cannot be merged.
  vtkSmartPointer<vtkImageData> Box(std::size_t step) const;

  /// The step that was waited for is drawn (BackgroundSeriesOptions::drawsFirst).
  void GoOn();

  /// Stops the loading of all steps but the one that is shown, and lets it go on. An opening that
  /// is paused fails.
  void Pause(bool paused);

  /// Opens the inputs once more on the other thread, for what was added to them. The steps stay
  /// until that is done; then those with the same contents (VolumeSeries::Contents) keep their
  /// volumes. Why it failed, if it did, is a line of the damage.
  void Reopen();

private:
  /// A series, and the steps that are shown of it.
  struct Opened
  {
    std::shared_ptr<VolumeSeries> series;
    std::vector<std::size_t> order; ///< indices of the steps
  };
  /// A volume, or a box of one; neither image nor failure: it was not loaded, or that was stopped.
  struct Loaded
  {
    vtkSmartPointer<vtkImageData> image;
    std::string failure;
    std::size_t bytes = 0;

    bool IsThere() const { return image || !failure.empty(); }
    /// The image. Throws Error where there is a failure in its place.
    vtkSmartPointer<vtkImageData> Get() const;
  };
  struct Kept
  {
    std::string contents; ///< VolumeSeries::Contents, before it was loaded
    Loaded volume;
    Loaded box;

    std::size_t Bytes() const { return volume.bytes + box.bytes; }
  };

  void Run();
  Opened OpenInputs();
  void Describe(State& series) const;
  bool Open();
  void OpenAgain(std::unique_lock<std::mutex>& lock);
  void TakeOver(Opened opened);
  void LoadNext(std::size_t step, std::unique_lock<std::mutex>& lock);
  std::vector<std::string> Damage() const;
  std::optional<std::size_t> NextStep() const;
  bool Lacks(std::size_t step) const;
  bool IsDone(std::size_t step) const;
  Loaded Load(std::size_t step, const std::optional<BoxRequest>& wantedBox);
  void MakeRoom(std::size_t bytes);
  Progress ReportTo();
  void Wake();

  const BackgroundSeriesOptions options;
  Opened opened;             // of the other thread
  std::string reopenFailure; // of the other thread
  mutable std::mutex mutex;  // of all that follows
  std::condition_variable changed;
  State state;
  std::map<std::size_t, Kept> kept; // by step
  std::size_t bytes = 0;            // of these
  std::size_t shown = 0;            // the step that was asked for last
  std::optional<BoxRequest> box;
  unsigned boxNumber = 0; // how often another box was set
  bool ended = false;
  bool awaited = true;      // the step that is shown was not there when it was asked for
  bool draws = false;       // that step is there, and comes before others
  bool reopens = false;     // as soon as nothing is being loaded
  bool interrupted = false; // another step is wanted than the one that is being loaded
  std::thread thread;
};

} // namespace nexrad
