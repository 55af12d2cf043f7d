// SPDX-License-Identifier: BSD-3-Clause
#include "Output/OutputFile.h"

#include "nexrad/System/AtomicFile.h"
#include "nexrad/System/Error.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <system_error>

namespace fs = std::filesystem;

namespace nexrad::application
{
namespace
{

[[noreturn]] void FailToWrite(const fs::path& path, int code)
{
  throw Error(path.string() + ": cannot be written: " + std::strerror(code));
}

// A device or a pipe, which cannot be replaced.
void WriteDirectly(const fs::path& path, const unsigned char* bytes, std::size_t size)
{
  struct Closer
  {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  std::unique_ptr<std::FILE, Closer> file(std::fopen(path.c_str(), "wb"));
  if (file == nullptr)
  {
    FailToWrite(path, errno);
  }
  // fwrite and fclose both may be the one that meets the full disk.
  if (std::fwrite(bytes, 1, size, file.get()) != size || std::fclose(file.release()) != 0)
  {
    FailToWrite(path, errno);
  }
}

} // namespace

void WriteFile(const fs::path& path, const unsigned char* bytes, std::size_t size)
{
  std::error_code ignored;
  if (fs::exists(path, ignored) && !fs::is_regular_file(path, ignored))
  {
    WriteDirectly(path, bytes, size);
    return;
  }
  WriteFileAtomically(path, bytes, size);
}

void MakeFolder(const fs::path& path)
{
  if (path.empty())
  {
    throw Error("the name of the folder to write to is empty; give it a name, or . for this one");
  }
  std::error_code error;
  fs::create_directories(path, error);
  if (error || !fs::is_directory(path))
  {
    throw Error(path.string() +
                ": cannot be made a folder: " + (error ? error.message() : "a file has that name"));
  }
}

} // namespace nexrad::application
