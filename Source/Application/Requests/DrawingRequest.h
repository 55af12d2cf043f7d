// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Filters/Series/InputSeries.h"
#include "Scene/DrawingSettings.h"

namespace nexrad::scene
{

/// What a picture is of, and how it is drawn.
struct DrawingRequest : DrawingOptions
{
  InputRequest input;
  bool maxGapGiven = false; ///< `input.grid` has a largest gap that somebody chose
};

} // namespace nexrad::scene
