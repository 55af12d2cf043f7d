// SPDX-License-Identifier: BSD-3-Clause
// What the steps of a series of volumes cost as it plays from disk, in the scene of `nexrad3d view`
// with its default table, 796 x 532 pixels: t1, t2 and t3 of the thesis's table 4.2. Usage:
// BenchmarkSeries [volumes ...]: .nxv files, an index or a folder of them. Without any, 24 volumes
// of three simulated radars (SYNTHETIC), 256 x 256 x 128, five minutes apart.
#include "Commands/SimulatedFiles.h"
#include "Drawing/PictureWindow.h"
#include "Filters/Series/BackgroundSeries.h"
#include "Filters/Series/VolumeFiles.h"
#include "StepTimes.h"
#include "Tables/Measurement.h"
#include "TestData.h"
#include "Volumes/WriteVolumes.h"
#include "nexrad/System/Error.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkNexradVolumeScene.h>
#include <vtkOpenGLTextureSliceVolumeMapper.h>
#include <vtkRenderWindow.h>

#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <exception>
#include <mutex>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace
{

using namespace nexrad;
using namespace nexrad::application;
using namespace nexrad::scene;

/// Times of loading, on whichever thread it happens.
class LoadTimes
{
public:
  void Begin()
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    ++this->Running;
  }
  void End(double seconds)
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->Seconds.push_back(seconds);
    --this->Running;
    this->Changed.notify_all();
  }
  std::vector<double> Take()
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    return std::exchange(this->Seconds, {});
  }
  void WaitUntilIdle()
  {
    std::unique_lock<std::mutex> lock(this->Mutex);
    this->Changed.wait(lock, [this] { return this->Running == 0; });
  }

private:
  std::mutex Mutex;
  std::condition_variable Changed;
  int Running = 0;
  std::vector<double> Seconds;
};

/// The same series, whose loading is timed.
class TimedSeries : public VolumeSeries
{
public:
  TimedSeries(std::unique_ptr<VolumeSeries> source, LoadTimes& loadTimes)
    : Source(std::move(source))
    , Loads(loadTimes)
  {
  }
  const std::vector<Time>& Times() const override { return this->Source->Times(); }
  bool AllowCodes(bool allowed) override { return this->Source->AllowCodes(allowed); }
  vtkSmartPointer<vtkImageData> Load(std::size_t index, const Progress& progress) override
  {
    this->Loads.Begin();
    vtkSmartPointer<vtkImageData> volume;
    this->Loads.End(SecondsOf([&] { volume = this->Source->Load(index, progress); }));
    return volume;
  }
  vtkSmartPointer<vtkImageData> LoadBox(
    std::size_t index, const BoxRequest& box, const Progress& progress) override
  {
    return this->Source->LoadBox(index, box, progress);
  }

private:
  std::unique_ptr<VolumeSeries> Source;
  LoadTimes& Loads;
};

/// Seconds of all steps of a series.
struct Play
{
  std::vector<double> Load;
  std::vector<double> Upload;
  std::vector<double> Draw;
  std::vector<double> Still; ///< the same frames once more, with nothing else going on
  std::vector<double> Ahead; ///< loading on its own thread
  double Whole = 0.0;        ///< from the first step to the last
};

std::filesystem::path WriteSyntheticSeries(const std::filesystem::path& folder)
{
  SimulatedDayOptions day;
  day.begin = *ParseIso8601("2006-03-12T17:00");
  day.length = std::chrono::minutes(135);
  GridJob job;
  job.inputs = WriteSimulatedFiles(day, folder / "files").files;
  job.folder = folder / "volumes";
  job.options.begin = *ParseIso8601("2006-03-12T17:10");
  job.options.end = *ParseIso8601("2006-03-12T19:05");
  return WriteVolumes(job).indices.front();
}

