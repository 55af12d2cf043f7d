// SPDX-License-Identifier: BSD-3-Clause
#pragma once

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

/// Removes a regular file that no living process has locked with TryLock; on file systems that know
/// no locks, none.
void RemoveIfAbandoned(const std::filesystem::path& path);

} // namespace nexrad
