// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Codec/NxvWriter.h"

#include "nexrad/Codec/NxvArrays.h"
#include "nexrad/Codec/NxvBricks.h"
#include "nexrad/Codec/NxvHeader.h"
#include "nexrad/Codec/NxvInput.h"
#include "nexrad/Codec/NxvLevels.h"
#include "nexrad/Codec/NxvOutput.h"
#include "nexrad/Codec/NxvReader.h"
#include "nexrad/Compression/Deflate.h"
#include "nexrad/Grid/MomentCode.h"
#include "nexrad/System/Error.h"

#include <cmath>
#include <utility>
#include <vector>

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

void AddMoment(FileContent& content, const GriddedVolume& volume, NxvEncoding encoding)
{
  CheckVoxelCount(volume);
  const NxvAddArray add =
    [&content](NxvArray array, std::size_t size, DeflateSearch search, const ByteSource& source)
  { content.AddDeflated(std::move(array), size, search, source); };
  switch (encoding)
  {
  case NxvEncoding::RadarSteps:
    AddRadarStepArrays(add, volume);
    break;
  case NxvEncoding::Thesis:
    AddThesisArrays([&content](NxvArray array, Bytes payload)
      { content.Add(std::move(array), std::move(payload)); },
      add, volume);
    break;
  case NxvEncoding::Float:
    AddFloatArrays(add, volume);
    break;
  }
  AddAncillaryArrays(add, volume, encoding == NxvEncoding::Float);
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
  WriteNxvFile(path, content.header, payload);
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
    const NxvAddArray add = [&level, &loop](const NxvArray& array, std::size_t,
                              DeflateSearch search, const ByteSource& source)
    { level.arrays.Add(array, search, source, loop); };
    if (band.grid != level.GridOf(level.arrays.BeginBand()))
    {
      throw Error(path.string() + ": bands must have " + std::to_string(Rows) +
                  " rows of the grid each, from the first row on");
    }
    AddBandArrays(add, band, level.exact);
    for (const GriddedVolume& further : band.further)
    {
      AddBandArrays(add, further, level.exact);
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
    Level& next = levels[number + 1];
    const VoxelsInOne voxels = VoxelsBetween(levels[number].voxels, next.voxels);
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
  WriteNxvFile(impl->path, impl->header, payload);
}

} // namespace nexrad
