// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/System/OrdinaryFile.h"

#include "nexrad/System/Error.h"

#include <system_error>

namespace fs = std::filesystem;

namespace nexrad
{

void RequireOrdinaryFile(const fs::path& path)
{
  std::error_code ignored;
  const fs::file_status status = fs::status(path, ignored);
  if (fs::is_other(status))
  {
    throw Error(path.string() + ": neither a file nor a folder; name a file");
  }
}

bool IsOrdinaryFile(const fs::path& path)
{
  std::error_code ignored;
  return fs::is_regular_file(path, ignored);
}

} // namespace nexrad
