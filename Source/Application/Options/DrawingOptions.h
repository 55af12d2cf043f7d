// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Scene/Frame/CameraView.h"
#include "Scene/SceneOptions.h"
#include "Scene/Series/InputSeries.h"

#include <array>

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

/// Once all are known: what the inputs must hold for the picture. Throws CLI::ValidationError for
/// options that contradict each other.
void FinishDrawingOptions(
  const CLI::App& command, scene::InputRequest& request, const scene::SceneOptions& options);

} // namespace nexrad::application
