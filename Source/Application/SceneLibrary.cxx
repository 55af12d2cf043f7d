// SPDX-License-Identifier: BSD-3-Clause
#include "SceneLibrary.h"

#include "Model/Error.h"
#include "ProgramLibrary.h"

namespace nexrad::application
{

scene::RenderReport RenderWithLibrary(const scene::RenderRequest& request)
{
  const auto render = reinterpret_cast<scene::RenderFunction>(
    LoadProgramFunction("nexrad3d-scene.so", scene::renderFunctionName, "draws", "nexrad3d-scene"));
  scene::RenderReport report;
  render(&request, &report);
  if (!report.error.empty())
  {
    throw Error(report.error);
  }
  return report;
}

} // namespace nexrad::application
