// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/System/FileLock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <utility>

namespace nexrad
{

FileDescriptor::FileDescriptor(FileDescriptor&& other) noexcept
  : number(std::exchange(other.number, -1))
{
}

FileDescriptor& FileDescriptor::operator=(FileDescriptor&& other) noexcept
{
  std::swap(number, other.number);
  return *this;
}

bool FileDescriptor::Close()
{
  const int closed = std::exchange(number, -1);
  return closed < 0 || close(closed) == 0;
}

bool TryLock(const FileDescriptor& file)
{
  if (flock(file.Number(), LOCK_EX | LOCK_NB) != 0)
  {
    return errno != EWOULDBLOCK;
  }
  struct stat status = {};
  return fstat(file.Number(), &status) != 0 || status.st_nlink > 0;
}

void RemoveIfAbandoned(const std::filesystem::path& path)
{
  const FileDescriptor file(open(path.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
  struct stat status = {};
  if (file.IsOpen() && fstat(file.Number(), &status) == 0 && S_ISREG(status.st_mode) &&
      flock(file.Number(), LOCK_EX | LOCK_NB) == 0)
  {
    // While it is locked: a process that has just made it sees that its name is gone.
    unlink(path.c_str());
  }
}

} // namespace nexrad
