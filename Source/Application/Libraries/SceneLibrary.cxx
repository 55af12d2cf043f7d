// SPDX-License-Identifier: BSD-3-Clause
#include "Libraries/SceneLibrary.h"

#include "Libraries/LibraryCall.h"

namespace nexrad::application
{
namespace
{

constexpr LibraryName library = {"nexrad3d-scene.so", "draws", "nexrad3d-scene"};
constexpr LibraryName windowLibrary = {
  "nexrad3d-window.so", "has the window of view", "nexrad3d-window"};

} // namespace

scene::RenderReport RenderWithLibrary(const scene::RenderRequest& request)
{
  return CallLibrary<scene::RenderReport>(library, scene::renderFunctionName, request);
}

scene::ViewReport ViewWithLibrary(const scene::ViewRequest& request)
{
  return CallLibrary<scene::ViewReport>(library, scene::viewFunctionName, request);
}

scene::WebReport WebWithLibrary(const scene::WebRequest& request)
{
  return CallLibrary<scene::WebReport>(library, scene::webFunctionName, request);
}

bool HasWindowLibrary()
{
  return HasProgramLibrary(windowLibrary.file);
}

scene::ViewReport WindowWithLibrary(const scene::ViewRequest& request)
{
  return CallLibrary<scene::ViewReport>(windowLibrary, scene::windowFunctionName, request);
}

} // namespace nexrad::application
