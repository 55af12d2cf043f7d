// SPDX-License-Identifier: BSD-3-Clause
#include "VolumeSeries.h"

#include "Model/Error.h"
#include "Temporal/TimeMerge.h"
#include "VtkMessages.h"
#include "vtkNexradDayReader.h"

#include <vtkCallbackCommand.h>
#include <vtkDoubleArray.h>
#include <vtkImageData.h>
#include <vtkMultiProcessController.h>
#include <vtkNew.h>
#include <vtkStringArray.h>

namespace nexrad::application
{
namespace
{

// Passes the progress of an algorithm on for as long as this lives.
class ProgressLink
{
public:
  ProgressLink(vtkAlgorithm* observed, const Progress& listener)
    : algorithm(observed)
    , progress(listener)
  {
    if (progress)
    {
      command->SetClientData(this);
      command->SetCallback(Report);
      algorithm->AddObserver(vtkCommand::ProgressEvent, command);
    }
  }
  ~ProgressLink() { algorithm->RemoveObserver(command); }
  ProgressLink(const ProgressLink&) = delete;
  ProgressLink& operator=(const ProgressLink&) = delete;

private:
  static void Report(vtkObject*, unsigned long, void* client, void*)
  {
    auto* self = static_cast<ProgressLink*>(client);
    if (!self->progress(self->algorithm->GetProgress()))
    {
      self->algorithm->SetAbortExecute(1);
    }
  }

  vtkAlgorithm* algorithm;
  const Progress& progress;
  vtkNew<vtkCallbackCommand> command;
};

class RadarFiles : public VolumeSeries
{
public:
  RadarFiles(const std::vector<std::filesystem::path>& inputs, const GridOptions& options,
    const Progress& progress, const Processes& processes)
  {
    messages.Watch(reader);
    reader->SetController(processes.Controller());
    for (const std::filesystem::path& input : inputs)
    {
      reader->AddFileName(input.c_str());
    }
    this->Configure(options);
    const ProgressLink link(reader, progress);
    reader->UpdateInformation();
    this->ThrowFirstError();
    vtkDoubleArray* steps = reader->GetTimeSteps();
    for (vtkIdType i = 0; i < steps->GetNumberOfValues(); ++i)
    {
      times.push_back(FromSeconds(steps->GetValue(i)));
    }
  }

  const std::vector<Time>& Times() const override { return times; }

  vtkSmartPointer<vtkImageData> Load(std::size_t index, const Progress& progress) override
  {
    const ProgressLink link(reader, progress);
    reader->UpdateTimeStep(ToSeconds(times[index]));
    messages.ThrowFirstError();
    // The reader fills its output anew for the next time; this one shall stay.
    auto volume = vtkSmartPointer<vtkImageData>::New();
    volume->ShallowCopy(reader->GetOutput());
    return volume;
  }

  std::vector<std::string> Problems() const override
  {
    std::vector<std::string> lines;
    vtkStringArray* damage = reader->GetDamage();
    for (vtkIdType i = 0; i < damage->GetNumberOfValues(); ++i)
    {
      lines.push_back(damage->GetValue(i));
    }
    return lines;
  }

private:
  // An input that is damaged throughout explains why there is nothing to merge.
  void ThrowFirstError() const
  {
    const std::vector<std::string> problems = this->Problems();
    if (messages.Errors().empty() || problems.empty())
    {
      messages.ThrowFirstError();
      return;
    }
    const std::size_t others = problems.size() - 1;
    throw Error(messages.Errors().front() + ": " + problems.front() +
                (others > 0 ? " (and " + std::to_string(others) + " more)" : ""));
  }

  static int StrategyOf(OverlapStrategy overlap)
  {
    switch (overlap)
    {
    case OverlapStrategy::Mean:
      return vtkNexradDayReader::MEAN;
    case OverlapStrategy::Nearest:
      return vtkNexradDayReader::NEAREST;
    case OverlapStrategy::Maximum:
      return vtkNexradDayReader::MAXIMUM;
    default:
      return vtkNexradDayReader::DISTANCE;
    }
  }

  void ConfigureBeam(const GridOptions& options)
  {
    reader->SetOverlapStrategy(StrategyOf(options.overlap));
    reader->SetOverlapLength(options.overlapLength);
    reader->SetVerticalFill(options.fill);
    reader->SetLinearReflectivity(options.linearReflectivity);
    reader->SetCompanionArrays(options.companions);
    if (options.motion.none)
    {
      reader->SetTimeInterpolationToLinear();
    }
    if (const auto& given = options.motion.given)
    {
      reader->SetGivenMotion(given->east, given->north);
      reader->UseGivenMotionOn();
    }
  }

  void Configure(const GridOptions& options)
  {
    reader->SetSiteName(options.siteName);
    reader->SetDimensions(options.grid.dimensions.data());
    reader->SetRange(options.grid.range);
    reader->SetHeightRange(options.grid.bottom, options.grid.top);
    if (const auto& bounds = options.grid.bounds)
    {
      reader->SetGeographicBounds(bounds->west, bounds->south, bounds->east, bounds->north);
      reader->UseGeographicBoundsOn();
    }
    reader->SetMoment(ToString(options.moment));
    const bool thesis = options.method == ToString(MergeMethod::Thesis);
    reader->SetMethod(thesis ? vtkNexradDayReader::THESIS : vtkNexradDayReader::BEAM);
    this->ConfigureBeam(options);
    reader->SetTimeStep(std::chrono::duration<double>(options.step).count());
    reader->SetMaximumGap(std::chrono::duration<double>(options.maximumGap).count());
    if (options.begin)
    {
      reader->SetBeginTime(ToSeconds(*options.begin));
    }
    if (options.end)
    {
      reader->SetEndTime(ToSeconds(*options.end));
    }
  }

  vtkNew<vtkNexradDayReader> reader;
  VtkMessages messages;
  std::vector<Time> times;
};

} // namespace

std::unique_ptr<VolumeSeries> OpenRadarFiles(const std::vector<std::filesystem::path>& inputs,
  const GridOptions& options, const Progress& progress, const Processes& processes)
{
  return std::make_unique<RadarFiles>(inputs, options, progress, processes);
}

} // namespace nexrad::application
