// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Live/ChunkedVolume.h"

#include "nexrad/Compression/Deflate.h"
#include "nexrad/Compression/LdmRecords.h"
#include "nexrad/Level2/Messages/VolumeHeader.h"

#include <algorithm>
#include <cstdlib>

namespace nexrad
{

namespace
{

// Walks over the records by their lengths. `marksLast`: the length of the last one is negative.
ChunkExtent ExtentOf(ByteView stored, bool marksLast)
{
  constexpr std::size_t lengthBytes = 4;
  constexpr std::size_t signature = 14; // a length, and what begins a bzip2 stream
  std::size_t position = IsVolumeHeader(stored, 0) ? VolumeHeader::bytes : 0;
  if (stored.Size() < position + signature)
  {
    return position == 0 ? ChunkExtent::Cut : ChunkExtent::Unknown;
  }
  bool lastIsMarked = false;
  while (position < stored.Size())
  {
    if (stored.Size() - position < signature)
    {
      return ChunkExtent::Cut;
    }
    if (!IsLdmRecord(stored, position))
    {
      return ChunkExtent::Unknown;
    }
    const std::int64_t length = stored.I32(position);
    const auto bytes = static_cast<std::size_t>(std::abs(length));
    if (!stored.Has(position + lengthBytes, bytes))
    {
      return ChunkExtent::Cut;
    }
    lastIsMarked = length < 0;
    position += lengthBytes + bytes;
  }
  return marksLast && !lastIsMarked ? ChunkExtent::Unknown : ChunkExtent::Whole;
}

// Whether a ray is the last one of its cut (ICD 2620002, table XVII: 2 end of elevation, 4 end of
// volume).
bool EndsCut(const Ray& ray)
{
  return ray.radialStatus == RadialStatus::EndOfCut ||
         ray.radialStatus == RadialStatus::EndOfVolume;
}

} // namespace

ChunkExtent ExtentOfChunk(ByteView stored)
{
  return ExtentOf(stored, false);
}

ChunkExtent ExtentOfFile(ByteView stored)
{
  return ExtentOf(stored, true);
}

std::vector<SweepArrival> ArrivedSweeps(const RadarVolume& volume)
{
  std::vector<SweepArrival> arrivals;
  for (const Sweep& sweep : volume.sweeps)
  {
    const bool isLast = &sweep == &volume.sweeps.back();
    arrivals.push_back({sweep.elevationNumber, sweep.MedianElevation(), sweep.rays.front().time,
      sweep.rays.back().time, sweep.rays.size(), !isLast || EndsCut(sweep.rays.back())});
  }
  return arrivals;
}

void DropSweepInProgress(RadarVolume& volume)
{
  if (!volume.sweeps.empty() && !EndsCut(volume.sweeps.back().rays.back()))
  {
    volume.sweeps.pop_back();
  }
}

ChunkedVolume::ChunkedVolume(std::string theName, const Level2Options& theOptions)
  : name(std::move(theName))
  , options(theOptions)
  , decoder(std::make_unique<ChunkDecoder>(theOptions))
{
}

ChunkedVolume::Arrival ChunkedVolume::Add(
  Place place, const std::string& file, std::vector<std::uint8_t> stored)
{
  const std::uint32_t crc32 = Crc32(stored.data(), stored.size());
  const auto found = chunks.find(place);
  const bool known = found != chunks.end();
  if (known && found->second.size == stored.size() && found->second.crc32 == crc32)
  {
    return Arrival::Repeated;
  }
  if (closed)
  {
    return Arrival::Closed;
  }
  const std::size_t size = stored.size();
  chunks[place] = {file, std::move(stored), size, crc32};
  const bool late = last && !(*last < place);
  if (late)
  {
    decoder = std::make_unique<ChunkDecoder>(options);
    last.reset();
    decoded = 0;
  }
  this->Decode();
  return known ? Arrival::Replaced : late ? Arrival::Late : Arrival::New;
}

// Decodes what follows the last chunk that was decoded.
void ChunkedVolume::Decode()
{
  int next = last ? last->number + 1 : 1;
  for (auto chunk = last ? chunks.upper_bound(*last) : chunks.begin(); chunk != chunks.end();
       ++chunk)
  {
    for (; next < chunk->first.number; ++next)
    {
      if (skipped.count(next) == 0)
      {
        return;
      }
    }
    decoder->Begin(chunk->first.number, chunk->second.file);
    decoder->Decode(chunk->second.stored);
    last = chunk->first;
    next = chunk->first.number + 1;
    ++decoded;
  }
}

std::vector<int> ChunkedVolume::Missing() const
{
  std::vector<int> missing;
  int next = 1;
  for (const auto& [place, chunk] : chunks)
  {
    for (; next < place.number; ++next)
    {
      missing.push_back(next);
    }
    next = place.number + 1;
  }
  return missing;
}

bool ChunkedVolume::HasEnd() const
{
  return std::any_of(
    chunks.begin(), chunks.end(), [](const auto& each) { return each.first.kind == 'E'; });
}

void ChunkedVolume::SkipMissing()
{
  const std::vector<int> missing = this->Missing();
  skipped.insert(missing.begin(), missing.end());
  this->Decode();
}

RadarVolume ChunkedVolume::Volume() const
{
  return decoder->VolumeSoFar(name);
}

void ChunkedVolume::Close()
{
  closed = true;
  decoder.reset();
  for (auto& [place, chunk] : chunks)
  {
    chunk.stored = {};
  }
}

} // namespace nexrad
