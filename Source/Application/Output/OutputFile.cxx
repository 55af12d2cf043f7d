// SPDX-License-Identifier: BSD-3-Clause
#include "Output/OutputFile.h"

#include "nexrad/System/AtomicFile.h"
#include "nexrad/System/Error.h"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <ctime>
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

// Opens a device or a pipe. A pipe is waited for until somebody reads it, in pieces that a signal
// ends: the call itself would begin anew after the signal's handler.
FileDescriptor OpenDirectly(const fs::path& path)
{
  constexpr timespec piece = {0, 50'000'000};
  for (;;)
  {
    FileDescriptor file(open(path.c_str(), O_WRONLY | O_NONBLOCK | O_CLOEXEC));
    if (file.IsOpen())
    {
      return file;
    }
    if (errno != ENXIO || nanosleep(&piece, nullptr) != 0)
    {
      FailToWrite(path, errno);
    }
  }
}

// A device or a pipe, which cannot be replaced.
void WriteDirectly(const fs::path& path, const unsigned char* bytes, std::size_t size)
{
  FileDescriptor file = OpenDirectly(path);
  for (std::size_t written = 0; written < size;)
  {
    const ssize_t count = write(file.Number(), bytes + written, size - written);
    written += count > 0 ? static_cast<std::size_t>(count) : 0;
    pollfd reader = {file.Number(), POLLOUT, 0};
    const bool waits = count < 0 && errno == EAGAIN;
    if ((count < 0 && !waits) || (waits && poll(&reader, 1, -1) < 0))
    {
      FailToWrite(path, errno);
    }
  }
  if (!file.Close())
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
