// SPDX-License-Identifier: BSD-3-Clause
#include "Web/WebPage.h"

#include "Filters/Series/InputSeries.h"
#include "Libraries/VtkErrors.h"
#include "Output/OutputFile.h"
#include "Scene/EchoFraming.h"
#include "Scene/VolumeAppearance.h"
#include "Web/PageCode.h"
#include "Web/PageScene.h"
#include "Web/PageText.h"
#include "nexrad/Archives/StoredFiles.h"
#include "nexrad/Codec/NxvFile.h"
#include "nexrad/Merging/SeriesMerger.h"
#include "nexrad/System/AtomicFile.h"
#include "nexrad/System/Error.h"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace fs = std::filesystem;

namespace nexrad::application
{
namespace
{

// The folder of a page shows the whole of large volumes in their largest voxels, and reads finer
// ones of what is near.
InputRequest InputOf(const scene::WebRequest& request, bool isFolder)
{
  InputRequest input = request.input;
  input.fewVoxels = isFolder;
  return input;
}

/// Volume files beside a page, and their index.
struct VolumeFolder
{
  std::size_t times = 0;         ///< in the index
  std::set<std::string> written; ///< names of the files there that a page of this folder brought
};

/// The page in its folder.
constexpr char PageName[] = "index.html";

/// Files by their names.
using NamedFiles = std::map<std::string, std::filesystem::path>;

constexpr char indexName[] = "volumes.nxv.series"; // as the command grid writes it

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
  if (input.extension() == ".series")
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

/// The volume files of some inputs: .nxv, .nxv.series, folders of .nxv. Throws Error for an input
/// that is none, and for two files of one name.
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

/// Brings volume files into the folder of a page and writes the index volumes.nxv.series of them.
/// Files that lie in the folder stay as they are; where all do, and the folder has an index, so
/// does the index: whoever adds volumes to the folder keeps it. Throws Error for what cannot be
/// written; and, before anything is, where a file of others stands in the place of one of these or
/// of the page, PageName.
VolumeFolder FillVolumeFolder(const NamedFiles& files, const fs::path& folder)
{
  MakeFolder(folder);
  VolumeFolder filled{0, ReadWrittenFiles(folder / PageName)};
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

class PageMaker
{
public:
  PageMaker(const scene::WebRequest& webRequest, bool isFolder)
    : request(webRequest)
    , series(OpenInputs(InputOf(webRequest, isFolder), webRequest.progress))
    , chosen(ChooseTimes(*series, webRequest.input))
    , echo(scene::MeasureSeries(*series, chosen, webRequest.scene))
  {
  }

  Outcome MakeSinglePage()
  {
    PageText text;
    for (std::size_t i = 0; i < chosen.size(); ++i)
    {
      const vtkSmartPointer<vtkImageData> volume = this->Load(i); // which makes the page
      const PackedColumns packed = PackColumns(page->Size(), page->Encode(volume));
      text.AddPart("ends-" + std::to_string(i), packed.ends);
      text.AddPart("codes-" + std::to_string(i), packed.codes);
    }
    return this->Finish(std::move(text), request.output, {}, times.size());
  }

  Outcome MakeFolder()
  {
    const NamedFiles files = FindVolumeFiles(request.input.inputs);
    this->Load(0); // fails for a preset that the volumes cannot have before anything is written
    const VolumeFolder volumes = FillVolumeFolder(files, request.output);
    PageText text;
    text.AddWrittenFiles(volumes.written);
    const PageFiles beside{indexName, IsNxvInBricks(files.begin()->second)};
    return this->Finish(std::move(text), request.output / PageName, beside, volumes.times);
  }

private:
  vtkSmartPointer<vtkImageData> Load(std::size_t i)
  {
    const Progress drawing = ShareOf(request.progress, ScanShare, 1.0);
    const auto image = series->Load(chosen[i], ShareOf(drawing, i, chosen.size()));
    if (!image)
    {
      throw Error("stopped before the page was made");
    }
    if (!page)
    {
      page.emplace(request, image, echo);
    }
    times.push_back(CaptionsOf(image, series->Times()[chosen[i]], request.scene));
    return image;
  }

  // `count`: times in the page, or in the index beside it.
  Outcome Finish(PageText text, const fs::path& path, const PageFiles& files, std::size_t count)
  {
    text.AddTextPart("scene", page->MakeText(times, files));
    text.AddPart("ground", page->GroundTexels());
    ThrowVtkErrors();
    const std::string html = text.Make(page->Title(times));
    WriteFile(path, reinterpret_cast<const unsigned char*>(html.data()), html.size());
    Outcome outcome;
    outcome.made = {
      path.string() + ": " + Counted(count, "time") + ", " + Counted(html.size(), "byte")};
    outcome.notes = scene::LinesPassedOver(request.scene);
    outcome.problems = series->Problems();
    return outcome;
  }

  const scene::WebRequest& request;
  std::unique_ptr<VolumeSeries> series;
  std::vector<std::size_t> chosen;
  std::optional<scene::EchoExtent> echo; ///< of all times, where there are several
  std::optional<PageScene> page;         ///< once the first volume is there
  std::vector<PageTime> times;
};

} // namespace

Outcome MakeWebPage(const scene::WebRequest& request)
{
  const fs::path extension = request.output.extension();
  const bool isPage = extension == ".html" || extension == ".htm";
  const bool isFolder = !isPage || fs::is_directory(request.output);
  PageMaker maker(request, isFolder);
  return isFolder ? maker.MakeFolder() : maker.MakeSinglePage();
}

} // namespace nexrad::application
