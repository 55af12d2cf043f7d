// SPDX-License-Identifier: BSD-3-Clause
// Feeds bytes to the Level II decoder, bare and in each container, and looks at all that comes out.
#include "FuzzTarget.h"

#include "nexrad/Level2/Level2File.h"
#include "nexrad/Model/MomentSummary.h"
#include "nexrad/Polar/PolarVolume.h"

#include <cmath>

using namespace nexrad;
using namespace nexrad::testing;

namespace
{

void LookAtSweep(const Sweep& sweep)
{
  Require(!sweep.rays.empty(), "a sweep has rays");
  for (const Ray& ray : sweep.rays)
  {
    Require(ray.azimuth >= 0.0F && ray.azimuth <= 360.0F, "azimuths are 0 to 360 degrees");
    Require(ray.elevation >= -10.0F && ray.elevation <= 90.0F, "elevations are -10 to 90 degrees");
    Require(ray.elevationNumber == sweep.elevationNumber, "rays of a sweep are of one cut");
    Require(std::isfinite(ray.nyquist) && ray.nyquist >= 0.0F, "Nyquist velocities are numbers");
    Require(std::isfinite(ray.unambiguousRange), "unambiguous ranges are numbers");
  }
  for (const MomentName name : AllMoments)
  {
    Summarize(sweep, name); // reads every word
  }
}

void LookAtDamage(const RadarVolume& volume, std::size_t fileSize)
{
  for (const nexrad::Damage& damage : volume.damage)
  {
    Require(damage.offset <= fileSize, "damage lies within the file");
    RequireMessage(damage.what);
  }
  for (const std::string& note : volume.notes)
  {
    RequireMessage(note);
  }
  Require(!volume.sweeps.empty() || !volume.damage.empty() || !volume.notes.empty(),
    "no ray is damage, or noted where metadata stand alone");
  Require(volume.complete || volume.sweeps.empty() || !volume.damage.empty(), "no end is damage");
}

void LookAtSize(const RadarVolume& volume, const Level2Options& options)
{
  std::size_t bytes = 0;
  for (const auto& buffer : volume.buffers)
  {
    bytes += buffer->size();
  }
  Require(bytes <= options.maximumFileBytes, "the cap on decompressed bytes holds");
}

void LookAtCycles(const RadarVolume& volume)
{
  std::size_t rays = 0;
  for (const RadarVolume& cycle : SplitCycles(volume))
  {
    rays += cycle.RayCount();
  }
  Require(rays == volume.RayCount(), "cycles have the rays of the volume");
}

// The ways that look at the first bytes alone.
void LookAtStart(const std::uint8_t* data, std::size_t size)
{
  static const InputFile file("volume");
  file.Write(data, size);
  LooksLikeLevel2(file.Path());
  PeekVolumeHeader(file.Path());
}

} // namespace

namespace nexrad::testing
{

std::vector<Bytes> FuzzSeeds()
{
  constexpr int level = 1; // the smallest blocks: decompressors take little memory
  std::vector<Bytes> seeds;
  for (const unsigned type : {1U, 31U})
  {
    RayPlan first;
    first.status = 3;
    RayPlan second;
    second.status = 0;
    second.cut = 2;
    second.elevation = 1.5;
    const Bytes metadata = Join({MakeMessage2(21, 1900), MakeMessage5(21, {0.5, 1.5})});
    const Bytes low = MakeSweepBytes(type, first, 4, 2);
    const Bytes high = MakeSweepBytes(type, second, 3, 4);
    const Bytes bare = Join({MakeVolumeHeader(), metadata, low, high});
    const Bytes records = Join({MakeVolumeHeader(), MakeLdmRecord(metadata, false, level),
      MakeLdmRecord(low, false, level), MakeLdmRecord(high, true, level)});
    seeds.insert(seeds.end(), {bare, Gzip(bare), Bzip2(bare, level), Compress(bare),
                                Compress(bare, 10), records, Gzip(records), MakeSmallVolume(type)});
  }
  return seeds;
}

} // namespace nexrad::testing

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  Level2Options options;
  if (IsSanitised)
  {
    options.maximumRecordBytes = std::size_t(1) << 20;
    options.maximumFileBytes = std::size_t(4) << 20;
  }
  options.threads = 1;
  const RadarVolume volume =
    DecodeLevel2(std::vector<std::uint8_t>(data, data + size), "fuzz", options);
  for (const Sweep& sweep : volume.sweeps)
  {
    LookAtSweep(sweep);
  }
  LookAtDamage(volume, size);
  LookAtSize(volume, options);
  LookAtCycles(volume);
  for (const MomentName moment : {MomentName::REF, MomentName::VEL, MomentName::SW})
  {
    MakePolarVolume(volume, moment);
  }
  LookAtStart(data, size);
  return 0;
}
