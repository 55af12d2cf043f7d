// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Requests/DrawingRequest.h"
#include "nexrad/System/Progress.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace nexrad::scene
{

/// What the web command asks of the scene library.
struct WebRequest : DrawingRequest
{
  std::filesystem::path output; ///< a page (.html) with the volumes in it; any other name is a
                                ///< folder, for a page beside volume files
  Progress progress;
};

/// What was made of it.
struct WebReport
{
  std::filesystem::path page;
  std::uintmax_t bytes = 0;          ///< of the page
  std::size_t times = 0;             ///< in the page, or in the index beside it
  std::vector<std::string> problems; ///< inputs that were damaged or left out, a line each
  std::vector<std::string> notes;    ///< what else is to be said, a line each
  std::string error;                 ///< why nothing was made; "" when all went well
};

/// Name and type of the function by which the program calls the scene library.
constexpr char webFunctionName[] = "nexrad3dWeb";
using WebFunction = void (*)(const WebRequest* request, WebReport* report);

} // namespace nexrad::scene
