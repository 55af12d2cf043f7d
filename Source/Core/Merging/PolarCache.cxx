// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Merging/PolarCache.h"

#include <algorithm>

namespace nexrad
{

PolarCache::PolarCache(std::size_t theLimit)
  : limit(theLimit)
{
}

// Called with the lock.
std::list<PolarCache::Entry>::iterator PolarCache::Place(const SeriesVolume& key, MomentName moment)
{
  return std::find_if(entries.begin(), entries.end(),
    [&](const Entry& each)
    { return each.volume->moment == moment && each.cycle == key.cycle && each.file == key.file; });
}

bool PolarCache::Offer(const SeriesVolume& key, const Volume& volume)
{
  const std::size_t bytes = MemoryOf(*volume);
  const std::lock_guard<std::mutex> lock(mutex);
  if (used + bytes > limit || this->Place(key, volume->moment) != entries.end())
  {
    return false;
  }
  entries.push_front({key.file, key.cycle, volume, bytes});
  used += bytes;
  return true;
}

void PolarCache::Keep(const SeriesVolume& key, const Volume& volume)
{
  const std::size_t bytes = MemoryOf(*volume);
  const std::lock_guard<std::mutex> lock(mutex);
  if (bytes > limit || this->Place(key, volume->moment) != entries.end())
  {
    return;
  }
  while (used + bytes > limit)
  {
    used -= entries.back().bytes;
    entries.pop_back();
  }
  entries.push_front({key.file, key.cycle, volume, bytes});
  used += bytes;
}

PolarCache::Volume PolarCache::Find(const SeriesVolume& key, MomentName moment)
{
  const std::lock_guard<std::mutex> lock(mutex);
  const auto entry = this->Place(key, moment);
  if (entry == entries.end())
  {
    return nullptr;
  }
  entries.splice(entries.begin(), entries, entry);
  return entries.front().volume;
}

std::size_t PolarCache::Used() const
{
  const std::lock_guard<std::mutex> lock(mutex);
  return used;
}

} // namespace nexrad
