// SPDX-License-Identifier: BSD-3-Clause
#include "Web/PageCode.h"

#include "nexrad/System/Error.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

namespace nexrad::application
{
namespace
{

using Codes = std::vector<std::uint8_t>;

class Packer
{
public:
  Packer(const std::array<int, 3>& size, const Codes& allCodes)
    : columns(static_cast<std::size_t>(size[0]))
    , rows(static_cast<std::size_t>(size[1]))
    , layers(static_cast<std::size_t>(size[2]))
    , codes(allCodes)
  {
  }

  PackedColumns Pack()
  {
    for (std::size_t column = 0; column < columns * rows; ++column)
    {
      this->PackEnds(column);
      this->PackCodes(column);
    }
    return std::move(packed);
  }

private:
  std::uint8_t CodeOf(std::size_t column, std::size_t layer) const
  {
    return codes[layer * columns * rows + column];
  }

  // The layers at which echo begins and ends by turns, as differences from those of the column
  // before where it has as many, else from the one below.
  void PackEnds(std::size_t column)
  {
    std::vector<std::size_t> ends;
    for (std::size_t layer = 0; layer <= layers; ++layer)
    {
      const bool echo = layer < layers && this->CodeOf(column, layer) != 0;
      if (echo != (ends.size() % 2 == 1))
      {
        ends.push_back(layer);
      }
    }
    packed.ends.push_back(static_cast<std::uint8_t>(ends.size()));
    for (std::size_t i = 0; i < ends.size(); ++i)
    {
      const std::size_t guess =
        ends.size() == before.size() ? before[i] : (i > 0 ? ends[i - 1] : 0);
      packed.ends.push_back(static_cast<std::uint8_t>(ends[i] - guess)); // modulo 256
    }
    before = ends;
  }

  // The code that a voxel probably has: that of the voxel below, to the west, or to the south, the
  // first of them with echo.
  std::uint8_t Guess(std::size_t column, std::size_t layer) const
  {
    const std::uint8_t below = layer > 0 ? this->CodeOf(column, layer - 1) : std::uint8_t{0};
    if (below != 0)
    {
      return below;
    }
    const std::uint8_t west =
      column % columns > 0 ? this->CodeOf(column - 1, layer) : std::uint8_t{0};
    if (west != 0)
    {
      return west;
    }
    return column >= columns ? this->CodeOf(column - columns, layer) : std::uint8_t{0};
  }

  void PackCodes(std::size_t column)
  {
    for (std::size_t layer = 0; layer < layers; ++layer)
    {
      const std::uint8_t code = this->CodeOf(column, layer);
      if (code != 0)
      {
        packed.codes.push_back(static_cast<std::uint8_t>(code - this->Guess(column, layer)));
      }
    }
  }

