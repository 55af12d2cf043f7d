// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Archives/FileParts.h"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

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

/// The members of a tar archive, and of the archives in it. Each can be read at its place.
struct Archive
{
  std::map<std::string, FilePart> members; ///< by name; of two with one name the last
  std::vector<ArchiveProblem> problems;
};

/// True for a tar archive, bare or in a stream of gzip or compress, by its first bytes; in one of
/// bzip2, which would have to be decompressed for 900 kB, where its name has "tar" or "tb" in it.
bool IsArchive(const FilePart& file, const std::string& name);

/// Lists an archive and those in it, three deep. A compressed one is decompressed into a temporary
/// file: as many as 64 MiB and 40 times the size of the archive. Of more than 100,000 members, and
/// of more than 4 MiB of names, the rest is left.
Archive ReadArchive(const FilePart& file);

} // namespace nexrad
