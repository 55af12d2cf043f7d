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

/// Fits what options ask of a scene to the volume that it has: a map shows the array that they
/// name, or a map that the moment has. What is wrong, and what is shown instead: where the volume
/// has no such array, the map of the moment; where cuts are in another unit than the volume's x and
/// y, no cut. Empty: nothing is wrong.
std::string FitToVolume(const scene::SceneOptions& options, vtkNexradVolumeScene* scene);

} // namespace nexrad::viewer
