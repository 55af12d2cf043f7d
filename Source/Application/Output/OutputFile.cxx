// SPDX-License-Identifier: BSD-3-Clause
#include "Output/OutputFile.h"

#include "nexrad/System/Error.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <string>
#include <unistd.h>

namespace fs = std::filesystem;

namespace nexrad::application
{
namespace
{

[[noreturn]] void FailToWrite(const fs::path& path, int code)
{
  throw Error(path.string() + ": cannot be written: " + std::strerror(code));
}

void WriteDirectly(
  const fs::path& path, const fs::path& name, const unsigned char* bytes, std::size_t size)
{
  struct Closer
  {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  std::unique_ptr<std::FILE, Closer> file(std::fopen(path.c_str(), "wb"));
  if (file == nullptr)
  {
    FailToWrite(name, errno);
  }
  // fwrite and fclose both may be the one that meets the full disk.
  if (std::fwrite(bytes, 1, size, file.get()) != size || std::fclose(file.release()) != 0)
  {
    FailToWrite(name, errno);
  }
}

} // namespace

OutputFile::OutputFile(const fs::path& path)
  : target(path)
{
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  if (!fs::is_directory(folder))
  {
    throw Error(path.string() + ": cannot be written: the folder does not exist");
  }
  temporary = folder / ("." + path.stem().string() + ".part" + std::to_string(getpid()) +
                         path.extension().string());
}

OutputFile::~OutputFile()
{
  std::error_code ignored;
  fs::remove(temporary, ignored);
}

void OutputFile::Commit()
{
  std::error_code error;
  fs::rename(temporary, target, error);
  if (error)
  {
    FailToWrite(target, error.value());
  }
}

void WriteFile(const fs::path& path, const unsigned char* bytes, std::size_t size)
{
  std::error_code ignored;
  if (fs::exists(path, ignored) && !fs::is_regular_file(path, ignored))
  {
    WriteDirectly(path, path, bytes, size);
    return;
  }
  OutputFile file(path);
  WriteDirectly(file.TemporaryPath(), path, bytes, size);
  file.Commit();
}

void MakeFolder(const fs::path& path)
{
  std::error_code error;
  fs::create_directories(path, error);
  if (error || !fs::is_directory(path))
  {
    throw Error(path.string() +
                ": cannot be made a folder: " + (error ? error.message() : "a file has that name"));
  }
}

} // namespace nexrad::application
