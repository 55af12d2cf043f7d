// SPDX-License-Identifier: BSD-3-Clause
#include "Volumes/VolumeFiles.h"

#include "Volumes/UnfinishedRun.h"
#include "nexrad/Merging/MergeSettings.h"
#include "nexrad/System/Error.h"
#include "vtkNexradThreads.h"

#include <optional>

namespace fs = std::filesystem;

namespace nexrad::application
{
namespace
{

std::optional<GridSpecification> GridIn(const fs::path& file)
{
  try
  {
    return ReadNxvHeader(file).grid;
  }
  catch (const Error&)
  {
    return std::nullopt;
  }
}

} // namespace

const char* ExtensionOf(VolumeFormat format)
{
  return format == VolumeFormat::Nxv ? ".nxv" : ".nc";
}

fs::path VolumeFileName(Time time, VolumeFormat format, const std::string& radar)
{
  return (radar.empty() ? "" : radar + "_") + FormatForFileName(time) + ExtensionOf(format);
}

void RequireSameGrid(
  const fs::path& folder, const std::set<std::string>& own, const GridSpecification& grid)
{
  for (const std::string& name : FilesIn(folder))
  {
    const bool isVolume = fs::path(name).extension() == ".nxv" && name.front() != '.';
    const auto other = isVolume && own.count(name) == 0 ? GridIn(folder / name) : std::nullopt;
    if (other && *other != grid)
    {
      throw Error(folder.string() + ": holds " + name + " with " + GridText(*other) +
                  ", and this run would add " + GridText(grid) +
                  "; remove the older volumes, or name another folder (-o)");
    }
  }
}

std::string RecipeOf(const std::string& command, const MergeOptions& options)
{
  std::string recipe = command;
  for (const OptionText& option : ToTexts(MergeSettings(), options))
  {
    recipe += '\n' + option.name + ' ' + option.value;
  }
  return recipe;
}

void WriteVolumeIndex(
  const fs::path& path, const std::vector<std::string>& files, const std::vector<Time>& times)
{
  NxvSeries index;
  for (std::size_t i = 0; i < times.size(); ++i)
  {
    index.emplace_back(files[i], ToSeconds(times[i]));
  }
  WriteNxvSeries(path, index);
}

bool AreInBricks(const VolumeFiles& files, const MergeOptions& options)
{
  double voxels = 1.0;
  for (const int size : options.grid.dimensions)
  {
    voxels *= size;
  }
  return files.format == VolumeFormat::Nxv && options.method == MergeMethod::Beam &&
         voxels > static_cast<double>(files.largestWhole);
}

bool AreCodes(const VolumeFiles& files, const MergeOptions& options)
{
  return files.format == VolumeFormat::Nxv && options.method == MergeMethod::Beam &&
         files.encoding.value_or(NxvEncoding::RadarSteps) == NxvEncoding::RadarSteps &&
         !AreInBricks(files, options); // of a band, coarser levels are made, which need values
}

TakeBand PackInto(NxvBandWriter& bricks)
{
  return [&bricks, loop = vtkNexradRangeLoop()](GriddedVolume band)
  {
    bricks.Add(band, loop);
    return band;
  };
}

VolumeUse UseOfWriting(const VolumeFiles& files, const MergeOptions& options)
{
  if (AreInBricks(files, options))
  {
    return {0, 0, NxvBandWriter::Rows};
  }
  if (files.format == VolumeFormat::Nxv)
  {
    // All is deflated piece by piece; what comes of exact values waits for the end of the file.
    const bool exact = files.encoding == NxvEncoding::Float;
    return {1, exact ? 2 * sizeof(float) : 0};
  }
  constexpr std::size_t ghostType = 1;
  constexpr std::size_t libraries = std::size_t(24) << 20; // of NetCDF and HDF5, with their buffers
  return {1, BytesOfAVoxel(options) + ghostType, 0, libraries};
}

} // namespace nexrad::application
