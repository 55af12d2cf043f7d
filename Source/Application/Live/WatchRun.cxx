// SPDX-License-Identifier: BSD-3-Clause
#include "Live/WatchRun.h"

#include "Live/LiveFolder.h"
#include "Live/NewestBricks.h"
#include "Output/ProgressBar.h"
#include "nexrad/Grid/GridSpecification.h"
#include "nexrad/Live/LiveSeries.h"
#include "nexrad/Live/StepBook.h"
#include "nexrad/System/MachineMemory.h"
#include "nexrad/System/MessageText.h"
#include "vtkNexradThreads.h"

#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <exception>
#include <set>
#include <thread>
#include <utility>

namespace fs = std::filesystem;

namespace nexrad::application
{
namespace
{

using FileTime = fs::file_time_type;
using Tell = std::function<void(const std::string&)>;

// The longest volume, and what a header's time may err: what began so long before the oldest time
// that needs it can be passed over.
constexpr auto longestVolume = std::chrono::hours(1);

// For how long files are taken before what they hold is merged.
constexpr auto intakeTime = std::chrono::milliseconds(500);

// Real time between two writings of the status when nothing happens but that data grow older.
constexpr auto statusInterval = std::chrono::seconds(1);

StepRules StepRulesOf(const WatchJob& job)
{
  return {job.options.step.value_or(DefaultStep), job.options.begin, job.options.end, job.late};
}

// Draws pictures by `nexrad3d render` in a process of its own, one at a time: what a driver of
// OpenGL does with memory over days does not stay, and merging does not wait for it. The process
// gives way to others (nice).
class PictureProcess
{
public:
  PictureProcess() = default;
  ~PictureProcess()
  {
    if (this->IsRunning())
    {
      kill(process, SIGTERM);
      waitpid(process, nullptr, 0);
    }
  }
  PictureProcess(const PictureProcess&) = delete;
  PictureProcess& operator=(const PictureProcess&) = delete;

  bool IsRunning()
  {
    int ended = 0;
    if (process != 0 && waitpid(process, &ended, WNOHANG) != 0)
    {
      process = 0;
      status = WIFEXITED(ended) ? WEXITSTATUS(ended) : -1;
    }
    return process != 0;
  }

  // Begins to draw with the words of a command line. Where no process can be started, LastStatus is
  // not 0.
  void Start(std::vector<std::string> words)
  {
    std::vector<char*> arguments;
    for (std::string& word : words)
    {
      arguments.push_back(word.data());
    }
    arguments.push_back(nullptr);
    pid_t started = 0;
    status = posix_spawn(&started, "/proc/self/exe", nullptr, nullptr, arguments.data(), environ);
    if (status == 0) // else there are too many processes, or too little memory
    {
      constexpr int gently = 10;
      setpriority(PRIO_PROCESS, static_cast<id_t>(started), gently);
      process = started;
    }
  }

  // Exit status of the last one that ended; below 0: a signal.
  int LastStatus() const { return status; }

private:
  int process = 0; // 0: none
  int status = 0;
};

class WatchRun
{
public:
  WatchRun(const WatchJob& theJob, const LiveClock& theClock, LiveFolder& theFolder,
    const LiveState& before, LiveStatus& theStatus, Tell theTell, Tell theComplain)
    : job(theJob)
    , tell(std::move(theTell))
    , complain(std::move(theComplain))
    , clock(theClock)
    , listing(job.folders)
    , intake(job.intake, clock)
    , series(job.options, vtkNexradRangeLoop(),
        AreInBricks(job.written, job.options) ? UseOfWriting(job.written, job.options) : LiveUse)
    , book(StepRulesOf(job))
    , folder(theFolder)
    , newestBricks(series, folder.NewestVolume(), job.written)
    , status(theStatus)
  {
    this->GoOn(before);
  }

  WatchReport Run()
  {
    while (!IsStopAsked())
    {
      const auto begin = std::chrono::steady_clock::now();
      const bool busy = this->Round();
      if (job.stopAfter && !busy && intake.SilentFor() > *job.stopAfter)
      {
        this->Conclude();
        status.reason = "nothing arrived for the time of --stop-after";
        break;
      }
      if (!busy)
      {
        this->Rest(std::chrono::steady_clock::now() - begin);
      }
    }
    concluding = true;
    this->TellEnds();
    status.reason = IsStopAsked() ? "a signal asked for it" : status.reason;
    this->WriteStatus("stopped");
    return report;
  }

private:
  // Takes up what an earlier run left.
  void GoOn(const LiveState& before)
  {
    for (const auto& [name, radar] : before.radars)
    {
      series.Expect(radar.first, radar.second);
    }
    if (before.keepsGrid)
    {
      series.KeepGrid();
    }
    if (!before.steps.empty())
    {
      book.Unpack(before.steps);
    }
    if (book.ClosedUntil())
    {
      intake.SetOldest(*book.ClosedUntil() - job.options.maximumGap - longestVolume);
    }
    status.staleAge = job.stale;
    status.newestFile = folder.NewestVolume().filename().string();
    status.pictureFile = job.drawing.empty() ? "" : "newest.png";
  }

