// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace nexrad::application
{

/// A file that came, or that changed.
struct ArrivedFile
{
  std::filesystem::path path;
  std::uintmax_t size = 0;
  std::filesystem::file_time_type changed{}; ///< time of its last byte
};

/// Follows folders and the folders in them, by listing them: that works on every file system, also
/// where another machine writes. A folder is listed again when its time says that it changed; files
/// that are being written are looked at each time. Names that begin with a dot are passed over,
/// links are followed, and each folder is listed once.
class FolderListing
{
public:
  explicit FolderListing(std::vector<std::filesystem::path> folders);

  /// The files that came or changed since the last call, in the order of their paths. A folder that
  /// does not exist or cannot be read is among the problems, once, and is looked for again.
  std::vector<ArrivedFile> Poll();

  /// Whether a file is looked at in each Poll, although its folder did not change: it is not whole
  /// yet.
  void Watch(const std::filesystem::path& file, bool watched);

  /// What was wrong since the last call, a line each.
  std::vector<std::string> TakeProblems();

private:
  using FileTime = std::filesystem::file_time_type;
  struct File
  {
    std::uintmax_t size = 0;
    FileTime changed{};
    bool watched = false;
  };
  struct Folder
  {
    FileTime changed{};   ///< of the folder, when it was listed
    bool settled = false; ///< nothing can have been added since without another time
    std::map<std::string, File> files;
    std::set<std::string> folders;
  };

  void Visit(const std::filesystem::path& path, int depth, std::vector<ArrivedFile>& arrived);
  bool List(const std::filesystem::path& path, Folder& folder);
  void Look(const std::filesystem::path& path, File& file, std::vector<ArrivedFile>& arrived);
  void Complain(const std::filesystem::path& path, const std::string& why);

  const std::vector<std::filesystem::path> tops;
  std::map<std::filesystem::path, Folder> folders;
  std::set<std::pair<std::uintmax_t, std::uintmax_t>> visited; ///< device and number, in one Poll
  std::set<std::filesystem::path> refused;
  std::vector<std::string> problems;
};

} // namespace nexrad::application
