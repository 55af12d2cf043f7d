// SPDX-License-Identifier: BSD-3-Clause
#include "Export/SceneState.h"

#include "Scene/Frame/VolumeInformation.h"
#include "Scene/VolumeAppearance.h"
#include "nexrad/System/Error.h"

#include <vtkImageData.h>
#include <vtkNexradMessages.h>
#include <vtkNexradTransferFunction.h>
#include <vtkNexradVolumeScene.h>

#include <algorithm>
#include <vector>

namespace nexrad::viewer
{
namespace
{

// Those of the colour map in use, where the preset or the file has others.
std::vector<scene::IsoValue> EditedIsoValues(
  const scene::SceneOptions& options, vtkNexradVolumeScene* scene)
{
  vtkNexradTransferFunction* used = scene->GetTransferFunction();
  if (used == nullptr || options.plan)
  {
    return {};
  }
  const std::vector<scene::IsoValue> values = scene::IsoValuesOf(used);
  const std::vector<scene::IsoValue> unedited =
    scene::IsoValuesOf(scene::MakeTransferFunction(options, scene::ArrayOf(scene->GetVolume())));
  const bool same = std::equal(values.begin(), values.end(), unedited.begin(), unedited.end(),
    [](const scene::IsoValue& a, const scene::IsoValue& b) { return a.value == b.value; });
  return same ? std::vector<scene::IsoValue>() : values;
}

} // namespace

scene::SceneOptions OptionsOf(vtkNexradVolumeScene* scene)
{
  scene::SceneOptions options = scene->GetOptions();
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
  scene::CameraView camera = scene->GetView();
  camera.lookAt.reset();
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
    used->ParseJSON(colours);
  }
  messages.ThrowFirstError();
  if (!isoValues.empty())
  {
    scene::SetIsoValues(isoValues, used);
  }
}

} // namespace nexrad::viewer
