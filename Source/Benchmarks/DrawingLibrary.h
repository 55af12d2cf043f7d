// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Frames/DrawingTimes.h"
#include "Sheets/SheetRequest.h"

namespace nexrad::application
{

/// Loads the library that draws for the benchmark, which brings VTK's rendering with it, and has it
/// do the request. Without drawing none of it is in the memory that is measured. Throws Error when
/// the library is not where the program was built or installed, and for what the drawing itself
/// fails at.
DrawingReport MeasureDrawingWithLibrary(const DrawingRequest& request);
scene::SheetReport DrawSheetsWithLibrary(const scene::SheetRequest& request);

/// Names of the functions in it.
constexpr char measureDrawingFunctionName[] = "nexrad3dMeasureDrawing";
constexpr char drawSheetsFunctionName[] = "nexrad3dDrawSheets";

} // namespace nexrad::application
