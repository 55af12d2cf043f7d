// SPDX-License-Identifier: BSD-3-Clause
#include "Libraries/SceneLibrary.h"

#include "Libraries/LibraryCall.h"

namespace nexrad::application
{
namespace
{

constexpr LibraryName library = {"nexrad3d-scene.so", "draws", "nexrad3d-scene"};
constexpr LibraryName windowLibrary = {"nexrad3d-window.so", "has the window of view",
  "nexrad3d-window, which needs Qt 5 and VTK's module GUISupportQt"};

} // namespace

scene::RenderReport RenderWithLibrary(const scene::RenderRequest& request)
{
  return CallLibrary<scene::RenderReport>(library, scene::renderFunctionName, request);
}

scene::WebReport WebWithLibrary(const scene::WebRequest& request)
{
  return CallLibrary<scene::WebReport>(library, scene::webFunctionName, request);
}

scene::ViewReport WindowWithLibrary(const scene::ViewRequest& request)
{
  return CallLibrary<scene::ViewReport>(windowLibrary, scene::windowFunctionName, request);
}

} // namespace nexrad::application
