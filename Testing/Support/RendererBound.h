// SPDX-License-Identifier: BSD-3-Clause
// Bounds of pictures, for tests that link VTK's rendering.
#pragma once

#include "vtkNew.h"
#include "vtkRenderWindow.h"

#include <string>

namespace nexrad::testing
{

/// The bound of a figure that depends on how OpenGL rounds. `llvmpipe`: for Mesa's software
/// renderer, which drew the baselines. `card`: for the drivers of graphics cards, measured on an
/// NVIDIA H100 with driver 580.159.04.
inline double BoundOfRenderer(double llvmpipe, double card)
{
  static const bool software = []
  {
    vtkNew<vtkRenderWindow> window;
    window->SetOffScreenRendering(1);
    return std::string(window->ReportCapabilities()).find("llvmpipe") != std::string::npos;
  }();
  return software ? llvmpipe : card;
}

} // namespace nexrad::testing
