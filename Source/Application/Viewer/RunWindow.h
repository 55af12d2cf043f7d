// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Requests/DrawingRequest.h"

#include <filesystem>
#include <string>
#include <vector>

namespace nexrad::scene
{

/// What the view command asks for. The size is that of the window at first.
struct ViewRequest : DrawingRequest
{
  Duration interval = std::chrono::milliseconds(500); ///< from one step to the next in playing
  std::filesystem::path pictures = ".";               ///< folder that takes screenshots
};

/// What came of it when the window was closed.
struct ViewReport
{
  std::vector<std::filesystem::path> pictures; ///< screenshots
  std::vector<std::string> problems; ///< inputs that were damaged or left out, a line each
  std::vector<std::string> notes;    ///< what else is to be said, a line each
};

} // namespace nexrad::scene

namespace nexrad::viewer
{

/// Shows the window until the user closes it. Throws Error when there is no display.
scene::ViewReport RunWindow(const scene::ViewRequest& request);

} // namespace nexrad::viewer
