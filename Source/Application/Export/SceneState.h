// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Scene/Frame/CameraView.h"
#include "Scene/SceneOptions.h"

#include <filesystem>
#include <string>
#include <vector>

class vtkNexradVolumeScene;

/// What a scene of the window shows, as the options of the program say it. SceneView::Apply is the
/// way there.
namespace nexrad::viewer
{

/// The settings of a scene, with the iso-values of its colour map where these were edited.
scene::SceneOptions OptionsOf(vtkNexradVolumeScene* scene);
scene::CameraView CameraOf(vtkNexradVolumeScene* scene);

/// The colours and opacities of a scene in ParaView's JSON, where they are not those that its
/// options make; else empty.
std::string EditedColours(vtkNexradVolumeScene* scene);

/// Draws with the edited colours and opacities that a file has: with its opacities alone where
/// another array gives the colours.
void UseColours(const std::filesystem::path& file, scene::SceneOptions& options);

/// Gives a scene that shows a volume the colours and opacities of such a text, and then surfaces at
/// iso-values; each where there are some. Throws Error for a text that is no colour map.
void SetColours(const std::string& colours, const std::vector<scene::IsoValue>& isoValues,
  vtkNexradVolumeScene* scene);

} // namespace nexrad::viewer
