// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace nexrad::application
{

/// Volume files beside a page, and their index.
struct VolumeFolder
{
  std::string index;             ///< name of the index, in the folder
  std::size_t times = 0;         ///< in the index
  std::set<std::string> written; ///< names of the files there that a page of this folder brought
};

/// The page in its folder.
constexpr char PageName[] = "index.html";

/// Files by their names.
using NamedFiles = std::map<std::string, std::filesystem::path>;

/// The volume files of some inputs: .nxv, .nxv.series, folders of .nxv. Throws Error for an input
/// that is none, and for two files of one name.
NamedFiles FindVolumeFiles(const std::vector<std::filesystem::path>& inputs);

/// Brings volume files into the folder of a page and writes the index volumes.nxv.series of them.
/// Files that lie in the folder stay as they are; where all do, and the folder has an index, so
/// does the index: whoever adds volumes to the folder keeps it. Throws Error for what cannot be
/// written; and, before anything is, where a file of others stands in the place of one of these or
/// of the page, PageName.
VolumeFolder FillVolumeFolder(const NamedFiles& files, const std::filesystem::path& folder);

} // namespace nexrad::application
