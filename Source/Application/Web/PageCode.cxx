// SPDX-License-Identifier: BSD-3-Clause
#include "Web/PageCode.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace nexrad::application
{
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
