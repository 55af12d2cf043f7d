// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/SceneSettings.h"

#include "vtkNexradVolumeScene.h"

#include <optional>

namespace nexrad::scene
{
namespace
{

std::optional<PlanOptions> PlanOf(vtkNexradVolumeScene* scene)
{
  PlanOptions plan;
  plan.height = scene->GetPlanHeight();
  plan.array = scene->GetPlanArray();
  plan.threshold = scene->GetEchoTopThreshold();
  switch (scene->GetPlan())
  {
  case vtkNexradVolumeScene::COMPOSITE:
    plan.level = PlanLevel::Composite;
    return plan;
  case vtkNexradVolumeScene::LOWEST:
    plan.level = PlanLevel::Lowest;
    return plan;
  case vtkNexradVolumeScene::AT_HEIGHT:
    plan.level = PlanLevel::Height;
    return plan;
  case vtkNexradVolumeScene::ECHO_TOP:
    plan.level = PlanLevel::EchoTop;
    return plan;
  case vtkNexradVolumeScene::LIQUID:
    plan.level = PlanLevel::Liquid;
    return plan;
  case vtkNexradVolumeScene::LIQUID_DENSITY:
    plan.level = PlanLevel::LiquidDensity;
    return plan;
  default:
    return std::nullopt;
  }
}

CutOptions CutOf(vtkNexradVolumeScene* scene)
{
  CutOptions cut;
  if (scene->GetCropping())
  {
    cut.box.emplace();
    scene->GetCropBounds(cut.box->data());
  }
  if (scene->GetClipping())
  {
    cut.plane.emplace();
    scene->GetClipOrigin(cut.plane->origin.data());
    scene->GetClipNormal(cut.plane->normal.data());
  }
  if (scene->GetSection())
  {
    cut.section.emplace();
    scene->GetSectionA(cut.section->from.data());
    scene->GetSectionB(cut.section->to.data());
  }
  return cut;
}

} // namespace

SceneOptions SettingsOf(vtkNexradVolumeScene* scene)
{
  SceneOptions options;
  options.preset = scene->GetPreset();
  options.colours = scene->GetColorFileName();
  options.opacities = scene->GetOpacityFileName();
  options.colourBy = scene->GetColorArray();
  if (scene->GetExaggeration() > 0.0)
  {
    options.exaggeration = scene->GetExaggeration();
  }
  options.mapper = scene->GetMapper() == vtkNexradVolumeScene::RAY_CAST
                     ? MapperChoice::RayCast
                     : MapperChoice::TextureSlice;
  options.preIntegration = scene->GetPreIntegration();
  options.linearInterpolation = scene->GetLinearInterpolation();
  options.slices = scene->GetNumberOfSlices();
  if (scene->GetOpacityDistance() > 0.0)
  {
    options.opacityDistance = scene->GetOpacityDistance();
  }
  options.framing =
    scene->GetFraming() == vtkNexradVolumeScene::DOMAIN ? FrameChoice::Domain : FrameChoice::Echo;
  options.light = {scene->GetShadowStrength(), scene->GetOcclusionStrength(),
    {scene->GetLightAzimuth(), scene->GetLightElevation()}};
  options.ringSpacing = scene->GetRingSpacing();
  options.theme =
    scene->GetTheme() == vtkNexradVolumeScene::LIGHT ? ThemeChoice::Light : ThemeChoice::Dark;
  options.heightWalls = scene->GetHeightWalls();
  options.placeNames = scene->GetPlaceNames();
  options.plan = PlanOf(scene);
  options.cut = CutOf(scene);
  return options;
}

} // namespace nexrad::scene
