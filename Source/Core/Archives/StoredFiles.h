// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Archives/Archive.h"
#include "nexrad/Archives/FileParts.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <system_error>
#include <vector>

/// Files and folders by path, where a tar archive is a folder: "day.tar/KTLX20130520_200356_V06.gz"
/// names a member. The lists of the archives that were used last stay in memory, so that a member
/// is found without reading the archive again; an archive that changed is listed anew.
namespace nexrad
{

/// What stands at a path.
enum class StoredKind
{
  Nothing,
  File,   ///< on disk, or the member of an archive
  Folder, ///< on disk, in an archive, or an archive
  Other   ///< a pipe, a device
};

StoredKind KindOf(const std::filesystem::path& path);

/// Throws Error for a path that is neither a file nor a folder: a pipe keeps its reader waiting for
/// a writer, and a device never ends. To be called before a file that somebody named is opened. A
/// path that does not exist passes: opening it says what is wrong.
void RequireOrdinaryFile(const std::filesystem::path& path);

/// True for a file on disk that can be opened without waiting: not for a folder, a pipe or a
/// device.
bool IsOrdinaryFile(const std::filesystem::path& path);

/// The archive that a path on disk names; nullptr where it names none.
std::shared_ptr<const Archive> FindArchive(const std::filesystem::path& path);

/// The content of a member of an archive; empty where the path names none.
std::optional<FilePart> FindMember(const std::filesystem::path& path);

/// What a folder holds, but for names that begin with a dot, in any order. `failure` is set for
/// what cannot be read and for what is no folder.
std::vector<std::filesystem::path> ListFolder(
  const std::filesystem::path& folder, std::error_code& failure);

/// The first bytes of a file, at most `most`; none where it cannot be read.
std::vector<std::uint8_t> ReadStart(const std::filesystem::path& path, std::size_t most);

/// Bytes of a file; 0 for anything else.
std::uintmax_t StoredSize(const std::filesystem::path& path);

/// When a file or folder was last written to; of a member, its archive. The earliest time where
/// there is nothing.
std::filesystem::file_time_type ChangedAt(const std::filesystem::path& path);

} // namespace nexrad
