// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Codec/NxvWriter.h"

#include "nexrad/Codec/MomentCode.h"
#include "nexrad/Codec/NxvHeader.h"
#include "nexrad/Codec/ThesisStream.h"
#include "nexrad/Compression/Deflate.h"
#include "nexrad/Grid/VolumeMoments.h"
#include "nexrad/System/AtomicFile.h"
#include "nexrad/System/Error.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace nexrad
{

namespace
{

using Bytes = std::vector<std::uint8_t>;

// Bytes of each piece of a deflated array: enough that the pieces make the file no larger, and so
// few that a volume of 256 x 256 x 128 voxels has several.
constexpr std::size_t pieceSize = std::size_t(1) << 20;

// A header that grows with the payloads that follow it.
struct FileContent
{
  NxvHeader header;
  std::vector<Bytes> payloads;

  void AddDeflated(NxvArray array, const Bytes& bytes, DeflateSearch search)
  {
    array.storage = NxvStorage::Deflated;
    DeflatedPieces deflated = DeflateInPieces(bytes.data(), bytes.size(), pieceSize, search);
    if (deflated.lengths.size() > 1)
    {
      array.pieceBytes = pieceSize;
      array.pieces = std::move(deflated.lengths);
    }
    this->Add(std::move(array), std::move(deflated.stream));
  }

  void Add(NxvArray array, Bytes payload)
  {
    array.length = payload.size();
    array.crc32 = Crc32(payload.data(), payload.size());
    header.arrays.push_back(std::move(array));
    payloads.push_back(std::move(payload));
  }
};

void AppendLittleEndian(Bytes& bytes, std::uint32_t word)
{
  for (unsigned shift = 0; shift < 32; shift += 8)
  {
    bytes.push_back(static_cast<std::uint8_t>(word >> shift));
  }
}

Bytes FloatBytes(const std::vector<float>& values)
{
  Bytes bytes;
  bytes.reserve(values.size() * sizeof(float));
  for (const float value : values)
  {
    std::uint32_t word = 0;
    std::memcpy(&word, &value, sizeof(word));
    AppendLittleEndian(bytes, word);
  }
  return bytes;
}

Bytes StateBytes(const std::vector<VoxelState>& states)
{
  Bytes bytes(states.size());
  std::transform(states.begin(), states.end(), bytes.begin(),
    [](VoxelState state)
    {
      const bool beyond = state == VoxelState::Filtered; // in an array of its own
      return static_cast<std::uint8_t>(beyond ? VoxelState::NoEcho : state);
    });
  return bytes;
}

NxvArray MomentArray(const GriddedVolume& volume)
{
  NxvArray array;
  array.name = ToString(volume.moment);
  array.unit = UnitOf(volume.moment);
  array.fill = volume.fill;
  return array;
}

void AddStates(FileContent& content, MomentName moment, const Bytes& states)
{
  NxvArray array;
  array.name = std::string(ToString(moment)) + "_state";
  array.type = NxvType::UInt8;
  array.fill = static_cast<double>(VoxelState::NotScanned);
  content.AddDeflated(array, states, DeflateSearch::Runs);
}

bool Holds(const std::vector<VoxelState>& states, VoxelState state)
{
  // std::find would look at them one by one.
  return std::memchr(states.data(), static_cast<int>(state), states.size()) != nullptr;
}

// Which voxels are filtered, where some are. Readers that do not know the array take them for no
// echo.
void AddFiltered(FileContent& content, const GriddedVolume& volume)
{
  if (!Holds(volume.states, VoxelState::Filtered))
  {
    return;
  }
  Bytes filtered(volume.states.size());
  std::transform(volume.states.begin(), volume.states.end(), filtered.begin(),
    [](VoxelState state) { return static_cast<std::uint8_t>(state == VoxelState::Filtered); });
  NxvArray array;
  array.name = std::string(ToString(volume.moment)) + "_filtered";
  array.type = NxvType::UInt8;
  content.AddDeflated(array, filtered, DeflateSearch::Runs);
}

void AddFloats(FileContent& content, const GriddedVolume& volume)
{
  CheckVoxelCount(volume);
  NxvArray array = MomentArray(volume);
  array.type = NxvType::Float32;
  content.AddDeflated(array, FloatBytes(volume.values), DeflateSearch::Repeats);
  AddStates(content, volume.moment, StateBytes(volume.states));
  AddFiltered(content, volume);
}

// The states that the 7-bit codes stand for, but range folded where the volume has it. The echoes
// that became code 0 are no echo, with the array of states as without.
Bytes StatesOfCodes(const Bytes& codes, const std::vector<VoxelState>& states)
{
  Bytes bytes(codes.size());
  for (std::size_t i = 0; i < bytes.size(); ++i)
  {
    const bool folded = states[i] == VoxelState::RangeFolded;
    bytes[i] =
      static_cast<std::uint8_t>(folded ? VoxelState::RangeFolded : ThesisCode::StateOf(codes[i]));
  }
  return bytes;
}

void AddThesisStream(FileContent& content, const GriddedVolume& volume)
{
  const Bytes codes = ThesisCode::EncodeAll(volume);
  content.Add(MomentArray(volume), EncodeRunLength(codes));
  if (Holds(volume.states, VoxelState::RangeFolded))
  {
    AddStates(content, volume.moment, StatesOfCodes(codes, volume.states));
  }
  AddFiltered(content, volume);
}

// An echo that is not a number has the code, and with it the state, of not scanned.
void AddRadarSteps(FileContent& content, const GriddedVolume& volume)
{
  const MomentCode code = MomentCode::Of(volume);
  NxvArray array = MomentArray(volume);
  array.type = code.bytes == 1 ? NxvType::UInt8 : NxvType::UInt16;
  array.offset = code.offset;
  array.scale = code.scale;
  content.AddDeflated(array, code.EncodeAll(volume), DeflateSearch::Runs);
  if (Holds(volume.states, VoxelState::RangeFolded))
  {
    Bytes states = StateBytes(volume.states);
    ForEachEcho(volume.states.data(), states.size(),
      [&](std::size_t i)
      {
        states[i] = static_cast<std::uint8_t>(
          std::isnan(volume.values[i]) ? VoxelState::NotScanned : VoxelState::Echo);
      });
    AddStates(content, volume.moment, states);
  }
  AddFiltered(content, volume);
}

// The first of finest × 1, 2, 5, 10, … of which 255 reach the largest value.
double RoundScale(const std::vector<float>& values, double finest)
{
  const double largest = static_cast<double>(*std::max_element(values.begin(), values.end()));
  double decade = finest;
  while (largest > 255.0 * 5.0 * decade)
  {
    decade *= 10.0;
  }
  return largest <= 255.0 * decade ? decade
                                   : decade * (largest <= 255.0 * 2.0 * decade ? 2.0 : 5.0);
}

Bytes CodeBytes(const std::vector<float>& values, double scale)
{
  Bytes bytes(values.size());
  std::transform(values.begin(), values.end(), bytes.begin(),
    [scale](float value)
    { return static_cast<std::uint8_t>(std::lround(static_cast<double>(value) / scale)); });
  return bytes;
}

Bytes MakeAncillaryArray(NxvArray& array, const std::vector<float>& values, bool exact)
{
  if (exact)
  {
    array.type = NxvType::Float32;
    return FloatBytes(values);
  }
  array.scale = RoundScale(values, array.unit == "s" ? 1.0 : 0.01);
  return CodeBytes(values, array.scale);
}

Bytes MakeAncillaryArray(NxvArray&, const std::vector<std::uint8_t>& values, bool)
{
  return values;
}

template <class Values>
void CheckAncillaryArray(
  const GriddedVolume& volume, const std::string& ancillary, const Values& values)
{
  try
  {
    if (values.size() != volume.grid.VoxelCount())
    {
      throw Error(std::to_string(values.size()) + " values for " +
                  std::to_string(volume.grid.VoxelCount()) + " voxels");
    }
    nexrad::CheckAncillaryArray(ancillary, values, volume.sites.size());
  }
  catch (const Error& problem)
  {
    throw Error(
      "array \"" + AncillaryArrayName(volume.moment, ancillary) + "\": " + problem.what());
  }
}

void AddAncillary(FileContent& content, const GriddedVolume& volume, bool exact)
{
  const auto add = [&](const std::string& name, const auto& values)
  {
    if (values.empty())
    {
      return;
    }
    CheckAncillaryArray(volume, name, values);
    NxvArray array;
    array.name = AncillaryArrayName(volume.moment, name);
    array.type = NxvType::UInt8;
    array.unit = name == "age" ? "s" : "";
    array.fill = name == "site" ? AncillaryArrays::NoSite : 0.0;
    const Bytes bytes = MakeAncillaryArray(array, values, exact);
    content.AddDeflated(array, bytes, DeflateSearch::Repeats);
  };
  ForEachAncillaryArray(volume.ancillary, add);
}

void AddMoment(FileContent& content, const GriddedVolume& volume, NxvEncoding encoding)
{
  switch (encoding)
  {
  case NxvEncoding::RadarSteps:
    AddRadarSteps(content, volume);
    break;
  case NxvEncoding::Thesis:
    AddThesisStream(content, volume);
    break;
  case NxvEncoding::Float:
    AddFloats(content, volume);
    break;
  }
  AddAncillary(content, volume, encoding == NxvEncoding::Float);
}

void WriteContent(const std::filesystem::path& path, const FileContent& content)
{
  const std::string header = FormatNxvHeader(content.header);
  if (header.size() > NxvLargestHeader)
  {
    throw Error(path.string() + ": the header would be longer than " +
                std::to_string(NxvLargestHeader) + " bytes");
  }
  Bytes start = {'N', 'X', 'V', '1'};
  AppendLittleEndian(start, static_cast<std::uint32_t>(header.size()));
  AtomicFile file(path);
  file.Write(start.data(), start.size());
  file.Write(header.data(), header.size());
  for (const Bytes& payload : content.payloads)
  {
    file.Write(payload.data(), payload.size());
  }
  file.Commit();
}

} // namespace

void WriteNxv(
  const std::filesystem::path& path, const GriddedVolume& volume, const NxvWriteOptions& options)
{
  if (!std::isfinite(volume.fill))
  {
    throw Error(path.string() + ": the fill value must be a finite number");
  }
  FileContent content;
  content.header.volume = WithoutVoxels(volume);
  const bool asTheThesis = volume.method == "thesis" && volume.moment == MomentName::REF;
  const NxvEncoding usual = asTheThesis ? NxvEncoding::Thesis : NxvEncoding::RadarSteps;
  AddMoment(content, volume, options.encoding.value_or(usual));
  const bool exact = options.encoding == NxvEncoding::Float;
  for (const GriddedVolume& further : volume.further)
  {
    AddMoment(content, further, exact ? NxvEncoding::Float : NxvEncoding::RadarSteps);
  }
  WriteContent(path, content);
}

} // namespace nexrad
