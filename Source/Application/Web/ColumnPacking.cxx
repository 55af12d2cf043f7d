// SPDX-License-Identifier: BSD-3-Clause
#include "Web/ColumnPacking.h"

#include "nexrad/System/Error.h"

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
  const std::size_t voxels = static_cast<std::size_t>(size[0]) * static_cast<std::size_t>(size[1]) *
                             static_cast<std::size_t>(size[2]);
  if (codes.size() != voxels)
  {
    throw Error("the volume has " + std::to_string(codes.size()) + " codes for " +
                std::to_string(voxels) + " voxels");
  }
  return Packer(size, codes).Pack();
}

} // namespace nexrad::application
