// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Merging/VolumeCache.h"

#include <algorithm>
#include <cstring>

namespace nexrad
{
namespace
{

// Runs shorter than this are written value by value.
constexpr std::size_t shortestRun = 4;

// An array as stretches, each begun by its length times two, plus one for a run of one value.
class Packer
{
public:
  template <class Value>
  void Add(const std::vector<Value>& values)
  {
    this->Append(static_cast<std::uint64_t>(values.size()));
    std::size_t begin = 0;
    std::size_t at = 0;
    while (at < values.size())
    {
      const std::size_t end = EndOfRun(values, at);
      if (end - at >= shortestRun)
      {
        this->AddValues(values, begin, at);
        this->Append(static_cast<std::uint64_t>(end - at) * 2 + 1);
        this->Append(values[at]);
        begin = end;
      }
      at = end;
    }
    this->AddValues(values, begin, values.size());
  }

  std::vector<std::uint8_t> Bytes() &&
  {
    bytes.shrink_to_fit();
    return std::move(bytes);
  }

private:
  // Values are compared by their bits: what is not a number equals itself, and -0 is not 0.
  template <class Value>
  static std::size_t EndOfRun(const std::vector<Value>& values, std::size_t at)
  {
    std::size_t end = at + 1;
    // NOLINTNEXTLINE(bugprone-suspicious-memory-comparison)
    while (end < values.size() && std::memcmp(&values[end], &values[at], sizeof(Value)) == 0)
    {
      ++end;
    }
    return end;
  }

  template <class Value>
  void Append(const Value& value)
  {
    const auto* first = reinterpret_cast<const std::uint8_t*>(&value);
    bytes.insert(bytes.end(), first, first + sizeof value);
  }

  template <class Value>
  void AddValues(const std::vector<Value>& values, std::size_t begin, std::size_t end)
  {
    if (begin < end)
    {
      this->Append(static_cast<std::uint64_t>(end - begin) * 2);
      const auto* first = reinterpret_cast<const std::uint8_t*>(values.data() + begin);
      bytes.insert(bytes.end(), first, first + (end - begin) * sizeof(Value));
    }
  }

  std::vector<std::uint8_t> bytes;
};

class Unpacker
{
public:
  explicit Unpacker(const std::vector<std::uint8_t>& bytes)
    : at(bytes.data())
  {
  }

  template <class Value>
  void Fill(std::vector<Value>& values)
  {
    values.resize(this->Take<std::uint64_t>());
    auto place = values.begin();
    while (place != values.end())
    {
      const auto header = this->Take<std::uint64_t>();
      const auto count = static_cast<std::ptrdiff_t>(header / 2);
      if (header % 2 == 1)
      {
        std::fill_n(place, count, this->Take<Value>());
      }
      else
      {
        std::memcpy(&*place, at, static_cast<std::size_t>(count) * sizeof(Value));
        at += static_cast<std::size_t>(count) * sizeof(Value);
      }
      place += count;
    }
  }

private:
  template <class Value>
  Value Take()
  {
    Value value;
    std::memcpy(&value, at, sizeof value);
    at += sizeof value;
    return value;
  }

  const std::uint8_t* at;
};

// Calls `visit` for each array of a volume, which may be const; always in the same order.
template <class Volume, class Visit>
void ForEachVoxelArray(Volume& volume, const Visit& visit)
{
  visit(volume.values);
  visit(volume.states);
  ForEachAncillaryArray(volume.ancillary, [&](const char*, auto& values) { visit(values); });
  for (auto& further : volume.further)
  {
    ForEachVoxelArray(further, visit);
  }
}

// A copy without the arrays of the volume and of its further ones.
GriddedVolume DescriptionOf(const GriddedVolume& volume)
{
  GriddedVolume description = WithoutVoxels(volume);
  for (const GriddedVolume& further : volume.further)
  {
    description.further.push_back(DescriptionOf(further));
  }
  return description;
}

} // namespace

std::list<VolumeCache::Packed>::iterator VolumeCache::Place(const VoxelBlock& block, Time time)
{
  return std::find_if(entries.begin(), entries.end(),
    [&](const Packed& each) { return each.description.time == time && each.block == block; });
}

void VolumeCache::Keep(const VoxelBlock& block, const GriddedVolume& volume)
{
  if (limit == 0 || this->Place(block, volume.time) != entries.end())
  {
    return;
  }
  Packer packer;
  ForEachVoxelArray(volume, [&](const auto& values) { packer.Add(values); });
  Packed packed{block, DescriptionOf(volume), std::move(packer).Bytes()};
  const std::size_t bytes = packed.arrays.size();
  while (bytes <= limit && used + bytes > limit)
  {
    used -= entries.back().arrays.size();
    entries.pop_back();
  }
  if (bytes <= limit)
  {
    entries.push_front(std::move(packed));
    used += bytes;
  }
}

std::optional<GriddedVolume> VolumeCache::Find(const VoxelBlock& block, Time time)
{
  const auto packed = this->Place(block, time);
  if (packed == entries.end())
  {
    return std::nullopt;
  }
  entries.splice(entries.begin(), entries, packed);
  GriddedVolume volume = packed->description;
  Unpacker unpacker(packed->arrays);
  ForEachVoxelArray(volume, [&](auto& values) { unpacker.Fill(values); });
  return volume;
}

void VolumeCache::Clear()
{
  entries.clear();
  used = 0;
}

} // namespace nexrad
