// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Filters/Series/InputSeries.h"
#include "Scene/DrawingSettings.h"
#include "nexrad/Settings/Setting.h"

#include <filesystem>
#include <string>
#include <vector>

namespace CLI
{
class App;
}

namespace nexrad::scene
{

/// What a picture is of, and how it is drawn.
struct DrawingRequest : DrawingOptions
{
  InputRequest input;
  bool maxGapGiven = false; ///< `input.grid` has a largest gap that somebody chose
};

} // namespace nexrad::scene

/// The options that the commands which draw share, and the way back from what is drawn to these
/// options: for a command to copy, and for a session to keep. Options store into what they are
/// given, which must outlive the parsing.
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

/// The options of `render` that draw a request, but for its inputs. What has its default is left
/// out.
std::vector<OptionText> OptionTextsOf(const scene::DrawingRequest& request);

/// Sets what the options say; the inputs stay. Throws Error, with the name of the option, for one
/// that `render` does not have, and as the command line does.
void ParseOptionTexts(const std::vector<OptionText>& texts, scene::DrawingRequest& request);

/// A word as a shell takes it: in single quotes where it has characters that mean something there.
std::string QuoteForShell(const std::string& word);

/// The command that draws a request as a picture, as one line for a shell.
std::string RenderCommandOf(
  const scene::DrawingRequest& request, const std::filesystem::path& output);

} // namespace nexrad::application
