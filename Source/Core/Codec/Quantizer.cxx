// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Codec/Quantizer.h"

#include "nexrad/Codec/EchoVoxels.h"
#include "nexrad/System/Error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace nexrad
{

namespace
{

// The code of an echo.
inline std::uint8_t CodeOf(float value, const Quantizer& quantizer)
{
  if (std::isnan(value))
  {
    return Quantizer::NotScannedCode;
  }
  const double limited = std::min(static_cast<double>(value), quantizer.maximum);
  const double code = std::clamp((limited - quantizer.offset) / quantizer.scale, 0.0,
    static_cast<double>(Quantizer::LargestCode));
  // std::round, which costs a call, for what is not negative.
  const auto below = static_cast<std::uint8_t>(code);
  return code - below < 0.5 ? below : static_cast<std::uint8_t>(below + 1);
}

} // namespace

std::uint8_t Quantizer::Encode(float value, VoxelState state) const
{
  switch (state)
  {
  case VoxelState::Echo:
    return CodeOf(value, *this);
  case VoxelState::NotScanned:
    return NotScannedCode;
  default:
    return NoEchoCode;
  }
}

VoxelState Quantizer::StateOf(std::uint8_t code)
{
  if (code == NotScannedCode)
  {
    return VoxelState::NotScanned;
  }
  return code == NoEchoCode ? VoxelState::NoEcho : VoxelState::Echo;
}

void Quantizer::Check(const GriddedVolume& volume) const
{
  if (!std::isfinite(offset) || !std::isfinite(scale) || scale <= 0.0 || std::isnan(maximum))
  {
    throw Error("codes of offset " + std::to_string(offset) + " and scale " +
                std::to_string(scale) + ": the scale must be above 0 and both finite");
  }
  CheckVoxelCount(volume);
}

std::vector<std::uint8_t> Quantizer::EncodeAll(const GriddedVolume& volume) const
{
  this->Check(volume);
  std::vector<std::uint8_t> codes(volume.values.size());
  this->EncodeSome(volume, 0, codes.size(), codes.data());
  return codes;
}

void Quantizer::EncodeSome(
  const GriddedVolume& volume, std::size_t begin, std::size_t end, std::uint8_t* codes) const
{
  const VoxelState* const states = volume.states.data() + begin;
  const float* const values = volume.values.data() + begin;
  const std::size_t count = end - begin;
  std::transform(states, states + count, codes,
    [](VoxelState state) { return state == VoxelState::NotScanned ? NotScannedCode : NoEchoCode; });
  ForEachEcho(states, count, [&](std::size_t i) { codes[i] = CodeOf(values[i], *this); });
}

void Quantizer::DecodeAll(const std::vector<std::uint8_t>& codes, GriddedVolume& volume) const
{
  std::array<float, 256> values;
  std::array<VoxelState, 256> states;
  for (std::size_t code = 0; code < values.size(); ++code)
  {
    states[code] = StateOf(static_cast<std::uint8_t>(code));
    values[code] = states[code] == VoxelState::Echo ? this->ValueOf(static_cast<std::uint8_t>(code))
                                                    : volume.fill;
  }
  volume.values.resize(codes.size());
  volume.states.resize(codes.size());
  std::transform(codes.begin(), codes.end(), volume.values.begin(),
    [&values](std::uint8_t code) { return values[code]; });
  std::transform(codes.begin(), codes.end(), volume.states.begin(),
    [&states](std::uint8_t code) { return states[code]; });
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
