// SPDX-License-Identifier: BSD-3-Clause
#include "Web/PageFolder.h"

#include "Output/OutputFile.h"
#include "Web/PageText.h"
#include "nexrad/Codec/NxvFile.h"
#include "nexrad/System/AtomicFile.h"
#include "nexrad/System/Error.h"
#include "nexrad/System/OrdinaryFile.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <system_error>

namespace fs = std::filesystem;

namespace nexrad::application
{
namespace
{

constexpr char indexName[] = "volumes.nxv.series"; // as the command grid writes it

bool IsIndex(const fs::path& path)
{
  return path.extension() == ".series";
}

std::vector<fs::path> VolumesOf(const fs::path& input)
{
  std::vector<fs::path> files;
  if (fs::is_directory(input))
  {
    for (const auto& entry : fs::directory_iterator(input))
    {
      if (entry.path().extension() == ".nxv" && entry.path().filename().string().front() != '.')
      {
        files.push_back(entry.path());
      }
    }
    return files;
  }
  if (IsIndex(input))
  {
    for (const auto& entry : ReadNxvSeries(input))
    {
      files.push_back(input.parent_path() / entry.first);
    }
    return files;
  }
  return {input};
}

// Copies a file so that it appears whole or not at all.
void CopyVolume(const fs::path& from, const fs::path& to)
{
  AtomicFile copy(to);
  std::error_code error;
  fs::copy_file(from, copy.TemporaryPath(), fs::copy_options::overwrite_existing, error);
  if (error)
  {
    throw Error(to.string() + ": cannot be written: " + error.message());
  }
  copy.Commit();
}

bool LiesIn(const fs::path& file, const fs::path& folder)
{
  const fs::path parent = file.parent_path();
  return fs::equivalent(parent.empty() ? fs::path(".") : parent, folder);
}

[[noreturn]] void RefuseToReplace(const fs::path& file)
{
  throw Error(file.string() + ": was not written by nexrad3d web, and stays as it is; move it, or "
                              "name another folder (-o)");
}

bool HaveSameBytes(const fs::path& a, const fs::path& b)
{
  if (!IsOrdinaryFile(a) || !IsOrdinaryFile(b) || fs::file_size(a) != fs::file_size(b))
  {
    return false;
  }
  std::ifstream first(a, std::ios::binary);
  std::ifstream second(b, std::ios::binary);
  return std::equal(std::istreambuf_iterator<char>(first), std::istreambuf_iterator<char>(),
    std::istreambuf_iterator<char>(second));
}

// The files that have to be brought into the folder. Those that are there already stay; `written`
// are the names that may be replaced.
NamedFiles FindMissing(
  const NamedFiles& files, const fs::path& folder, const std::set<std::string>& written)
{
  NamedFiles missing;
  for (const auto& [name, file] : files)
  {
    const fs::path place = folder / name;
    const bool isThere = fs::exists(fs::symlink_status(place));
    const bool isSame = LiesIn(file, folder) || (isThere && HaveSameBytes(file, place));
    if (isThere && !isSame && written.count(name) == 0)
    {
      RefuseToReplace(place);
    }
    if (!isSame)
    {
      missing.emplace(name, file);
    }
  }
  return missing;
}

NxvSeries SeriesOf(const NamedFiles& files)
{
  NxvSeries series;
  for (const auto& [name, file] : files)
  {
    series.emplace_back(name, ToSeconds(ReadNxvHeader(file).time));
  }
  std::stable_sort(
    series.begin(), series.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  return series;
}

} // namespace

NamedFiles FindVolumeFiles(const std::vector<fs::path>& inputs)
{
  NamedFiles files;
  for (const fs::path& input : inputs)
  {
    for (const fs::path& file : VolumesOf(input))
    {
      const std::string name = file.filename();
      if (file.extension() != ".nxv")
      {
        throw Error((file == input ? "" : input.string() + ": ") + file.string() +
                    ": is no volume file (.nxv), and a browser reads those alone; "
                    "make some with nexrad3d grid, or write one page, as storm.html");
      }
      const auto [place, added] = files.emplace(name, file);
      if (!added && !fs::equivalent(place->second, file))
      {
        throw Error(file.string() + ": has the name of " + place->second.string() +
                    "; a folder holds one of them");
      }
    }
  }
  return files;
}

VolumeFolder FillVolumeFolder(const NamedFiles& files, const fs::path& folder)
{
  MakeFolder(folder);
  VolumeFolder filled{indexName, 0, ReadWrittenFiles(folder / PageName)};
  const fs::path index = folder / indexName;
  const bool allThere = std::all_of(
    files.begin(), files.end(), [&](const auto& file) { return LiesIn(file.second, folder); });
  if (allThere && fs::exists(index))
  {
    filled.times = ReadNxvSeries(index).size();
    return filled;
  }
  const NxvSeries series = SeriesOf(files);
  filled.times = series.size();
  const NamedFiles missing = FindMissing(files, folder, filled.written);
  const bool hasIndex = filled.written.count(indexName) == 0 && fs::exists(index);
  if (hasIndex && ReadNxvSeries(index) != series)
  {
    RefuseToReplace(index);
  }
  for (const auto& [name, file] : missing)
  {
    CopyVolume(file, folder / name);
    filled.written.insert(name);
  }
  if (!hasIndex)
  {
    WriteNxvSeries(index, series);
    filled.written.insert(indexName);
  }
  return filled;
}

} // namespace nexrad::application
