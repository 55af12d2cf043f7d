// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Merging/PolarCache.h"

#include "nexrad/System/Error.h"

#include <algorithm>
#include <utility>

namespace nexrad
{

PolarCache::PolarCache(MomentName theMoment, std::size_t theLimit, Level2Options theOptions,
  const QualityOptions& theQuality)
  : moment(theMoment)
  , limit(theLimit)
  , options(std::move(theOptions))
  , quality(theQuality)
{
}

std::size_t PolarCache::Used() const
{
  const std::lock_guard<std::mutex> lock(mutex);
  return usedBytes;
}

std::size_t PolarCache::DecodedFiles() const
{
  const std::lock_guard<std::mutex> lock(mutex);
  return decodedFiles;
}

void PolarCache::Offer(const SeriesVolume& key, const RadarVolume& volume)
{
  {
    const std::lock_guard<std::mutex> lock(mutex);
    if (usedBytes >= limit)
    {
      return;
    }
  }
  this->Insert(
    key, std::make_shared<const PolarVolume>(MakeCleanVolume(volume, moment, quality)), false);
}

std::shared_ptr<const PolarVolume> PolarCache::Get(const SeriesVolume& key)
{
  if (Volume kept = this->Find(key))
  {
    return kept;
  }
  {
    const std::lock_guard<std::mutex> lock(mutex);
    ++decodedFiles;
  }
  const std::vector<RadarVolume> cycles = SplitCycles(ReadLevel2(key.file, options));
  if (key.cycle >= cycles.size() || cycles[key.cycle].Start() != key.start)
  {
    throw Error(key.file.string() + ": the file changed since it was first read; read it again");
  }
  auto volume =
    std::make_shared<const PolarVolume>(MakeCleanVolume(cycles[key.cycle], moment, quality));
  this->Insert(key, volume, true);
  return volume;
}

PolarCache::Volume PolarCache::Find(const SeriesVolume& key)
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

void PolarCache::Insert(const SeriesVolume& key, Volume volume, bool makeRoom)
{
  const std::size_t bytes = MemoryOf(*volume);
  const std::lock_guard<std::mutex> lock(mutex);
  while (makeRoom && bytes <= limit && usedBytes + bytes > limit)
  {
    usedBytes -= entries.back().bytes;
    entries.pop_back();
  }
  if (usedBytes + bytes <= limit)
  {
    entries.push_front({key.file, key.cycle, bytes, std::move(volume)});
    usedBytes += bytes;
  }
}

} // namespace nexrad
