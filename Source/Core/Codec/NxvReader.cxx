// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Codec/NxvReader.h"

#include "nexrad/Codec/MomentCode.h"
#include "nexrad/Codec/NxvAncillary.h"
#include "nexrad/Codec/NxvHeader.h"
#include "nexrad/Codec/NxvInput.h"
#include "nexrad/Codec/NxvPayload.h"
#include "nexrad/Codec/Quantizer.h"
#include "nexrad/System/Error.h"
#include "nexrad/System/HugePages.h"

#include <algorithm>
#include <cstring>
#include <type_traits>
#include <utility>

namespace fs = std::filesystem;

namespace nexrad
{

namespace
{

using Bytes = std::vector<std::uint8_t>;

std::uint32_t LittleEndian(const std::uint8_t* bytes)
{
  return bytes[0] | static_cast<std::uint32_t>(bytes[1]) << 8 |
         static_cast<std::uint32_t>(bytes[2]) << 16 | static_cast<std::uint32_t>(bytes[3]) << 24;
}

template <typename Work>
auto NamingTheFile(const fs::path& path, const Work& work)
{
  try
  {
    return work();
  }
  catch (const Error& problem)
  {
    throw Error(path.string() + ": " + problem.what());
  }
}

// `bytesBesides`: of each voxel, for its further arrays and for the caller.
void CheckMemory(const GridSpecification& grid, std::size_t bytesBesides, std::size_t maximumBytes)
{
  // A value, a state, and a code while it is decoded.
  const std::size_t bytesPerVoxel = sizeof(float) + sizeof(VoxelState) + 1 + bytesBesides;
  if (grid.VoxelCount() > maximumBytes / bytesPerVoxel)
  {
    throw Error(std::to_string(grid.VoxelCount()) + " voxels of " + std::to_string(bytesPerVoxel) +
                " bytes need more memory than the " + std::to_string(maximumBytes) +
                " bytes allowed");
  }
}

bool IsWanted(
  const NxvArray& array, MomentName moment, const char* ancillary, const NxvReadOptions& options)
{
  const auto& names = options.leaveOut;
  return array.name == AncillaryArrayName(moment, ancillary) &&
         std::find(names.begin(), names.end(), array.name) == names.end();
}

// Bytes that a voxel takes in memory beside its value, its state, and a byte of its code while it
// is decoded: those of its ancillary arrays, and of a wider code.
std::size_t FurtherBytes(const NxvHeader& header, const NxvReadOptions& options)
{
  std::size_t bytes = header.arrays[0].type == NxvType::UInt16 ? 1 : 0;
  const auto count = [&](const char* name, const auto& values)
  {
    const auto wanted = [&](const NxvArray& array)
    { return IsWanted(array, header.volume.moment, name, options); };
    const bool any = std::any_of(header.arrays.begin(), header.arrays.end(), wanted);
    bytes += any ? sizeof(typename std::decay_t<decltype(values)>::value_type) : 0;
  };
  ForEachAncillaryArray(header.volume.ancillary, count);
  return bytes;
}

// A file that is being read, and what of it is wanted.
struct Reading
{
  NxvInput& file;
  const NxvContent& content;
  const NxvReadOptions& options;

