// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Codec/NxvReader.h"
#include "nexrad/Codec/LittleEndian.h"

#include "nexrad/Codec/JsonText.h"
#include "nexrad/Codec/NxvBricks.h"
#include "nexrad/Codec/NxvHeader.h"
#include "nexrad/Codec/NxvInput.h"
#include "nexrad/Codec/ThesisStream.h"
#include "nexrad/System/Error.h"
#include "nexrad/System/MachineMemory.h"
#include "nexrad/System/MessageText.h"

#include <algorithm>
#include <cstring>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>

namespace fs = std::filesystem;

namespace nexrad
{

namespace
{

using Bytes = std::vector<std::uint8_t>;

// One of the levels of what a file contains, as a volume of its own; 0: the volume itself. Throws
// Error for a level that the file does not have.
NxvContent LevelOf(NxvContent content, std::size_t level)
{
  std::vector<NxvLevel>& levels = content.header.levels;
  if (level > levels.size())
  {
    throw Error("the file has no level " + std::to_string(level) + "; its levels are 0 to " +
                std::to_string(levels.size()));
  }
  for (std::size_t i = 0; i < level; ++i)
  {
    for (const NxvArray& array : content.header.arrays)
    {
      content.payloads += array.length;
    }
    content.header.arrays = std::move(levels[i].arrays);
  }
  if (level > 0)
  {
    GridSpecification& grid = content.header.volume.grid;
    grid = CoarserGrid(grid, levels[level - 1].voxels);
    levels.clear();
  }
  return content;
}

bool HasByteCodes(const NxvArray& array)
{
  return array.type == NxvType::UInt7 || array.type == NxvType::UInt8;
}

// What codes of one byte stand for in a volume of this fill.
VoxelCodes ByteCodesOf(const NxvArray& array, float fill)
{
  const bool sevenBits = array.type == NxvType::UInt7;
  const MomentCode momentCode{1, array.offset, array.scale};
  VoxelCodes meaning;
  for (unsigned code = 0; code < VoxelCodes::Count; ++code)
  {
    const auto byte = static_cast<std::uint8_t>(code);
    VoxelState& state = meaning.states[code];
    state = sevenBits ? ThesisCode::StateOf(byte) : MomentCode::StateOf(code);
    if (sevenBits && code > ThesisCode::NotScannedCode)
    {
      state = VoxelState::NotScanned; // no voxel has such a code
    }
    meaning.values[code] = state == VoxelState::Echo ? momentCode.ValueOf(code) : fill;
  }
  return meaning;
}

// Of a voxel: a value, a state, and a code while it is decoded.
constexpr std::size_t bytesOfValues = sizeof(float) + sizeof(VoxelState) + 1;
constexpr std::size_t bytesOfCodes = 1;

void CheckMemory(const GridSpecification& grid, std::size_t bytesPerVoxel, std::size_t maximumBytes)
{
  if (grid.VoxelCount() > maximumBytes / bytesPerVoxel)
  {
    throw Error(std::to_string(grid.VoxelCount()) + " voxels of " + std::to_string(bytesPerVoxel) +
                " bytes need more memory than the " + std::to_string(maximumBytes) +
                " bytes allowed; merge it with fewer (--dims), or a part of it (--bounds)");
  }
}

bool IsWanted(
  const NxvArray& array, MomentName moment, const char* ancillary, const NxvReadOptions& options)
{
  const auto& names = options.leaveOut;
  return array.name == AncillaryArrayName(moment, ancillary) &&
         std::find(names.begin(), names.end(), array.name) == names.end();
}

// The moments of a file, in its order.
std::vector<MomentName> MomentsOf(const NxvHeader& header)
{
  std::vector<MomentName> moments;
  for (const NxvArray& array : header.arrays)
  {
    const auto moment = ParseMomentName(array.name);
    if (moment && std::find(moments.begin(), moments.end(), *moment) != moments.end())
    {
      throw Error("the file has two arrays \"" + Excerpt(array.name) + "\"");
    }
    if (moment)
    {
      moments.push_back(*moment);
    }
  }
  return moments;
}

// A moment's own array, of a moment that the file has.
const NxvArray& ArrayOf(const NxvHeader& header, MomentName moment)
{
  return *std::find_if(header.arrays.begin(), header.arrays.end(),
    [moment](const NxvArray& array) { return array.name == ToString(moment); });
}

std::vector<MomentName> WantedMoments(const NxvHeader& header, const NxvReadOptions& options)
{
  const std::vector<MomentName> own = MomentsOf(header);
  std::string names;
  for (const MomentName moment : own)
  {
    names += (names.empty() ? "" : ", ") + std::string(ToString(moment));
  }
  for (const MomentName moment : options.moments)
  {
    if (std::find(own.begin(), own.end(), moment) == own.end())
    {
      throw Error("the file has no " + std::string(ToString(moment)) + "; it has " + names);
    }
  }
  return options.moments.empty() ? own : options.moments;
}

// Bytes that a voxel takes in memory beside the value and the state of one moment, and a byte of
// its code while it is decoded: those of a wider code, of ancillary arrays and of further moments,
// and what the caller makes of each moment.
std::size_t FurtherBytes(const NxvHeader& header, const NxvReadOptions& options)
{
  const std::vector<MomentName> moments = WantedMoments(header, options);
  const bool wide = std::any_of(header.arrays.begin(), header.arrays.end(),
    [](const NxvArray& array) { return array.type == NxvType::UInt16; });
  const std::size_t ofMoment = sizeof(float) + sizeof(VoxelState) + options.bytesBesides;
  std::size_t bytes = options.bytesBesides + (wide ? 1 : 0) + (moments.size() - 1) * ofMoment;
  for (const MomentName moment : moments)
  {
    const auto count = [&](const char* name, const auto& values)
    {
      const auto wanted = [&](const NxvArray& array)
      { return IsWanted(array, moment, name, options); };
      const bool any = std::any_of(header.arrays.begin(), header.arrays.end(), wanted);
      bytes += any ? sizeof(typename std::decay_t<decltype(values)>::value_type) : 0;
    };
    ForEachAncillaryArray(header.volume.ancillary, count);
  }
  return bytes;
}

// A file that is being read, and what of it is wanted.
struct Reading
{
  NxvInput& file;
  const NxvContent& content;
  const NxvReadOptions& options;
  const VoxelBlock block; // that is wanted

