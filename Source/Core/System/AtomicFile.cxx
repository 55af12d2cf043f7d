// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/System/AtomicFile.h"

#include "nexrad/System/Error.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace fs = std::filesystem;

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

namespace
{

constexpr const char* mark = ".part-";
constexpr std::size_t digitCount = 16;

// Sixteen hexadecimal digits that nobody can guess.
std::string RandomDigits()
{
  std::random_device source;
  char digits[digitCount + 1];
  std::snprintf(digits, sizeof digits, "%08x%08x", source(), source());
  return digits;
}

// What the temporary names for a path begin with.
std::string TemporaryPrefix(const fs::path& path)
{
  return "." + path.stem().string() + mark;
}

bool IsTemporaryFor(const fs::path& path, const fs::path& other)
{
  const std::string prefix = TemporaryPrefix(path);
  const std::string ending = path.extension().string();
  const std::string name = other.filename().string();
  return name.size() == prefix.size() + digitCount + ending.size() &&
         name.compare(0, prefix.size(), prefix) == 0 &&
         name.find_first_not_of("0123456789abcdef", prefix.size()) >= prefix.size() + digitCount &&
         name.compare(prefix.size() + digitCount, std::string::npos, ending) == 0;
}

// Removes a regular file that no living process has locked with TryLock; on file systems that know
// no locks, none.
void RemoveIfAbandoned(const fs::path& path)
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

// Removes what processes that were killed left behind for a path.
void RemoveAbandoned(const fs::path& path)
{
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  std::vector<fs::path> others;
  std::error_code failure;
  for (fs::directory_iterator entry(folder, failure), end; !failure && entry != end;
       entry.increment(failure))
  {
    if (IsTemporaryFor(path, entry->path()))
    {
      others.push_back(entry->path());
    }
  }
  for (const fs::path& other : others)
  {
    RemoveIfAbandoned(other);
  }
}

} // namespace

AtomicFile::AtomicFile(const fs::path& path)
  : target(path)
{
  std::error_code ignored;
  const fs::file_status status = fs::status(target, ignored);
  if (fs::exists(status) && !fs::is_regular_file(status))
  {
    throw Error(target.string() + ": cannot be written: it is a folder or a device");
  }
  RemoveAbandoned(target);
  this->Open();
}

// Another process that looks for what was left behind may remove the file before it is locked; then
// another is made.
void AtomicFile::Open()
{
  constexpr int attempts = 10;
  for (int attempt = 0; attempt < attempts; ++attempt)
  {
    temporary = target.parent_path() /
                (TemporaryPrefix(target) + RandomDigits() + target.extension().string());
    descriptor = FileDescriptor(
      open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666));
    if (descriptor.IsOpen() && TryLock(descriptor))
    {
      return;
    }
    if (!descriptor.IsOpen() && errno != EEXIST)
    {
      break;
    }
  }
  this->Fail();
}

AtomicFile::~AtomicFile()
{
  if (descriptor.IsOpen())
  {
    unlink(temporary.c_str());
  }
}

void AtomicFile::Fail() const
{
  throw Error(target.string() + ": cannot be written: " + std::strerror(errno));
}

void AtomicFile::Write(const void* data, std::size_t size)
{
  // One call takes at most 2 GiB on Linux.
  constexpr std::size_t largestWrite = std::size_t(1) << 30;
  const auto* bytes = static_cast<const char*>(data);
  while (size > 0)
  {
    const ssize_t written = write(descriptor.Number(), bytes, std::min(size, largestWrite));
    if (written < 0 && errno == EINTR)
    {
      continue;
    }
    if (written <= 0)
    {
      this->Fail();
    }
    bytes += written;
    size -= static_cast<std::size_t>(written);
  }
}

void AtomicFile::RequireRoom(std::size_t bytes)
{
  const off_t end = lseek(descriptor.Number(), 0, SEEK_END);
  if (end < 0)
  {
    this->Fail();
  }
  int failure = 0;
  do
  {
    failure = posix_fallocate(descriptor.Number(), end, static_cast<off_t>(bytes));
  } while (failure == EINTR);
  if (ftruncate(descriptor.Number(), end) != 0 && failure == 0)
  {
    failure = errno;
  }
  if (failure != 0)
  {
    errno = failure;
    this->Fail();
  }
}

void AtomicFile::Commit()
{
  // A full disk or a broken network mount may show only now. Some file systems know no fsync.
  if (fsync(descriptor.Number()) != 0 && errno != EINVAL && errno != ENOTSUP)
  {
    this->Fail();
  }
  // Renamed while it is locked: without its lock it could be taken for left behind.
  if (rename(temporary.c_str(), target.c_str()) != 0 || !descriptor.Close())
  {
    this->Fail();
  }
}

void WriteFileAtomically(const fs::path& path, const void* data, std::size_t size)
{
  AtomicFile file(path);
  file.Write(data, size);
  file.Commit();
}

} // namespace nexrad
