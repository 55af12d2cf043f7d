// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Archives/StoredFiles.h"

#include "nexrad/System/Error.h"

#include <algorithm>
#include <list>
#include <mutex>
#include <string>
#include <tuple>
#include <utility>

namespace fs = std::filesystem;

namespace nexrad
{

namespace
{

// The archives that were used last. Each has one or two open files.
class KnownArchives
{
public:
  // nullptr where the file is no archive.
  std::shared_ptr<const Archive> Find(const fs::path& path)
  {
    std::error_code failure;
    const State state = {
      path.string(), fs::file_size(path, failure), fs::last_write_time(path, failure)};
    const std::lock_guard<std::mutex> lock(mutex);
    const auto known = std::find_if(
      archives.begin(), archives.end(), [&](const auto& each) { return each.first == state; });
    if (known != archives.end())
    {
      archives.splice(archives.begin(), archives, known);
      return archives.front().second;
    }
    const auto file = FilePart::Open(path);
    if (!file || !IsArchive(*file, path.filename().string()))
    {
      return nullptr;
    }
    archives.emplace_front(state, std::make_shared<const Archive>(ReadArchive(*file)));
    archives.resize(std::min(archives.size(), most));
    return archives.front().second;
  }

private:
  using State = std::tuple<std::string, std::uintmax_t, fs::file_time_type>;
  static constexpr std::size_t most = 128; // a process may have 1024 open files

  std::mutex mutex;
  std::list<std::pair<State, std::shared_ptr<const Archive>>> archives;
};

// A path in an archive, and the name there; "" for the archive itself.
struct PlaceInArchive
{
  fs::path file;
  std::shared_ptr<const Archive> archive;
  std::string name;
};

// Empty for a path that leads into no archive.
std::optional<PlaceInArchive> FindPlace(const fs::path& path)
{
  const std::string text = path.string();
  std::error_code failure;
  if (const fs::file_status status = fs::status(path, failure); fs::exists(status))
  {
    auto archive = fs::is_regular_file(status) ? FindArchive(path) : nullptr;
    return archive ? std::optional(PlaceInArchive{path, std::move(archive), ""}) : std::nullopt;
  }
  if (failure != std::errc::not_a_directory && failure != std::errc::filename_too_long)
  {
    return std::nullopt;
  }
  for (std::size_t end = text.find('/', 1); end != std::string::npos; end = text.find('/', end + 1))
  {
    const fs::path front = text.substr(0, end);
    if (fs::is_regular_file(front, failure))
    {
      auto archive = FindArchive(front);
      return archive
               ? std::optional(PlaceInArchive{front, std::move(archive), text.substr(end + 1)})
               : std::nullopt;
    }
  }
  return std::nullopt;
}

// The name of the folder with a slash, which all names of its members begin with.
std::string PrefixOf(const PlaceInArchive& folder)
{
  return folder.name.empty() || folder.name.back() == '/' ? folder.name : folder.name + '/';
}

bool IsFolderOf(const PlaceInArchive& place)
{
  const std::string prefix = PrefixOf(place);
  const auto first = place.archive->members.lower_bound(prefix);
  return prefix.empty() ||
         (first != place.archive->members.end() && first->first.rfind(prefix, 0) == 0);
}

std::vector<fs::path> ListPlace(const PlaceInArchive& folder)
{
  const std::map<std::string, FilePart>& members = folder.archive->members;
  const std::string prefix = PrefixOf(folder);
  std::vector<fs::path> entries;
  for (auto member = members.lower_bound(prefix);
       member != members.end() && member->first.rfind(prefix, 0) == 0;)
  {
    const std::size_t end = member->first.find('/', prefix.size());
    const std::string name = member->first.substr(0, end);
    if (name[prefix.size()] != '.')
    {
      entries.emplace_back(folder.file.string() + '/' + name);
    }
    // All of a folder in one step: '0' follows '/'.
    member = end == std::string::npos ? std::next(member) : members.lower_bound(name + '0');
  }
  return entries;
}

} // namespace

StoredKind KindOf(const fs::path& path)
{
  std::error_code failure;
  const fs::file_status status = fs::status(path, failure);
  if (fs::is_directory(status))
  {
    return StoredKind::Folder;
  }
  if (fs::exists(status) && !fs::is_regular_file(status))
  {
    return StoredKind::Other;
  }
  const auto place = FindPlace(path);
  if (!place)
  {
    return fs::exists(status) ? StoredKind::File : StoredKind::Nothing;
  }
  const bool isMember = place->archive->members.count(place->name) > 0;
  return isMember             ? StoredKind::File
         : IsFolderOf(*place) ? StoredKind::Folder
                              : StoredKind::Nothing;
}

void RequireOrdinaryFile(const fs::path& path)
{
  std::error_code ignored;
  if (fs::is_other(path, ignored))
  {
    throw Error(path.string() + ": neither a file nor a folder; name a file");
  }
}

bool IsOrdinaryFile(const fs::path& path)
{
  std::error_code ignored;
  return fs::is_regular_file(path, ignored);
}

std::shared_ptr<const Archive> FindArchive(const fs::path& path)
{
  static KnownArchives known;
  return known.Find(path);
}

std::optional<FilePart> FindMember(const fs::path& path)
{
  const auto place = FindPlace(path);
  const auto member = place ? place->archive->members.find(place->name)
                            : std::map<std::string, FilePart>::const_iterator();
  return place && member != place->archive->members.end() ? std::optional(member->second)
                                                          : std::nullopt;
}

std::vector<fs::path> ListFolder(const fs::path& folder, std::error_code& failure)
{
  failure.clear();
  if (!fs::is_directory(folder, failure))
  {
    if (const auto place = FindPlace(folder))
    {
      failure.clear();
      return ListPlace(*place);
    }
  }
  std::vector<fs::path> entries;
  for (fs::directory_iterator entry(folder, failure), end; !failure && entry != end;
       entry.increment(failure))
  {
    if (entry->path().filename().string().front() != '.')
    {
      entries.push_back(entry->path());
    }
  }
  return entries;
}

std::vector<std::uint8_t> ReadStart(const fs::path& path, std::size_t most)
{
  const auto file = FilePart::Open(path);
  const auto part = file ? file : FindMember(path);
  return part ? part->Start(most) : std::vector<std::uint8_t>();
}

std::uintmax_t StoredSize(const fs::path& path)
{
  std::error_code failure;
  const std::uintmax_t size = fs::file_size(path, failure); // fails for folders
  if (!failure)
  {
    return size;
  }
  const auto member = FindMember(path);
  return member ? member->Size() : 0;
}

fs::file_time_type ChangedAt(const fs::path& path)
{
  std::error_code failure;
  const fs::file_time_type changed = fs::last_write_time(path, failure);
  if (!failure)
  {
    return changed;
  }
  const auto place = FindPlace(path);
  return place ? fs::last_write_time(place->file, failure) : fs::file_time_type::min();
}

} // namespace nexrad
