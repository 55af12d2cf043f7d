// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Codec/NxvHeader.h"

#include "nexrad/Codec/JsonText.h"
#include "nexrad/Compression/Deflate.h"
#include "nexrad/Geometry/Angles.h"
#include "nexrad/System/MessageText.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <sstream>
#include <utility>

namespace nexrad
{

namespace
{

using Json = nlohmann::ordered_json;

// Last key of the text; its CRC-32 covers the text before this.
constexpr std::string_view checksumKey = ",\"header_crc32\":";

constexpr std::array<std::pair<NxvStorage, const char*>, 3> storageNames = {
  {{NxvStorage::RunLength, "rle"}, {NxvStorage::Deflated, "deflate"},
    {NxvStorage::Bricks, "bricks"}}};

constexpr std::array<std::pair<NxvType, const char*>, 4> typeNames = {{{NxvType::UInt7, "uint7"},
  {NxvType::UInt8, "uint8"}, {NxvType::UInt16, "uint16"}, {NxvType::Float32, "float32"}}};

template <typename Names, typename Value>
const char* NameOf(const Names& names, Value value)
{
  for (const auto& entry : names)
  {
    if (entry.first == value)
    {
      return entry.second;
    }
  }
  return "";
}

template <typename Names>
auto ValueOf(const Names& names, const std::string& key, const Json& name)
{
  for (const auto& entry : names)
  {
    if (name == entry.second)
    {
      return entry.first;
    }
  }
  throw Error("header: " + key + " " + Excerpt(name.dump()) + " is not known");
}

std::uint32_t Checksum(std::string_view text)
{
  return Crc32(reinterpret_cast<const std::uint8_t*>(text.data()), text.size());
}

Json FormatArray(const NxvArray& array)
{
  Json json = {{"name", array.name}, {"type", NameOf(typeNames, array.type)}, {"unit", array.unit},
    {"offset", array.offset}, {"scale", array.scale}, {"fill", array.fill},
    {"encoding", NameOf(storageNames, array.storage)}, {"length", array.length},
    {"crc32", array.crc32}};
  if (!array.pieces.empty())
  {
    json["piece_bytes"] = array.pieceBytes;
    json["pieces"] = array.pieces;
  }
  if (array.storage == NxvStorage::Bricks)
  {
    json["brick"] = array.brick;
    json["index_length"] = array.indexLength;
  }
  return json;
}

Json FormatArrays(const std::vector<NxvArray>& arrays)
{
  Json json = Json::array();
  for (const NxvArray& array : arrays)
  {
    json.push_back(FormatArray(array));
  }
  return json;
}

double FiniteNumber(const Json& value, const std::string& key)
{
  const double number = value.get<double>();
  if (!std::isfinite(number))
  {
    throw Error("header: " + key + " is not a finite number");
  }
  return number;
}

// Something that a float must be able to hold, also after a scale was applied.
double ModestNumber(const Json& value, const std::string& key)
{
  constexpr double limit = 1e30;
  const double number = value.get<double>();
  if (!(std::abs(number) <= limit))
  {
    throw Error("header: " + key + " " + Excerpt(value.dump()) + " is out of range");
  }
  return number;
}

// How the payload is divided, where a writer says so.
void ParsePieces(const Json& json, NxvArray& array)
{
  constexpr std::uint64_t largestPiece = std::uint64_t(1) << 30;
  if (!json.contains("pieces"))
  {
    return;
  }
  array.pieceBytes = json.at("piece_bytes").get<std::uint64_t>();
  std::uint64_t left = array.length;
  for (const Json& length : json.at("pieces"))
  {
    array.pieces.push_back(length.is_number_unsigned() ? length.get<std::uint64_t>() : 0);
    if (array.pieces.back() < 1 || array.pieces.back() > left)
    {
      throw Error("header: array \"" + Excerpt(array.name) + "\": a piece of " +
                  Excerpt(length.dump()) + " bytes where " + std::to_string(left) + " are left");
    }
    left -= array.pieces.back();
  }
  if (left != 0 || array.pieceBytes < 1 || array.pieceBytes > largestPiece ||
      array.storage != NxvStorage::Deflated)
  {
    throw Error("header: array \"" + array.name +
                "\": its pieces must make up a deflated payload, of 1 to 2^30 bytes each");
  }
}

void ParseBricks(const Json& json, NxvArray& array)
{
  if (array.storage != NxvStorage::Bricks)
  {
    return;
  }
  constexpr double leastVoxels = 1 << 9; // so that the index takes little memory
  constexpr double mostVoxels = 1 << 24;
  double voxels = 1.0;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const Json& along = json.at("brick").at(axis);
    const auto size = along.is_number_unsigned() ? along.get<std::uint64_t>() : 0;
    voxels *= static_cast<double>(size);
    array.brick[axis] = static_cast<int>(std::min(size, std::uint64_t(1) << 24));
  }
  if (!(voxels >= leastVoxels && voxels <= mostVoxels))
  {
    throw Error("header: array \"" + Excerpt(array.name) + "\": bricks of " +
                Excerpt(json.at("brick").dump()) + " voxels: must be 2^9 to 2^24");
  }
  const Json& length = json.at("index_length");
  array.indexLength = length.is_number_unsigned() ? length.get<std::uint64_t>() : 0;
  if (array.indexLength < 1 || array.indexLength > array.length)
  {
    throw Error("header: array \"" + Excerpt(array.name) + "\": an index of " +
                Excerpt(length.dump()) + " bytes in a payload of " + std::to_string(array.length));
  }
}

NxvArray ParseArray(const Json& json)
{
  NxvArray array;
  array.name = json.at("name").get<std::string>();
  array.type = ValueOf(typeNames, "type", json.at("type"));
  array.unit = json.at("unit").get<std::string>();
  array.offset = ModestNumber(json.at("offset"), "offset");
  array.scale = ModestNumber(json.at("scale"), "scale");
  array.fill = ModestNumber(json.at("fill"), "fill");
  array.storage = ValueOf(storageNames, "encoding", json.at("encoding"));
  if (!json.at("length").is_number_unsigned() || !json.at("crc32").is_number_unsigned())
  {
    throw Error("header: length and crc32 of array \"" + Excerpt(array.name) +
                "\" must be whole numbers, 0 or more");
  }
  array.length = json.at("length").get<std::uint64_t>();
  const auto crc = json.at("crc32").get<std::uint64_t>();
  if (array.scale <= 0.0 || crc > std::numeric_limits<std::uint32_t>::max())
  {
    throw Error("header: array \"" + Excerpt(array.name) + "\" has a scale or crc32 out of range");
  }
  array.crc32 = static_cast<std::uint32_t>(crc);
  ParsePieces(json, array);
  ParseBricks(json, array);
  return array;
}

// "+key=number" among the words of a PROJ string.
std::optional<double> ProjectionNumber(const std::string& projection, const std::string& key)
{
  std::istringstream words(projection);
  const std::string prefix = "+" + key + "=";
  for (std::string word; words >> word;)
  {
    double number = 0.0;
    const char* const end = word.data() + word.size();
    if (word.rfind(prefix, 0) == 0 &&
        std::from_chars(word.data() + prefix.size(), end, number).ptr == end &&
        std::isfinite(number))
    {
      return number;
    }
  }
  return std::nullopt;
}

void ParseProjection(const std::string& projection, GridSpecification& grid)
{
  if (projection.find("+proj=longlat") != std::string::npos)
  {
    grid.axes = GridAxes::Geographic;
    const auto middle = [&grid](std::size_t axis)
    { return grid.origin[axis] + 0.5 * grid.spacing[axis] * (grid.dimensions[axis] - 1); };
    grid.centreLongitude = std::round(AngleDifference(0.0, middle(0)) * 100.0) / 100.0;
    grid.centreLatitude = std::round(middle(1) * 100.0) / 100.0;
    return;
  }
  const auto latitude = ProjectionNumber(projection, "lat_0");
  const auto longitude = ProjectionNumber(projection, "lon_0");
  if (projection.find("+proj=aeqd") == std::string::npos || !latitude || !longitude ||
      std::abs(*latitude) > 90.0)
  {
    throw Error("header: projection \"" + Excerpt(projection) +
                "\": must be +proj=aeqd with +lat_0 and +lon_0, or +proj=longlat");
  }
  grid.centreLatitude = *latitude;
  grid.centreLongitude = *longitude;
}

GridSpecification ParseGrid(const Json& json)
{
  GridSpecification grid;
  double voxels = 1.0;
  for (const char* key : {"dimensions", "origin", "spacing"})
  {
    if (!json.at(key).is_array() || json.at(key).size() != 3)
    {
      throw Error(std::string("header: ") + key + " must be three numbers");
    }
  }
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const Json& dimension = json.at("dimensions")[axis];
    const auto size = dimension.is_number_unsigned() ? dimension.get<std::uint64_t>() : 0;
    voxels *= static_cast<double>(size);
    if (size < 1 || voxels > std::numeric_limits<int>::max())
    {
      throw Error("header: dimensions " + Excerpt(json.at("dimensions").dump()) +
                  ": each must be 1 or more, and their product below 2^31");
    }
    grid.dimensions[axis] = static_cast<int>(size);
    grid.origin[axis] = FiniteNumber(json.at("origin")[axis], "origin");
    grid.spacing[axis] = FiniteNumber(json.at("spacing")[axis], "spacing");
    if (grid.spacing[axis] <= 0.0)
    {
      throw Error("header: spacing " + Excerpt(json.at("spacing").dump()) + ": must be above 0");
    }
  }
  ParseProjection(json.at("projection").get<std::string>(), grid);
  return grid;
}

