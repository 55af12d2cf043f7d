// SPDX-License-Identifier: BSD-3-Clause
#include "Viewer/ChosenArrays.h"

#include "Scene/Frame/VolumeInformation.h"
#include "Scene/VolumeCut.h"
#include "nexrad/System/Error.h"

#include <vtkImageData.h>
#include <vtkNexradVolumeScene.h>
#include <vtkPointData.h>

#include <optional>

namespace nexrad::viewer
{
namespace
{

// The map that a moment has in place of that of another one: PHI and RHO have no largest value.
scene::PlanOptions PlanOf(scene::PlanOptions plan, MomentName moment)
{
  if (scene::IsColumnProduct(plan.level) && moment != MomentName::REF)
  {
    plan.level = scene::PlanLevel::Composite;
  }
  const bool largest = moment != MomentName::PHI && moment != MomentName::RHO;
  if (plan.level == scene::PlanLevel::Composite && !largest)
  {
    plan.level = scene::PlanLevel::Lowest;
  }
  const std::size_t end = plan.array.find('_');
  plan.array = end == std::string::npos ? "" : ToString(moment) + plan.array.substr(end);
  return plan;
}

// What is wrong; empty: nothing.
std::string FitMap(const scene::SceneOptions& options, vtkNexradVolumeScene* scene)
{
  vtkImageData* volume = scene->GetVolume();
  scene::SceneOptions found = scene->GetOptions();
  const std::string shown = scene::ArrayOf(volume);
  const std::optional<MomentName> moment = ParseMomentName(shown);
  if (!found.plan || !moment)
  {
    return "";
  }
  found.plan->array = options.plan ? options.plan->array : "";
  found.plan = PlanOf(*found.plan, *moment);
  const std::string wanted = found.plan->array;
  const bool has = wanted.empty() || HasArray(volume, wanted);
  found.plan->array = has ? wanted : "";
  scene->SetOptions(found);
  return has ? "" : "the volume has no array " + wanted + "; the map shows " + shown;
}

} // namespace

application::Session WithMoment(application::Session shown, MomentName moment)
{
  InputRequest& input = shown.drawing.input;
  input.grid.moments = {moment};
  input.momentNamed = true;
  scene::SceneOptions& options = shown.drawing.scene;
  options.preset.clear(); // those of the moment before are not of this one
  options.colours.clear();
  options.opacities.clear();
  options.isoValues.clear();
  shown.colours.clear();
  options.colourBy = options.colourBy == ToString(moment) ? "" : options.colourBy;
  input.colourBy = options.colourBy;
  return shown;
}

application::Session WithColoursOf(application::Session shown, const std::string& array)
{
  shown.drawing.scene.colourBy = array;
  shown.drawing.input.colourBy = array;
  return shown;
}

application::Session WithMapOf(application::Session shown, const std::string& array)
{
  if (shown.drawing.scene.plan)
  {
    shown.drawing.scene.plan->array = array;
  }
  // Captions state the ages of data, also once the volume is back.
  bool& ancillary = shown.drawing.input.grid.beam.ancillary;
  ancillary = ancillary || !array.empty();
  return shown;
}

bool HasArray(vtkImageData* volume, const std::string& array)
{
  return volume != nullptr && volume->GetPointData()->HasArray(array.c_str()) != 0;
}

std::string FitToVolume(const scene::SceneOptions& options, vtkNexradVolumeScene* scene)
{
  const std::string problem = FitMap(options, scene);
  try
  {
    scene::CheckCutUnit(options.cut, scene->GetVolume());
  }
  catch (const Error& error)
  {
    scene->CroppingOff();
    scene->ClippingOff();
    scene->SectionOff();
    return problem + (problem.empty() ? "" : "; ") + error.what();
  }
  return problem;
}

} // namespace nexrad::viewer
