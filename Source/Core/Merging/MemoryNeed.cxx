// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Merging/MemoryNeed.h"

#include "nexrad/Archives/StoredFiles.h"
#include "nexrad/Compression/DecodingBudget.h"
#include "nexrad/Grid/GriddedVolume.h"
#include "nexrad/Grid/SiteGeometry.h"
#include "nexrad/Gridding/BeamMerge.h"
#include "nexrad/Level2/Level2File.h"
#include "nexrad/Merging/Store.h"
#include "nexrad/Model/SiteTable.h"
#include "nexrad/Settings/ValueTexts.h"
#include "nexrad/System/Error.h"
#include "nexrad/System/MachineMemory.h"
#include "nexrad/Thesis/ThesisMerge.h"

#include <algorithm>
#include <string>

namespace fs = std::filesystem;

namespace nexrad
{

namespace
{

constexpr std::size_t mebibyte = std::size_t(1) << 20;

// The program with VTK's libraries and the tables of the decoders.
constexpr std::size_t programBytes = 80 * mebibyte;

// Bytes for each byte of a file of the archive in records of bzip2.
// Documentation/User/6-benchmarks.md compares the sum with what runs took.
constexpr std::size_t decodedBytes = 16;    // of a file while it is decoded, with its polar data
constexpr std::size_t furtherBytes = 8;     // and of each moment but the first
constexpr double readyBytes = 5.2;          // of a moment that is ready for merges
constexpr double mostMeans = 4.9;           // of its means, for voxels twice as wide as most gates
constexpr double widthOfMostMeans = 500.0;  // m, of these voxels; twice the width halves the means
constexpr std::size_t leastFile = mebibyte; // smaller files stand for the start of larger ones

// How many times as large a file of messages in gzip is: of 30 of the archive 1.10 to 1.48.
constexpr double sizeInGzip = 1.2;

// Volumes of a radar that a time takes, and one of the time before.
constexpr std::size_t volumesOfARadar = 4;

// Bytes of all moments that are ready for merges at a time, where one has so many for each byte of
// its file.
std::size_t ReadyBytes(
  const MergeOptions& options, const InputSizes& inputs, unsigned threads, double ofAByte)
{
  const std::size_t ahead = FilesAhead * threads;
  const std::size_t held = std::min(inputs.files, volumesOfARadar * inputs.radars + ahead);
  const std::size_t stored = held * std::max(inputs.fileBytes, leastFile) * options.moments.size();
  return static_cast<std::size_t>(static_cast<double>(stored) * ofAByte);
}

std::size_t RayBytes(const MergeOptions& options, const InputSizes& inputs, unsigned threads)
{
  const std::size_t decoding = std::min<std::size_t>(inputs.files, threads);
  const std::size_t further = furtherBytes * (options.moments.size() - 1);
  return std::max(inputs.fileBytes, leastFile) * decoding * (decodedBytes + further) +
         ReadyBytes(options, inputs, threads, readyBytes);
}

// `width` is that of the voxels, m; 0 where it is not known: then they take the most.
std::size_t MeansBytes(
  const MergeOptions& options, const InputSizes& inputs, unsigned threads, double width)
{
  if (options.method != MergeMethod::Beam || !options.beam.means)
  {
    return 0;
  }
  const double part = std::min(1.0, widthOfMostMeans / std::max(width, widthOfMostMeans));
  return ReadyBytes(options, inputs, threads, mostMeans * part);
}

// The use of merges of which there may be one alone: then no volume of another time is there.
VolumeUse UseOf(const MergeOptions& options, const InputSizes& inputs, const VolumeUse& use)
{
  const bool oneTime = options.time || (options.begin && options.begin == options.end) ||
                       (inputs.files == 1 && !options.step && !options.begin && !options.end);
  return {oneTime ? 0 : use.others, use.bytesAVoxel, use.rows, use.libraries};
}

std::size_t VoxelBytes(
  const MergeOptions& options, const std::array<int, 3>& dimensions, const VolumeUse& use)
{
  const std::size_t ofMoments = BytesOfAVoxel(options);
  const bool thesis = options.method == MergeMethod::Thesis;
  const std::size_t ofMerge = thesis ? ThesisBytesAVoxel : 0;
  double voxels = static_cast<double>(ofMoments * (1 + use.others) + use.bytesAVoxel + ofMerge);
  for (const int size : dimensions)
  {
    voxels *= static_cast<double>(size);
  }
  if (use.rows > 0 && use.rows < dimensions[1])
  {
    voxels *= static_cast<double>(use.rows) / static_cast<double>(dimensions[1]);
  }
  constexpr double most = 1e18; // whatever the dimensions, the sum of the needs can be counted
  return static_cast<std::size_t>(std::min(voxels, most));
}

// The largest dimensions of the same proportions whose voxels take no more than `bytes`.
std::array<int, 3> DimensionsWithin(
  const MergeOptions& options, const VolumeUse& use, double geometry, double bytes)
{
  std::array<int, 3> fitting = {0, 0, 0};
  double lower = 0.0; // that fit, and do not fit, parts of the dimensions asked for
  double upper = 1.0;
  for (int halving = 0; halving < 40; ++halving)
  {
    const double part = 0.5 * (lower + upper);
    std::array<int, 3> dimensions = options.grid.dimensions;
    for (int& size : dimensions)
    {
      size = std::max(1, static_cast<int>(part * size));
    }
    const auto voxels = static_cast<double>(VoxelBytes(options, dimensions, use));
    const bool fits = voxels + geometry * part * part <= bytes;
    (fits ? lower : upper) = part;
    fitting = fits ? dimensions : fitting;
  }
  return fitting;
}

[[noreturn]] void Refuse(const MergeOptions& options, const MemoryNeed& need, const VolumeUse& use)
{
  const MemoryLimit& limit = options.memoryLimit;
  const std::size_t further = options.moments.size() - 1;
  std::string text = "a grid of " + DimensionsText(options.grid.dimensions) + " voxels" +
                     (further > 0 ? " with " + std::to_string(further + 1) + " moments" : "") +
                     " needs " + MemoryText(need.Total()) + " of memory; " +
                     (limit.option.empty() ? "there is " + MemoryText(limit.bytes)
                                           : limit.option + " allows " + MemoryText(limit.bytes));
  const std::size_t fixed = need.rays + need.means + need.program;
  const std::array<int, 3> fitting =
    limit.bytes > fixed ? DimensionsWithin(options, use, static_cast<double>(need.geometry),
                            static_cast<double>(limit.bytes - fixed))
                        : std::array<int, 3>{0, 0, 0};
  if (fitting[0] > 0)
  {
    text += "; --dims " + DimensionsText(fitting) + " fits";
  }
  else
  {
    text += ", of which the rays and the program need " + MemoryText(fixed);
  }
  if (!limit.option.empty())
  {
    const std::size_t enough = need.Total() / mebibyte + 1;
    text += (fitting[0] > 0 ? ", and so does " : "; what fits is ") + limit.option + " " +
            std::to_string(enough) + "MiB";
  }
  throw Error(text);
}

// Refuses what needs more than the limit even at the `least`.
const MemoryNeed& Require(
  const MergeOptions& options, const MemoryNeed& need, std::size_t least, const VolumeUse& use)
{
  if (options.memoryLimit.bytes > 0 && least > options.memoryLimit.bytes)
  {
    Refuse(options, need, use);
  }
  return need;
}

} // namespace

std::size_t BytesOfAVoxel(const MergeOptions& options)
{
  std::size_t further = 0;
  if (options.beam.ancillary)
  {
    const AncillaryArrays none;
    ForEachAncillaryArray(none, [&further](const char*, const auto& values)
      { further += sizeof(typename std::decay_t<decltype(values)>::value_type); });
  }
  std::size_t bytes = 0;
  for (const MomentName moment : options.moments)
  {
    const bool coded = options.method == MergeMethod::Beam && HasCodes(options.beam, moment);
    bytes += further + (coded ? sizeof(std::uint8_t) : sizeof(float) + sizeof(VoxelState));
  }
  return bytes;
}

InputSizes SizesOf(const std::vector<fs::path>& paths, std::size_t radars)
{
  std::vector<std::pair<std::size_t, const fs::path*>> sizes;
  for (const fs::path& path : paths)
  {
    const std::uintmax_t size = StoredSize(path);
    if (size > 0) // 0: of folders
    {
      sizes.emplace_back(static_cast<std::size_t>(size), &path);
    }
  }
  InputSizes inputs;
  inputs.radars = radars;
  inputs.files = std::max<std::size_t>(1, paths.size());
  if (!sizes.empty())
  {
    const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
    std::nth_element(sizes.begin(), middle, sizes.end());
    const double inGzip = IsGzipOfMessages(*middle->second) ? sizeInGzip : 1.0;
    inputs.fileBytes =
      std::min(static_cast<std::size_t>(static_cast<double>(middle->first) / inGzip),
        Level2Options().maximumFileBytes);
  }
  return inputs;
}

MemoryNeed NeedOf(const MergeOptions& options, const std::array<int, 3>& dimensions,
  const InputSizes& inputs, unsigned threads, const VolumeUse& use)
{
  MemoryNeed need;
  need.voxels = VoxelBytes(options, dimensions, UseOf(options, inputs, use));
  need.rays = RayBytes(options, inputs, threads);
  need.program = programBytes + use.libraries;
  return need;
}

std::vector<Position> KnownPlaces(const std::optional<FilesByRadar>& headers)
{
  std::vector<Position> places;
  for (const auto& [radar, files] : headers.value_or(FilesByRadar()))
  {
    const KnownSite* site = FindSite(radar);
    if (site == nullptr)
    {
      return {};
    }
    places.push_back(site->position);
  }
  return places;
}

MemoryNeed RequireMemory(const MergeOptions& options, const InputSizes& inputs, unsigned threads,
  const VolumeUse& use, const std::vector<Position>& places)
{
  const std::array<int, 3>& dimensions = options.grid.dimensions;
  if (!places.empty())
  {
    return RequireMemory(
      options, inputs, threads, use, GridOf(options, places, DefaultRange), places);
  }
  MemoryNeed need = NeedOf(options, dimensions, inputs, threads, use);
  need.means = MeansBytes(options, inputs, threads, 0.0);
  const std::size_t least = need.Total();
  if (options.method == MergeMethod::Beam)
  {
    need.geometry = inputs.radars * SiteGeometry::MostMemoryBytes(dimensions);
  }
  return Require(options, need, least, UseOf(options, inputs, use));
}

MemoryNeed RequireMemory(const MergeOptions& options, const InputSizes& inputs, unsigned threads,
  const VolumeUse& use, const GridSpecification& grid, const std::vector<Position>& radars)
{
  MemoryNeed need = NeedOf(options, grid.dimensions, inputs, threads, use);
  if (options.method == MergeMethod::Beam)
  {
    need.geometry = GeometryBytes(grid, radars, use.rows);
  }
  const std::array<double, 2> voxel = VoxelExtent(grid, 0.5 * (grid.dimensions[1] - 1));
  need.means = MeansBytes(options, inputs, threads, std::min(voxel[0], voxel[1]));
  return Require(options, need, need.Total(), UseOf(options, inputs, use));
}

std::size_t FreeBytesOfAFile(const MergeOptions& options, unsigned threads)
{
  constexpr std::size_t memoryForAByte = 4; // of the budget, where quality control judges all of it
  constexpr std::size_t least = 4 * mebibyte;
  const std::size_t limit = options.memoryLimit.bytes;
  if (limit == 0)
  {
    return DecodingBudget::FreeBytes;
  }
  const std::size_t left = (limit - std::min(limit, programBytes)) / 2;
  return std::clamp(
    left / (memoryForAByte * std::max(1U, threads)), least, DecodingBudget::FreeBytes);
}

std::size_t MemoryForKeptRays(const MergeOptions& options, const MemoryNeed& need)
{
  const std::size_t limit = options.memoryLimit.bytes;
  const std::size_t left = limit - std::min(limit, need.Total());
  return limit > 0 ? std::min(options.memory, left) : options.memory;
}

} // namespace nexrad
