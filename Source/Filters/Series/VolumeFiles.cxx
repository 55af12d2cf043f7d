// SPDX-License-Identifier: BSD-3-Clause
#include "Filters/Series/VolumeFiles.h"

#include "nexrad/Codec/NxvFile.h"
#include "nexrad/Grid/FinerBox.h"
#include "nexrad/Grid/GriddedVolume.h"
#include "nexrad/System/Error.h"
#include "nexrad/System/MessageText.h"
#include "vtkNexradFieldData.h"
#include "vtkNexradImageConversion.h"
#include "vtkNexradMessages.h"
#include "vtkNexradVoxels.h"

#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkXMLImageDataReader.h>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <system_error>
#include <utility>

namespace fs = std::filesystem;
namespace nexrad
{
namespace
{

bool EndsWith(const fs::path& path, const std::string& ending)
{
  const std::string name = path.filename().string();
  return name.size() > ending.size() &&
         name.compare(name.size() - ending.size(), ending.size(), ending) == 0;
}

bool IsVolumeFile(const fs::path& path)
{
  return EndsWith(path, ".nxv") || EndsWith(path, ".vti");
}

bool IsIndex(const fs::path& path)
{
  return EndsWith(path, ".nxv.series");
}

vtkSmartPointer<vtkImageData> ReadVti(const fs::path& path)
{
  vtkNew<vtkXMLImageDataReader> reader;
  vtkNexradMessages messages;
  messages.Watch(reader);
  reader->SetFileName(path.c_str());
  if (!fs::is_regular_file(path) || reader->CanReadFile(path.c_str()) == 0)
  {
    throw Error(path.string() + ": not a VTK XML image file");
  }
  reader->Update();
  if (!messages.Errors().empty())
  {
    throw FileError(path, messages.Errors().front());
  }
  return reader->GetOutput();
}

// What has to be known of a volume file before it is drawn: time and grid. A .vti has to be read
// for it.
GriddedVolume Describe(const fs::path& path)
{
  if (EndsWith(path, ".nxv"))
  {
    return ReadNxvHeader(path);
  }
  const auto image = ReadVti(path);
  const auto seconds = vtkNexradGetValue(image->GetFieldData(), "TimeValue");
  if (!seconds)
  {
    throw Error(path.string() + ": has no time (field data TimeValue); merge with nexrad3d grid");
  }
  GriddedVolume volume;
  volume.time = FromSeconds(*seconds);
  volume.grid = vtkNexradImageToGrid(image);
  return volume;
}

// What drawing an image makes of a voxel: the words of its texture, before and behind their way to
// the graphics memory.
constexpr std::size_t pictureBytesPerVoxel = 4;

// A voxel takes twice its bytes of a texture: its value, and whether it is visible.
constexpr double textureShare = 2.0;

bool FitsAsWhole(const NxvReadOptions& options, std::size_t bytesPerVoxel, double memory)
{
  constexpr int mostAlongAxis = 2048; // more than a picture has pixels
  const VoxelBlock& block = *options.block;
  const int most = std::max({block.Size(0), block.Size(1), block.Size(2)});
  return most <= mostAlongAxis &&
         textureShare * static_cast<double>(block.VoxelCount() * bytesPerVoxel) <= memory;
}

// Of parts that are all alike the slices store one. They draw codes; VTK's ray caster draws values.
bool FitsInPages(const fs::path& path, const NxvReadOptions& options, double memory)
{
  constexpr double sharedTexels = 1.15; // of neighbouring pages
  constexpr double timesAsMuch = 2.5;   // bytes of the computer
  return static_cast<double>(options.block->VoxelCount()) <= timesAsMuch * memory &&
         textureShare * sharedTexels * static_cast<double>(CountVoxelsThatDiffer(path, options)) <=
           memory;
}

// A volume file, and the index that names it; without one, an empty path.
struct TimedFile
{
  Time time;
  fs::path path;
  fs::path index;
};
using TimedFiles = std::vector<TimedFile>;

// Does what reads a file. An error names the file, and before it the index that the user named.
template <typename Work>
auto NamingTheIndex(const TimedFile& file, const Work& work)
{
  try
  {
    return work(file.path);
  }
  catch (const Error& problem)
  {
    std::string line = problem.what();
    const std::string path = file.path.string();
    line = line.rfind(path, 0) == 0 ? line : path + ": " + line;
    throw Error(file.index.empty() ? line : file.index.string() + ": " + line);
  }
}

void AddIndex(TimedFiles& files, const fs::path& index)
{
  for (const auto& [name, seconds] : ReadNxvSeries(index))
  {
    files.push_back({FromSeconds(seconds), index.parent_path() / name, index});
  }
}

void AddFolder(TimedFiles& files, const fs::path& folder)
{
  std::set<fs::path> names;
  for (const auto& entry : fs::directory_iterator(folder))
  {
    const fs::path name = entry.path().filename();
    if (IsVolumeFile(name) && name.string().front() != '.')
    {
      names.insert(entry.path());
    }
  }
  std::optional<GridSpecification> grid;
  for (const fs::path& name : names)
  {
    const GriddedVolume volume = Describe(name);
    if (grid && *grid != volume.grid)
    {
      throw Error(folder.string() + ": holds volumes of different runs: " +
                  names.begin()->filename().string() + " has " + GridText(*grid) + ", " +
                  name.filename().string() + " has " + GridText(volume.grid) +
                  "; name the index of one run (volumes.nxv.series), or its volumes");
    }
    grid = volume.grid;
    files.push_back({volume.time, name, {}});
  }
}

// Of the moments that a file has, those that are read, the one that is shown first.
std::vector<MomentName> ChooseMoments(
  const VolumeFileRequest& request, const std::vector<MomentName>& own)
{
  std::vector<MomentName> chosen = request.moments;
  const auto add = [&chosen](MomentName moment)
  {
    if (std::find(chosen.begin(), chosen.end(), moment) == chosen.end())
    {
      chosen.push_back(moment);
    }
  };
  if (chosen.empty())
  {
    add(own.front());
  }
  if (request.colours)
  {
    add(*request.colours);
  }
  for (std::size_t i = 0; request.all && i < own.size(); ++i)
  {
    add(own[i]);
  }
  return chosen;
}

// Those of an image's arrays that are moments.
std::vector<MomentName> MomentsOf(vtkImageData* image)
{
  std::vector<MomentName> moments;
  for (const MomentName moment : KnownMoments)
  {
    if (image->GetPointData()->HasArray(ToString(moment)) != 0)
    {
      moments.push_back(moment);
    }
  }
  return moments;
}

// An image with the first of the moments as its first, where that is another one.
vtkSmartPointer<vtkImageData> Showing(
  const std::vector<MomentName>& wanted, vtkSmartPointer<vtkImageData> image)
{
  if (wanted.empty() || vtkNexradScalarsName(image) == ToString(wanted.front()))
  {
    return image;
  }
  std::vector<GriddedVolume> moments = SplitMoments(vtkNexradImageToVolume(image));
  const auto shown = std::find_if(moments.begin(), moments.end(),
    [&](const GriddedVolume& moment) { return moment.moment == wanted.front(); });
  if (shown == moments.end())
  {
    throw Error("the volume has no " + std::string(ToString(wanted.front())));
  }
  std::rotate(moments.begin(), shown, moments.end());
  auto turned = vtkSmartPointer<vtkImageData>::New();
  vtkNexradVolumeToImage(JoinMoments(std::move(moments)), turned);
  return turned;
}

class VolumeFiles : public VolumeSeries
{
public:
  VolumeFiles(TimedFiles timedFiles, VolumeFileRequest fileRequest)
    : files(std::move(timedFiles))
    , request(std::move(fileRequest))
  {
    std::stable_sort(
      files.begin(), files.end(), [](const auto& a, const auto& b) { return a.time < b.time; });
    for (const TimedFile& file : files)
    {
      times.push_back(file.time);
    }
  }

