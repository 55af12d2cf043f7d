// SPDX-License-Identifier: BSD-3-Clause
#include "Libraries/SceneLibrary.h"

#include "Libraries/ProgramLibrary.h"
#include "nexrad/System/Error.h"

namespace nexrad::application
{
namespace
{

template <typename Report, typename Request>
Report RunInLibrary(const char* name, const Request& request)
{
  const auto work = reinterpret_cast<void (*)(const Request*, Report*)>(
    LoadProgramFunction("nexrad3d-scene.so", name, "draws", "nexrad3d-scene"));
  Report report;
  work(&request, &report);
  if (!report.error.empty())
  {
    throw Error(report.error);
  }
  return report;
}

} // namespace

scene::RenderReport RenderWithLibrary(const scene::RenderRequest& request)
{
  return RunInLibrary<scene::RenderReport>(scene::renderFunctionName, request);
}

scene::ViewReport ViewWithLibrary(const scene::ViewRequest& request)
{
  return RunInLibrary<scene::ViewReport>(scene::viewFunctionName, request);
}

DrawingReport MeasureDrawingWithLibrary(const DrawingRequest& request)
{
  return RunInLibrary<DrawingReport>(measureDrawingFunctionName, request);
}

scene::SheetReport DrawSheetsWithLibrary(const scene::SheetRequest& request)
{
  return RunInLibrary<scene::SheetReport>(scene::drawSheetsFunctionName, request);
}

} // namespace nexrad::application
