// SPDX-License-Identifier: BSD-3-Clause
#include "Drawing/Render.h"
#include "Drawing/View.h"
#include "MeasureDrawing.h"
#include "SheetRequest.h"

#include <exception>

namespace
{

// No exception may leave the library: what went wrong is in `report->error`.
template <typename Report, typename Request>
void Run(Report (*work)(const Request&), const Request* request, Report* report)
{
  try
  {
    *report = work(*request);
  }
  catch (const std::exception& error)
  {
    report->error = error.what();
  }
}

} // namespace

/// The functions that the program looks for in this library.
extern "C" __attribute__((visibility("default"))) void nexrad3dRender(
  const nexrad::scene::RenderRequest* request, nexrad::scene::RenderReport* report)
{
  Run(nexrad::scene::Render, request, report);
}

extern "C" __attribute__((visibility("default"))) void nexrad3dView(
  const nexrad::scene::ViewRequest* request, nexrad::scene::ViewReport* report)
{
  Run(nexrad::scene::View, request, report);
}

extern "C" __attribute__((visibility("default"))) void nexrad3dMeasureDrawing(
  const nexrad::application::DrawingRequest* request, nexrad::application::DrawingReport* report)
{
  Run(nexrad::scene::MeasureDrawing, request, report);
}

extern "C" __attribute__((visibility("default"))) void nexrad3dDrawSheets(
  const nexrad::scene::SheetRequest* request, nexrad::scene::SheetReport* report)
{
  Run(nexrad::scene::DrawSheets, request, report);
}
