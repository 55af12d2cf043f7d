// SPDX-License-Identifier: BSD-3-Clause
#include "Libraries/SceneLibrary.h"

#include "Libraries/LibraryCall.h"

namespace nexrad::application
{
namespace
{

constexpr LibraryName library = {"nexrad3d-scene.so", "draws", "nexrad3d-scene"};

} // namespace

scene::RenderReport RenderWithLibrary(const scene::RenderRequest& request)
{
  return CallLibrary<scene::RenderReport>(library, scene::renderFunctionName, request);
}

scene::ViewReport ViewWithLibrary(const scene::ViewRequest& request)
{
  return CallLibrary<scene::ViewReport>(library, scene::viewFunctionName, request);
}

} // namespace nexrad::application
