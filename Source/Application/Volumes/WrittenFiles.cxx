// SPDX-License-Identifier: BSD-3-Clause
#include "Volumes/WrittenFiles.h"

#include "nexrad/System/AtomicFile.h"
#include "nexrad/System/Error.h"

#include <system_error>
#include <utility>

namespace fs = std::filesystem;

namespace nexrad::application
{
namespace
{

void RemoveFile(const fs::path& file)
{
  std::error_code ignored;
  fs::remove(file, ignored);
}

} // namespace

WrittenFiles::~WrittenFiles()
{
  this->RemoveBeside();
}

WrittenFiles& WrittenFiles::operator=(WrittenFiles&& other) noexcept
{
  std::swap(files, other.files);
  return *this;
}

fs::path WrittenFiles::PlaceFor(const fs::path& path)
{
  std::error_code ignored;
  return fs::is_regular_file(path, ignored) ? TemporaryPathFor(path) : path;
}

void WrittenFiles::Add(const fs::path& written, const fs::path& path)
{
  files.push_back({written, path});
}

void WrittenFiles::Keep()
{
  for (File& file : files)
  {
    if (file.written != file.path)
    {
      std::error_code problem;
      fs::rename(file.written, file.path, problem);
      if (problem)
      {
        throw Error(file.path.string() + ": cannot be replaced: " + problem.message());
      }
      file.written = file.path;
    }
  }
}

void WrittenFiles::Remove()
{
  for (const File& file : files)
  {
    RemoveFile(file.written);
  }
  files.clear();
}

void WrittenFiles::RemoveBeside()
{
  for (const File& file : files)
  {
    if (file.written != file.path)
    {
      RemoveFile(file.written);
    }
  }
}

} // namespace nexrad::application