  const std::vector<Time>& Times() const override { return times; }
  bool AllowCodes(bool allowed) override { return codes.exchange(allowed) != allowed; }
  std::vector<MomentName> Moments() const override
  {
    return NamingTheIndex(files.front(), [](const fs::path& first)
      { return EndsWith(first, ".nxv") ? ReadNxvMoments(first) : MomentsOf(ReadVti(first)); });
  }

  vtkSmartPointer<vtkImageData> Load(std::size_t index, const Progress&) override
  {
    const auto load = [this](const fs::path& path)
    {
      return EndsWith(path, ".vti")
               ? Showing(request.moments, ReadVti(path))
               : this->ReadPart(path, this->FindWhole(path, ReadNxvLevels(path)));
    };
    return NamingTheIndex(files[index], load);
  }

  vtkSmartPointer<vtkImageData> LoadBox(
    std::size_t index, const BoxRequest& box, const Progress&) override
  {
    const auto load = [&](const fs::path& path)
    {
      const Levels levels = EndsWith(path, ".vti") ? Levels() : ReadNxvLevels(path);
      if (levels.empty() || this->FindWhole(path, levels).options.level == 0)
      {
        throw Error("all of its voxels are drawn; finer ones are merged from radar files alone");
      }
      if (box.followedFrom)
      {
        throw Error("a box moves with the echo of radar files alone; leave out --follow-from");
      }
      CheckPlaceUnit(request.boxUnit, PlaceUnitOf(levels.front().axes), "the box is");
      return this->ReadPart(path, this->FindBox(path, levels, box));
    };
    return NamingTheIndex(files[index], load);
  }

  bool LeavesOutFiner(std::size_t index) const override
  {
    return NamingTheIndex(files[index],
      [this](const fs::path& path) {
        return EndsWith(path, ".nxv") &&
               this->FindWhole(path, ReadNxvLevels(path)).options.level > 0;
      });
  }

