// SPDX-License-Identifier: BSD-3-Clause
#include "Libraries/ProgramLibrary.h"

#include "nexrad/System/Error.h"

#include <vtksys/DynamicLoader.hxx>

#include <filesystem>

namespace fs = std::filesystem;

namespace nexrad::application
{
namespace
{

fs::path FindLibrary(const std::string& name, const std::string& does, const std::string& target)
{
  const fs::path folder = fs::read_symlink("/proc/self/exe").parent_path();
  const fs::path built = folder / ".." / "lib" / "nexrad3d" / name;
  const fs::path installed = folder / ".." / NEXRAD_LIBRARY_FOLDER / "nexrad3d" / name;
  if (fs::exists(built))
  {
    return built;
  }
  if (!fs::exists(installed))
  {
    throw Error(installed.lexically_normal().string() + ": the library that " + does +
                " is missing; build the target " + target + ", or install again");
  }
  return installed;
}

} // namespace

AnyFunction LoadProgramFunction(const std::string& library, const std::string& function,
  const std::string& does, const std::string& target)
{
  const std::string path = FindLibrary(library, does, target).string();
  // Never closed: VTK's factories, a graphics driver or MPI keep pointers into it.
  vtksys::DynamicLoader::LibraryHandle handle = vtksys::DynamicLoader::OpenLibrary(path);
  if (handle == nullptr)
  {
    throw Error(path + ": cannot be loaded: " + vtksys::DynamicLoader::LastError());
  }
  const auto found = vtksys::DynamicLoader::GetSymbolAddress(handle, function);
  if (found == nullptr)
  {
    throw Error(path + ": is not the library of this program; install both again");
  }
  return reinterpret_cast<AnyFunction>(found);
}

} // namespace nexrad::application
