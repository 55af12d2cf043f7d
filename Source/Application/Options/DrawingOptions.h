// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Requests/DrawingRequest.h"

namespace CLI
{
class App;
}

/// The options that the commands which draw share. They store into what they are given, which must
/// outlive the parsing. OptionTexts.h is the way back.
namespace nexrad::application
{

/// What is drawn, and which time of it. `required`: whether an input must be named.
void AddTimedInputs(CLI::App& command, InputRequest& request, bool required = true);

/// The same, with a box of it that is merged again in finer voxels.
void AddInputOptions(CLI::App& command, InputRequest& request, bool required = true);

/// Those settings of the camera and of the scene that a page has (DrawingSettings).
void AddPageOptions(CLI::App& command, scene::DrawingOptions& options);

/// All settings of a picture.
void AddDrawingOptions(CLI::App& command, scene::DrawingOptions& options);

/// Once all are known: what the inputs must hold for the picture. The command has the options of
/// merging as well (AddGridOptions). Throws CLI::ValidationError for options that contradict each
/// other.
void FinishDrawingOptions(const CLI::App& command, scene::DrawingRequest& request);

} // namespace nexrad::application