  std::string Contents(std::size_t index) const override
  {
    const fs::path& path = files[index].path;
    std::error_code gone;
    const auto written = fs::last_write_time(path, gone).time_since_epoch().count();
    const std::uintmax_t bytes = gone ? 0 : fs::file_size(path, gone);
    return gone ? std::string()
                : path.string() + ' ' + std::to_string(written) + ' ' + std::to_string(bytes);
  }

private:
  using Levels = std::vector<GridSpecification>;

  static constexpr double partOfWhole = 0.25; // of the texture memory; a box may take the rest

  // What is read of a file, and whether as codes where that can be.
  struct Part
  {
    NxvReadOptions options;
    bool codes = false;
  };

  // Whether voxels of so many bytes fit into the texture memory.
  using Fits = std::function<bool(const NxvReadOptions& options, std::size_t bytesPerVoxel)>;

  // Of the finest level of which the block that `blockOf` names fits, that block; without one, of
  // the coarsest. Nothing is asked of the first `from` levels.
  Part FindPart(const fs::path& path, const Levels& levels, std::size_t from,
    const std::function<VoxelBlock(const GridSpecification&)>& blockOf, const Fits& fits) const
  {
    Part part;
    part.codes = codes;
    NxvReadOptions& options = part.options;
    options.moments = ChooseMoments(request, ReadNxvMoments(path));
    options.bytesBesides = pictureBytesPerVoxel;
    const std::size_t bytes =
      part.codes && HasNxvCodes(path, options) ? 1 : sizeof(float) * options.moments.size();
    options.level = from;
    options.block = blockOf(levels[from]);
    while (options.level + 1 < levels.size() && !request.allVoxels && !fits(options, bytes))
    {
      ++options.level;
      options.block = blockOf(levels[options.level]);
    }
    return part;
  }

  Part FindWhole(const fs::path& path, const Levels& levels) const
  {
    const bool coarsest = request.fewVoxels && IsNxvInBricks(path);
    return this->FindPart(path, levels, coarsest ? levels.size() - 1 : 0, VoxelBlock::Of,
      [this](const NxvReadOptions& options, std::size_t bytes)
      { return FitsAsWhole(options, bytes, partOfWhole * this->TextureMemory()); });
  }

  Part FindBox(const fs::path& path, const Levels& levels, const BoxRequest& box) const
  {
    std::size_t from = 0;
    while (from + 1 < levels.size() && IsFinerThanAsked(levels[from], box))
    {
      ++from;
    }
    return this->FindPart(
      path, levels, from,
      [&box](const GridSpecification& level) { return VoxelsOfBox(level, box); },
      [this, &path](const NxvReadOptions& options, std::size_t bytes)
      {
        const double memory = (1.0 - partOfWhole) * this->TextureMemory();
        return bytes == 1 ? FitsInPages(path, options, memory)
                          : FitsAsWhole(options, bytes, memory);
      });
  }

  double TextureMemory() const { return static_cast<double>(request.textureMemory); }

  static vtkSmartPointer<vtkImageData> ReadPart(const fs::path& path, const Part& part)
  {
    auto image = vtkSmartPointer<vtkImageData>::New();
    vtkNexradReadVolumeFile(path.string(), part.options, part.codes, image);
    return image;
  }

  TimedFiles files;
  const VolumeFileRequest request;
  std::vector<Time> times;
  std::atomic<bool> codes = false;
};

bool HoldsVolumes(const fs::path& path)
{
  std::error_code ignored;
  if (!fs::is_directory(path, ignored))
  {
    return IsVolumeFile(path) || IsIndex(path);
  }
  const fs::directory_iterator entries(path, ignored);
  return std::any_of(begin(entries), end(entries),
    [](const fs::directory_entry& entry) { return IsVolumeFile(entry.path()); });
}

} // namespace

bool AreVolumes(const std::vector<fs::path>& paths)
{
  const auto count = std::count_if(paths.begin(), paths.end(), HoldsVolumes);
  if (count != 0 && count != static_cast<std::ptrdiff_t>(paths.size()))
  {
    throw Error("the inputs are volumes and radar files; draw one or the other");
  }
  return count != 0;
}

std::unique_ptr<VolumeSeries> OpenVolumeFiles(
  const std::vector<fs::path>& inputs, const VolumeFileRequest& request)
{
  TimedFiles files;
  for (const fs::path& input : inputs)
  {
    if (!fs::exists(input))
    {
      throw Error(input.string() + ": does not exist");
    }
    if (fs::is_directory(input))
    {
      AddFolder(files, input);
    }
    else if (IsIndex(input))
    {
      AddIndex(files, input);
    }
    else
    {
      files.push_back({Describe(input).time, input, {}});
    }
  }
  if (files.empty())
  {
    throw Error(inputs.front().string() + ": lists no volume");
  }
  return std::make_unique<VolumeFiles>(std::move(files), request);
}

} // namespace nexrad