  void Unpack(std::uint64_t offset, const NxvArray& array, std::uint8_t* target) const
  {
    ReadArray(file, offset, array, content.header.volume.grid, block, target, options.loop);
  }
};

void ReadValues(const Reading& reading, std::uint64_t offset, const NxvArray& array,
  std::vector<std::uint8_t>& values, std::size_t voxels)
{
  values.resize(voxels);
  reading.Unpack(offset, array, values.data());
}

void ReadValues(const Reading& reading, std::uint64_t offset, const NxvArray& array,
  std::vector<float>& values, std::size_t voxels)
{
  values.resize(voxels);
  auto* const bytes = reinterpret_cast<std::uint8_t*>(values.data());
  reading.Unpack(offset, array, bytes);
  for (std::size_t i = 0; i < voxels; ++i)
  {
    const std::uint32_t word = LittleEndian(bytes + i * sizeof(float));
    std::memcpy(&values[i], &word, sizeof(word));
  }
}

std::unique_ptr<std::uint8_t[]> ReadCodes(
  const Reading& reading, std::uint64_t offset, const NxvArray& array, std::size_t voxels)
{
  // Not set to 0 first: all of them are written.
  std::unique_ptr<std::uint8_t[]> codes(new std::uint8_t[voxels]);
  UseHugePages(codes.get(), voxels);
  reading.Unpack(offset, array, codes.get());
  return codes;
}

void ReadMoment(
  const Reading& reading, std::uint64_t offset, const NxvArray& array, GriddedVolume& volume)
{
  const std::size_t voxels = volume.grid.VoxelCount();
  if (HasByteCodes(array))
  {
    const auto codes = ReadCodes(reading, offset, array, voxels);
    volume.values.resize(voxels);
    volume.states.resize(voxels);
    ExpandCodes(ByteCodesOf(array, volume.fill), codes.get(), voxels, volume.values.data(),
      volume.states.data(), reading.options.loop);
    return;
  }
  if (array.type == NxvType::UInt16)
  {
    const MomentCode code{2, array.offset, array.scale};
    Bytes codes(code.bytes * voxels);
    reading.Unpack(offset, array, codes.data());
    code.DecodeAll(codes, volume);
    return;
  }
  ReadValues(reading, offset, array, volume.values, voxels);
  // Without an array of states a voxel with the fill value is taken for not scanned.
  volume.states.resize(voxels);
  std::transform(volume.values.begin(), volume.values.end(), volume.states.begin(),
    [&volume](float value)
    { return value == volume.fill ? VoxelState::NotScanned : VoxelState::Echo; });
}

// The two arrays that say more of a moment's states than its codes.
bool IsOfStates(const NxvArray& array, MomentName moment)
{
  return array.name == std::string(ToString(moment)) + "_state" && array.type == NxvType::UInt8;
}

bool IsOfFiltered(const NxvArray& array, MomentName moment)
{
  return array.name == std::string(ToString(moment)) + "_filtered" && array.type == NxvType::UInt8;
}

// The bytes of one of them, which must follow the moment.
Bytes ReadStateBytes(
  const Reading& reading, std::uint64_t offset, const NxvArray& array, const GriddedVolume& volume)
{
  const std::size_t voxels = volume.grid.VoxelCount();
  if (volume.states.size() != voxels)
  {
    throw Error("it must follow the array " + std::string(ToString(volume.moment)));
  }
  Bytes bytes;
  ReadValues(reading, offset, array, bytes, voxels);
  return bytes;
}

// Takes the states from their own array. With codes, it may only add what they cannot say. Without,
// a writer may have left any value where no echo is.
void ReadStates(const Reading& reading, std::uint64_t offset, const NxvArray& array,
  GriddedVolume& volume, bool fromCodes)
{
  const Bytes bytes = ReadStateBytes(reading, offset, array, volume);
  for (std::size_t i = 0; i < bytes.size(); ++i)
  {
    if (fromCodes && array.storage == NxvStorage::Bricks && bytes[i] == NxvStateAsCode)
    {
      continue;
    }
    const auto state = static_cast<VoxelState>(bytes[i]);
    const bool beyondCodes = state == VoxelState::RangeFolded || state == VoxelState::Filtered;
    const bool added = beyondCodes && volume.states[i] == VoxelState::NoEcho;
    if (bytes[i] > static_cast<std::uint8_t>(VoxelState::Filtered) ||
        (fromCodes && state != volume.states[i] && !added))
    {
      throw Error("state " + std::to_string(bytes[i]) + " of voxel " + std::to_string(i) +
                  (fromCodes ? " contradicts its code" : " is not known"));
    }
    volume.states[i] = state;
    volume.values[i] = state == VoxelState::Echo ? volume.values[i] : volume.fill;
  }
}

// Which of the voxels that hold no echo by code or state are filtered.
void ReadFiltered(
  const Reading& reading, std::uint64_t offset, const NxvArray& array, GriddedVolume& volume)
{
  const Bytes bytes = ReadStateBytes(reading, offset, array, volume);
  for (std::size_t i = 0; i < bytes.size(); ++i)
  {
    if (bytes[i] > 1 || (bytes[i] == 1 && volume.states[i] != VoxelState::NoEcho))
    {
      throw Error(std::to_string(bytes[i]) + " at voxel " + std::to_string(i) +
                  (bytes[i] > 1 ? " is neither 0 nor 1" : " contradicts its state"));
    }
    volume.states[i] = bytes[i] == 1 ? VoxelState::Filtered : volume.states[i];
  }
}

// Numbers of radars and sites are what they are; ages and weights are exact, or codes.
void ReadAncillaryArrayValues(const Reading& reading, std::uint64_t offset, const NxvArray& array,
  std::vector<std::uint8_t>& values, std::size_t voxels)
{
  if (array.type != NxvType::UInt8)
  {
    throw Error("its type must be uint8");
  }
  ReadValues(reading, offset, array, values, voxels);
}

void ReadAncillaryArrayValues(const Reading& reading, std::uint64_t offset, const NxvArray& array,
  std::vector<float>& values, std::size_t voxels)
{
  if (array.type == NxvType::Float32)
  {
    ReadValues(reading, offset, array, values, voxels);
    return;
  }
  Bytes codes;
  ReadAncillaryArrayValues(reading, offset, array, codes, voxels);
  values.resize(voxels);
  std::transform(codes.begin(), codes.end(), values.begin(),
    [&array](std::uint8_t code) { return static_cast<float>(array.offset + array.scale * code); });
}

// Reads the array when it is an ancillary array of the volume that is wanted.
void ReadAncillaryArray(
  const Reading& reading, std::uint64_t offset, const NxvArray& array, GriddedVolume& volume)
{
  const auto read = [&](const char* name, auto& values)
  {
    if (!IsWanted(array, volume.moment, name, reading.options))
    {
      return;
    }
    ReadAncillaryArrayValues(reading, offset, array, values, volume.grid.VoxelCount());
    CheckAncillaryArray(name, values, volume.sites.size());
  };
  ForEachAncillaryArray(volume.ancillary, read);
}

// Calls `read(offset, array)` for each of the arrays, and names the one that it refuses.
template <typename Read>
void ReadEachArray(const NxvContent& content, const Read& read)
{
  std::uint64_t offset = content.payloads;
  for (const NxvArray& array : content.header.arrays)
  {
    try
    {
      read(offset, array);
    }
    catch (const Error& problem)
    {
      RefuseNxv(offset, "array \"" + Excerpt(array.name) + "\": " + problem.what());
    }
    offset += array.length;
  }
}

GriddedVolume BeginMoment(const Reading& reading, MomentName moment)
{
  const NxvHeader& header = reading.content.header;
  GriddedVolume volume = header.volume;
  volume.grid = PartOf(volume.grid, reading.block);
  volume.moment = moment;
  volume.fill = static_cast<float>(ArrayOf(header, moment).fill);
  return volume;
}

void ReadArrayOfMoment(
  const Reading& reading, std::uint64_t offset, const NxvArray& array, GriddedVolume& volume)
{
  if (array.name == ToString(volume.moment))
  {
    ReadMoment(reading, offset, array, volume);
  }
  else if (IsOfStates(array, volume.moment))
  {
    const NxvArray& values = ArrayOf(reading.content.header, volume.moment);
    ReadStates(reading, offset, array, volume, values.type != NxvType::Float32);
  }
  else if (IsOfFiltered(array, volume.moment))
  {
    ReadFiltered(reading, offset, array, volume);
  }
  else
  {
    ReadAncillaryArray(reading, offset, array, volume);
  }
}

GriddedVolume ReadVoxels(const Reading& reading)
{
  const NxvHeader& header = reading.content.header;
  std::vector<GriddedVolume> moments;
  for (const MomentName moment : WantedMoments(header, reading.options))
  {
    moments.push_back(BeginMoment(reading, moment));
  }
  ReadEachArray(reading.content,
    [&](std::uint64_t offset, const NxvArray& array)
    {
      for (GriddedVolume& volume : moments)
      {
        ReadArrayOfMoment(reading, offset, array, volume);
      }
    });
  return JoinMoments(std::move(moments));
}

// Of a moment that has codes of one byte.
CodedVolume ReadCodedVoxels(const Reading& reading, MomentName moment)
{
  CodedVolume coded;
  coded.volume = BeginMoment(reading, moment);
  coded.meaning = ByteCodesOf(ArrayOf(reading.content.header, moment), coded.volume.fill);
  ReadEachArray(reading.content,
    [&](std::uint64_t offset, const NxvArray& array)
    {
      if (array.name == ToString(moment))
      {
        coded.codes = ReadCodes(reading, offset, array, coded.volume.grid.VoxelCount());
      }
      ReadAncillaryArray(reading, offset, array, coded.volume);
    });
  return coded;
}

// Checks what can be checked before voxels are read, which take so many bytes beside their further
// arrays. Bricks have check sums of their own: those of
// whole payloads are looked at only where all bricks are read.
Reading BeginReading(NxvInput& file, const NxvContent& content, const NxvReadOptions& options,
  std::size_t bytesOfVoxel)
{
  const GridSpecification& grid = content.header.volume.grid;
  const VoxelBlock block = options.block.value_or(VoxelBlock::Of(grid));
  const bool all = block == VoxelBlock::Of(grid);
  const std::vector<NxvArray>& arrays = content.header.arrays;
  const bool bricks = std::all_of(arrays.begin(), arrays.end(),
    [](const NxvArray& array) { return array.storage == NxvStorage::Bricks; });
  CheckMemory(PartOf(grid, bricks ? block : VoxelBlock::Of(grid)),
    bytesOfVoxel + FurtherBytes(content.header, options), options.maximumBytes);
  if (all || !bricks)
  {
    CheckNxvPayloads(file, content);
  }
  return {file, content, options, block};
}

// The one moment that is read, if it is one and has codes of one byte; with `allStates`, if these
// tell the states of all voxels.
std::optional<MomentName> CodedMoment(
  const NxvHeader& header, const NxvReadOptions& options, bool allStates)
{
  const std::vector<MomentName> wanted = WantedMoments(header, options);
  const MomentName moment = wanted.front();
  const auto isOfStates = [moment](const NxvArray& array)
  { return IsOfStates(array, moment) || IsOfFiltered(array, moment); };
  const bool coded =
    wanted.size() == 1 && HasByteCodes(ArrayOf(header, moment)) &&
    !(allStates && std::any_of(header.arrays.begin(), header.arrays.end(), isOfStates));
  return coded ? std::optional(moment) : std::nullopt;
}

// Does some work on a file and on what it contains, and names the file in what that throws.
template <typename Work>
auto WithContent(const fs::path& path, const Work& work)
{
  return NamingTheFile(path,
    [&path, &work]
    {
      NxvInput file(path);
      return work(file, OpenNxv(file));
    });
}

} // namespace

GriddedVolume ReadNxv(const fs::path& path, const NxvReadOptions& options)
{
  return WithContent(path,
    [&options](NxvInput& file, const NxvContent& whole)
    {
      const NxvContent content = LevelOf(whole, options.level);
      return ReadVoxels(BeginReading(file, content, options, bytesOfValues));
    });
}

std::optional<CodedVolume> ReadNxvCodes(
  const fs::path& path, const NxvReadOptions& options, bool allStates)
{
  return WithContent(path,
    [&options, allStates](NxvInput& file, const NxvContent& whole) -> std::optional<CodedVolume>
    {
      const NxvContent content = LevelOf(whole, options.level);
      const auto moment = CodedMoment(content.header, options, allStates);
      if (!moment)
      {
        return std::nullopt;
      }
      return ReadCodedVoxels(BeginReading(file, content, options, bytesOfCodes), *moment);
    });
}

bool HasNxvCodes(const fs::path& path, const NxvReadOptions& options)
{
  return WithContent(path, [&options](const NxvInput&, const NxvContent& whole)
    { return CodedMoment(LevelOf(whole, options.level).header, options, false).has_value(); });
}

bool IsNxvInBricks(const fs::path& path)
{
  return WithContent(path, [](const NxvInput&, const NxvContent& content)
    { return content.header.arrays.front().storage == NxvStorage::Bricks; });
}

std::size_t CountVoxelsThatDiffer(const fs::path& path, const NxvReadOptions& options)
{
  return WithContent(path,
    [&options](NxvInput& file, const NxvContent& whole)
    {
      const NxvContent content = LevelOf(whole, options.level);
      const GridSpecification& grid = content.header.volume.grid;
      const VoxelBlock block = options.block.value_or(VoxelBlock::Of(grid));
      const char* moment = ToString(WantedMoments(content.header, options).front());
      std::size_t voxels = block.VoxelCount();
      ReadEachArray(content,
        [&](std::uint64_t offset, const NxvArray& array)
        {
          if (array.name == moment && array.storage == NxvStorage::Bricks)
          {
            voxels = CountVoxelsThatDiffer(array, grid.dimensions, block, PayloadOf(file, offset));
          }
        });
      return voxels;
    });
}

GriddedVolume ReadNxvHeader(const fs::path& path)
{
  return WithContent(
    path, [](const NxvInput&, const NxvContent& content) { return content.header.volume; });
}

std::vector<GridSpecification> ReadNxvLevels(const fs::path& path)
{
  return WithContent(path,
    [](const NxvInput&, const NxvContent& content)
    {
      const GridSpecification& grid = content.header.volume.grid;
      std::vector<GridSpecification> grids{grid};
      for (const NxvLevel& level : content.header.levels)
      {
        grids.push_back(CoarserGrid(grid, level.voxels));
      }
      return grids;
    });
}

std::vector<MomentName> ReadNxvMoments(const fs::path& path)
{
  return WithContent(
    path, [](const NxvInput&, const NxvContent& content) { return MomentsOf(content.header); });
}

std::vector<std::string> ReadNxvAncillaryArrayNames(const fs::path& path)
{
  return WithContent(path,
    [](const NxvInput&, const NxvContent& content)
    {
      std::vector<std::string> names;
      for (const NxvArray& array : content.header.arrays)
      {
        const auto add = [&](const char* name, const auto&)
        {
          for (const MomentName moment : MomentsOf(content.header))
          {
            if (array.name == AncillaryArrayName(moment, name))
            {
              names.push_back(array.name);
            }
          }
        };
        ForEachAncillaryArray(content.header.volume.ancillary, add);
      }
      return names;
    });
}

} // namespace nexrad
