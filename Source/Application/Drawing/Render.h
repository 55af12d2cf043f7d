// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Requests/DrawingRequest.h"
#include "nexrad/System/Progress.h"

#include <filesystem>
#include <string>
#include <vector>

namespace nexrad::scene
{

/// What the render command asks for.
struct RenderRequest : DrawingRequest
{
  std::filesystem::path output; ///< .png, .ogv, .mp4 or .glb; of a map also .tif
  int framesPerSecond = 8;      ///< of a movie
  int frames = 0;               ///< of a movie; 0: one for each time
  double turn = 0.0;            ///< degrees by which the camera goes round during a movie
  Progress progress;
};

/// What was made of it.
struct RenderReport
{
  std::vector<std::filesystem::path> outputs;
  std::vector<std::string> problems; ///< inputs that were damaged or left out, a line each
  std::vector<std::string> notes;    ///< what else is to be said, a line each
};

/// Draws the pictures or the movie. Throws Error when that cannot be done.
RenderReport Render(const RenderRequest& request);

} // namespace nexrad::scene
