// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Codec/NxvPackedVolume.h"

#include "nexrad/Codec/JsonText.h"
#include "nexrad/Codec/NxvArrays.h"
#include "nexrad/Codec/NxvBricks.h"
#include "nexrad/Codec/NxvInput.h"
#include "nexrad/Codec/NxvOutput.h"
#include "nexrad/System/Error.h"

#include <algorithm>
#include <numeric>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>

namespace nexrad
{

namespace
{

// Two voxels with the moments and ancillary arrays of a file, and with the states that codes do not
// tell: they have all arrays that a band can have.
GriddedVolume VolumeOfAllArrays(const NxvHeader& header)
{
  std::vector<GriddedVolume> moments;
  for (const NxvArray& array : header.arrays)
  {
    const auto moment = ParseMomentName(array.name);
    if (!moment)
    {
      continue;
    }
    GriddedVolume volume = header.volume;
    volume.grid.dimensions = {2, 1, 1};
    volume.moment = *moment;
    volume.fill = static_cast<float>(array.fill);
    volume.values.assign(2, volume.fill);
    volume.states = {VoxelState::RangeFolded, VoxelState::Filtered};
    const auto add = [&](const std::string& name, auto& values)
    {
      const bool has = std::any_of(header.arrays.begin(), header.arrays.end(),
        [&](const NxvArray& each) { return each.name == AncillaryArrayName(*moment, name); });
      using Value = typename std::decay_t<decltype(values)>::value_type;
      values.assign(has ? 2 : 0, static_cast<Value>(name == "site" ? AncillaryArrays::NoSite : 0));
    };
    ForEachAncillaryArray(volume.ancillary, add);
    moments.push_back(std::move(volume));
  }
  return JoinMoments(std::move(moments));
}

// All arrays of a level that has the moments of a volume.
std::vector<NxvPackedArray> ArraysLike(
  const GriddedVolume& volume, const GridSpecification& grid, bool exact)
{
  std::vector<NxvPackedArray> arrays;
  const std::size_t bricks = CountBricks(grid.dimensions, NxvBrickSize);
  const NxvAddArray add = [&](const NxvArray& array, std::size_t, DeflateSearch search,
                            const ByteSource&) { arrays.emplace_back(array, search, bricks); };
  AddBandArrays(add, volume, exact);
  for (const GriddedVolume& further : volume.further)
  {
    AddBandArrays(add, further, exact);
  }
  return arrays;
}

// The array of a level that one of a file is.
NxvPackedArray& FindPacked(NxvPackedLevel& level, const NxvArray& array)
{
  const auto found = std::find_if(level.arrays.begin(), level.arrays.end(),
    [&array](const NxvPackedArray& each) { return each.array.name == array.name; });
  const auto meaning = [](const NxvArray& each)
  { return std::tie(each.type, each.unit, each.offset, each.scale, each.fill); };
  if (array.storage != NxvStorage::Bricks || array.brick != NxvBrickSize)
  {
    throw Error("it must be in bricks of 64 x 64 x 8 voxels");
  }
  if (found == level.arrays.end() || meaning(found->array) != meaning(array))
  {
    throw Error("it must be one that volumes in bricks are written with");
  }
  return *found;
}

// Reads one array, all of which is in memory while it is checked.
void ReadPackedArray(
  NxvInput& file, std::uint64_t offset, const NxvArray& array, NxvPackedLevel& level)
{
  NxvPackedArray& packed = FindPacked(level, array);
  const std::vector<std::uint8_t> payload = file.ReadAll(offset, array.length);
  if (Crc32(payload.data(), payload.size()) != array.crc32)
  {
    throw Error("its CRC-32 is wrong");
  }
  packed.bricks = ReadPackedBricks(array, level.grid.dimensions,
    [&payload](std::uint64_t from, std::size_t size)
    {
      const auto begin = payload.begin() + static_cast<std::ptrdiff_t>(from);
      return std::vector<std::uint8_t>(begin, begin + static_cast<std::ptrdiff_t>(size));
    });
}

// Reads the arrays of a level, the first of which begins at `offset`, which becomes their end.
void ReadPackedArrays(
  NxvInput& file, std::uint64_t& offset, const std::vector<NxvArray>& arrays, NxvPackedLevel& level)
{
  for (const NxvArray& array : arrays)
  {
    try
    {
      ReadPackedArray(file, offset, array, level);
    }
    catch (const Error& problem)
    {
      RefuseNxv(offset, "array \"" + Excerpt(array.name) + "\": " + problem.what());
    }
    offset += array.length;
  }
  for (const NxvPackedArray& each : level.arrays)
  {
    const auto isIt = [&each](const NxvArray& array) { return array.name == each.array.name; };
    const auto count = std::count_if(arrays.begin(), arrays.end(), isIt);
    if (count > 1 || (count == 0 && !NxvMayBeLeftOut(each.array)))
    {
      throw Error("the array \"" + each.array.name + "\" must be there once, in all levels");
    }
  }
}

void RequireUsualLevels(const NxvHeader& header)
{
  const std::vector<VoxelsInOne> usual = CoarserLevels(header.volume.grid);
  const auto same = [](const NxvLevel& level, const VoxelsInOne& voxels)
  { return level.voxels == voxels; };
  if (!std::equal(header.levels.begin(), header.levels.end(), usual.begin(), usual.end(), same))
  {
    throw Error("its levels must be those that volumes in bricks are written with");
  }
}

// Before memory is taken for them.
void RequireFewBricks(const GridSpecification& grid)
{
  constexpr std::size_t most = std::size_t(1) << 20; // sixteen times those of 2^31 voxels
  const std::size_t bricks = CountBricks(grid.dimensions, NxvBrickSize);
  if (bricks > most)
  {
    throw Error(std::to_string(bricks) + " bricks in an array: must be " + std::to_string(most) +
                " or fewer");
  }
}

NxvPackedVolume ReadPackedVolume(NxvInput& file)
{
  const NxvContent content = OpenNxv(file);
  const NxvHeader& header = content.header;
  GriddedVolume volume = VolumeOfAllArrays(header);
  NxvPackedVolume packed;
  packed.exact = header.arrays.front().type == NxvType::Float32;
  const GridSpecification& grid = header.volume.grid;
  std::uint64_t offset = content.payloads;
  const auto read = [&](const VoxelsInOne& voxels, const std::vector<NxvArray>& arrays)
  {
    const GridSpecification coarser = CoarserGrid(grid, voxels);
    RequireFewBricks(coarser);
    packed.levels.push_back({coarser, voxels, ArraysLike(volume, coarser, packed.exact)});
    ReadPackedArrays(file, offset, arrays, packed.levels.back());
  };
  read({1, 1, 1}, header.arrays);
  RequireUsualLevels(header);
  volume.ancillary = {};
  for (GriddedVolume& further : volume.further)
  {
    further.ancillary = {};
  }
  for (const NxvLevel& level : header.levels)
  {
    read(level.voxels, level.arrays);
  }
  return packed;
}

// The first row of bricks that a file needs the array for; past the last one: none.
std::size_t FirstBand(const NxvPackedArray& packed, const GridSpecification& grid)
{
  if (!NxvMayBeLeftOut(packed.array))
  {
    return 0;
  }
  const auto [x, y, z] = BricksAlong(grid.dimensions, NxvBrickSize);
  const std::uint32_t leftOut = NxvLeftOutValue(packed.array);
  const auto needed = std::find_if(packed.bricks.begin(), packed.bricks.end(),
    [leftOut](const NxvBrick& brick) { return !brick.stream.empty() || brick.value != leftOut; });
  return static_cast<std::size_t>(needed - packed.bricks.begin()) / static_cast<std::size_t>(x * z);
}

// The arrays that a file of a level has, in the order in which its bands would add them.
std::vector<const NxvPackedArray*> ArraysToWrite(const NxvPackedLevel& level)
{
  const auto bands = static_cast<std::size_t>(BricksAlong(level.grid.dimensions, NxvBrickSize)[1]);
  std::vector<std::pair<std::size_t, const NxvPackedArray*>> found;
  for (const NxvPackedArray& each : level.arrays)
  {
    const std::size_t first = FirstBand(each, level.grid);
    if (first < bands)
    {
      found.emplace_back(first, &each);
    }
  }
  std::stable_sort(found.begin(), found.end(),
    [](const auto& one, const auto& other) { return one.first < other.first; });
  std::vector<const NxvPackedArray*> arrays;
  for (const auto& each : found)
  {
    arrays.push_back(each.second);
  }
  return arrays;
}

std::size_t StreamBytes(const NxvPackedArray& packed)
{
  return std::accumulate(packed.bricks.begin(), packed.bricks.end(), std::size_t(0),
    [](std::size_t bytes, const NxvBrick& brick) { return bytes + brick.stream.size(); });
}

std::vector<NxvBrickPayload> PayloadsOf(const std::vector<const NxvPackedArray*>& arrays)
{
  std::vector<NxvBrickPayload> payloads;
  for (const NxvPackedArray* each : arrays)
  {
    payloads.push_back({each->array, {}, {}});
    NxvBrickPayload& payload = payloads.back();
    payload.bricks.reserve(StreamBytes(*each));
    for (const NxvBrick& brick : each->bricks)
    {
      payload.Append(brick);
    }
  }
  return payloads;
}

} // namespace

NxvPackedArray::NxvPackedArray(const NxvArray& theArray, DeflateSearch theSearch, std::size_t count)
  : array(theArray)
  , search(theSearch)
  , bricks(count, NxvBrick{{}, NxvLeftOutValue(theArray)})
{
  array.storage = NxvStorage::Bricks;
  array.brick = NxvBrickSize;
}

NxvPackedVolume NxvPackedVolume::Read(const std::filesystem::path& path)
{
  return NamingTheFile(path,
    [&path]
    {
      NxvInput file(path);
      return ReadPackedVolume(file);
    });
}

void NxvPackedVolume::Write(
  const std::filesystem::path& path, const GriddedVolume& description) const
{
  NxvHeader header;
  header.volume = WithoutVoxels(description);
  header.volume.grid = levels.front().grid;
  NxvPayload payload;
  std::vector<std::vector<NxvBrickPayload>> payloads; // which the file is written from
  for (const NxvPackedLevel& level : levels)
  {
    payloads.push_back(PayloadsOf(ArraysToWrite(level)));
    std::vector<NxvArray> arrays;
    for (NxvBrickPayload& each : payloads.back())
    {
      arrays.push_back(each.Finish(payload));
    }
    if (&level == &levels.front())
    {
      header.arrays = std::move(arrays);
    }
    else
    {
      header.levels.push_back({level.voxels, std::move(arrays)});
    }
  }
  WriteNxvFile(path, header, payload);
}

std::size_t NxvPackedVolume::MemoryBytes() const
{
  std::size_t bytes = 0;
  for (const NxvPackedLevel& level : levels)
  {
    for (const NxvPackedArray& each : level.arrays)
    {
      bytes += each.bricks.size() * sizeof(NxvBrick) + StreamBytes(each);
    }
  }
  return bytes;
}

} // namespace nexrad
