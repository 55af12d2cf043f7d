// SPDX-License-Identifier: BSD-3-Clause
#include "Export/SceneState.h"

#include "Scene/Frame/VolumeInformation.h"
#include "Scene/SceneSettings.h"
#include "Scene/VolumeAppearance.h"
#include "nexrad/System/Error.h"

#include <vtkImageData.h>
#include <vtkNexradMessages.h>
#include <vtkNexradTransferFunction.h>
#include <vtkNexradVolumeScene.h>

#include <QDir>
#include <QTemporaryFile>

#include <array>
#include <map>
#include <vector>

namespace nexrad::viewer
{
namespace
{

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
  const auto made = scene::MakeTransferFunction(options, scene::ArrayOf(scene->GetVolume()));
  for (std::size_t i = 0; values != IsoValuesOf(made) && i < values.size(); ++i)
  {
    edited.push_back({values[i], used->Evaluate(vtkNexradTransferFunction::OPACITY, values[i])});
  }
  return edited;
}

} // namespace

void SetPlan(const scene::SceneOptions& options, vtkNexradVolumeScene* scene)
{
  if (!options.plan)
  {
    scene->SetPlan(vtkNexradVolumeScene::NO_PLAN);
    return;
  }
  const std::map<scene::PlanLevel, int> plans = {
    {scene::PlanLevel::Composite, vtkNexradVolumeScene::COMPOSITE},
    {scene::PlanLevel::Lowest, vtkNexradVolumeScene::LOWEST},
    {scene::PlanLevel::Height, vtkNexradVolumeScene::AT_HEIGHT},
    {scene::PlanLevel::EchoTop, vtkNexradVolumeScene::ECHO_TOP},
    {scene::PlanLevel::Liquid, vtkNexradVolumeScene::LIQUID},
    {scene::PlanLevel::LiquidDensity, vtkNexradVolumeScene::LIQUID_DENSITY}};
  scene->SetPlan(plans.at(options.plan->level));
  scene->SetPlanHeight(options.plan->height);
  scene->SetPlanArray(options.plan->array);
  scene->SetEchoTopThreshold(options.plan->threshold);
}

void SetCut(const scene::CutOptions& cut, vtkNexradVolumeScene* scene)
{
  scene->SetCropping(cut.box.has_value());
  if (cut.box)
  {
    std::array<double, 6> box = *cut.box;
    scene->SetCropBounds(box.data());
  }
  scene->SetClipping(cut.plane.has_value());
  if (cut.plane)
  {
    const auto& plane = *cut.plane;
    scene->SetClipOrigin(plane.origin[0], plane.origin[1], plane.origin[2]);
    scene->SetClipNormal(plane.normal[0], plane.normal[1], plane.normal[2]);
  }
  scene->SetSection(cut.section.has_value());
  if (cut.section)
  {
    scene->SetSectionA(cut.section->from[0], cut.section->from[1]);
    scene->SetSectionB(cut.section->to[0], cut.section->to[1]);
  }
}

scene::SceneOptions OptionsOf(vtkNexradVolumeScene* scene)
{
  scene::SceneOptions options = scene::SettingsOf(scene);
  if (vtkImageData* volume = scene->GetVolume())
  {
    options.cut.unit = scene::PlaceUnitOf(volume);
  }
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
  scene::CameraView camera{
    scene->GetAzimuth(), scene->GetTilt(), scene->GetZoom(), scene->GetParallelProjection(), {}};
  double place[3];
  if (scene->GetLookAtGeographic(place))
  {
    camera.lookAt = scene::LookAt{{place[1], place[0], place[2]}, true};
  }
  return camera;
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
    const auto made =
      scene::MakeTransferFunction(OptionsOf(scene), scene::ArrayOf(scene->GetVolume()));
    return made->FormatJSON() == used->FormatJSON() ? "" : used->FormatJSON();
  }
  catch (const Error&)
  {
    return used->FormatJSON();
  }
}

void UseColours(const std::filesystem::path& file, scene::SceneOptions& options)
{
  (options.colourBy.empty() ? options.colours : options.opacities) = file;
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
  if (colours.empty() && isoValues.empty())
  {
    return;
  }
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
