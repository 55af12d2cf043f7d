// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Options/DrawingOptions.h"
#include "Output/MessageOutput.h"
#include "nexrad/System/Progress.h"

#include <filesystem>

namespace nexrad::scene
{

/// What the render command asks for.
struct RenderRequest : DrawingRequest
{
  std::filesystem::path output; ///< .png, .ogv, .mp4 or .glb; of a map also .tif
  int framesPerSecond = 8;      ///< of a movie
  int frames = 0;               ///< of a movie; 0: one for each time
  double turn = 0.0;            ///< degrees by which the camera goes round during a movie
  bool fly = false;             ///< from the whole frame to the view of the camera during a movie
  Progress progress;
};

/// Draws the pictures or the movie, or writes a file of numbers for each time. The outcome names
/// the files. Throws Error when that cannot be done.
application::Outcome Render(const RenderRequest& request);

} // namespace nexrad::scene
