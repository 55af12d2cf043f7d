// SPDX-License-Identifier: BSD-3-Clause
#include "Drawing/SurfaceFiles.h"

#include "Drawing/VolumeOutputs.h"
#include "Gltf/SurfaceScene.h"
#include "Output/OutputFile.h"

#include <vtkImageData.h>

#include <vector>

namespace nexrad::scene
{

RenderReport WriteSurfaces(const RenderRequest& request)
{
  const auto write = [&request](const std::filesystem::path& path, vtkImageData* volume)
  {
    const std::vector<unsigned char> bytes = MakeGlb(MakeSurfaceScene(volume, request.scene));
    application::WriteFile(path, bytes.data(), bytes.size());
  };
  return WriteEachVolume(request, write);
}

} // namespace nexrad::scene
