// SPDX-License-Identifier: BSD-3-Clause
#include "Volumes/GridTask.h"

#include "nexrad/Compression/Deflate.h"
#include "nexrad/System/AtomicFile.h"
#include "nexrad/System/Error.h"

#include <array>
#include <charconv>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iterator>
#include <optional>
#include <set>
#include <string_view>
#include <system_error>

namespace fs = std::filesystem;

namespace nexrad::application
{
namespace
{

constexpr std::size_t mostParts = 99'999;
// Between the name of a volume and the part: its rows, and what these are made of.
constexpr const char* rowsMark = ".rows-";
constexpr const char* madeMark = ".made-";

// "2-of-4", as the names of files end.
std::string NameOf(const GridTask& task)
{
  return std::to_string(task.part + 1) + "-of-" + std::to_string(task.parts);
}

// A recipe in eight letters.
std::string ShortOf(const std::string& recipe)
{
  std::array<char, 9> name{};
  std::snprintf(name.data(), name.size(), "%08x",
    Crc32(reinterpret_cast<const std::uint8_t*>(recipe.data()), recipe.size()));
  return name.data();
}

// A number from 1 on; empty for any other text.
std::optional<std::size_t> ReadCount(std::string_view text)
{
  std::size_t count = 0;
  const auto [end, wrong] = std::from_chars(text.data(), text.data() + text.size(), count);
  const bool whole = wrong == std::errc() && end == text.data() + text.size();
  return whole && count >= 1 && count <= mostParts ? std::optional(count) : std::nullopt;
}

// The part after "scan:" or "rows:", as "1/4".
std::optional<GridTask> ReadPart(GridTask::Kind kind, std::string_view text)
{
  const std::size_t slash = text.find('/');
  if (slash == std::string_view::npos)
  {
    return std::nullopt;
  }
  const auto part = ReadCount(text.substr(0, slash));
  const auto parts = ReadCount(text.substr(slash + 1));
  return part && parts && *part <= *parts ? std::optional(GridTask{kind, *part - 1, *parts})
                                          : std::nullopt;
}

std::string ReadAll(const fs::path& path)
{
  std::ifstream file(path, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  if (!file)
  {
    throw Error(path.string() + ": cannot be read");
  }
  return text;
}

} // namespace

GridTask ParseGridTask(const std::string& text)
{
  using Kind = GridTask::Kind;
  const std::string_view all = text;
  constexpr std::size_t word = 5; // letters of "scan:"
  const auto task = all == "join"                    ? std::optional(GridTask{Kind::Join, 0, 1})
                    : all.substr(0, word) == "scan:" ? ReadPart(Kind::Scan, all.substr(word))
                    : all.substr(0, word) == "rows:" ? ReadPart(Kind::Rows, all.substr(word))
                                                     : std::nullopt;
  if (!task)
  {
    throw Error(
      "'" + text + "' is no task; write scan:1/4 (the first of four parts), rows:1/4 or join");
  }
  return *task;
}

TaskFolder::TaskFolder(const fs::path& folder, const std::string& recipe)
  : hidden(folder / (".grid.tasks-" + ShortOf(recipe)))
{
}

void TaskFolder::Make() const
{
  std::error_code failed;
  fs::create_directories(hidden, failed);
  if (failed)
  {
    throw Error(hidden.string() + ": cannot be made: " + failed.message());
  }
}

// The files "NAME-1-of-N" to "NAME-N-of-N", which tasks of this name leave.
std::vector<fs::path> TaskFolder::Find(const std::string& name, const std::string& task) const
{
  constexpr std::string_view of = "-of-";
  std::set<std::size_t> counts;
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(hidden, none))
  {
    const std::string file = entry.path().filename().string();
    if (file.rfind(name + '-', 0) == 0)
    {
      counts.insert(
        ReadCount(std::string_view(file).substr(file.rfind(of) + of.size())).value_or(0));
    }
  }
  if (counts.size() != 1)
  {
    throw Error(
      hidden.string() +
      (counts.empty() ? ": lacks what --task " + task + ":1/N leaves there; run these tasks first"
                      : ": holds parts of different numbers of --task " + task +
                          "; remove the folder, and begin anew"));
  }
  std::vector<fs::path> paths;
  for (std::size_t part = 0; part < *counts.begin(); ++part)
  {
    paths.push_back(hidden / (name + '-' + NameOf(GridTask{{}, part, *counts.begin()})));
    if (!fs::exists(paths.back()))
    {
      throw Error(paths.back().string() + ": is missing; run --task " + task + ':' +
                  std::to_string(part + 1) + '/' + std::to_string(*counts.begin()) + " first");
    }
  }
  return paths;
}

fs::path TaskFolder::PutKnown(const GridTask& task, const std::string& known) const
{
  this->Make();
  fs::path path = hidden / ("scan-" + NameOf(task));
  WriteFileAtomically(path, known.data(), known.size());
  return path;
}

std::vector<std::string> TaskFolder::Known() const
{
  std::vector<std::string> all;
  for (const fs::path& path : this->Find("scan", "scan"))
  {
    all.push_back(ReadAll(path));
  }
  return all;
}

fs::path TaskFolder::PlaceForRows(const std::string& volume, const GridTask& task) const
{
  this->Make();
  return hidden / (volume + rowsMark + NameOf(task));
}

void TaskFolder::PutMade(
  const std::string& volume, const GridTask& task, const std::string& made) const
{
  this->Make();
  WriteFileAtomically(hidden / (volume + madeMark + NameOf(task)), made.data(), made.size());
}

std::vector<fs::path> TaskFolder::RowsOf(const std::string& volume, const std::string& made) const
{
  std::vector<fs::path> rows;
  for (const fs::path& path : this->Find(volume + ".made", "rows"))
  {
    if (ReadAll(path) != made)
    {
      throw Error(path.string() + ": these rows were made of other files; run --task rows again");
    }
    std::string name = path.filename().string();
    name.replace(volume.size(), std::strlen(madeMark), rowsMark);
    if (fs::exists(hidden / name))
    {
      rows.push_back(hidden / name);
    }
  }
  return rows;
}

void TaskFolder::Remove() const
{
  std::error_code ignored;
  fs::remove_all(hidden, ignored);
}

} // namespace nexrad::application
