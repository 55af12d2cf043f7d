// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Scene/Frame/CameraView.h"
#include "Scene/SceneOptions.h"
#include "Scene/Series/InputSeries.h"

#include <array>
#include <string>
#include <vector>

namespace CLI
{
class App;
}

/// The options that the commands which draw share. They store into what they are given, which must
/// outlive the parsing.
namespace nexrad::application
{

/// What is drawn, and which time of it. `required`: whether an input must be named.
void AddInputOptions(CLI::App& command, scene::InputRequest& request, bool required = true);

/// From where.
void AddCameraOptions(CLI::App& command, scene::CameraView& camera);

/// How it looks, and how large.
void AddPictureOptions(CLI::App& command, std::array<int, 2>& size, scene::SceneOptions& options);

/// Values of surfaces, each with an opacity if it is not to have the usual one: "20:0.3,40:0.6,50".
/// Throws Error for anything else.
std::vector<scene::IsoValue> ParseIsoValues(const std::string& text);

/// Once all are known: what the inputs must hold for the picture. Throws CLI::ValidationError for
/// options that contradict each other.
void FinishDrawingOptions(
  const CLI::App& command, scene::InputRequest& request, const scene::SceneOptions& options);

} // namespace nexrad::application
