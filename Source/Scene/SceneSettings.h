// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Scene/SceneOptions.h"

class vtkNexradVolumeScene;

namespace nexrad::scene
{

/// The settings of a scene as options, without the iso-values that were added to it. Cuts are in
/// the unit of the volume.
SceneOptions SettingsOf(vtkNexradVolumeScene* scene);

} // namespace nexrad::scene