// Those of the sites, where a writer names them.
std::vector<Position> ParsePositions(const Json& json, std::size_t sites)
{
  std::vector<Position> positions;
  for (const Json& each : json)
  {
    if (!each.is_array() || each.size() != 3)
    {
      throw Error("header: site_positions must be latitude, longitude and altitude of each site");
    }
    const Position position{FiniteNumber(each[0], "site_positions"),
      FiniteNumber(each[1], "site_positions"), FiniteNumber(each[2], "site_positions")};
    if (std::abs(position.latitude) > 90.0)
    {
      throw Error("header: site_positions: latitude " + Excerpt(each[0].dump()) + " is over 90");
    }
    positions.push_back(position);
  }
  if (!positions.empty() && positions.size() != sites)
  {
    throw Error("header: " + std::to_string(positions.size()) + " site_positions of " +
                std::to_string(sites) + " sites");
  }
  return positions;
}

Json FormatPositions(const std::vector<Position>& positions)
{
  Json json = Json::array();
  for (const Position& position : positions)
  {
    json.push_back({position.latitude, position.longitude, position.altitude});
  }
  return json;
}

// The arrays of a volume, or of one of its levels, begin with its moment.
std::vector<NxvArray> ParseArrays(const Json& json)
{
  std::vector<NxvArray> arrays;
  for (const Json& array : json)
  {
    arrays.push_back(ParseArray(array));
  }
  if (arrays.empty() || !ParseMomentName(arrays[0].name))
  {
    throw Error("header: the first of the arrays must be a moment");
  }
  for (const NxvArray& array : arrays)
  {
    if ((array.type == NxvType::UInt7) != (array.storage == NxvStorage::RunLength))
    {
      throw Error("header: array \"" + Excerpt(array.name) +
                  "\": rle is for uint7, deflate and bricks are for the other types");
    }
  }
  return arrays;
}

