// SPDX-License-Identifier: BSD-3-Clause
// Feeds volume files (.nxv) to their readers, as they are and once more with check sums that fit:
// those of a changed file are wrong, and nothing behind them would be reached. Payloads of deflated
// arrays may stand in the input as they are; they are deflated then.
#include "FuzzTarget.h"

#include "Level2Bytes.h"
#include "VolumeMaker.h"
#include "nexrad/Codec/NxvFile.h"
#include "nexrad/Compression/Deflate.h"
#include "nexrad/Grid/GriddedVolume.h"
#include "nexrad/System/Error.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <optional>

using namespace nexrad;
using namespace nexrad::testing;
using Json = nlohmann::ordered_json;

namespace
{

constexpr std::size_t startSize = 8; // magic and header length
constexpr std::size_t mostBytes = std::size_t(4) << 20;

Bytes FileOf(const std::string& header, const Bytes& payloads)
{
  Bytes file = BytesOf("NXV1");
  for (unsigned shift = 0; shift < 32; shift += 8)
  {
    file.push_back(static_cast<std::uint8_t>(header.size() >> shift));
  }
  return Join({file, BytesOf(header), payloads});
}

// The header of a file and what follows it; empty when the header is no JSON with arrays.
struct Parts
{
  Json header;
  Bytes payloads;
};

std::optional<Parts> Split(const Bytes& file)
{
  if (file.size() < startSize)
  {
    return std::nullopt;
  }
  const std::size_t stated =
    file[4] | std::size_t(file[5]) << 8 | std::size_t(file[6]) << 16 | std::size_t(file[7]) << 24;
  const std::size_t length = std::min(stated, file.size() - startSize);
  const auto text = file.begin() + startSize;
  const auto end = text + static_cast<std::ptrdiff_t>(length);
  Parts parts = {Json::parse(text, end, nullptr, false), Bytes(end, file.end())};
  const bool hasArrays = parts.header.is_object() && parts.header.contains("arrays") &&
                         parts.header["arrays"].is_array();
  return hasArrays ? std::optional(std::move(parts)) : std::nullopt;
}

// The entries of the arrays, and of those of levels, in the order of their payloads.
std::vector<Json*> ArraysIn(Json& header)
{
  std::vector<Json*> arrays;
  const auto add = [&arrays](Json& of)
  {
    if (of.is_object() && of.contains("arrays") && of["arrays"].is_array())
    {
      for (Json& array : of["arrays"])
      {
        arrays.push_back(&array);
      }
    }
  };
  add(header);
  if (header.contains("levels") && header["levels"].is_array())
  {
    std::for_each(header["levels"].begin(), header["levels"].end(), add);
  }
  return arrays;
}

bool IsZlibStream(const Bytes& bytes)
{
  return bytes.size() > 1 && bytes[0] == 0x78 && (bytes[0] * 256U + bytes[1]) % 31 == 0;
}

// The payload of an array, deflated where the header says so and it is not.
Bytes PayloadOf(const Json& array, const Bytes& bytes)
{
  const bool deflated = array.value("encoding", Json()) == "deflate";
  return deflated && !IsZlibStream(bytes) ? DeflateBytes(bytes.data(), bytes.size()) : bytes;
}

// The same file with lengths and check sums that fit; empty when it has none.
std::optional<Bytes> Mend(const Bytes& file)
{
  std::optional<Parts> parts = Split(file);
  if (!parts)
  {
    return std::nullopt;
  }
  Bytes payloads;
  auto rest = parts->payloads.cbegin();
  for (Json* each : ArraysIn(parts->header))
  {
    Json& array = *each;
    if (!array.is_object() || !array.value("length", Json()).is_number_unsigned())
    {
      continue;
    }
    const auto left = static_cast<std::uint64_t>(parts->payloads.cend() - rest);
    const auto length = std::min(array["length"].get<std::uint64_t>(), left);
    const auto end = rest + static_cast<std::ptrdiff_t>(length);
    const Bytes payload = PayloadOf(array, Bytes(rest, end));
    array["length"] = payload.size();
    array["crc32"] = Crc32(payload.data(), payload.size());
    payloads.insert(payloads.end(), payload.begin(), payload.end());
    rest = end;
  }
  parts->header.erase("header_crc32");
  return FileOf(parts->header.dump(-1, ' ', false, Json::error_handler_t::replace), payloads);
}

void LookAtMoment(const GriddedVolume& volume)
{
  const std::size_t voxels = volume.grid.VoxelCount();
  Require(volume.values.size() == voxels && volume.states.size() == voxels,
    "each voxel has a value and a state");
  for (std::size_t i = 0; i < voxels; ++i)
  {
    Require(static_cast<unsigned>(volume.states[i]) < VoxelStateCount, "states are known ones");
    Require(volume.states[i] == VoxelState::Echo || volume.values[i] == volume.fill ||
              std::isnan(volume.values[i]),
      "voxels without echo have the fill value");
  }
  ForEachAncillaryArray(volume.ancillary, [voxels](const char*, const auto& values)
    { Require(values.empty() || values.size() == voxels, "ancillary arrays are whole"); });
  for (const std::uint8_t site : volume.ancillary.nearestSite)
  {
    Require(site == AncillaryArrays::NoSite || site < volume.sites.size(), "sites are known ones");
  }
}

bool AreSame(float a, float b)
{
  return a == b || (std::isnan(a) && std::isnan(b));
}

void RequireSame(const GriddedVolume& a, const GriddedVolume& b)
{
  Require(a.states == b.states, "states come back as they were written");
  Require(std::equal(a.values.begin(), a.values.end(), b.values.begin(), b.values.end(), AreSame),
    "values come back as they were written");
  Require(a.grid.dimensions == b.grid.dimensions && a.time == b.time && a.sites == b.sites,
    "the header comes back as it was written");
}

void LookAtCodes(const std::filesystem::path& path, const GriddedVolume& volume)
{
  NxvReadOptions options;
  options.maximumBytes = mostBytes;
  options.moments = {volume.moment};
  const auto coded = ReadNxvCodes(path, options);
  Require(coded.has_value() == HasNxvCodes(path, options), "HasNxvCodes foretells ReadNxvCodes");
  if (!coded)
  {
    return;
  }
  const bool allStates = ReadNxvCodes(path, options, true).has_value();
  const std::size_t voxels = volume.grid.VoxelCount();
  std::vector<float> values(voxels);
  std::vector<VoxelState> states(voxels);
  ExpandCodes(coded->meaning, coded->codes.get(), voxels, values.data(), states.data());
  for (std::size_t i = 0; i < voxels; ++i)
  {
    Require(AreSame(values[i], volume.values[i]), "codes stand for the values");
    Require(!allStates || states[i] == volume.states[i], "codes stand for the states");
  }
}

void WriteAndReadAgain(const GriddedVolume& volume)
{
  static const InputFile again("again.nxv");
  WriteNxv(again.Path(), volume, NxvEncoding::Float);
  const GriddedVolume back = ReadNxv(again.Path());
  RequireSame(volume, back);
  Require(volume.further.size() == back.further.size(), "further moments come back");
  for (std::size_t i = 0; i < volume.further.size(); ++i)
  {
    RequireSame(volume.further[i], back.further[i]);
  }
}

// Whether a reader takes the file; it may refuse it with an Error of one line that names the file.
template <typename Read>
bool IsRead(const std::filesystem::path& path, const Read& read)
{
  try
  {
    read();
    return true;
  }
  catch (const Error& error)
  {
    const std::string message = error.what();
    Require(message.rfind(path.string() + ": ", 0) == 0, "a message names the file");
    RequireMessage(message);
    return false;
  }
}

void ReadAll(const Bytes& bytes)
{
  static const InputFile file("volume.nxv");
  file.Write(bytes.data(), bytes.size());
  const auto& path = file.Path();
  NxvReadOptions options;
  options.maximumBytes = mostBytes;
  std::optional<GriddedVolume> volume;
  const bool whole = IsRead(path, [&] { volume = ReadNxv(path, options); });
  const bool header = IsRead(path, [&] { ReadNxvHeader(path); });
  IsRead(path, [&] { ReadNxvMoments(path); });
  IsRead(path, [&] { ReadNxvAncillaryArrayNames(path); });
  IsRead(path, [&] { ReadNxvCodes(path, options); });
  IsRead(path, [&] { HasNxvCodes(path, options); });
  Require(header || !whole, "a volume that is read has a header that is read");
  std::vector<GridSpecification> levels;
  IsRead(path, [&] { levels = ReadNxvLevels(path); });
  for (options.level = levels.size(); options.level-- > 1;)
  {
    IsRead(path, [&] { LookAtMoment(ReadNxv(path, options)); });
  }
  options.level = 0;
  if (whole)
  {
    LookAtMoment(*volume);
    std::for_each(volume->further.begin(), volume->further.end(), LookAtMoment);
    LookAtCodes(path, *volume);
    WriteAndReadAgain(*volume);
  }
}

Bytes Written(const GriddedVolume& volume, NxvEncoding encoding)
{
  const InputFile file("seed.nxv");
  WriteNxv(file.Path(), volume, encoding);
  return BytesOf(FileContent(file.Path()));
}

Bytes WrittenInBricks(const GriddedVolume& volume)
{
  const InputFile file("seed.nxv");
  NxvBandWriter writer(file.Path(), volume.grid);
  writer.Add(volume);
  writer.Commit();
  return BytesOf(FileContent(file.Path()));
}

// The same file with its payloads as they are before they are deflated.
Bytes Inflated(const Bytes& file)
{
  Parts parts = *Split(file);
  Bytes payloads;
  auto rest = parts.payloads.cbegin();
  for (Json& array : parts.header["arrays"])
  {
    const auto end = rest + array["length"].get<std::ptrdiff_t>();
    Bytes payload;
    if (array["encoding"] == "rle")
    {
      payload.assign(rest, end);
    }
    else
    {
      payload = InflateStream(Bytes(rest, end)).value();
    }
    array["length"] = payload.size();
    payloads.insert(payloads.end(), payload.begin(), payload.end());
    rest = end;
  }
  return FileOf(parts.header.dump(), payloads);
}

} // namespace

