// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Archives/FileParts.h"

#include "nexrad/System/Error.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <string>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace fs = std::filesystem;

namespace nexrad
{

FilePart::FilePart(
  std::shared_ptr<const FileDescriptor> file, std::uint64_t begin, std::uint64_t size)
  : descriptor(std::move(file))
  , first(begin)
  , length(size)
{
}

std::optional<FilePart> FilePart::Open(const fs::path& path)
{
  std::error_code failure; // a pipe is not opened: its writer would take it for the reader
  auto file = std::make_shared<const FileDescriptor>(
    fs::is_regular_file(path, failure) ? open(path.c_str(), O_RDONLY | O_CLOEXEC) : -1);
  struct stat status = {};
  if (!file->IsOpen() || fstat(file->Number(), &status) != 0 || !S_ISREG(status.st_mode))
  {
    return std::nullopt;
  }
  return FilePart(std::move(file), 0, static_cast<std::uint64_t>(status.st_size));
}

FilePart FilePart::Sub(std::uint64_t offset, std::uint64_t size) const
{
  const std::uint64_t begin = std::min(offset, length);
  return {descriptor, first + begin, std::min(size, length - begin)};
}

std::size_t FilePart::Read(std::uint64_t offset, std::uint8_t* target, std::size_t size) const
{
  const std::uint64_t left = offset < length ? length - offset : 0;
  const auto wanted = static_cast<std::size_t>(std::min<std::uint64_t>(size, left));
  std::size_t done = 0;
  while (done < wanted)
  {
    const ssize_t count = pread(descriptor->Number(), target + done, wanted - done,
      static_cast<off_t>(first + offset + done));
    if (count == 0 || (count < 0 && errno != EINTR))
    {
      break;
    }
    done += count > 0 ? static_cast<std::size_t>(count) : 0;
  }
  return done;
}

std::vector<std::uint8_t> FilePart::Start(std::size_t most) const
{
  std::vector<std::uint8_t> bytes(static_cast<std::size_t>(std::min<std::uint64_t>(most, length)));
  bytes.resize(this->Read(0, bytes.data(), bytes.size()));
  return bytes;
}

ScratchFile::ScratchFile()
{
  std::error_code failure;
  const fs::path folder = fs::temp_directory_path(failure);
  std::string name = (folder / "vtk-nexrad-XXXXXX").string();
  const int number = failure ? -1 : mkostemp(name.data(), O_CLOEXEC);
  if (number < 0)
  {
    throw Error("no temporary file can be made in " + folder.string() + ": " +
                (failure ? failure.message() : std::strerror(errno)));
  }
  unlink(name.c_str());
  descriptor = std::make_shared<const FileDescriptor>(number);
}

void ScratchFile::Append(const std::uint8_t* data, std::size_t size)
{
  while (size > 0)
  {
    const ssize_t count = write(descriptor->Number(), data, size);
    if (count < 0 && errno != EINTR)
    {
      throw Error(std::string("the temporary file cannot be written: ") + std::strerror(errno) +
                  "; TMPDIR names its folder");
    }
    const std::size_t done = count > 0 ? static_cast<std::size_t>(count) : 0;
    data += done;
    size -= done;
    length += done;
  }
}

FilePart ScratchFile::From(std::uint64_t begin) const
{
  return FilePart(descriptor, 0, length).Sub(begin, length);
}

} // namespace nexrad