std::vector<NxvLevel> ParseLevels(const Json& json, const std::string& moment)
{
  constexpr std::uint64_t most = std::uint64_t(1) << 16; // voxels in one, along an axis
  std::vector<NxvLevel> levels;
  for (const Json& each : json)
  {
    NxvLevel level;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const Json& voxels = each.at("voxels").at(axis);
      const auto count = voxels.is_number_unsigned() ? voxels.get<std::uint64_t>() : 0;
      if (count < 1 || count > most)
      {
        throw Error("header: level of " + Excerpt(each.at("voxels").dump()) +
                    " voxels in one: must be 1 to 2^16 along each axis");
      }
      level.voxels[axis] = static_cast<int>(count);
    }
    level.arrays = ParseArrays(each.at("arrays"));
    if (level.arrays[0].name != moment)
    {
      throw Error("header: the first array of a level must be " + Excerpt(moment) + ", as in all");
    }
    levels.push_back(std::move(level));
  }
  return levels;
}

NxvHeader ParseJson(const Json& json)
{
  NxvHeader header;
  header.volume.grid = ParseGrid(json);
  const auto text = json.at("time").get<std::string>();
  const auto time = ParseIso8601(text);
  if (!time)
  {
    throw Error("header: time \"" + Excerpt(text) + "\" is not ISO 8601");
  }
  header.volume.time = *time;
  header.volume.sites = json.at("sites").get<std::vector<std::string>>();
  if (json.contains("site_positions"))
  {
    header.volume.sitePositions =
      ParsePositions(json.at("site_positions"), header.volume.sites.size());
  }
  header.volume.method = json.at("method").get<std::string>();
  header.volume.synthetic = json.value("synthetic", false);
  header.volume.sharpened = json.value("sharpened", false);
  header.volume.biologicalShare = json.value("biological_share", 0.0F);
  if (!(header.volume.biologicalShare >= 0.0F && header.volume.biologicalShare <= 1.0F))
  {
    throw Error("header: biological_share must be from 0 to 1");
  }
  header.volume.notes = json.value("notes", std::vector<std::string>());
  header.volume.ofOneRadar = json.value("one_radar", false);
  if (header.volume.ofOneRadar && header.volume.sitePositions.size() != 1)
  {
    throw Error("header: one_radar needs one site and its site_positions");
  }
  header.arrays = ParseArrays(json.at("arrays"));
  header.levels = ParseLevels(json.value("levels", Json::array()), header.arrays[0].name);
  header.volume.moment = *ParseMomentName(header.arrays[0].name);
  header.volume.fill = static_cast<float>(header.arrays[0].fill);
  return header;
}

