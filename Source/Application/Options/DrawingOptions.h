// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Requests/DrawingRequest.h"

#include <string>
#include <vector>

namespace CLI
{
class App;
}

/// The options that the commands which draw share. They store into what they are given, which must
/// outlive the parsing. OptionTexts.h is the way back.
namespace nexrad::application
{

/// Where the camera stands over a map unless an option says otherwise, degrees.
constexpr double MapAzimuth = 180.0;
constexpr double MapTilt = 90.0;

/// What is drawn, and which time of it. `required`: whether an input must be named.
void AddTimedInputs(CLI::App& command, InputRequest& request, bool required = true);

/// The same, with a box of it that is merged again in finer voxels.
void AddInputOptions(CLI::App& command, InputRequest& request, bool required = true);

/// From where.
void AddCameraOptions(CLI::App& command, scene::CameraView& camera);

/// Colours, opacities, surfaces, stretch of heights, theme.
void AddAppearanceOptions(CLI::App& command, scene::SceneOptions& options);

/// From where, how it looks, how large, and whether as a map.
void AddDrawingOptions(CLI::App& command, scene::DrawingRequest& request);

/// Values of surfaces, each with an opacity if it is not to have the usual one: "20:0.3,40:0.6,50".
/// Throws Error for anything else.
std::vector<scene::IsoValue> ParseIsoValues(const std::string& text);

/// Once all are known: what the inputs must hold for the picture. The command has the options of
/// merging as well (AddGridOptions). Throws CLI::ValidationError for options that contradict each
/// other.
void FinishDrawingOptions(const CLI::App& command, scene::DrawingRequest& request);

} // namespace nexrad::application
