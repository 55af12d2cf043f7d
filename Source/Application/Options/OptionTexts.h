// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Requests/DrawingRequest.h"
#include "nexrad/Settings/Setting.h"

#include <filesystem>
#include <string>
#include <vector>

/// The way back from what is drawn to the options that draw it: for a command to copy, and for a
/// session to keep. DrawingOptions.h is the way there.
namespace nexrad::application
{

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