  const std::size_t columns;
  const std::size_t rows;
  const std::size_t layers;
  const Codes& codes;
  std::vector<std::size_t> before; // ends of the column before
  PackedColumns packed;
};

} // namespace

PackedColumns PackColumns(const std::array<int, 3>& size, const Codes& codes)
{
  if (size[2] > MostPackedLayers)
  {
    throw Error("the volume has " + std::to_string(size[2]) + " layers, and a page takes at most " +
                std::to_string(MostPackedLayers) +
                "; merge with fewer, or write the page into a folder beside the volumes");
  }
  return Packer(size, codes).Pack();
}

namespace
{

constexpr int lastByte = 255;
constexpr int bytesPerCode = 4;       // of reflectivity: 2 dBZ
constexpr int bytesPerMaskedCode = 2; // of the other moments

// Weak echo beside visible echo has two codes. Its values only shape the edge of what is seen: the
// texture interpolates from them. The shares are of the bytes below the floor.
constexpr std::uint8_t weakCodes = 2;
constexpr double weakMiddle = 0.6;
constexpr double weakValues[weakCodes] = {0.45, 0.87};

std::uint8_t ToByte(double value)
{
  return static_cast<std::uint8_t>(std::clamp(std::lround(value), 0L, long{lastByte}));
}

// Marks the neighbours of marked voxels along one axis, whose voxels are `stride` apart.
void Spread(std::vector<bool>& marks, std::size_t stride, std::size_t extent)
{
  const std::vector<bool> before = marks;
  for (std::size_t voxel = 0; voxel < marks.size(); ++voxel)
  {
    const std::size_t place = voxel / stride % extent;
    marks[voxel] = before[voxel] || (place > 0 && before[voxel - stride]) ||
                   (place + 1 < extent && before[voxel + stride]);
  }
}

// The voxels from which a value at or above the floor can be interpolated: those that have one, and
// all their neighbours.
std::vector<bool> FindKept(const GriddedVolume& volume, double floor)
{
  std::vector<bool> kept(volume.values.size());
  for (std::size_t voxel = 0; voxel < kept.size(); ++voxel)
  {
    kept[voxel] = volume.states[voxel] == VoxelState::Echo &&
                  static_cast<double>(volume.values[voxel]) >= floor;
  }
  std::size_t stride = 1;
  for (const int extent : volume.grid.dimensions)
  {
    Spread(kept, stride, static_cast<std::size_t>(extent));
    stride *= static_cast<std::size_t>(extent);
  }
  return kept;
}

} // namespace

PageCode PageCode::OfReflectivity(const GriddedVolume& volume, double leastVisible)
{
  PageCode code;
  code.first = static_cast<double>(volume.fill);
  code.step = 0.5;
  const double least = std::clamp(std::floor(code.ByteOf(leastVisible)), 1.0, double{lastByte});
  code.floor = code.ValueOf(static_cast<std::uint8_t>(least));
  code.bytes = {0, ToByte(weakValues[0] * least), ToByte(weakValues[1] * least)};
  for (int byte = static_cast<int>(least); byte <= lastByte; byte += bytesPerCode)
  {
    code.bytes.push_back(ToByte(byte + bytesPerCode / 2.0));
  }
  return code;
}

PageCode PageCode::OfRange(const std::array<double, 2>& range)
{
  PageCode code;
  code.masked = true;
  code.step = (range[1] - range[0]) / (lastByte - 1);
  code.first = range[0] - code.step;
  code.bytes = {0};
  for (int byte = 1; byte < lastByte; byte += bytesPerMaskedCode)
  {
    code.bytes.push_back(ToByte(byte + bytesPerMaskedCode / 2.0));
  }
  return code;
}

std::vector<std::uint8_t> PageCode::Encode(const GriddedVolume& volume) const
{
  const double floorByte = floor ? this->ByteOf(*floor) : 0.0;
  const std::vector<bool> kept = floor ? FindKept(volume, *floor) : std::vector<bool>();
  const int firstCode = floor ? 1 + weakCodes : 1;
  const int lastCode = static_cast<int>(bytes.size()) - 1;
  const double firstByte = floor ? floorByte : 1.0;
  const int width = floor ? bytesPerCode : bytesPerMaskedCode;
  std::vector<std::uint8_t> codes(volume.values.size());
  for (std::size_t voxel = 0; voxel < codes.size(); ++voxel)
  {
    const double byte = this->ByteOf(static_cast<double>(volume.values[voxel]));
    if (volume.states[voxel] != VoxelState::Echo ||
        !(floor ? bool{kept[voxel]} : !std::isnan(byte)))
    {
      continue;
    }
    if (floor && byte < floorByte)
    {
      codes[voxel] = byte < weakMiddle * floorByte ? 1 : weakCodes;
      continue;
    }
    const double steps = std::clamp((byte - firstByte) / width, 0.0, double{lastByte});
    codes[voxel] =
      static_cast<std::uint8_t>(std::min(firstCode + static_cast<int>(steps), lastCode));
  }
  return codes;
}

} // namespace nexrad::application