namespace nexrad::testing
{

std::vector<Bytes> FuzzSeeds()
{
  GriddedVolume plain = MakeGriddedVolume();
  GriddedVolume rich = plain;
  rich.sitePositions = {{38.81, -94.264, 333.0}, {38.699, -90.683, 220.0}};
  AddAncillary(rich);
  rich.states[1] = VoxelState::Filtered;
  rich.states[4] = VoxelState::RangeFolded;
  GriddedVolume velocity = plain;
  velocity.moment = MomentName::VEL;
  GriddedVolume geographic = plain;
  geographic.grid.axes = GridAxes::Geographic;
  geographic.grid.origin = {-92.0, 38.0, 100.0};
  geographic.grid.spacing = {0.01, 0.01, 500.0};
  GriddedVolume several = plain;
  several.further.push_back(velocity);
  std::vector<Bytes> seeds = {Written(plain, NxvEncoding::Thesis),
    Written(rich, NxvEncoding::RadarSteps), Written(rich, NxvEncoding::Float),
    Written(several, NxvEncoding::RadarSteps), Written(geographic, NxvEncoding::Float)};
  for (std::size_t i = 1, count = seeds.size(); i < count; ++i)
  {
    seeds.push_back(Inflated(seeds[i]));
  }
  seeds.push_back(WrittenInBricks(rich));
  seeds.push_back(WrittenInBricks(MakeGriddedVolume({513, 2, 1}))); // with a level
  return seeds;
}

} // namespace nexrad::testing

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  const Bytes file(data, data + size);
  ReadAll(file);
  if (const auto mended = Mend(file))
  {
    ReadAll(*mended);
  }
  return 0;
}
