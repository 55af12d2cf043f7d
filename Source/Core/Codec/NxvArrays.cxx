// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Codec/NxvArrays.h"

#include "nexrad/Codec/NxvBricks.h"
#include "nexrad/Codec/ThesisStream.h"
#include "nexrad/Grid/MomentCode.h"
#include "nexrad/System/Error.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>

namespace nexrad
{

namespace
{

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

void AddStates(const NxvAddArray& add, const GriddedVolume& volume, const ByteSource& states)
{
  NxvArray array;
  array.name = std::string(ToString(volume.moment)) + "_state";
  array.type = NxvType::UInt8;
  array.fill = static_cast<double>(VoxelState::NotScanned);
  add(array, volume.grid.VoxelCount(), DeflateSearch::Runs, states);
}

// Whether any voxel has a state that codes do not tell.
bool Holds(const GriddedVolume& volume, VoxelState state)
{
  if (!volume.codes.empty())
  {
    const std::vector<StateRun>& runs = volume.statesBesideCodes;
    return std::any_of(
      runs.begin(), runs.end(), [state](const StateRun& run) { return run.state == state; });
  }
  // std::find would look at them one by one.
  const std::vector<VoxelState>& states = volume.states;
  return std::memchr(states.data(), static_cast<int>(state), states.size()) != nullptr;
}

// Of the bytes [first, first + count) of all voxels, sets those of voxels that have a state beside
// their codes.
void SetBytesOf(VoxelState state, const GriddedVolume& volume, std::uint8_t byte, std::size_t first,
  std::size_t count, std::uint8_t* to)
{
  const std::vector<StateRun>& runs = volume.statesBesideCodes;
  auto run = std::partition_point(runs.begin(), runs.end(),
    [first](const StateRun& each) { return each.first + each.count <= first; });
  for (; run != runs.end() && run->first < first + count; ++run)
  {
    if (run->state == state)
    {
      const std::size_t begin = std::max(run->first, first);
      const std::size_t end = std::min(run->first + run->count, first + count);
      std::fill(to + (begin - first), to + (end - first), byte);
    }
  }
}

void RequireValues(const GriddedVolume& volume)
{
  if (!volume.codes.empty())
  {
    throw Error(
      "a volume that was merged into codes can be written as these alone, without bricks");
  }
}

// Which voxels are filtered, where some are. Readers that do not know the array take them for no
// echo.
void AddFiltered(const NxvAddArray& add, const GriddedVolume& volume)
{
  if (!Holds(volume, VoxelState::Filtered))
  {
    return;
  }
  NxvArray array;
  array.name = std::string(ToString(volume.moment)) + "_filtered";
  array.type = NxvType::UInt8;
  const ByteSource ofStates = BytesOfVoxels(
    [&states = volume.states](std::size_t i) { return states[i] == VoxelState::Filtered; });
  const ByteSource besideCodes = [&volume](std::size_t first, std::size_t count, std::uint8_t* to)
  {
    std::fill(to, to + count, std::uint8_t(0));
    SetBytesOf(VoxelState::Filtered, volume, 1, first, count, to);
  };
  add(array, volume.grid.VoxelCount(), DeflateSearch::Runs,
    volume.codes.empty() ? ofStates : besideCodes);
}

void AddCodes(const NxvAddArray& add, const GriddedVolume& volume, const MomentCode& code)
{
  NxvArray array = MomentArray(volume);
  array.type = code.bytes == 1 ? NxvType::UInt8 : NxvType::UInt16;
  array.offset = code.offset;
  array.scale = code.scale;
  const auto write = [&](std::size_t first, std::size_t count, std::uint8_t* to)
  {
    volume.codes.empty() ? code.WriteBytes(volume, first, count, to)
                         : void(std::copy_n(volume.codes.data() + first, count, to));
  };
  add(array, code.bytes * volume.grid.VoxelCount(), DeflateSearch::Runs, write);
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
void CheckAncillaryValues(
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

// The same code in all bands, whatever they hold; states where the codes do not tell them.
void AddBandCodes(const NxvAddArray& add, const GriddedVolume& volume)
{
  AddCodes(add, volume, MomentCode::Widest(volume.moment));
  if (Holds(volume, VoxelState::RangeFolded))
  {
    AddStates(add, volume,
      BytesOfVoxels(
        [&states = volume.states](std::size_t i)
        {
          return states[i] == VoxelState::RangeFolded ? static_cast<std::uint8_t>(states[i])
                                                      : NxvStateAsCode;
        }));
  }
  AddFiltered(add, volume);
}

} // namespace

void AddFloatArrays(const NxvAddArray& add, const GriddedVolume& volume)
{
  RequireValues(volume);
  NxvArray array = MomentArray(volume);
  array.type = NxvType::Float32;
  add(
    array, volume.values.size() * sizeof(float), DeflateSearch::Repeats, FloatBytes(volume.values));
  AddStates(add, volume,
    BytesOfVoxels([&states = volume.states](std::size_t i) { return StateInFile(states[i]); }));
  AddFiltered(add, volume);
}

// The array of states has those that the 7-bit codes stand for, but range folded. Echoes that
// became code 0 are no echo, with the array of states as without.
void AddThesisArrays(
  const NxvAddPayload& addPayload, const NxvAddArray& add, const GriddedVolume& volume)
{
  RequireValues(volume);
  const std::vector<std::uint8_t> codes = ThesisCode::EncodeAll(volume);
  addPayload(MomentArray(volume), EncodeRunLength(codes));
  if (Holds(volume, VoxelState::RangeFolded))
  {
    AddStates(add, volume,
      BytesOfVoxels(
        [&codes, &states = volume.states](std::size_t i)
        {
          const bool folded = states[i] == VoxelState::RangeFolded;
          return folded ? VoxelState::RangeFolded : ThesisCode::StateOf(codes[i]);
        }));
  }
  AddFiltered(add, volume);
}

// An echo that is not a number has the code, and with it the state, of not scanned.
void AddRadarStepArrays(const NxvAddArray& add, const GriddedVolume& volume)
{
  AddCodes(add, volume, MomentCode::Of(volume));
  if (Holds(volume, VoxelState::RangeFolded))
  {
    const ByteSource ofStates = BytesOfVoxels(
      [&volume](std::size_t i)
      {
        const VoxelState state = StateInFile(volume.states[i]);
        const bool isNumber = state != VoxelState::Echo || !std::isnan(volume.values[i]);
        return isNumber ? state : VoxelState::NotScanned;
      });
    const ByteSource besideCodes = [&volume](std::size_t first, std::size_t count, std::uint8_t* to)
    {
      const std::uint8_t* codes = volume.codes.data() + first;
      std::transform(codes, codes + count, to,
        [](std::uint8_t code) { return static_cast<std::uint8_t>(MomentCode::StateOf(code)); });
      constexpr VoxelState folded = VoxelState::RangeFolded;
      SetBytesOf(folded, volume, static_cast<std::uint8_t>(folded), first, count, to);
    };
    AddStates(add, volume, volume.codes.empty() ? ofStates : besideCodes);
  }
  AddFiltered(add, volume);
}

void AddAncillaryArrays(const NxvAddArray& add, const GriddedVolume& volume, bool exact)
{
  const auto addIfThere = [&](const std::string& name, const auto& values)
  {
    if (values.empty())
    {
      return;
    }
    CheckAncillaryValues(volume, name, values);
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

void AddBandArrays(const NxvAddArray& add, const GriddedVolume& volume, bool exact)
{
  CheckVoxelCount(volume);
  RequireValues(volume); // of which the coarser levels are made, too
  if (exact)
  {
    AddFloatArrays(add, volume);
  }
  else
  {
    AddBandCodes(add, volume);
  }
  AddAncillaryArrays(add, volume, true);
}

} // namespace nexrad
