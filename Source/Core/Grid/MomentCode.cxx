// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Grid/MomentCode.h"

#include "nexrad/System/Error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace nexrad
{

namespace
{

// value = (word − offset) / scale, as the data blocks of message 31 have it.
struct RadarWords
{
  unsigned bytes;
  double offset;
  double scale;
};

// In the order of MomentName. ZDR in the finer steps of the two that radars use.
// Derived moments have no words in message 31: SRV has those of VEL; shear and divergence have
// steps of 0.00001/s, KDP steps of 0.01 degrees a km.
constexpr std::array<RadarWords, KnownMomentCount> radarWords = {{{1, 66.0, 2.0}, {1, 129.0, 2.0},
  {1, 129.0, 2.0}, {2, 418.0, 32.0}, {2, 2.0, 2.8361}, {1, -60.5, 300.0}, {1, 8.0, 1.0},
  {1, 129.0, 2.0}, {2, 32768.0, 100'000.0}, {2, 32768.0, 100'000.0}, {2, 32768.0, 100.0}}};

// Velocities of radars that send whole m/s reach to ±127 m/s, and unfolded ones farther.
constexpr RadarWords wideVelocity = {2, 32768.0, 2.0};

MomentCode CodeOf(const RadarWords& words)
{
  return {words.bytes, -words.offset / words.scale, 1.0 / words.scale};
}

unsigned LargestCode(unsigned bytes)
{
  return bytes == 1 ? 0xFFU : 0xFFFFU;
}

// Whether all echoes lie between the first and the last code, but for rounding.
bool HoldsAll(const MomentCode& code, const GriddedVolume& volume)
{
  const double least = code.ValueOf(MomentCode::FirstEchoCode) - 0.5 * code.scale;
  const double most = code.ValueOf(LargestCode(code.bytes)) + 0.5 * code.scale;
  bool all = true;
  ForEachEcho(volume.states.data(), volume.states.size(),
    [&](std::size_t i)
    {
      const auto value = static_cast<double>(volume.values[i]);
      all = all && !(value < least || value > most);
    });
  return all;
}

} // namespace

MomentCode MomentCode::Of(const GriddedVolume& volume)
{
  const MomentCode code = CodeOf(radarWords[static_cast<std::size_t>(volume.moment)]);
  const bool tooFast = IsRadialVelocity(volume.moment) && !HoldsAll(code, volume);
  return tooFast ? CodeOf(wideVelocity) : code;
}

MomentCode MomentCode::Widest(MomentName moment)
{
  return CodeOf(
    IsRadialVelocity(moment) ? wideVelocity : radarWords[static_cast<std::size_t>(moment)]);
}

unsigned MomentCode::Encode(float value) const
{
  if (std::isnan(value))
  {
    return NotScannedCode;
  }
  const double code = std::clamp((static_cast<double>(value) - offset) / scale,
    static_cast<double>(FirstEchoCode), static_cast<double>(LargestCode(bytes)));
  return static_cast<unsigned>(code + 0.5);
}

VoxelState MomentCode::StateOf(unsigned code)
{
  switch (code)
  {
  case NoEchoCode:
    return VoxelState::NoEcho;
  case NotScannedCode:
    return VoxelState::NotScanned;
  default:
    return VoxelState::Echo;
  }
}

void MomentCode::WriteBytes(const float* values, const VoxelState* states, std::size_t count,
  unsigned shift, std::uint8_t* to) const
{
  const auto codeOf = [shift](VoxelState state)
  { return state == VoxelState::NotScanned ? NotScannedCode >> shift : NoEchoCode; };
  std::transform(states, states + count, to,
    [&codeOf](VoxelState state) { return static_cast<std::uint8_t>(codeOf(state)); });
  ForEachEcho(states, count,
    [&](std::size_t i) { to[i] = static_cast<std::uint8_t>(this->Encode(values[i]) >> shift); });
}

void MomentCode::WriteBytes(
  const GriddedVolume& volume, std::size_t first, std::size_t count, std::uint8_t* to) const
{
  const std::size_t voxels = volume.states.size();
  const std::size_t lower = first < voxels ? std::min(count, voxels - first) : 0;
  const auto write = [&](std::size_t voxel, std::size_t length, unsigned shift)
  {
    this->WriteBytes(volume.values.data() + voxel, volume.states.data() + voxel, length, shift, to);
    to += length;
  };
  write(first, lower, 0);
  if (count > lower)
  {
    write(first + lower - voxels, count - lower, 8);
  }
}

void MomentCode::DecodeAll(const std::vector<std::uint8_t>& codes, GriddedVolume& volume) const
{
  std::vector<float> values(LargestCode(bytes) + std::size_t(1));
  for (unsigned code = 0; code < values.size(); ++code)
  {
    values[code] = StateOf(code) == VoxelState::Echo ? this->ValueOf(code) : volume.fill;
  }
  const std::size_t count = codes.size() / bytes;
  volume.values.resize(count);
  volume.states.resize(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    const unsigned higher = bytes == 2 ? codes[count + i] : 0;
    const unsigned code = codes[i] | higher << 8;
    volume.values[i] = values[code];
    volume.states[i] = StateOf(code);
  }
}

void ExpandCodes(const VoxelCodes& meaning, const std::uint8_t* codes, std::size_t count,
  float* values, VoxelState* states, const RangeLoop& loop)
{
  constexpr std::size_t stretch = std::size_t(1) << 18;
  RunLoop(loop, static_cast<int>((count + stretch - 1) / stretch),
    [&](int first, int last)
    {
      const std::size_t end = std::min(count, static_cast<std::size_t>(last) * stretch);
      for (std::size_t i = static_cast<std::size_t>(first) * stretch; i < end; ++i)
      {
        values[i] = meaning.values[codes[i]];
        states[i] = meaning.states[codes[i]];
      }
    });
}

void CheckVoxelCount(const GriddedVolume& volume)
{
  const std::size_t voxels = volume.grid.VoxelCount();
  if (voxels > 0 && volume.codes.size() == voxels)
  {
    return;
  }
  if (voxels == 0 || volume.values.size() != voxels || volume.states.size() != voxels)
  {
    throw Error("a volume of " + std::to_string(voxels) + " voxels with " +
                std::to_string(volume.values.size()) + " values and " +
                std::to_string(volume.states.size()) + " states cannot be stored");
  }
}

} // namespace nexrad