  // Takes what arrived, and makes what follows from it. False when there was nothing to do.
  bool Round()
  {
    intake.Arrive(listing.Poll());
    this->TellProblems(listing.TakeProblems());
    this->Use(intake.Take(listing, intakeTime));
    this->TellEnds();
    const bool newest = !intake.IsBehind() && this->MakeNewest();
    const bool steps = this->MakeSteps(false);
    if (steps)
    {
      this->Forget();
      ReturnFreedMemory();
      folder.WriteIndex(book.Made());
      this->WriteState();
    }
    this->Draw();
    if (newest || steps || std::chrono::steady_clock::now() - statusWritten > statusInterval)
    {
      this->WriteStatus("running");
    }
    return newest || steps || intake.IsBehind();
  }

  // The less a look at the folders took, the sooner is the next: looks take a twentieth of the
  // time.
  void Rest(std::chrono::nanoseconds looked) const
  {
    constexpr auto slice = std::chrono::milliseconds(50); // in which a signal is noticed
    const auto longest = std::chrono::nanoseconds(std::max(slice, job.poll));
    const auto rest = std::clamp(20 * looked, std::chrono::nanoseconds(slice), longest);
    const auto end = std::chrono::steady_clock::now() + rest;
    while (!IsStopAsked() && std::chrono::steady_clock::now() < end)
    {
      std::this_thread::sleep_for(std::min<std::chrono::steady_clock::duration>(
        slice, end - std::chrono::steady_clock::now()));
    }
  }

  // Nothing more comes: all that is there is finished, and each step is made of it.
  void Conclude()
  {
    concluding = true;
    this->Use(intake.FinishAll(listing));
    this->MakeNewest();
    this->MakeSteps(true);
    folder.WriteIndex(book.Made());
    this->WriteState();
    while (picture.IsRunning() && !IsStopAsked())
    {
      this->Rest({});
    }
  }

  void TellProblems(const std::vector<std::string>& lines)
  {
    report.problems += lines.size();
    for (const std::string& line : lines)
    {
      complain(line);
    }
  }

  void Use(std::vector<IntakeChange> changes)
  {
    this->TellProblems(intake.TakeProblems());
    if (changes.empty())
    {
      return;
    }
    const auto before = series.HasGrid() ? std::optional(series.Grid()) : std::nullopt;
    std::vector<LiveInput> inputs;
    for (IntakeChange& change : changes)
    {
      if (change.completed && *change.completed > begun)
      {
        waitingSince = std::min(waitingSince.value_or(*change.completed), *change.completed);
      }
      inputs.push_back(std::move(change.input));
    }
    this->EndBeforePause(inputs);
    std::vector<ScannedFile> scanned = series.Put(inputs);
    for (std::size_t i = 0; i < inputs.size(); ++i)
    {
      if (!inputs[i].finished)
      {
        scanned[i].problems.clear();
      }
      ends.Keep(scanned[i]);
      this->TellProblems(ProblemLines(scanned[i].problems));
    }
    if (std::any_of(changes.begin(), changes.end(),
          [](const IntakeChange& change) { return change.isTakenBack; }))
    {
      this->DropStrays();
    }
    this->FollowGrid(before);
    for (const auto& [radar, time] : series.NewestByRadar())
    {
      newestRays[radar] = time;
    }
    for (const TimeSpan& span : series.Known().Spans())
    {
      book.Extend(span.first, span.last);
    }
  }

  // Of volumes that lack their end, those of which it is known why.
  void TellEnds()
  {
    const AwaitedEnds::Decided decided = ends.TakeDecided(series.Known(), this->SilentRadars());
    this->TellProblems(ProblemLines(decided.problems));
    for (const std::string& note : decided.notes)
    {
      tell(note);
    }
  }

  // What was scanned before a pause of more than a day is as if nothing more came: its steps are
  // made before the series leaps over the pause.
  void EndBeforePause(const std::vector<LiveInput>& inputs)
  {
    const std::optional<Time> newest = series.Known().Last();
    const bool leaps = std::any_of(inputs.begin(), inputs.end(),
      [&newest](const LiveInput& input)
      {
        const std::optional<Time> start = input.volume.Start();
        return newest && start && *start - *newest > LongestPause;
      });
    if (leaps)
    {
      this->MakeSteps(true);
    }
  }

