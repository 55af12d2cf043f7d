// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNexradSession.h"

#include "Filters/Series/BackgroundSeries.h"
#include "Filters/Series/InputSeries.h"
#include "Filters/Series/VolumeFiles.h"
#include "Scene/EchoFraming.h"
#include "Scene/Frame/VolumeInformation.h"
#include "Scene/SceneOptions.h"
#include "nexrad/System/Error.h"

#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkNexradDayReader.h"
#include "vtkNexradVolumeScene.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLTextureSliceVolumeMapper.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <filesystem>
#include <numeric>

using nexrad::BackgroundSeries;
using nexrad::VolumeSeries;
using nexrad::scene::SceneOptions;

// The series that is shown, and what loads it ahead.
struct vtkNexradSession::Opened
{
  std::shared_ptr<VolumeSeries> volumes;
  std::vector<std::size_t> steps; ///< indices of the volumes that take part
  std::optional<nexrad::BoxRequest> box;
  std::optional<nexrad::BoxRequest> seen; ///< that is drawn in finer voxels; not with `box`
  bool given = false;                     ///< by SetSeries: the file names do not count
  vtkMTimeType time = 0;                  ///< of the settings that it was opened with
  std::optional<SceneOptions> framed;     ///< what the frame was measured with
  std::unique_ptr<BackgroundSeries> ahead;
};

namespace
{

bool AreFramedAlike(const SceneOptions& a, const SceneOptions& b)
{
  return a.preset == b.preset && a.framing == b.framing &&
         a.opacityDistance.has_value() == b.opacityDistance.has_value() &&
         a.plan.has_value() == b.plan.has_value();
}

// Does for each volume what the slices need of it before they are drawn, after the one before it.
std::function<void(vtkImageData*)> PrepareInTurn()
{
  return [before = vtkSmartPointer<vtkObject>()](vtkImageData* volume) mutable
  { before = vtkOpenGLTextureSliceVolumeMapper::PrepareScalars(volume, before); };
}

} // namespace

vtkStandardNewMacro(vtkNexradSession);

vtkNexradSession::vtkNexradSession()
  : Series(std::make_unique<Opened>())
{
}

vtkNexradSession::~vtkNexradSession() = default;

void vtkNexradSession::AddFileName(const char* path)
{
  this->DayReader->AddFileName(path);
}

void vtkNexradSession::ClearFileNames()
{
  this->DayReader->ClearFileNames();
}

int vtkNexradSession::GetNumberOfFileNames() const
{
  return this->DayReader->GetNumberOfFileNames();
}

const char* vtkNexradSession::GetFileName(int index) const
{
  return this->DayReader->GetFileName(index);
}

vtkNexradDayReader* vtkNexradSession::GetDayReader() const
{
  return this->DayReader;
}

vtkNexradVolumeScene* vtkNexradSession::GetScene() const
{
  return this->Scene;
}

void vtkNexradSession::Open()
{
  std::vector<std::filesystem::path> paths;
  for (int i = 0; i < this->GetNumberOfFileNames(); ++i)
  {
    paths.emplace_back(this->GetFileName(i));
  }
  if (paths.empty())
  {
    throw nexrad::Error("no file name is set");
  }
  nexrad::VolumeFileRequest request = {{}, {}, true};
  request.textureMemory = this->Scene->GetOptions().textureMemory;
  this->Series->volumes = nexrad::AreVolumes(paths)
                            ? nexrad::OpenVolumeFiles(paths, request)
                            : nexrad::OpenRadarFiles(paths, this->DayReader->MakeDayOptions());
  std::vector<std::size_t>& steps = this->Series->steps;
  steps.resize(this->Series->volumes->Times().size());
  std::iota(steps.begin(), steps.end(), std::size_t(0));
}

void vtkNexradSession::SetSeries(std::unique_ptr<VolumeSeries> series,
  std::vector<std::size_t> steps, const std::optional<nexrad::BoxRequest>& box)
{
  this->Forget();
  this->Series->given = true;
  this->Series->volumes = std::move(series);
  this->Series->steps = std::move(steps);
  this->Series->box = box;
  this->ListTimes();
}

void vtkNexradSession::Forget()
{
  this->Series = std::make_unique<Opened>();
  this->TimeSteps->Initialize();
  this->TimeStepIndex = -1;
}

void vtkNexradSession::ListTimes()
{
  for (const std::size_t index : this->Series->steps)
  {
    this->TimeSteps->InsertNextValue(nexrad::ToSeconds(this->Series->volumes->Times()[index]));
  }
}

// The frame holds the echo of all times, as the scene's preset shows it.
void vtkNexradSession::MeasureFrame()
{
  const SceneOptions options = this->Scene->GetOptions();
  if (!this->Series->framed || !AreFramedAlike(*this->Series->framed, options))
  {
    this->Series->framed = options;
    this->Series->ahead.reset(); // one thread at a time uses the series
    this->Scene->HoldEcho(
      nexrad::scene::MeasureSeries(*this->Series->volumes, this->Series->steps, options));
  }
}

