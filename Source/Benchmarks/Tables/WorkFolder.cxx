// SPDX-License-Identifier: BSD-3-Clause
#include "Tables/WorkFolder.h"

#include "nexrad/System/Error.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <string>
#include <system_error>

namespace nexrad::application
{

WorkFolder::WorkFolder()
{
  std::error_code failure;
  std::string name = std::filesystem::temp_directory_path(failure) / "nexrad3d-XXXXXX";
  if (failure || mkdtemp(name.data()) == nullptr)
  {
    throw Error(name + ": cannot be made: " + (failure ? failure.message() : std::strerror(errno)));
  }
  path = name;
}

WorkFolder::~WorkFolder()
{
  std::error_code ignored;
  std::filesystem::remove_all(path, ignored);
}

} // namespace nexrad::application
