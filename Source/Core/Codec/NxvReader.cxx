// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Codec/NxvReader.h"

#include "nexrad/Codec/MomentCode.h"
#include "nexrad/Codec/NxvAncillary.h"
#include "nexrad/Codec/NxvHeader.h"
#include "nexrad/Codec/Quantizer.h"
#include "nexrad/Codec/RunLength.h"
#include "nexrad/Compression/Deflate.h"
#include "nexrad/Grid/VolumeMoments.h"
#include "nexrad/System/Error.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <functional>
#include <optional>
#include <type_traits>
#include <utility>

namespace fs = std::filesystem;

namespace nexrad
{

namespace
{

using Bytes = std::vector<std::uint8_t>;
using Receiver = std::function<void(const std::uint8_t*, std::size_t)>;

constexpr std::size_t startSize = 8; // magic and header length

// Within this file errors say where in the file; the functions at the end add which file.
[[noreturn]] void Refuse(std::uint64_t offset, const std::string& what)
{
  throw Error("byte " + std::to_string(offset) + ": " + what);
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

// A file that is read in pieces, its length known from the start.
class InputFile
{
public:
  explicit InputFile(const fs::path& path)
  {
    std::error_code problem;
    length = fs::file_size(path, problem);
    if (problem)
    {
      throw Error("cannot be read: " + problem.message());
    }
    stream.open(path, std::ios::binary);
    if (!stream)
    {
      throw Error(std::string("cannot be read: ") + std::strerror(errno));
    }
  }

  std::uint64_t Length() const { return length; }

  // Hands `size` bytes from `offset` on to the receiver, a piece at a time.
  void Read(std::uint64_t offset, std::uint64_t size, const Receiver& receive)
  {
    stream.clear();
    stream.seekg(static_cast<std::streamoff>(offset));
    while (size > 0)
    {
      const auto piece = static_cast<std::size_t>(std::min<std::uint64_t>(size, buffer.size()));
      if (!stream.read(buffer.data(), static_cast<std::streamsize>(piece)))
      {
        Refuse(offset, "cannot be read");
      }
      receive(reinterpret_cast<const std::uint8_t*>(buffer.data()), piece);
      offset += piece;
      size -= piece;
    }
  }

  Bytes ReadAll(std::uint64_t offset, std::size_t size)
  {
    Bytes bytes;
    bytes.reserve(size);
    this->Read(offset, size,
      [&bytes](const std::uint8_t* data, std::size_t count)
      { bytes.insert(bytes.end(), data, data + count); });
    return bytes;
  }

private:
  std::uint64_t length = 0;
  std::ifstream stream;
  std::array<char, 64 * 1024> buffer;
};

std::uint32_t LittleEndian(const std::uint8_t* bytes)
{
  return bytes[0] | static_cast<std::uint32_t>(bytes[1]) << 8 |
         static_cast<std::uint32_t>(bytes[2]) << 16 | static_cast<std::uint32_t>(bytes[3]) << 24;
}

// Header, and where the payloads begin.
struct OpenedFile
{
  NxvHeader header;
  std::uint64_t payloads = 0;
};

void CheckLengths(const InputFile& file, const OpenedFile& opened)
{
  std::uint64_t left = file.Length() - opened.payloads;
  for (const NxvArray& array : opened.header.arrays)
  {
    if (array.length > left)
    {
      Refuse(file.Length() - left, "array \"" + array.name + "\" should have " +
                                     std::to_string(array.length) + " bytes, the file has " +
                                     std::to_string(left));
    }
    left -= array.length;
  }
  if (left != 0)
  {
    Refuse(file.Length() - left, std::to_string(left) + " bytes after the last array");
  }
}

OpenedFile Open(InputFile& file)
{
  if (file.Length() < startSize)
  {
    Refuse(0, "too short for a volume file");
  }
  const Bytes start = file.ReadAll(0, startSize);
  if (std::memcmp(start.data(), "NXV1", 4) != 0)
  {
    Refuse(0, "not a volume file: it must begin with NXV1");
  }
  const std::uint32_t headerLength = LittleEndian(start.data() + 4);
  if (headerLength > NxvLargestHeader || headerLength > file.Length() - startSize)
  {
    Refuse(4, "a header of " + std::to_string(headerLength) + " bytes in a file of " +
                std::to_string(file.Length()));
  }
  const Bytes text = file.ReadAll(startSize, headerLength);
  OpenedFile opened;
  try
  {
    opened.header = ParseNxvHeader(std::string(text.begin(), text.end()));
  }
  catch (const Error& problem)
  {
    Refuse(startSize, problem.what());
  }
  opened.payloads = startSize + headerLength;
  CheckLengths(file, opened);
  return opened;
}

void CheckChecksums(InputFile& file, const OpenedFile& opened)
{
  std::uint64_t offset = opened.payloads;
  for (const NxvArray& array : opened.header.arrays)
  {
    std::uint32_t crc = 0;
    file.Read(offset, array.length,
      [&crc](const std::uint8_t* data, std::size_t size) { crc = Crc32(data, size, crc); });
    if (crc != array.crc32)
    {
      Refuse(offset, "array \"" + array.name + "\": its CRC-32 is wrong");
    }
    offset += array.length;
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

// The moments of a file, in its order.
std::vector<MomentName> MomentsOf(const NxvHeader& header)
{
  std::vector<MomentName> moments;
  for (const NxvArray& array : header.arrays)
  {
    const auto moment = ParseMomentName(array.name);
    if (moment && std::find(moments.begin(), moments.end(), *moment) != moments.end())
    {
      throw Error("the file has two arrays \"" + array.name + "\"");
    }
    if (moment)
    {
      moments.push_back(*moment);
    }
  }
  return moments;
}

// The moments that are read.
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

// Inflates an array that must give exactly `size` bytes into `target`.
void ReadDeflated(InputFile& file, std::uint64_t offset, const NxvArray& array,
  std::uint8_t* target, std::size_t size)
{
  std::size_t filled = 0;
  Inflater inflater(
    [&](const std::uint8_t* data, std::size_t count)
    {
      if (count > size - filled)
      {
        throw Error("it holds more than " + std::to_string(size) + " bytes");
      }
      std::copy_n(data, count, target + filled);
      filled += count;
    });
  file.Read(offset, array.length,
    [&inflater](const std::uint8_t* data, std::size_t count) { inflater.Feed(data, count); });
  inflater.Finish();
  if (filled != size)
  {
    throw Error(
      "it holds " + std::to_string(filled) + " bytes in place of " + std::to_string(size));
  }
}

Bytes ReadCodes(InputFile& file, std::uint64_t offset, const NxvArray& array, std::size_t voxels)
{
  Bytes codes(voxels);
  RunLengthDecoder decoder(codes.data(), codes.size());
  const auto decode = [&decoder](const std::uint8_t* data, std::size_t size)
  { decoder.Feed(data, size); };
  if (array.storage == NxvStorage::RunLengthDeflated)
  {
    Inflater inflater(decode);
    file.Read(offset, array.length,
      [&inflater](const std::uint8_t* data, std::size_t size) { inflater.Feed(data, size); });
    inflater.Finish();
  }
  else
  {
    file.Read(offset, array.length, decode);
  }
  decoder.Finish();
  return codes;
}

void ReadValues(InputFile& file, std::uint64_t offset, const NxvArray& array,
  std::vector<std::uint8_t>& values, std::size_t voxels)
{
  values.resize(voxels);
  ReadDeflated(file, offset, array, values.data(), voxels);
}

void ReadValues(InputFile& file, std::uint64_t offset, const NxvArray& array,
  std::vector<float>& values, std::size_t voxels)
{
  values.resize(voxels);
  auto* const bytes = reinterpret_cast<std::uint8_t*>(values.data());
  ReadDeflated(file, offset, array, bytes, voxels * sizeof(float));
  for (std::size_t i = 0; i < voxels; ++i)
  {
    const std::uint32_t word = LittleEndian(bytes + i * sizeof(float));
    std::memcpy(&values[i], &word, sizeof(word));
  }
}

void ReadMoment(InputFile& file, std::uint64_t offset, const NxvArray& array, GriddedVolume& volume)
{
  const std::size_t voxels = volume.grid.VoxelCount();
  if (array.type == NxvType::UInt7)
  {
    const Quantizer quantizer{array.offset, array.scale};
    quantizer.DecodeAll(ReadCodes(file, offset, array, voxels), volume);
    return;
  }
  if (array.type != NxvType::Float32)
  {
    const MomentCode code{array.type == NxvType::UInt8 ? 1U : 2U, array.offset, array.scale};
    Bytes codes(code.bytes * voxels);
    ReadDeflated(file, offset, array, codes.data(), codes.size());
    code.DecodeAll(codes, volume);
    return;
  }
  ReadValues(file, offset, array, volume.values, voxels);
  // Without an array of states a voxel with the fill value is taken for not scanned.
  volume.states.resize(voxels);
  std::transform(volume.values.begin(), volume.values.end(), volume.states.begin(),
    [&volume](float value)
    { return value == volume.fill ? VoxelState::NotScanned : VoxelState::Echo; });
}

// Takes the states from their own array. With codes, it may only add what they cannot say.
void ReadStates(InputFile& file, std::uint64_t offset, const NxvArray& array, GriddedVolume& volume,
  bool fromCodes)
{
  Bytes bytes(volume.grid.VoxelCount());
  ReadDeflated(file, offset, array, bytes.data(), bytes.size());
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
void ReadAncillaryArrayValues(InputFile& file, std::uint64_t offset, const NxvArray& array,
  std::vector<std::uint8_t>& values, std::size_t voxels)
{
  if (array.type != NxvType::UInt8)
  {
    throw Error("its type must be uint8");
  }
  ReadValues(file, offset, array, values, voxels);
}

void ReadAncillaryArrayValues(InputFile& file, std::uint64_t offset, const NxvArray& array,
  std::vector<float>& values, std::size_t voxels)
{
  if (array.type == NxvType::Float32)
  {
    ReadValues(file, offset, array, values, voxels);
    return;
  }
  Bytes codes;
  ReadAncillaryArrayValues(file, offset, array, codes, voxels);
  values.resize(voxels);
  std::transform(codes.begin(), codes.end(), values.begin(),
    [&array](std::uint8_t code) { return static_cast<float>(array.offset + array.scale * code); });
}

// Reads the array when it is an ancillary array of the volume that is wanted.
void ReadAncillaryArray(InputFile& file, std::uint64_t offset, const NxvArray& array,
  const NxvReadOptions& options, GriddedVolume& volume)
{
  const auto read = [&](const char* name, auto& values)
  {
    if (!IsWanted(array, volume.moment, name, options))
    {
      return;
    }
    ReadAncillaryArrayValues(file, offset, array, values, volume.grid.VoxelCount());
    CheckAncillaryArray(name, values, volume.sites.size());
  };
  ForEachAncillaryArray(volume.ancillary, read);
}

// The moments of a file that are read, one after the other.
class MomentReader
{
public:
  // Takes the arrays of `memory`.
  MomentReader(InputFile& theFile, const NxvHeader& theHeader, const NxvReadOptions& theOptions,
    GriddedVolume& memory)
    : file(theFile)
    , header(theHeader)
    , options(theOptions)
    , wanted(WantedMoments(header, options))
    , volumes(SplitMoments(std::move(memory)))
    , types(wanted.size())
  {
    volumes.resize(wanted.size());
    for (GriddedVolume& volume : volumes)
    {
      GriddedVolume fresh = header.volume;
      fresh.values = std::move(volume.values);
      fresh.states = std::move(volume.states);
      volume = std::move(fresh);
    }
  }

  // Reads an array of one of the moments; passes over others. What belongs to a moment follows it.
  void Read(std::uint64_t offset, const NxvArray& array)
  {
    for (std::size_t i = 0; i < wanted.size(); ++i)
    {
      const std::string moment = ToString(wanted[i]);
      if (array.name == moment)
      {
        this->Begin(i, array);
        ReadMoment(file, offset, array, volumes[i]);
      }
      else if (types[i] && array.name == moment + "_state" && array.type == NxvType::UInt8)
      {
        ReadStates(file, offset, array, volumes[i], *types[i] != NxvType::Float32);
      }
      else if (types[i])
      {
        ReadAncillaryArray(file, offset, array, options, volumes[i]);
      }
    }
  }

  GriddedVolume Take() { return JoinMoments(std::move(volumes)); }

private:
  void Begin(std::size_t i, const NxvArray& array)
  {
    types[i] = array.type;
    volumes[i].moment = wanted[i];
    volumes[i].fill = static_cast<float>(array.fill);
  }

  InputFile& file;
  const NxvHeader& header;
  const NxvReadOptions& options;
  const std::vector<MomentName> wanted;
  std::vector<GriddedVolume> volumes;
  std::vector<std::optional<NxvType>> types; // of the moments that have begun
};

GriddedVolume ReadVoxels(
  InputFile& file, const OpenedFile& opened, const NxvReadOptions& options, GriddedVolume& memory)
{
  const std::vector<NxvArray>& arrays = opened.header.arrays;
  MomentReader reader(file, opened.header, options, memory);
  std::uint64_t offset = opened.payloads;
  for (const NxvArray& array : arrays)
  {
    try
    {
      reader.Read(offset, array);
    }
    catch (const Error& problem)
    {
      Refuse(offset, "array \"" + array.name + "\": " + problem.what());
    }
    offset += array.length;
  }
  return reader.Take();
}

} // namespace

GriddedVolume ReadNxv(const fs::path& path, const NxvReadOptions& options, GriddedVolume memory)
{
  return NamingTheFile(path,
    [&path, &options, &memory]
    {
      InputFile file(path);
      const OpenedFile opened = Open(file);
      CheckMemory(
        opened.header.volume.grid, FurtherBytes(opened.header, options), options.maximumBytes);
      CheckChecksums(file, opened);
      return ReadVoxels(file, opened, options, memory);
    });
}

GriddedVolume ReadNxvHeader(const fs::path& path)
{
  return NamingTheFile(path,
    [&path]
    {
      InputFile file(path);
      return Open(file).header.volume;
    });
}

std::vector<MomentName> ReadNxvMoments(const fs::path& path)
{
  return NamingTheFile(path,
    [&path]
    {
      InputFile file(path);
      return MomentsOf(Open(file).header);
    });
}

std::vector<std::string> ReadNxvAncillaryArrayNames(const fs::path& path)
{
  return NamingTheFile(path,
    [&path]
    {
      InputFile file(path);
      const NxvHeader header = Open(file).header;
      std::vector<std::string> names;
      for (const NxvArray& array : header.arrays)
      {
        const auto add = [&](const char* name, const auto&)
        {
          for (const MomentName moment : MomentsOf(header))
          {
            if (array.name == AncillaryArrayName(moment, name))
            {
              names.push_back(array.name);
            }
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
      InputFile file(path);
      NxvArray whole;
      whole.length = file.Length();
      return ReadCodes(file, 0, whole, description.grid.VoxelCount());
    });
  Quantizer{options.offset, options.scale, options.maximum}.DecodeAll(codes, description);
  return description;
}

} // namespace nexrad
