// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Requests/DrawingRequest.h"

#include <filesystem>
#include <string>
#include <vector>

namespace nexrad::scene
{

/// What the view command asks of the library of the window. The size is that of the window at first.
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
  std::string error;                 ///< why there was no window; "" when all went well
};

/// Name and type of the function by which the program calls the library of the window.
constexpr char windowFunctionName[] = "nexrad3dWindow";
using ViewFunction = void (*)(const ViewRequest* request, ViewReport* report);

} // namespace nexrad::scene
