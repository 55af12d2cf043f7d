// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Scene/Frame/CameraView.h"
#include "Scene/SceneOptions.h"
#include "nexrad/Settings/Setting.h"

#include <array>
#include <string>
#include <vector>

namespace nexrad::scene
{

/// How a volume is drawn.
struct DrawingOptions
{
  std::array<int, 2> size = {1280, 720}; ///< of the picture, pixels
  CameraView camera;
  SceneOptions scene;
};

/// All settings of a picture, of its camera and of its scene. A new one is a row here, a member,
/// and the place where it acts.
const SettingTable<DrawingOptions>& DrawingSettings();

/// What is drawn where nothing else is asked for beside some options: a map is seen from above,
/// north up, in parallel projection.
DrawingOptions UsualBeside(const DrawingOptions& options);

/// Values of surfaces, each with an opacity if it is not to have the usual one: "20:0.3,40:0.6,50".
/// Throws Error for anything else.
std::vector<IsoValue> ParseIsoValues(const std::string& text);

} // namespace nexrad::scene