  // Steps of files that proved to be older than the feed: all of them are taken back, and the book
  // begins anew, as no step is done with then.
  void DropStrays()
  {
    if (book.ClosedUntil())
    {
      return;
    }
    this->RemoveSteps();
    book = StepBook(StepRulesOf(job));
    newestRays.clear();
  }

  void RemoveSteps()
  {
    for (const Time step : book.Made())
    {
      folder.RemoveStep(step);
    }
    folder.WriteIndex({});
  }

  // A radar that comes while all steps may still change makes the domain larger. Later the series
  // keeps the domain that it has.
  void FollowGrid(const std::optional<GridSpecification>& before)
  {
    if (!series.HasGrid())
    {
      return;
    }
    if (!before)
    {
      std::set<std::string> own;
      for (const Time step : book.Made())
      {
        own.insert(VolumeFileName(step).string());
      }
      own.insert(folder.NewestVolume().filename().string());
      RequireSameGrid(job.output, own, series.Grid());
    }
    else if (*before != series.Grid())
    {
      this->RemoveSteps();
      book.Restart();
    }
    for (const auto& [radar, time] : series.NewestByRadar())
    {
      const std::string note = radar +
                               " came when the domain was settled: it has no part in its size; "
                               "give --bounds, or name another folder (-o), for a larger one";
      if (series.Sites().count(radar) == 0 &&
          std::find(status.notes.begin(), status.notes.end(), note) == status.notes.end())
      {
        status.notes.push_back(note);
        tell(note);
      }
    }
  }

  // Merges the volume at a time, and writes it. False when asked to stop.
  bool Make(Time time, const fs::path& path)
  {
    if (AreInBricks(job.written, job.options))
    {
      return this->MakeInBricks(time, path);
    }
    std::optional<GriddedVolume> volume = series.Merge(time, this->Going(), std::move(memory));
    if (volume)
    {
      WriteNxv(path, *volume, job.written.encoding);
      memory = std::move(*volume);
    }
    return volume.has_value();
  }

  bool MakeInBricks(Time time, const fs::path& path)
  {
    NxvBandWriter bricks(path, series.Grid(), job.written.encoding);
    const bool made =
      series.Plan(time).MergeBands(NxvBandWriter::Rows, PackInto(bricks), this->Going());
    if (made)
    {
      bricks.Commit();
    }
    return made;
  }

  // The time of the newest volume: of the newest ray, or of volumes in bricks one that lies ahead.
  std::optional<Time> NewestTime() const
  {
    const std::optional<Time> ray = series.Known().Last();
    if (!ray || !AreInBricks(job.written, job.options))
    {
      return ray;
    }
    return newestBricks.TimeFor(*ray, job.options.step.value_or(DefaultStep));
  }

  // The newest merged volume. False when there is nothing new.
  bool MakeNewest()
  {
    const std::optional<Time> newest = this->NewestTime();
    if (!newest)
    {
      return false;
    }
    const std::string inputs = FormatIso8601(*newest) + series.InputsAt(*newest);
    if (inputs == newestInputs)
    {
      waitingSince.reset();
      return false;
    }
    const bool made = AreInBricks(job.written, job.options)
                        ? newestBricks.Make(*newest, this->Going())
                        : this->Make(*newest, folder.NewestVolume());
    if (!made)
    {
      return false;
    }
    newestInputs = inputs;
    status.newest = newest;
    ++report.newest;
    if (waitingSince)
    {
      status.delays.Add(
        std::chrono::duration<double>(FileTime::clock::now() - *waitingSince).count());
      waitingSince.reset();
    }
    return true;
  }

  // Makes the steps that have their last chance, and one more that is due; `all`: all that are due,
  // as if nothing more came. False when none was due.
  bool MakeSteps(bool all)
  {
    if (!series.Known().Last())
    {
      return false;
    }
    const std::set<std::string> silent = this->SilentRadars();
    bool made = false;
    bool closing = false;
    // A file that will be taken as soon as it is known to be whole still counts for the steps
    // before its volume, with which it is merged.
    const std::optional<Time> waiting = intake.OldestWaiting();
    const bool mayClose =
      !waiting || *waiting - job.options.maximumGap > *series.Known().Last() - job.late;
    for (const Time step : book.Open())
    {
      const bool isClosing = mayClose && book.IsClosing(step);
      const bool settled = all || series.IsSettled(step, silent);
      closing = closing || isClosing;
      const std::string inputs = series.InputsAt(step);
      const bool waits = intake.IsBehind() && !isClosing && !settled;
      if (waits || !book.IsDue(step, inputs, settled))
      {
        continue;
      }
      if (!this->Make(step, folder.StepVolume(step)))
      {
        return made;
      }
      book.Make(step, inputs);
      ++report.steps;
      made = true;
      if (!isClosing && !all)
      {
        break; // the newest volume comes first
      }
    }
    if (closing)
    {
      series.KeepGrid();
      book.Close();
    }
    return made || closing;
  }