// Of what is drawn, the slices of one moment alone know codes, and what is prepared.
void vtkNexradSession::LoadAhead()
{
  constexpr std::size_t memory = std::size_t(512) << 20;
  Opened& series = *this->Series;
  const SceneOptions options = this->Scene->GetOptions();
  const bool slices = options.mapper == nexrad::scene::MapperChoice::TextureSlice &&
                      !options.plan && options.colourBy.empty();
  if (series.volumes->AllowCodes(this->ScalarsAsCodes && slices))
  {
    series.ahead.reset();
    this->TimeStepIndex = -1; // the volume that is shown is another one now
  }
  if (!series.ahead)
  {
    nexrad::BackgroundSeriesOptions loading;
    loading.open = [volumes = series.volumes](const nexrad::Progress&) { return volumes; };
    loading.choose = [steps = series.steps](const VolumeSeries&) { return steps; };
    loading.prepare = slices && series.steps.size() > 1 ? PrepareInTurn() : nullptr;
    loading.memory = memory;
    series.ahead = std::make_unique<BackgroundSeries>(std::move(loading));
    series.ahead->SetBox(series.box);
    series.seen.reset();
  }
}

bool vtkNexradSession::UpdateInformation()
{
  const vtkMTimeType now = std::max(this->GetMTime(), this->DayReader->GetMTime());
  if (this->Series->given || (this->Series->volumes && this->Series->time >= now))
  {
    return true;
  }
  this->Forget();
  try
  {
    this->Open();
  }
  catch (const std::exception& error)
  {
    vtkErrorMacro(<< error.what());
    return false;
  }
  this->ListTimes();
  this->Series->time = now;
  return true;
}

vtkDoubleArray* vtkNexradSession::GetTimeSteps()
{
  this->UpdateInformation();
  return this->TimeSteps;
}

bool vtkNexradSession::Load(int index, const nexrad::Progress& progress)
{
  const vtkIdType count = this->TimeSteps->GetNumberOfValues();
  if (index < 0 || index >= count)
  {
    throw nexrad::Error("there is no time step " + std::to_string(index) + "; there are " +
                        std::to_string(count) + ", counted from 0");
  }
  const auto step = static_cast<std::size_t>(index);
  const auto volume = this->Series->ahead->Wait(step, progress);
  if (!volume)
  {
    return false;
  }
  this->Scene->SetVolume(volume);
  this->TimeStepIndex = index;
  this->Scene->SetDetail(nullptr);
  if (this->Series->box)
  {
    const auto box = this->Series->ahead->Box(step);
    const auto [west, east, south, north] = nexrad::scene::SidesOf(box);
    this->Scene->SetDetail(box);
    this->Scene->MarkBox(west, east, south, north);
  }
  return true;
}

// What the picture shows, in voxels as fine as its pixels, where the series has them. False when
// `progress` asked to stop.
bool vtkNexradSession::LoadSeen(const nexrad::Progress& progress)
{
  Opened& series = *this->Series;
  const auto step = static_cast<std::size_t>(this->TimeStepIndex);
  if (series.box || !series.volumes->LeavesOutFiner(series.steps[step]))
  {
    return true;
  }
  const std::optional<nexrad::BoxRequest> seen = this->Scene->SeenBox();
  if (!(series.seen == seen))
  {
    series.seen = seen;
    series.ahead->SetBox(seen);
  }
  if (!series.ahead->Wait(step, progress))
  {
    return false;
  }
  this->Scene->SetDetail(series.ahead->Box(step));
  this->Scene->Draw();
  return true;
}

bool vtkNexradSession::Show(int step, const nexrad::Progress& progress)
{
  this->MeasureFrame();
  this->LoadAhead();
  const vtkSmartPointer<vtkImageData> shown = this->Scene->GetVolume();
  const int shownStep = this->TimeStepIndex;
  if (step != this->TimeStepIndex && !this->Load(step, progress))
  {
    return false;
  }
  try
  {
    this->Scene->Draw();
    return this->LoadSeen(progress);
  }
  catch (...)
  {
    this->Scene->SetVolume(shown);
    this->TimeStepIndex = shownStep;
    throw;
  }
}

bool vtkNexradSession::ShowTimeStep(int index)
{
  if (!this->UpdateInformation())
  {
    return false;
  }
  try
  {
    return this->Show(index);
  }
  catch (const std::exception& error)
  {
    vtkErrorMacro(<< error.what());
    return false;
  }
}

bool vtkNexradSession::ShowTime(double time)
{
  if (!this->UpdateInformation())
  {
    return false;
  }
  const double* first = this->TimeSteps->GetPointer(0);
  const double* nearest = std::min_element(first, first + this->TimeSteps->GetNumberOfValues(),
    [time](double a, double b) { return std::abs(a - time) < std::abs(b - time); });
  return this->ShowTimeStep(static_cast<int>(nearest - first));
}

std::vector<std::string> vtkNexradSession::Problems() const
{
  return this->Series->ahead     ? this->Series->ahead->Get().damage
         : this->Series->volumes ? this->Series->volumes->Problems()
                                 : std::vector<std::string>();
}

vtkStringArray* vtkNexradSession::GetDamage()
{
  this->Damage->Initialize();
  for (const std::string& line : this->Problems())
  {
    this->Damage->InsertNextValue(line);
  }
  return this->Damage;
}

void vtkNexradSession::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileNames: " << this->GetNumberOfFileNames() << "\n";
  os << indent << "ScalarsAsCodes: " << this->ScalarsAsCodes << "\n";
  os << indent << "TimeStepIndex: " << this->TimeStepIndex << "\n";
  os << indent << "DayReader:\n";
  this->DayReader->PrintSelf(os, indent.GetNextIndent());
  os << indent << "Scene:\n";
  this->Scene->PrintSelf(os, indent.GetNextIndent());
}
