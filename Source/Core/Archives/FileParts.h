// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/System/AtomicFile.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

namespace nexrad
{

/// A part of an open file. Copies share the open file; several threads may read them at a time.
class FilePart
{
public:
  /// A whole file; empty where no regular file can be opened.
  static std::optional<FilePart> Open(const std::filesystem::path& path);

  std::uint64_t Size() const { return length; }
  /// The part of `size` bytes at `offset`, fewer where this one ends.
  FilePart Sub(std::uint64_t offset, std::uint64_t size) const;
  /// Fills the target from `offset`. Returns the number of bytes: fewer than `size` where the part
  /// ends or cannot be read.
  std::size_t Read(std::uint64_t offset, std::uint8_t* target, std::size_t size) const;
  /// The first bytes, at most `most`.
  std::vector<std::uint8_t> Start(std::size_t most) const;

private:
  friend class ScratchFile;
  FilePart(std::shared_ptr<const FileDescriptor> file, std::uint64_t begin, std::uint64_t size);

  std::shared_ptr<const FileDescriptor> descriptor;
  std::uint64_t first;
  std::uint64_t length;
};

/// A file without a name in the folder for temporary files (TMPDIR). It is gone when neither it nor
/// a part of it is there any more.
class ScratchFile
{
public:
  /// Throws Error when the folder takes no file.
  ScratchFile();

  /// Throws Error when the bytes cannot be written.
  void Append(const std::uint8_t* data, std::size_t size);
  std::uint64_t Size() const { return length; }
  /// What was appended after the first `begin` bytes.
  FilePart From(std::uint64_t begin) const;

private:
  std::shared_ptr<const FileDescriptor> descriptor;
  std::uint64_t length = 0;
};

} // namespace nexrad