  void Forget()
  {
    if (!book.ClosedUntil() || !series.Known().Last())
    {
      return;
    }
    const std::vector<Time> open = book.Open();
    const Time from = open.empty() ? *series.Known().Last() : open.front();
    series.Forget(from);
    intake.SetOldest(from - job.options.maximumGap - longestVolume);
    if (job.keep)
    {
      const Time oldest = *series.Known().Last() - *job.keep;
      for (const Time step : book.Made())
      {
        if (step < oldest)
        {
          folder.RemoveStep(step);
        }
      }
      book.Drop(oldest);
    }
  }

  // Draws the newest volume, unless the one before is still being drawn.
  void Draw()
  {
    const bool drawsNone =
      status.pictureFile.empty(); // none is asked for, or one could not be drawn
    if (drawsNone || picture.IsRunning() || drawn == report.newest)
    {
      return;
    }
    if (picture.LastStatus() != 0)
    {
      status.pictureFile.clear();
      status.notes.push_back("the picture cannot be drawn: see standard error; no more are drawn");
      complain(status.notes.back());
      return;
    }
    std::vector<std::string> words = {"nexrad3d", "render", folder.NewestVolume().string(), "-o",
      (job.output / status.pictureFile).string(), "--quiet"};
    words.insert(words.end(), job.drawing.begin(), job.drawing.end());
    picture.Start(std::move(words));
    drawn = report.newest;
    status.pictureTime = status.newest;
  }

  std::map<std::string, RadarStatus> RadarStates() const
  {
    std::map<std::string, RadarStatus> states;
    for (const auto& [name, arriving] : intake.Radars())
    {
      states[name].arriving = arriving;
    }
    const Time now = clock.Now();
    for (const auto& [radar, newest] : newestRays)
    {
      states[radar].newest = newest;
      states[radar].live = now - newest <= job.stale;
    }
    return states;
  }

  // Those of which nothing is waited for any more: none as long as files wait that may be theirs.
  std::set<std::string> SilentRadars() const
  {
    std::set<std::string> silent;
    const Time now = clock.Now();
    for (const auto& [radar, newest] : newestRays)
    {
      if (concluding || (!intake.IsBehind() && now - newest > job.stale))
      {
        silent.insert(radar);
      }
    }
    return silent;
  }

  void WriteStatus(const std::string& state)
  {
    status.state = state;
    status.written = clock.Now();
    status.radars = this->RadarStates();
    status.steps = book.Made();
    status.problems = report.problems;
    status.heldBytes = series.MemoryBytes();
    folder.WriteStatus(status);
    statusWritten = std::chrono::steady_clock::now();
    std::map<std::string, bool> live;
    for (const auto& [name, radar] : status.radars)
    {
      if (radar.newest)
      {
        live[name] = radar.live;
      }
    }
    if (live != wasLive)
    {
      wasLive = std::move(live);
      tell(StatusLine(status));
    }
  }

  void WriteState() const
  {
    folder.WriteState({book.Pack(), series.Sites(), book.ClosedUntil().has_value()});
  }

  Progress Going() const
  {
    return [](double) { return !IsStopAsked(); };
  }

  const WatchJob& job;
  const Tell tell;
  const Tell complain;
  const LiveClock& clock;
  FolderListing listing;
  LiveIntake intake;
  LiveSeries series;
  AwaitedEnds ends;
  StepBook book;
  LiveFolder& folder;
  NewestBricks newestBricks;
  PictureProcess picture;
  LiveStatus& status;
  WatchReport report;
  std::map<std::string, Time> newestRays; // of each radar, also when its volumes are dropped
  std::string newestInputs;
  GriddedVolume memory; // arrays that are used again
  const FileTime begun = FileTime::clock::now();
  std::optional<FileTime> waitingSince; // last byte of the first sweep that no volume has yet
  std::size_t drawn = 0; // of the newest volumes, how many there were for the last picture
  bool concluding = false;
  std::map<std::string, bool> wasLive;
  std::chrono::steady_clock::time_point statusWritten{};
};

} // namespace

WatchReport WatchFolders(const WatchJob& job, const std::function<void(const std::string&)>& tell,
  const std::function<void(const std::string&)>& complain)
{
  const LiveClock clock(job.replay);
  LiveFolder folder(job.output, job.recipe);
  LiveStatus status;
  try
  {
    const LiveState before = folder.GoOn();
    return WatchRun(job, clock, folder, before, status, tell, complain).Run();
  }
  catch (const std::exception& problem)
  {
    status.state = "stopped";
    status.written = clock.Now();
    status.reason = MessageLine(problem.what());
    folder.WriteLastStatus(status);
    throw;
  }
}

} // namespace nexrad::application
