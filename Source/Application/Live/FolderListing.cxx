// SPDX-License-Identifier: BSD-3-Clause
#include "Live/FolderListing.h"

#include <sys/stat.h>

#include <system_error>
#include <utility>

namespace fs = std::filesystem;

namespace nexrad::application
{
namespace
{

constexpr int deepest = 16; // folders in folders, as in FindInputFiles

// Times of folders are as exact as the ticks of the clock of their machine; a folder whose time is
// younger may change once more with the same time.
constexpr auto tick = std::chrono::seconds(3);

// A file whose last byte is younger is looked at again: it may grow, and its folder does not tell.
constexpr auto young = std::chrono::seconds(60);

} // namespace

FolderListing::FolderListing(std::vector<fs::path> theFolders)
  : tops(std::move(theFolders))
{
}

std::vector<ArrivedFile> FolderListing::Poll()
{
  visited.clear();
  std::vector<ArrivedFile> arrived;
  for (const fs::path& top : tops)
  {
    this->Visit(top, 0, arrived);
  }
  return arrived;
}

void FolderListing::Visit(const fs::path& path, int depth, std::vector<ArrivedFile>& arrived)
{
  struct stat status = {};
  std::error_code failure;
  if (stat(path.c_str(), &status) != 0 || !S_ISDIR(status.st_mode))
  {
    if (depth == 0)
    {
      this->Complain(path, "no such folder");
    }
    folders.erase(path);
    return;
  }
  if (depth > deepest || !visited.insert({status.st_dev, status.st_ino}).second)
  {
    return;
  }
  const FileTime changed = fs::last_write_time(path, failure);
  Folder& folder = folders[path];
  const bool listed = failure || changed != folder.changed || !folder.settled;
  if (listed)
  {
    folder.changed = changed;
    folder.settled = FileTime::clock::now() - changed > tick;
    if (!this->List(path, folder))
    {
      return;
    }
  }
  for (auto& [name, file] : folder.files)
  {
    if (listed || file.watched || FileTime::clock::now() - file.changed < young)
    {
      this->Look(path / name, file, arrived);
    }
  }
  const std::set<std::string> inner = folder.folders;
  for (const std::string& name : inner)
  {
    this->Visit(path / name, depth + 1, arrived);
  }
}

// False when the folder cannot be read.
bool FolderListing::List(const fs::path& path, Folder& folder)
{
  std::map<std::string, File> files;
  std::set<std::string> inner;
  std::error_code failure;
  for (fs::directory_iterator entry(path, failure), end; !failure && entry != end;
       entry.increment(failure))
  {
    std::error_code ignored;
    const std::string name = entry->path().filename().string();
    if (name.front() == '.')
    {
      continue;
    }
    if (entry->is_directory(ignored))
    {
      inner.insert(name);
    }
    else if (entry->is_regular_file(ignored))
    {
      const auto known = folder.files.find(name);
      files[name] = known != folder.files.end() ? known->second : File{};
    }
    else
    {
      this->Complain(entry->path(), "neither a file nor a folder: left out");
    }
  }
  if (failure)
  {
    this->Complain(path, "the folder cannot be read: " + failure.message());
    return false;
  }
  for (const std::string& name : folder.folders)
  {
    if (inner.count(name) == 0)
    {
      folders.erase(path / name);
    }
  }
  folder.files = std::move(files);
  folder.folders = std::move(inner);
  refused.erase(path);
  return true;
}

// Adds the file when it is new or has changed.
void FolderListing::Look(const fs::path& path, File& file, std::vector<ArrivedFile>& arrived)
{
  std::error_code removed;
  std::error_code failure;
  const std::uintmax_t size = fs::file_size(path, removed);
  const FileTime changed = fs::last_write_time(path, failure);
  if (!removed && !failure && (file.changed != changed || file.size != size))
  {
    file.changed = changed;
    file.size = size;
    arrived.push_back({path, size, changed});
  }
}

void FolderListing::Watch(const fs::path& path, bool watched)
{
  const auto folder = folders.find(path.parent_path());
  if (folder == folders.end())
  {
    return;
  }
  const auto file = folder->second.files.find(path.filename().string());
  if (file != folder->second.files.end())
  {
    file->second.watched = watched;
  }
}

void FolderListing::Complain(const fs::path& path, const std::string& why)
{
  if (refused.insert(path).second)
  {
    problems.push_back(path.string() + ": " + why);
  }
}

std::vector<std::string> FolderListing::TakeProblems()
{
  return std::exchange(problems, {});
}

} // namespace nexrad::application
