// SPDX-License-Identifier: BSD-3-Clause
#include "Libraries/ProgramLibrary.h"

#include "nexrad/System/Error.h"

#include <dlfcn.h>
#include <filesystem>

namespace fs = std::filesystem;

namespace nexrad::application
{
namespace
{

// Where it was built; else where it would be installed.
fs::path PlaceOf(const std::string& name)
{
  const fs::path folder = fs::read_symlink("/proc/self/exe").parent_path();
  const fs::path built = folder / ".." / "lib" / "nexrad3d" / name;
  return fs::exists(built) ? built : folder / ".." / NEXRAD_LIBRARY_FOLDER / "nexrad3d" / name;
}

} // namespace

AnyFunction LoadProgramFunction(const ProgramLibrary& library, const std::string& function)
{
  const fs::path place = PlaceOf(library.file);
  if (!fs::exists(place))
  {
    throw Error(place.lexically_normal().string() + ": the library that " + library.does +
                " is missing; build the target " + library.target + ", or install again");
  }
  const std::string path = place.string();
  // Never closed: VTK's factories, a graphics driver or MPI keep pointers into it.
  void* const handle = dlopen(path.c_str(), RTLD_LAZY);
  if (handle == nullptr)
  {
    throw Error(path + ": cannot be loaded: " + dlerror());
  }
  void* const found = dlsym(handle, function.c_str());
  if (found == nullptr)
  {
    throw Error(path + ": is not the library of this program; install both again");
  }
  return reinterpret_cast<AnyFunction>(found);
}

} // namespace nexrad::application
