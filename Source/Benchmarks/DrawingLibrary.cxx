// SPDX-License-Identifier: BSD-3-Clause
#include "DrawingLibrary.h"

#include "Libraries/LibraryCall.h"

namespace nexrad::application
{
namespace
{

constexpr LibraryName library = {
  "nexrad3d-bench-drawing.so", "draws for the benchmark", "nexrad3d-bench-drawing"};

} // namespace

DrawingReport MeasureDrawingWithLibrary(const DrawingRequest& request)
{
  return CallLibrary<DrawingReport>(library, measureDrawingFunctionName, request);
}

scene::SheetReport DrawSheetsWithLibrary(const scene::SheetRequest& request)
{
  return CallLibrary<scene::SheetReport>(library, drawSheetsFunctionName, request);
}

} // namespace nexrad::application
