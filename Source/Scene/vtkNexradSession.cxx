// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNexradSession.h"

#include "Scene/EchoFraming.h"
#include "Scene/PlayAhead.h"
#include "Scene/SceneSettings.h"
#include "Scene/Series/DayVolumes.h"
#include "Scene/Series/VolumeFiles.h"
#include "nexrad/System/Error.h"

#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkNexradDayReader.h"
#include "vtkNexradVolumeScene.h"
#include "vtkObjectFactory.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <filesystem>
#include <numeric>

using nexrad::scene::VolumeSeries;

// The series of the inputs, and when the settings were made that it was opened with.
struct vtkNexradSession::Opened
{
  vtkMTimeType time = 0;
  nexrad::scene::SceneOptions options; ///< of the scene, as far as reading depends on them
  std::unique_ptr<VolumeSeries> volumes;
  std::optional<nexrad::scene::SceneOptions> framed; ///< what the frame was measured with
};

namespace
{

// What of the scene decides on how volumes are read.
nexrad::scene::SceneOptions OptionsOf(vtkNexradVolumeScene* scene, bool scalarsAsCodes)
{
  nexrad::scene::SceneOptions options;
  options.scalarsAsCodes = scalarsAsCodes;
  options.mapper = scene->GetMapper() == vtkNexradVolumeScene::RAY_CAST
                     ? nexrad::scene::MapperChoice::RayCast
                     : nexrad::scene::MapperChoice::TextureSlice;
  options.colourBy = scene->GetColorArray();
  if (scene->GetPlan() != vtkNexradVolumeScene::NO_PLAN)
  {
    options.plan.emplace();
  }
  return options;
}

bool AreReadAlike(const nexrad::scene::SceneOptions& a, const nexrad::scene::SceneOptions& b)
{
  return a.scalarsAsCodes == b.scalarsAsCodes && a.mapper == b.mapper &&
         a.colourBy.empty() == b.colourBy.empty() && a.plan.has_value() == b.plan.has_value();
}

std::vector<std::size_t> AllSteps(const VolumeSeries& volumes)
{
  std::vector<std::size_t> steps(volumes.Times().size());
  std::iota(steps.begin(), steps.end(), std::size_t(0));
  return steps;
}

bool AreFramedAlike(const nexrad::scene::SceneOptions& a, const nexrad::scene::SceneOptions& b)
{
  return a.preset == b.preset && a.framing == b.framing &&
         a.opacityDistance.has_value() == b.opacityDistance.has_value() &&
         a.plan.has_value() == b.plan.has_value();
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
  if (nexrad::scene::AreVolumes(paths))
  {
    auto files = nexrad::scene::OpenVolumeFiles(paths);
    const std::vector<std::size_t> order = AllSteps(*files);
    this->Series->volumes =
      nexrad::scene::PlayAhead(std::move(files), order, this->Series->options);
    return;
  }
  this->Series->volumes = nexrad::scene::OpenDayVolumes(this->DayReader);
}

// The frame holds the echo of all times, as the scene's preset shows it.
void vtkNexradSession::MeasureFrame()
{
  const nexrad::scene::SceneOptions options = nexrad::scene::SettingsOf(this->Scene);
  if (!this->Series->framed || !AreFramedAlike(*this->Series->framed, options))
  {
    this->Series->framed = options;
    VolumeSeries& volumes = *this->Series->volumes;
    this->Scene->HoldEcho(nexrad::scene::MeasureSeries(volumes, AllSteps(volumes), options));
  }
}

bool vtkNexradSession::UpdateInformation()
{
  const nexrad::scene::SceneOptions options = OptionsOf(this->Scene, this->ScalarsAsCodes);
  if (this->Series->volumes && AreReadAlike(options, this->Series->options) &&
      this->Series->time >= std::max(this->GetMTime(), this->DayReader->GetMTime()))
  {
    return true;
  }
  this->Series = std::make_unique<Opened>();
  this->Series->options = options;
  this->TimeSteps->Initialize();
  this->TimeStepIndex = -1;
  try
  {
    this->Open();
  }
  catch (const std::exception& error)
  {
    vtkErrorMacro(<< error.what());
    return false;
  }
  for (const nexrad::Time time : this->Series->volumes->Times())
  {
    this->TimeSteps->InsertNextValue(nexrad::ToSeconds(time));
  }
  this->Series->time = std::max(this->GetMTime(), this->DayReader->GetMTime());
  return true;
}

vtkDoubleArray* vtkNexradSession::GetTimeSteps()
{
  this->UpdateInformation();
  return this->TimeSteps;
}

void vtkNexradSession::Load(int index)
{
  const auto count = static_cast<int>(this->Series->volumes->Times().size());
  if (index < 0 || index >= count)
  {
    throw nexrad::Error("there is no time step " + std::to_string(index) + "; there are " +
                        std::to_string(count) + ", counted from 0");
  }
  this->Scene->SetVolume(this->Series->volumes->Load(static_cast<std::size_t>(index), {}));
  this->TimeStepIndex = index;
}

bool vtkNexradSession::ShowTimeStep(int index)
{
  if (!this->UpdateInformation())
  {
    return false;
  }
  const vtkSmartPointer<vtkImageData> shown = this->Scene->GetVolume();
  const int shownIndex = this->TimeStepIndex;
  try
  {
    this->MeasureFrame();
    if (index != this->TimeStepIndex)
    {
      this->Load(index);
    }
  }
  catch (const std::exception& error)
  {
    vtkErrorMacro(<< error.what());
    return false;
  }
  if (!this->Scene->Update())
  {
    this->Scene->SetVolume(shown);
    this->TimeStepIndex = shownIndex;
    return false;
  }
  return true;
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

vtkStringArray* vtkNexradSession::GetDamage()
{
  this->Damage->Initialize();
  if (this->Series->volumes)
  {
    for (const std::string& line : this->Series->volumes->Problems())
    {
      this->Damage->InsertNextValue(line);
    }
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
