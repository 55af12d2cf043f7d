// SPDX-License-Identifier: BSD-3-Clause
#include "SceneLibrary.h"

#include "Model/Error.h"

#include <vtksys/DynamicLoader.hxx>

#include <filesystem>
#include <string>

namespace fs = std::filesystem;

namespace nexrad::application
{
namespace
{

constexpr char libraryName[] = "nexrad3d-scene.so";

// Beside the program as it was built, or below the library folder that it was installed with.
fs::path FindLibrary()
{
  const fs::path folder = fs::read_symlink("/proc/self/exe").parent_path();
  const fs::path built = folder / ".." / "lib" / "nexrad3d" / libraryName;
  const fs::path installed = folder / ".." / NEXRAD_LIBRARY_FOLDER / "nexrad3d" / libraryName;
  if (fs::exists(built))
  {
    return built;
  }
  if (!fs::exists(installed))
  {
    throw Error(installed.lexically_normal().string() +
                ": the library that draws is missing; build the target nexrad3d-scene, or install "
                "again");
  }
  return installed;
}

scene::RenderFunction LoadRenderFunction()
{
  const std::string path = FindLibrary().string();
  // Never closed: VTK's factories and the graphics driver keep pointers into it.
  vtksys::DynamicLoader::LibraryHandle library = vtksys::DynamicLoader::OpenLibrary(path);
  if (library == nullptr)
  {
    throw Error(path + ": cannot be loaded: " + vtksys::DynamicLoader::LastError());
  }
  const auto function = vtksys::DynamicLoader::GetSymbolAddress(library, scene::renderFunctionName);
  if (function == nullptr)
  {
    throw Error(path + ": is not the library of this program; install both again");
  }
  return reinterpret_cast<scene::RenderFunction>(function);
}

} // namespace

scene::RenderReport RenderWithLibrary(const scene::RenderRequest& request)
{
  scene::RenderReport report;
  LoadRenderFunction()(&request, &report);
  if (!report.error.empty())
  {
    throw Error(report.error);
  }
  return report;
}

} // namespace nexrad::application
