// SPDX-License-Identifier: BSD-3-Clause
#include "Volumes/OtherVolumes.h"

#include "nexrad/Codec/NxvFile.h"
#include "nexrad/Grid/GridText.h"
#include "nexrad/System/Error.h"

#include <optional>
#include <system_error>

namespace fs = std::filesystem;

namespace nexrad::application
{
namespace
{

std::optional<GridSpecification> GridIn(const fs::path& file)
{
  try
  {
    return ReadNxvHeader(file).grid;
  }
  catch (const Error&)
  {
    return std::nullopt;
  }
}

// Names of the volume files in a folder.
std::set<std::string> VolumesIn(const fs::path& folder)
{
  std::set<std::string> names;
  std::error_code failure;
  for (fs::directory_iterator entry(folder, failure), end; !failure && entry != end;
       entry.increment(failure))
  {
    const fs::path name = entry->path().filename();
    std::error_code ignored;
    if (name.extension() == ".nxv" && name.string().front() != '.' &&
        entry->is_regular_file(ignored))
    {
      names.insert(name.string());
    }
  }
  return names;
}

} // namespace

void RequireSameGrid(
  const fs::path& folder, const std::set<std::string>& own, const GridSpecification& grid)
{
  for (const std::string& name : VolumesIn(folder))
  {
    const auto other = own.count(name) == 0 ? GridIn(folder / name) : std::nullopt;
    if (other && *other != grid)
    {
      throw Error(folder.string() + ": holds " + name + " with " + GridText(*other) +
                  ", and this run would add " + GridText(grid) +
                  "; remove the older volumes, or name another folder (-o)");
    }
  }
}

} // namespace nexrad::application
