// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <filesystem>

namespace nexrad
{

/// An open file of the operating system, closed at the end of its life.
class FileDescriptor
{
public:
  FileDescriptor() = default;
  /// Takes what open() returned; below 0: no file.
  explicit FileDescriptor(int opened)
    : number(opened)
  {
  }
  ~FileDescriptor() { this->Close(); }
  FileDescriptor(FileDescriptor&& other) noexcept;
  FileDescriptor& operator=(FileDescriptor&& other) noexcept;
  FileDescriptor(const FileDescriptor&) = delete;
  FileDescriptor& operator=(const FileDescriptor&) = delete;

  bool IsOpen() const { return number >= 0; }
  int Number() const { return number; }
  /// False, with errno, when the system reports a failure of a write before; the file is closed.
  bool Close();

private:
  int number = -1;
};

/// Locks an open file for this process, without waiting. The lock ends when the file is closed, and
/// so with the process, however it ends. False when another process (or another FileDescriptor of
/// this one) has the lock, and when the file no longer has a name: who had the lock removed it.
/// True on file systems that know no locks.
bool TryLock(const FileDescriptor& file);

/// A file that appears complete or not at all: it is written under a temporary name in the same
/// folder, and Commit gives it its name. Without Commit the temporary file is removed. Every
/// failure (no such folder, no permission, a full disk) throws Error: path, what failed, why.
///
/// The temporary name is hidden (".NAME.part-" and 16 random hexadecimal digits, then the
/// extension), and the file is locked while this object lives. What a process that was killed left
/// behind for the same path has no lock, and the next AtomicFile for that path removes it.
class AtomicFile
{
public:
  /// Opens the temporary file, which no other process can have made before: not as a symbolic link
  /// either. Refuses a path that is something other than a regular file (a folder, a device).
  explicit AtomicFile(const std::filesystem::path& path);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  void Write(const void* data, std::size_t size);

  /// Throws Error as Write does where so many bytes more do not fit on the disk: for a library that
  /// writes beside this file and does not survive a full disk. Takes them and gives them back.
  void RequireRoom(std::size_t bytes);

  /// For writers that open the file themselves, by its name, in place of Write.
  const std::filesystem::path& TemporaryPath() const { return temporary; }

  /// Makes sure that the bytes are on the disk, then renames. Nothing may be written afterwards.
  void Commit();

private:
  [[noreturn]] void Fail() const;
  void Open();

  std::filesystem::path target;
  std::filesystem::path temporary;
  FileDescriptor descriptor;
};

/// Writes a whole file through AtomicFile.
void WriteFileAtomically(const std::filesystem::path& path, const void* data, std::size_t size);

} // namespace nexrad
