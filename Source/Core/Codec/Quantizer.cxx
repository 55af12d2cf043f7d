// SPDX-License-Identifier: BSD-3-Clause
#include "Codec/Quantizer.h"

#include "Model/Error.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace nexrad
{

std::uint8_t Quantizer::Encode(float value, VoxelState state) const
{
  if (state == VoxelState::NotScanned || (state == VoxelState::Echo && std::isnan(value)))
  {
    return NotScannedCode;
  }
  if (state != VoxelState::Echo)
  {
    return NoEchoCode;
  }
  const double limited = std::min(static_cast<double>(value), maximum);
  const double code = std::round((limited - offset) / scale);
  return static_cast<std::uint8_t>(std::clamp(code, 0.0, static_cast<double>(LargestCode)));
}

VoxelState Quantizer::StateOf(std::uint8_t code)
{
  if (code == NotScannedCode)
  {
    return VoxelState::NotScanned;
  }
  return code == NoEchoCode ? VoxelState::NoEcho : VoxelState::Echo;
}

std::vector<std::uint8_t> Quantizer::EncodeAll(const GriddedVolume& volume) const
{
  if (!std::isfinite(offset) || !std::isfinite(scale) || scale <= 0.0 || std::isnan(maximum))
  {
    throw Error("codes of offset " + std::to_string(offset) + " and scale " +
                std::to_string(scale) + ": the scale must be above 0 and both finite");
  }
  CheckVoxelCount(volume);
  std::vector<std::uint8_t> codes(volume.values.size());
  for (std::size_t i = 0; i < codes.size(); ++i)
  {
    codes[i] = this->Encode(volume.values[i], volume.states[i]);
  }
  return codes;
}

void Quantizer::DecodeAll(const std::vector<std::uint8_t>& codes, GriddedVolume& volume) const
{
  volume.values.resize(codes.size());
  volume.states.resize(codes.size());
  for (std::size_t i = 0; i < codes.size(); ++i)
  {
    volume.states[i] = StateOf(codes[i]);
    volume.values[i] = volume.states[i] == VoxelState::Echo ? this->ValueOf(codes[i]) : volume.fill;
  }
}

void CheckVoxelCount(const GriddedVolume& volume)
{
  const std::size_t voxels = volume.grid.VoxelCount();
  if (voxels == 0 || volume.values.size() != voxels || volume.states.size() != voxels)
  {
    throw Error("a volume of " + std::to_string(voxels) + " voxels with " +
                std::to_string(volume.values.size()) + " values and " +
                std::to_string(volume.states.size()) + " states cannot be stored");
  }
}

} // namespace nexrad
