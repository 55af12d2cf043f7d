// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Options/SessionFile.h"
#include "nexrad/Model/Moment.h"

#include <string>

class vtkImageData;
class vtkNexradVolumeScene;

/// What is to be opened when the user chooses another moment, or another array for colours or maps:
/// the inputs are read, or merged, again, because a volume has only the arrays that were asked for.
namespace nexrad::viewer
{

/// Another moment, with its own preset.
application::Session WithMoment(application::Session shown, MomentName moment);

/// Colours of another array; empty: of the moment.
application::Session WithColoursOf(application::Session shown, const std::string& array);

/// Maps of an ancillary array, which radar files are merged again for; empty: of the moment.
application::Session WithMapOf(application::Session shown, const std::string& array);

/// Whether a volume has an array; none has the empty name.
bool HasArray(vtkImageData* volume, const std::string& array);

/// Lets a scene that shows a map show the array that the options ask for, or a map that the moment
/// of its volume has. What is wrong when the volume has no such array; the map then shows the
/// moment. Empty: nothing.
std::string FollowMap(const scene::SceneOptions& options, vtkNexradVolumeScene* scene);

} // namespace nexrad::viewer
