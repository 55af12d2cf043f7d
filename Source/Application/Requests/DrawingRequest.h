// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Filters/Series/InputSeries.h"
#include "Scene/Frame/CameraView.h"
#include "Scene/SceneOptions.h"

#include <array>
#include <vector>

namespace nexrad::scene
{

/// What a picture is of, and how it is drawn.
struct DrawingRequest
{
  InputRequest input;
  bool maxGapGiven = false;              ///< `input.grid` has a largest gap that somebody chose
  std::array<int, 2> size = {1280, 720}; ///< pixels
  CameraView camera;
  SceneOptions scene;
};

} // namespace nexrad::scene
