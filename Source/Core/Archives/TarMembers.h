// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Archives/FileParts.h"
#include "nexrad/Compression/BigEndian.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

namespace nexrad
{

/// Headers and contents of a tar archive stand in blocks of this size.
constexpr std::size_t tarBlockBytes = 512;

/// The header of one member of a tar archive (POSIX.1-1988 "ustar", and the formats before it):
///
///     0 name   100 mode, owner   124 size   136 time   148 check sum   156 type   157 link
///     257 "ustar"   263 version   265 owner's names   345 first part of the name   500 end
struct TarHeader
{
  std::string name;       ///< as it is written, "" when it is empty
  std::uint64_t size = 0; ///< of what follows the header, bytes
  char type = '0';        ///< '0' or a zero byte: a file; 'L', 'x': about the next member
};

/// Reads a header. Empty when its check sum is wrong or its size is no size: base-256 numbers may
/// be negative or larger than any file.
std::optional<TarHeader> ParseTarHeader(ByteView block);

/// What the member of type 'x' before a file says of the file (POSIX.1-2001, extended header).
struct TarExtension
{
  std::optional<std::string> name;
  std::optional<std::uint64_t> size;
  bool sparse = false; ///< GNU's formats of files with holes
};

/// Reads records "LENGTH KEY=VALUE\n" as far as they are whole.
TarExtension ParseTarExtension(const std::string& records);

/// What is wrong in an archive, or with one of its members.
struct ArchiveProblem
{
  std::string member;       ///< "" for the archive itself
  std::uint64_t offset = 0; ///< in the archive; in the member, when there is one
  std::string what;         ///< one line
  bool leftOut = false;     ///< the member is not read
};

/// Takes what ListTar finds.
struct TarReceiver
{
  /// A file of the archive. False when no more are wanted.
  std::function<bool(std::string name, FilePart content)> member;
  std::function<void(ArchiveProblem&& problem)> problem;
};

/// True when the part begins with the header of a tar archive.
bool IsTar(const FilePart& part);

/// Goes through a tar archive from member to member and reads nothing of the files. Names lose the
/// parts "", "." and "..", so that they lead nowhere but into the archive. Folders and links are
/// passed over. Behind damage it goes on at the next header; a file that the archive's end cuts off
/// is as long as what is there.
void ListTar(const FilePart& archive, const TarReceiver& receiver);

} // namespace nexrad