  void Inflate(
    std::uint64_t offset, const NxvArray& array, std::uint8_t* target, std::size_t size) const
  {
    ReadDeflated(file, offset, array, target, size, options.loop);
  }
};

void ReadValues(const Reading& reading, std::uint64_t offset, const NxvArray& array,
  std::vector<std::uint8_t>& values, std::size_t voxels)
{
  values.resize(voxels);
  reading.Inflate(offset, array, values.data(), voxels);
}

void ReadValues(const Reading& reading, std::uint64_t offset, const NxvArray& array,
  std::vector<float>& values, std::size_t voxels)
{
  values.resize(voxels);
  auto* const bytes = reinterpret_cast<std::uint8_t*>(values.data());
  reading.Inflate(offset, array, bytes, voxels * sizeof(float));
  for (std::size_t i = 0; i < voxels; ++i)
  {
    const std::uint32_t word = LittleEndian(bytes + i * sizeof(float));
    std::memcpy(&values[i], &word, sizeof(word));
  }
}

std::unique_ptr<std::uint8_t[]> ReadCodes(const Reading& reading, std::size_t voxels)
{
  // Not set to 0 first: all of them are written.
  std::unique_ptr<std::uint8_t[]> codes(new std::uint8_t[voxels]);
  UseHugePages(codes.get(), voxels);
  const NxvContent& content = reading.content;
  ReadByteCodes(reading.file, content.payloads, content.header.arrays[0], codes.get(), voxels,
    reading.options.loop);
  return codes;
}

void ReadMoment(const Reading& reading, GriddedVolume& volume)
{
  const NxvContent& content = reading.content;
  const NxvArray& array = content.header.arrays[0];
  const std::size_t voxels = volume.grid.VoxelCount();
  if (HasByteCodes(array))
  {
    const auto codes = ReadCodes(reading, voxels);
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
    reading.Inflate(content.payloads, array, codes.data(), codes.size());
    code.DecodeAll(codes, volume);
    return;
  }
  ReadValues(reading, content.payloads, array, volume.values, voxels);
  // Without an array of states a voxel with the fill value is taken for not scanned.
  volume.states.resize(voxels);
  std::transform(volume.values.begin(), volume.values.end(), volume.states.begin(),
    [&volume](float value)
    { return value == volume.fill ? VoxelState::NotScanned : VoxelState::Echo; });
}

bool IsOfStates(const NxvArray& array, const NxvHeader& header)
{
  return array.name == header.arrays[0].name + "_state" && array.type == NxvType::UInt8;
}

// Takes the states from their own array. With codes, it may only add what they cannot say.
void ReadStates(const Reading& reading, std::uint64_t offset, const NxvArray& array,
  GriddedVolume& volume, bool fromCodes)
{
  Bytes bytes(volume.grid.VoxelCount());
  reading.Inflate(offset, array, bytes.data(), bytes.size());
  for (std::size_t i = 0; i < bytes.size(); ++i)
  {
    const auto state = static_cast<VoxelState>(bytes[i]);
    const bool folded = state == VoxelState::RangeFolded && volume.states[i] == VoxelState::NoEcho;
    if (bytes[i] > static_cast<std::uint8_t>(VoxelState::NotScanned) ||
        (fromCodes && state != volume.states[i] && !folded))
    {
      throw Error("state " + std::to_string(bytes[i]) + " of voxel " + std::to_string(i) +
                  (fromCodes ? " contradicts its code" : " is not known"));
    }
    volume.states[i] = state;
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

// Reads the moment by `readMoment`, and calls `readFurther(offset, array)` for each of the arrays.
template <typename ReadMoment, typename ReadFurther>
void ReadArrays(
  const NxvContent& content, const ReadMoment& readMoment, const ReadFurther& readFurther)
{
  const std::vector<NxvArray>& arrays = content.header.arrays;
  std::uint64_t offset = content.payloads;
  std::size_t index = 0;
  try
  {
    readMoment();
    for (; index < arrays.size(); ++index)
    {
      readFurther(offset, arrays[index]);
      offset += arrays[index].length;
    }
  }
  catch (const Error& problem)
  {
    RefuseNxv(offset, "array \"" + arrays[index].name + "\": " + problem.what());
  }
}

GriddedVolume ReadVoxels(const Reading& reading)
{
  const NxvHeader& header = reading.content.header;
  GriddedVolume volume = header.volume;
  ReadArrays(
    reading.content, [&] { ReadMoment(reading, volume); },
    [&](std::uint64_t offset, const NxvArray& array)
    {
      if (IsOfStates(array, header))
      {
        ReadStates(reading, offset, array, volume, header.arrays[0].type != NxvType::Float32);
      }
      ReadAncillaryArray(reading, offset, array, volume);
    });
  return volume;
}

CodedVolume ReadCodedVoxels(const Reading& reading)
{
  const NxvHeader& header = reading.content.header;
  CodedVolume coded;
  coded.volume = header.volume;
  coded.meaning = ByteCodesOf(header.arrays[0], coded.volume.fill);
  ReadArrays(
    reading.content, [&] { coded.codes = ReadCodes(reading, coded.volume.grid.VoxelCount()); },
    [&](std::uint64_t offset, const NxvArray& array)
    {
      coded.rangeFolded = coded.rangeFolded || IsOfStates(array, header);
      ReadAncillaryArray(reading, offset, array, coded.volume);
    });
  return coded;
}

} // namespace

GriddedVolume ReadNxv(const fs::path& path, const NxvReadOptions& options)
{
  return NamingTheFile(path,
    [&path, &options]
    {
      NxvInput file(path);
      const NxvContent content = OpenNxv(file);
      CheckMemory(content.header.volume.grid,
        FurtherBytes(content.header, options) + options.bytesBesides, options.maximumBytes);
      CheckNxvPayloads(file, content);
      return ReadVoxels({file, content, options});
    });
}

std::optional<CodedVolume> ReadNxvCodes(const fs::path& path, const NxvReadOptions& options)
{
  return NamingTheFile(path,
    [&path, &options]() -> std::optional<CodedVolume>
    {
      NxvInput file(path);
      const NxvContent content = OpenNxv(file);
      if (!HasByteCodes(content.header.arrays[0]))
      {
        return std::nullopt;
      }
      CheckMemory(content.header.volume.grid,
        FurtherBytes(content.header, options) + options.bytesBesides, options.maximumBytes);
      CheckNxvPayloads(file, content);
      return ReadCodedVoxels({file, content, options});
    });
}

bool HasNxvCodes(const fs::path& path, bool allStates)
{
  return NamingTheFile(path,
    [&path, allStates]
    {
      NxvInput file(path);
      const NxvHeader header = OpenNxv(file).header;
      const auto isOfStates = [&header](const NxvArray& array)
      { return IsOfStates(array, header); };
      return HasByteCodes(header.arrays[0]) &&
             !(allStates && std::any_of(header.arrays.begin(), header.arrays.end(), isOfStates));
    });
}

GriddedVolume ReadNxvHeader(const fs::path& path)
{
  return NamingTheFile(path,
    [&path]
    {
      NxvInput file(path);
      return OpenNxv(file).header.volume;
    });
}

std::vector<std::string> ReadNxvAncillaryArrayNames(const fs::path& path)
{
  return NamingTheFile(path,
    [&path]
    {
      NxvInput file(path);
      const NxvHeader header = OpenNxv(file).header;
      std::vector<std::string> names;
      for (const NxvArray& array : header.arrays)
      {
        const auto add = [&](const char* name, const auto&)
        {
          if (array.name == AncillaryArrayName(header.volume.moment, name))
          {
            names.push_back(array.name);
          }
        };
        ForEachAncillaryArray(header.volume.ancillary, add);
      }
      return names;
    });
}

GriddedVolume ReadRaw(const fs::path& path, GriddedVolume description,
  const NxvWriteOptions& options, std::size_t maximumBytes)
{
  const auto codes = NamingTheFile(path,
    [&]
    {
      CheckMemory(description.grid, 0, maximumBytes);
      NxvInput file(path);
      NxvArray whole;
      whole.length = file.Length();
      Bytes bytes(description.grid.VoxelCount());
      ReadByteCodes(file, 0, whole, bytes.data(), bytes.size(), {});
      return bytes;
    });
  Quantizer{options.offset, options.scale, options.maximum}.DecodeAll(codes, description);
  return description;
}

} // namespace nexrad
