// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Codec/NxvWriter.h"

#include "nexrad/Codec/MomentCode.h"
#include "nexrad/Codec/NxvBricks.h"
#include "nexrad/Codec/NxvHeader.h"
#include "nexrad/Codec/NxvInput.h"
#include "nexrad/Codec/NxvLevels.h"
#include "nexrad/Codec/NxvReader.h"
#include "nexrad/Codec/ThesisStream.h"
#include "nexrad/Compression/Deflate.h"
#include "nexrad/System/AtomicFile.h"
#include "nexrad/System/Error.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>

namespace nexrad
{

namespace
{

using Bytes = std::vector<std::uint8_t>;

// Bytes of each piece of a deflated array: enough that the pieces make the file no larger, and so
// few that a volume of 256 x 256 x 128 voxels has several.
constexpr std::size_t pieceSize = std::size_t(1) << 20;

// What takes an array of a volume, of which `source` gives `size` bytes, to be deflated.
using AddArray = std::function<void(
  NxvArray array, std::size_t size, DeflateSearch search, const ByteSource& source)>;

// A header that grows with the payloads that follow it.
struct FileContent
{
  NxvHeader header;
  std::vector<Bytes> payloads;

  void AddDeflated(NxvArray array, std::size_t size, DeflateSearch search, const ByteSource& source)
  {
    array.storage = NxvStorage::Deflated;
    DeflatedPieces deflated = DeflateInPieces(source, size, pieceSize, search);
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

// Bytes of floats, of which whole ones are asked for.
ByteSource FloatBytes(const std::vector<float>& values)
{
  return [&values](std::size_t first, std::size_t count, std::uint8_t* to)
  {
    for (std::size_t i = first / sizeof(float); i < (first + count) / sizeof(float); ++i)
    {
      std::uint32_t word = 0;
      std::memcpy(&word, &values[i], sizeof(word));
      for (unsigned shift = 0; shift < 32; shift += 8)
      {
        *to++ = static_cast<std::uint8_t>(word >> shift);
      }
    }
  };
}

// One byte for each voxel: what `byteOf` makes of its index.
template <class ByteOf>
ByteSource BytesOfVoxels(const ByteOf& byteOf)
{
  return [byteOf](std::size_t first, std::size_t count, std::uint8_t* to)
  {
    for (std::size_t i = first; i < first + count; ++i)
    {
      *to++ = static_cast<std::uint8_t>(byteOf(i));
    }
  };
}

// Filtered is in an array of its own.
VoxelState StateInFile(VoxelState state)
{
  return state == VoxelState::Filtered ? VoxelState::NoEcho : state;
}

NxvArray MomentArray(const GriddedVolume& volume)
{
  NxvArray array;
  array.name = ToString(volume.moment);
  array.unit = UnitOf(volume.moment);
  array.fill = volume.fill;
  return array;
}

// `stateOf` gives the state that the file has of a voxel.
template <class StateOf>
void AddStates(const AddArray& add, const GriddedVolume& volume, const StateOf& stateOf)
{
  NxvArray array;
  array.name = std::string(ToString(volume.moment)) + "_state";
  array.type = NxvType::UInt8;
  array.fill = static_cast<double>(VoxelState::NotScanned);
  add(array, volume.states.size(), DeflateSearch::Runs, BytesOfVoxels(stateOf));
}

bool Holds(const std::vector<VoxelState>& states, VoxelState state)
{
  // std::find would look at them one by one.
  return std::memchr(states.data(), static_cast<int>(state), states.size()) != nullptr;
}

// Which voxels are filtered, where some are. Readers that do not know the array take them for no
// echo.
void AddFiltered(const AddArray& add, const GriddedVolume& volume)
{
  if (!Holds(volume.states, VoxelState::Filtered))
  {
    return;
  }
  NxvArray array;
  array.name = std::string(ToString(volume.moment)) + "_filtered";
  array.type = NxvType::UInt8;
  add(array, volume.states.size(), DeflateSearch::Runs,
    BytesOfVoxels(
      [&states = volume.states](std::size_t i) { return states[i] == VoxelState::Filtered; }));
}

void AddFloats(const AddArray& add, const GriddedVolume& volume)
{
  NxvArray array = MomentArray(volume);
  array.type = NxvType::Float32;
  add(
    array, volume.values.size() * sizeof(float), DeflateSearch::Repeats, FloatBytes(volume.values));
  AddStates(
    add, volume, [&states = volume.states](std::size_t i) { return StateInFile(states[i]); });
  AddFiltered(add, volume);
}

// The array of states has those that the 7-bit codes stand for, but range folded. Echoes that
// became code 0 are no echo, with the array of states as without.
void AddThesisStream(FileContent& content, const AddArray& add, const GriddedVolume& volume)
{
  const Bytes codes = ThesisCode::EncodeAll(volume);
  content.Add(MomentArray(volume), EncodeRunLength(codes));
  if (Holds(volume.states, VoxelState::RangeFolded))
  {
    AddStates(add, volume,
      [&codes, &states = volume.states](std::size_t i)
      {
        const bool folded = states[i] == VoxelState::RangeFolded;
        return folded ? VoxelState::RangeFolded : ThesisCode::StateOf(codes[i]);
      });
  }
  AddFiltered(add, volume);
}

void AddCodes(const AddArray& add, const GriddedVolume& volume, const MomentCode& code)
{
  NxvArray array = MomentArray(volume);
  array.type = code.bytes == 1 ? NxvType::UInt8 : NxvType::UInt16;
  array.offset = code.offset;
  array.scale = code.scale;
  add(array, code.bytes * volume.states.size(), DeflateSearch::Runs,
    [&](std::size_t first, std::size_t count, std::uint8_t* to)
    { code.WriteBytes(volume, first, count, to); });
}

// An echo that is not a number has the code, and with it the state, of not scanned.
void AddRadarSteps(const AddArray& add, const GriddedVolume& volume)
{
  AddCodes(add, volume, MomentCode::Of(volume));
  if (Holds(volume.states, VoxelState::RangeFolded))
  {
    AddStates(add, volume,
      [&volume](std::size_t i)
      {
        const VoxelState state = StateInFile(volume.states[i]);
        const bool isNumber = state != VoxelState::Echo || !std::isnan(volume.values[i]);
        return isNumber ? state : VoxelState::NotScanned;
      });
  }
  AddFiltered(add, volume);
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

ByteSource AncillaryBytes(NxvArray& array, const std::vector<float>& values, bool exact)
{
  if (exact)
  {
    array.type = NxvType::Float32;
    return FloatBytes(values);
  }
  array.scale = RoundScale(values, array.unit == "s" ? 1.0 : 0.01);
  return BytesOfVoxels([&values, scale = array.scale](std::size_t i)
    { return std::lround(static_cast<double>(values[i]) / scale); });
}

ByteSource AncillaryBytes(NxvArray&, const std::vector<std::uint8_t>& values, bool)
{
  return BytesOfVoxels([&values](std::size_t i) { return values[i]; });
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

void AddAncillary(const AddArray& add, const GriddedVolume& volume, bool exact)
{
  const auto addIfThere = [&](const std::string& name, const auto& values)
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
    const ByteSource source = AncillaryBytes(array, values, exact);
    const std::size_t each = array.type == NxvType::Float32 ? sizeof(float) : 1;
    add(array, values.size() * each, DeflateSearch::Repeats, source);
  };
  ForEachAncillaryArray(volume.ancillary, addIfThere);
}

void AddMoment(FileContent& content, const GriddedVolume& volume, NxvEncoding encoding)
{
  CheckVoxelCount(volume);
  const AddArray add =
    [&content](NxvArray array, std::size_t size, DeflateSearch search, const ByteSource& source)
  { content.AddDeflated(std::move(array), size, search, source); };
  switch (encoding)
  {
  case NxvEncoding::RadarSteps:
    AddRadarSteps(add, volume);
    break;
  case NxvEncoding::Thesis:
    AddThesisStream(content, add, volume);
    break;
  case NxvEncoding::Float:
    AddFloats(add, volume);
    break;
  }
  AddAncillary(add, volume, encoding == NxvEncoding::Float);
}

// The same code in all bands, whatever they hold; states where the codes do not tell them.
void AddBandCodes(const AddArray& add, const GriddedVolume& volume)
{
  AddCodes(add, volume, MomentCode::Widest(volume.moment));
  if (Holds(volume.states, VoxelState::RangeFolded))
  {
    AddStates(add, volume,
      [&states = volume.states](std::size_t i)
      {
        return states[i] == VoxelState::RangeFolded ? static_cast<std::uint8_t>(states[i])
                                                    : NxvStateAsCode;
      });
  }
  AddFiltered(add, volume);
}

void AddBand(const AddArray& add, const GriddedVolume& volume, bool exact)
{
  CheckVoxelCount(volume);
  if (exact)
  {
    AddFloats(add, volume);
  }
  else
  {
    AddBandCodes(add, volume);
  }
  AddAncillary(add, volume, true);
}

void WriteFile(
  const std::filesystem::path& path, const NxvHeader& volume, const NxvPayload& payload)
{
  const std::string header = FormatNxvHeader(volume);
  if (header.size() > NxvLargestHeader)
  {
    throw Error(path.string() + ": the header would be longer than " +
                std::to_string(NxvLargestHeader) + " bytes");
  }
  Bytes start = {'N', 'X', 'V', '1'};
  AppendLittleEndian(static_cast<std::uint32_t>(header.size()), start);
  AtomicFile file(path);
  file.Write(start.data(), start.size());
  file.Write(header.data(), header.size());
  for (const Bytes* part : payload)
  {
    file.Write(part->data(), part->size());
  }
  file.Commit();
}

void RequireFiniteFill(const std::filesystem::path& path, const GriddedVolume& volume)
{
  if (!std::isfinite(volume.fill))
  {
    throw Error(path.string() + ": the fill value must be a finite number");
  }
}

} // namespace

void WriteNxv(const std::filesystem::path& path, const GriddedVolume& volume,
  std::optional<NxvEncoding> encoding)
{
  RequireFiniteFill(path, volume);
  FileContent content;
  content.header.volume = WithoutVoxels(volume);
  const bool asTheThesis = volume.method == "thesis" && volume.moment == MomentName::REF;
  const NxvEncoding usual = asTheThesis ? NxvEncoding::Thesis : NxvEncoding::RadarSteps;
  AddMoment(content, volume, encoding.value_or(usual));
  const bool exact = encoding == NxvEncoding::Float;
  for (const GriddedVolume& further : volume.further)
  {
    AddMoment(content, further, exact ? NxvEncoding::Float : NxvEncoding::RadarSteps);
  }
  NxvPayload payload;
  for (const Bytes& each : content.payloads)
  {
    payload.push_back(&each);
  }
  WriteFile(path, content.header, payload);
}

static_assert(NxvBandWriter::Rows == NxvBrickSize[1]);
static_assert(NxvBandWriter::Rows % 2 == 0, "a band is whole rows of the next level");

struct NxvBandWriter::Impl
{
  // The volume, or one of its coarser levels; of a part of its rows.
  struct Level
  {
    Level(const GridSpecification& theGrid, const VoxelBlock& rows, const VoxelsInOne& theVoxels,
      bool isExact)
      : grid(theGrid)
      , firstRow(rows.begin[1])
      , voxels(theVoxels)
      , exact(isExact)
      , arrays(PartOf(theGrid, rows))
    {
    }

    // Rows of the part as a grid.
    GridSpecification GridOf(VoxelBlock rows) const
    {
      rows.begin[1] += firstRow;
      rows.end[1] += firstRow;
      return PartOf(grid, rows);
    }

    GridSpecification grid; // of all rows
    int firstRow;           // of the part
    VoxelsInOne voxels;     // of the volume, in one of its
    bool exact;
    NxvBrickArrays arrays;
    std::optional<GriddedVolume> band; // that is being made of the level before
    int rows = 0;                      // of it that are made
  };

  // Takes what bands say of the volume.
  void Describe(const GriddedVolume& band)
  {
    const GridSpecification grid = header.volume.grid;
    header.volume = WithoutVoxels(band);
    header.volume.grid = grid;
  }

  void Add(std::size_t number, const GriddedVolume& band, const RangeLoop& loop)
  {
    Level& level = levels[number];
    const AddArray add = [&level, &loop](const NxvArray& array, std::size_t, DeflateSearch search,
                           const ByteSource& source)
    { level.arrays.Add(array, search, source, loop); };
    if (band.grid != level.GridOf(level.arrays.BeginBand()))
    {
      throw Error(path.string() + ": bands must have " + std::to_string(Rows) +
                  " rows of the grid each, from the first row on");
    }
    AddBand(add, band, level.exact);
    for (const GriddedVolume& further : band.further)
    {
      AddBand(add, further, level.exact);
    }
    level.arrays.EndBand();
    if (number + 1 < levels.size())
    {
      this->AddToNext(number, band, loop);
    }
  }

  // Makes rows of the next level of a band of this one, and adds that level's band once it has all.
  void AddToNext(std::size_t number, const GriddedVolume& band, const RangeLoop& loop)
  {
    const VoxelsInOne& before = levels[number].voxels;
    Level& next = levels[number + 1];
    const VoxelsInOne voxels = {
      next.voxels[0] / before[0], next.voxels[1] / before[1], next.voxels[2] / before[2]};
    if (!next.band)
    {
      next.band = VolumeLike(band, next.GridOf(next.arrays.NextRows()));
      next.rows = 0;
    }
    SetCoarser(band, voxels, next.rows, *next.band, loop);
    next.rows += CoarserGrid(band.grid, voxels).dimensions[1];
    if (next.rows == next.band->grid.dimensions[1])
    {
      const GriddedVolume made = std::move(*next.band);
      next.band.reset();
      this->Add(number + 1, made, loop);
    }
  }

  // Takes the bricks of a part as they are.
  void AddRowsOf(const std::filesystem::path& part)
  {
    NxvInput file(part);
    const NxvContent content = OpenNxv(file);
    const GridSpecification& grid = content.header.volume.grid;
    NxvBrickArrays& arrays = levels.front().arrays;
    const VoxelBlock rows = arrays.NextRows(grid.dimensions[1]);
    // Not as a whole: the centre of a file's geographic grid is that of its rows.
    if (rows.Size(1) != grid.dimensions[1] || grid.origin != levels.front().GridOf(rows).origin)
    {
      throw Error("its rows do not follow those before");
    }
    CheckNxvPayloads(file, content);
    arrays.AddRows(grid.dimensions[1], content.header.arrays,
      [&](std::uint64_t offset, std::size_t size)
      { return file.ReadAll(content.payloads + offset, size); });
    this->Describe(content.header.volume);
  }

  // Makes bands of the next level of what a part has of it.
  void AddNextOf(const std::filesystem::path& part, const RangeLoop& loop)
  {
    const Level& next = levels[1];
    NxvReadOptions options;
    options.loop = loop;
    options.level = 1;
    const int rows = ReadNxvLevels(part).at(1).dimensions[1];
    for (int row = 0; row < rows; row += Rows)
    {
      VoxelBlock block = next.arrays.NextRows();
      const GridSpecification grid = next.GridOf(block);
      block.end[1] = row + block.Size(1);
      block.begin[1] = row;
      options.block = block;
      GriddedVolume band = ReadNxv(part, options);
      band.grid = grid;
      for (GriddedVolume& further : band.further)
      {
        further.grid = grid;
      }
      this->Add(1, band, loop);
    }
  }

  std::filesystem::path path;
  NxvHeader header;
  std::vector<Level> levels; // from fine to coarse
};

NxvBandWriter::NxvBandWriter(const std::filesystem::path& path, const GridSpecification& grid,
  std::optional<NxvEncoding> encoding)
  : impl(new Impl{path, {}, {}})
{
  const bool exact = encoding == NxvEncoding::Float;
  impl->header.volume.grid = grid;
  impl->levels.emplace_back(grid, VoxelBlock::Of(grid), VoxelsInOne{1, 1, 1}, exact);
  for (const VoxelsInOne& voxels : CoarserLevels(grid))
  {
    const GridSpecification coarser = CoarserGrid(grid, voxels);
    impl->levels.emplace_back(coarser, VoxelBlock::Of(coarser), voxels, exact);
  }
}

// The further levels are made of the next one, which for that must be exact.
NxvBandWriter::NxvBandWriter(const std::filesystem::path& path, const GridSpecification& grid,
  const VoxelBlock& rows, std::optional<NxvEncoding> encoding)
  : impl(new Impl{path, {}, {}})
{
  impl->header.volume.grid = PartOf(grid, rows);
  impl->levels.emplace_back(grid, rows, VoxelsInOne{1, 1, 1}, encoding == NxvEncoding::Float);
  const std::vector<VoxelsInOne> levels = CoarserLevels(grid);
  if (!levels.empty())
  {
    const VoxelsInOne& voxels = levels.front();
    const GridSpecification coarser = CoarserGrid(grid, voxels);
    VoxelBlock ofRows = VoxelBlock::Of(coarser);
    ofRows.begin[1] = rows.begin[1] / voxels[1];
    ofRows.end[1] = (rows.end[1] - 1) / voxels[1] + 1;
    impl->levels.emplace_back(coarser, ofRows, voxels, true);
  }
}

NxvBandWriter::~NxvBandWriter() = default;

void NxvBandWriter::Add(const GriddedVolume& band, const RangeLoop& loop)
{
  RequireFiniteFill(impl->path, band);
  impl->Describe(band);
  impl->Add(0, band, loop);
}

void NxvBandWriter::AddPart(const std::filesystem::path& part, const RangeLoop& loop)
{
  NamingTheFile(part, [&] { impl->AddRowsOf(part); });
  if (impl->levels.size() > 1)
  {
    impl->AddNextOf(part, loop);
  }
}

void NxvBandWriter::Commit()
{
  NxvPayload payload;
  for (Impl::Level& level : impl->levels)
  {
    std::vector<NxvArray> arrays = level.arrays.Finish(payload);
    if (&level == &impl->levels.front())
    {
      impl->header.arrays = std::move(arrays);
    }
    else
    {
      impl->header.levels.push_back({level.voxels, std::move(arrays)});
    }
  }
  WriteFile(impl->path, impl->header, payload);
}

} // namespace nexrad
