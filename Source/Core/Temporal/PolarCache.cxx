// SPDX-License-Identifier: BSD-3-Clause
#include "Temporal/PolarCache.h"

#include "Model/Error.h"

#include <algorithm>
#include <utility>

namespace nexrad
{

std::size_t MemoryOf(const PolarVolume& volume)
{
  std::size_t bytes = sizeof(PolarVolume);
  for (const PolarSweep& sweep : volume.sweeps)
  {
    bytes += sizeof(PolarSweep) + sweep.rays.size() * sizeof(PolarRay) +
             sweep.values.size() * sizeof(float) + sweep.states.size() * sizeof(GateState);
  }
  return bytes;
}

PolarCache::PolarCache(MomentName theMoment, std::size_t theLimit, Level2Options theOptions)
  : moment(theMoment)
  , limit(theLimit)
  , options(std::move(theOptions))
{
}

std::size_t PolarCache::Used() const
{
  const std::lock_guard<std::mutex> lock(mutex);
  return used;
}

void PolarCache::Offer(const SeriesVolume& key, const RadarVolume& volume)
{
  if (this->Used() >= limit)
  {
    return;
  }
  this->Insert(key, std::make_shared<const PolarVolume>(MakePolarVolume(volume, moment)), false);
}

std::shared_ptr<const PolarVolume> PolarCache::Get(const SeriesVolume& key)
{
  if (std::shared_ptr<const PolarVolume> kept = this->Find(key))
  {
    return kept;
  }
  const std::vector<RadarVolume> cycles = SplitCycles(ReadLevel2(key.file, options));
  if (key.cycle >= cycles.size() || cycles[key.cycle].Start() != key.start)
  {
    throw Error(key.file.string() + ": the file changed since it was first read; read it again");
  }
  auto volume = std::make_shared<const PolarVolume>(MakePolarVolume(cycles[key.cycle], moment));
  this->Insert(key, volume, true);
  return volume;
}

std::shared_ptr<const PolarVolume> PolarCache::Find(const SeriesVolume& key)
{
  const std::lock_guard<std::mutex> lock(mutex);
  const auto entry = std::find_if(entries.begin(), entries.end(),
    [&key](const Entry& each) { return each.cycle == key.cycle && each.file == key.file; });
  if (entry == entries.end())
  {
    return nullptr;
  }
  entries.splice(entries.begin(), entries, entry);
  return entry->volume;
}

void PolarCache::Insert(
  const SeriesVolume& key, std::shared_ptr<const PolarVolume> volume, bool makeRoom)
{
  const std::size_t bytes = MemoryOf(*volume);
  const std::lock_guard<std::mutex> lock(mutex);
  while (makeRoom && bytes <= limit && used + bytes > limit)
  {
    used -= entries.back().bytes;
    entries.pop_back();
  }
  if (used + bytes <= limit)
  {
    entries.push_front({key.file, key.cycle, bytes, std::move(volume)});
    used += bytes;
  }
}

} // namespace nexrad