void VerifyChecksum(const std::string& text)
{
  const std::size_t key = text.rfind(checksumKey);
  if (key == std::string::npos)
  {
    return; // other writers may leave it out
  }
  const std::string expected =
    std::to_string(Checksum(std::string_view(text).substr(0, key))) + "}";
  if (text.compare(key + checksumKey.size(), std::string::npos, expected) != 0)
  {
    throw Error("header: its CRC-32 is wrong");
  }
}

} // namespace

std::string FormatNxvHeader(const NxvHeader& header)
{
  const GriddedVolume& volume = header.volume;
  Json json = {{"dimensions", volume.grid.dimensions}, {"origin", volume.grid.origin},
    {"spacing", volume.grid.spacing}, {"projection", volume.grid.Projection()},
    {"time", FormatIso8601(volume.time)}, {"sites", volume.sites}};
  if (!volume.sitePositions.empty())
  {
    json["site_positions"] = FormatPositions(volume.sitePositions);
  }
  json["method"] = volume.method;
  if (volume.ofOneRadar)
  {
    json["one_radar"] = true;
  }
  json["synthetic"] = volume.synthetic;
  json["sharpened"] = volume.sharpened;
  if (volume.biologicalShare > 0.0F)
  {
    json["biological_share"] = std::round(1.0e4 * double(volume.biologicalShare)) / 1.0e4;
  }
  if (!volume.notes.empty())
  {
    json["notes"] = volume.notes;
  }
  json["arrays"] = FormatArrays(header.arrays);
  for (const NxvLevel& level : header.levels)
  {
    json["levels"].push_back({{"voxels", level.voxels}, {"arrays", FormatArrays(level.arrays)}});
  }
  std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  text.pop_back();
  const std::string checksum = std::to_string(Checksum(text));
  return text.append(checksumKey).append(checksum).append("}");
}

NxvHeader ParseNxvHeader(const std::string& text)
{
  VerifyChecksum(text);
  RequireShallowJson(text);
  try
  {
    return ParseJson(Json::parse(text));
  }
  catch (const Json::exception& problem)
  {
    throw Error("header: " + Shortened(problem.what()));
  }
}

namespace
{

template <class Value, class Test>
void CheckAll(const std::vector<Value>& values, const Test& isPossible, const std::string& right)
{
  const auto wrong = std::find_if_not(values.begin(), values.end(), isPossible);
  if (wrong != values.end())
  {
    throw Error("voxel " + std::to_string(wrong - values.begin()) + " has " +
                std::to_string(*wrong) + ": " + right);
  }
}

} // namespace

void CheckAncillaryArray(const std::string&, const std::vector<float>& values, std::size_t)
{
  CheckAll(
    values, [](float value) { return value >= 0.0F && std::isfinite(value); },
    "must be 0 or more, and finite");
}

void CheckAncillaryArray(
  const std::string& name, const std::vector<std::uint8_t>& values, std::size_t sites)
{
  if (name == "site")
  {
    CheckAll(
      values,
      [sites](std::uint8_t site) { return site < sites || site == AncillaryArrays::NoSite; },
      "must be one of " + std::to_string(sites) + " sites, counted from 0, or 255");
  }
}

} // namespace nexrad
