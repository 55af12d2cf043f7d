// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Archives/FileParts.h"

#include <cstdint>
#include <functional>
#include <string>

namespace nexrad
{

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