class Player
{
public:
  Player(const std::vector<std::filesystem::path>& inputs, int slices)
  {
    this->Scene->SetOption("slices", static_cast<double>(slices));
    BackgroundSeriesOptions options;
    options.open = [this, &inputs](const Progress&)
    {
      auto series = std::make_shared<TimedSeries>(OpenVolumeFiles(inputs), this->Loads);
      series->AllowCodes(true);
      return series;
    };
    options.prepare = [before = vtkSmartPointer<vtkObject>()](vtkImageData* volume) mutable
    { before = vtkOpenGLTextureSliceVolumeMapper::PrepareScalars(volume, before); };
    options.memory = std::size_t(64) << 20; // fewer than all, so that each step is read again
    this->Series = std::make_unique<BackgroundSeries>(std::move(options));
    this->Window->SetOffScreenRendering(1);
    this->Window->SetMultiSamples(0);
    this->Window->SetSize(796, 532);
    this->Window->AddRenderer(this->Scene->GetRenderer());
    MeasureStep(*this->Series, 0, this->Scene, this->Window); // shaders, storage
  }

  std::size_t Count() const { return this->Series->Get().times.size(); }

  Play Run()
  {
    Play play;
    for (std::size_t step = 1; step < this->Count(); ++step)
    {
      this->Scene->SetVolume(this->Series->Wait(step));
      this->Loads.WaitUntilIdle();
      MeasureFrame(this->Window);
      play.Still.push_back(MeasureFrame(this->Window));
    }
    this->Scene->SetVolume(this->Series->Wait(0));
    MeasureFrame(this->Window);
    this->Loads.Take();
    play.Whole = SecondsOf([&] { this->Measure(play); });
    play.Ahead = this->Loads.Take();
    return play;
  }

private:
  void Measure(Play& play)
  {
    for (std::size_t step = 1; step < this->Count(); ++step)
    {
      const StepTimes times = MeasureStep(*this->Series, step, this->Scene, this->Window);
      play.Load.push_back(times.load);
      play.Upload.push_back(times.upload);
      play.Draw.push_back(times.draw);
    }
  }

  LoadTimes Loads;
  std::unique_ptr<BackgroundSeries> Series;
  vtkNew<vtkNexradVolumeScene> Scene;
  vtkNew<vtkRenderWindow> Window;
};

double Sum(const std::vector<double>& seconds)
{
  return std::accumulate(seconds.begin(), seconds.end(), 0.0);
}

void Print(int slices, const Play& play)
{
  const auto median = [](const std::vector<double>& seconds)
  { return 1000.0 * Summarize(seconds).median; };
  const auto most = [](const std::vector<double>& seconds)
  { return 1000.0 * Summarize(seconds).most; };
  std::printf("| %d | %.1f (%.1f) | %.1f (%.1f) | %.1f | %.1f | %.3f | %.3f | %.1f | %.1f |\n",
    slices, median(play.Load), most(play.Load), median(play.Upload), most(play.Upload),
    median(play.Draw), median(play.Still), (Sum(play.Load) + Sum(play.Upload)) / Sum(play.Draw),
    (Sum(play.Load) + Sum(play.Upload)) / Sum(play.Still), median(play.Ahead),
    static_cast<double>(play.Draw.size()) / play.Whole);
  std::fflush(stdout);
}

void Measure(std::vector<std::filesystem::path> inputs)
{
  RequireDisplay();
  std::optional<nexrad::testing::TemporaryFolder> folder;
  if (inputs.empty())
  {
    inputs = {WriteSyntheticSeries(folder.emplace().Path())};
  }
  std::printf(
    "796 x 532 pixels, milliseconds, median (most) of the steps\n\n"
    "| slices | t1, load | t2, upload | t3, draw | t3 of a still picture | (t1 + t2) / t3 "
    "| / still | loading ahead | frames a second |\n"
    "|---|---|---|---|---|---|---|---|---|\n");
  for (const int slices : {64, 256, 1024})
  {
    Print(slices, Player(inputs, slices).Run());
  }
}

} // namespace

int main(int argc, char* argv[])
{
  try
  {
    Measure({argv + 1, argv + argc});
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "BenchmarkSeries: %s\n", error.what());
    return 1;
  }
  return 0;
}
