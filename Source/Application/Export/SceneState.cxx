// SPDX-License-Identifier: BSD-3-Clause
#include "Export/SceneState.h"

#include "Scene/VolumeAppearance.h"
#include "nexrad/System/Error.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkNexradMessages.h>
#include <vtkNexradTransferFunction.h>
#include <vtkNexradVolumeScene.h>
#include <vtkPointData.h>

#include <QDir>
#include <QTemporaryFile>

#include <optional>
#include <vector>

namespace nexrad::viewer
{
namespace
{

std::optional<scene::PlanOptions> PlanOf(vtkNexradVolumeScene* scene)
{
  scene::PlanOptions plan;
  plan.height = scene->GetPlanHeight();
  plan.array = scene->GetPlanArray();
  switch (scene->GetPlan())
  {
  case vtkNexradVolumeScene::COMPOSITE:
    plan.level = scene::PlanLevel::Composite;
    return plan;
  case vtkNexradVolumeScene::LOWEST:
    plan.level = scene::PlanLevel::Lowest;
    return plan;
  case vtkNexradVolumeScene::AT_HEIGHT:
    plan.level = scene::PlanLevel::Height;
    return plan;
  default:
    return std::nullopt;
  }
}

std::string NameOfScalars(vtkImageData* volume)
{
  vtkDataArray* scalars = volume != nullptr ? volume->GetPointData()->GetScalars() : nullptr;
  const char* name = scalars != nullptr ? scalars->GetName() : nullptr;
  return name != nullptr ? name : "";
}

std::vector<double> IsoValuesOf(vtkNexradTransferFunction* colours)
{
  std::vector<double> values;
  for (int i = 0; i < colours->GetNumberOfIsoValues(); ++i)
  {
    values.push_back(colours->GetIsoValue(i));
  }
  return values;
}

// Those of the colour map in use, where the preset or the file has others.
std::vector<scene::IsoValue> EditedIsoValues(
  const scene::SceneOptions& options, vtkNexradVolumeScene* scene)
{
  vtkNexradTransferFunction* used = scene->GetTransferFunction();
  std::vector<scene::IsoValue> edited;
  if (used == nullptr || options.plan)
  {
    return edited;
  }
  const std::vector<double> values = IsoValuesOf(used);
  const auto made = scene::MakeTransferFunction(options, ArrayOf(scene));
  for (std::size_t i = 0; values != IsoValuesOf(made) && i < values.size(); ++i)
  {
    edited.push_back({values[i], used->Evaluate(vtkNexradTransferFunction::OPACITY, values[i])});
  }
  return edited;
}

scene::SceneOptions SettingsOf(vtkNexradVolumeScene* scene)
{
  scene::SceneOptions options;
  options.preset = scene->GetPreset();
  options.colours = scene->GetColorFileName();
  options.colourBy = scene->GetColorArray();
  if (scene->GetExaggeration() > 0.0)
  {
    options.exaggeration = scene->GetExaggeration();
  }
  options.mapper = scene->GetMapper() == vtkNexradVolumeScene::RAY_CAST
                     ? scene::MapperChoice::RayCast
                     : scene::MapperChoice::TextureSlice;
  options.preIntegration = scene->GetPreIntegration();
  options.linearInterpolation = scene->GetLinearInterpolation();
  options.slices = scene->GetNumberOfSlices();
  options.light = {scene->GetShadowStrength(), scene->GetOcclusionStrength(),
    {scene->GetLightAzimuth(), scene->GetLightElevation()}};
  options.ringSpacing = scene->GetRingSpacing();
  options.theme = scene->GetTheme() == vtkNexradVolumeScene::LIGHT ? scene::ThemeChoice::Light
                                                                   : scene::ThemeChoice::Dark;
  options.heightWalls = scene->GetHeightWalls();
  options.placeNames = scene->GetPlaceNames();
  options.plan = PlanOf(scene);
  return options;
}

} // namespace

void SetPlan(const scene::SceneOptions& options, vtkNexradVolumeScene* scene)
{
  int plan = vtkNexradVolumeScene::NO_PLAN;
  if (options.plan)
  {
    plan = options.plan->level == scene::PlanLevel::Composite ? vtkNexradVolumeScene::COMPOSITE
           : options.plan->level == scene::PlanLevel::Lowest  ? vtkNexradVolumeScene::LOWEST
                                                              : vtkNexradVolumeScene::AT_HEIGHT;
    scene->SetPlanHeight(options.plan->height);
    scene->SetPlanArray(options.plan->array);
  }
  scene->SetPlan(plan);
}

std::string ArrayOf(vtkNexradVolumeScene* scene)
{
  return NameOfScalars(scene->GetVolume());
}

std::string PresetFor(vtkImageData* volume, const std::string& preset)
{
  for (int i = 0; i < vtkNexradTransferFunction::GetNumberOfPresets(); ++i)
  {
    if (preset == vtkNexradTransferFunction::GetPresetName(i))
    {
      return NameOfScalars(volume) == vtkNexradTransferFunction::GetPresetArray(i) ? preset : "";
    }
  }
  return "";
}

scene::SceneOptions OptionsOf(vtkNexradVolumeScene* scene)
{
  scene::SceneOptions options = SettingsOf(scene);
  try
  {
    options.isoValues = EditedIsoValues(options, scene);
  }
  catch (const Error&)
  {
    // The options are not of the moment that is shown: the colour map is of others.
  }
  return options;
}

scene::CameraView CameraOf(vtkNexradVolumeScene* scene)
{
  return {scene->GetAzimuth(), scene->GetTilt(), scene->GetZoom(), scene->GetParallelProjection()};
}

std::string EditedColours(vtkNexradVolumeScene* scene)
{
  vtkNexradTransferFunction* used = scene->GetTransferFunction();
  if (used == nullptr)
  {
    return "";
  }
  try
  {
    const auto made = scene::MakeTransferFunction(OptionsOf(scene), ArrayOf(scene));
    return made->FormatJSON() == used->FormatJSON() ? "" : used->FormatJSON();
  }
  catch (const Error&)
  {
    return used->FormatJSON();
  }
}

std::unique_ptr<QTemporaryFile> WriteTemporaryColours(const std::string& colours)
{
  auto file = std::make_unique<QTemporaryFile>(QDir::temp().filePath("colours-XXXXXX.json"));
  const auto size = static_cast<qint64>(colours.size());
  if (!file->open() || file->write(colours.data(), size) != size || !file->flush())
  {
    throw Error("no temporary file for colours: " + file->errorString().toStdString());
  }
  file->close();
  return file;
}

void SetColours(const std::string& colours, const std::vector<scene::IsoValue>& isoValues,
  vtkNexradVolumeScene* scene)
{
  scene->Update(); // which makes the colour map
  vtkNexradTransferFunction* used = scene->GetTransferFunction();
  if (used == nullptr)
  {
    return;
  }
  vtkNexradMessages messages;
  messages.Watch(used);
  if (!colours.empty())
  {
    used->ReadFile(WriteTemporaryColours(colours)->fileName().toLocal8Bit().constData());
  }
  messages.ThrowFirstError();
  if (!isoValues.empty())
  {
    scene::SetIsoValues(isoValues, used);
  }
}

} // namespace nexrad::viewer
