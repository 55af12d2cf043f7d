// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/System/AtomicFile.h"

#include "nexrad/System/Error.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <string>

namespace fs = std::filesystem;

namespace nexrad
{

fs::path TemporaryPathFor(const fs::path& path)
{
  static std::atomic<unsigned> count{0};
  const std::string part = ".part-" + std::to_string(getpid()) + "-" + std::to_string(count++);
  return path.parent_path() / ("." + path.stem().string() + part + path.extension().string());
}

AtomicFile::AtomicFile(const fs::path& path)
  : target(path)
  , temporary(TemporaryPathFor(path))
{
  std::error_code ignored;
  const fs::file_status status = fs::status(target, ignored);
  if (fs::exists(status) && !fs::is_regular_file(status))
  {
    throw Error(target.string() + ": cannot be written: it is a folder or a device");
  }
  descriptor = open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (descriptor < 0)
  {
    this->Fail("cannot be written");
  }
}

AtomicFile::~AtomicFile()
{
  if (descriptor >= 0)
  {
    close(descriptor);
    unlink(temporary.c_str());
  }
}

void AtomicFile::Fail(const char* what) const
{
  throw Error(target.string() + ": " + what + ": " + std::strerror(errno));
}

void AtomicFile::Write(const void* data, std::size_t size)
{
  // One call takes at most 2 GiB on Linux.
  constexpr std::size_t largestWrite = std::size_t(1) << 30;
  const auto* bytes = static_cast<const char*>(data);
  while (size > 0)
  {
    const ssize_t written = write(descriptor, bytes, std::min(size, largestWrite));
    if (written < 0 && errno == EINTR)
    {
      continue;
    }
    if (written <= 0)
    {
      this->Fail("cannot be written");
    }
    bytes += written;
    size -= static_cast<std::size_t>(written);
  }
}

void AtomicFile::Commit()
{
  // A full disk or a broken network mount may show only now. Some file systems know no fsync.
  if (fsync(descriptor) != 0 && errno != EINVAL && errno != ENOTSUP)
  {
    this->Fail("cannot be written");
  }
  if (close(descriptor) != 0 || rename(temporary.c_str(), target.c_str()) != 0)
  {
    const int reason = errno;
    unlink(temporary.c_str());
    descriptor = -1;
    errno = reason;
    this->Fail("cannot be written");
  }
  descriptor = -1;
}

void WriteFileAtomically(const fs::path& path, const void* data, std::size_t size)
{
  AtomicFile file(path);
  file.Write(data, size);
  file.Commit();
}

} // namespace nexrad
