// SPDX-License-Identifier: BSD-3-Clause
#include "Web/PageFolder.h"

#include "Output/OutputFile.h"
#include "nexrad/Codec/NxvFile.h"
#include "nexrad/System/AtomicFile.h"
#include "nexrad/System/Error.h"

#include <algorithm>
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
        throw Error(file.string() +
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
  const fs::path index = folder / indexName;
  const bool allThere = std::all_of(
    files.begin(), files.end(), [&](const auto& file) { return LiesIn(file.second, folder); });
  if (allThere && fs::exists(index))
  {
    return {indexName, ReadNxvSeries(index).size()};
  }
  NxvSeries series;
  for (const auto& [name, file] : files)
  {
    if (!LiesIn(file, folder))
    {
      CopyVolume(file, folder / name);
    }
    series.emplace_back(name, ToSeconds(ReadNxvHeader(folder / name).time));
  }
  std::stable_sort(
    series.begin(), series.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  WriteNxvSeries(index, series);
  return {indexName, series.size()};
}

} // namespace nexrad::application
