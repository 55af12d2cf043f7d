// SPDX-License-Identifier: BSD-3-Clause
// Feeds bytes to the Level II decoder and looks at all that comes out. With clang it is a libFuzzer
// target (-fsanitize=fuzzer); MutationDriver.cxx runs it without.
#include "nexrad/Level2/Level2File.h"
#include "nexrad/Model/MomentSummary.h"
#include "nexrad/Polar/PolarVolume.h"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <vector>

using namespace nexrad;

namespace
{

// What every volume promises, whatever the bytes were.
void Check(bool holds)
{
  if (!holds)
  {
    std::abort();
  }
}

void LookAtSweep(const Sweep& sweep)
{
  Check(!sweep.rays.empty());
  for (const Ray& ray : sweep.rays)
  {
    Check(ray.azimuth >= 0.0F && ray.azimuth <= 360.0F);
    Check(ray.elevation >= -2.0F && ray.elevation <= 90.0F);
    Check(ray.elevationNumber == sweep.elevationNumber);
  }
  for (const MomentName name : AllMoments)
  {
    Summarize(sweep, name); // reads every word
  }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  Level2Options options;
  options.maximumRecordBytes = std::size_t(1) << 20;
  options.maximumFileBytes = std::size_t(4) << 20;
  const RadarVolume volume =
    DecodeLevel2(std::vector<std::uint8_t>(data, data + size), "fuzz", options);
  for (const Sweep& sweep : volume.sweeps)
  {
    LookAtSweep(sweep);
  }
  Check(!volume.sweeps.empty() || !volume.damage.empty());
  Check(volume.complete || !volume.damage.empty());
  MakePolarVolume(volume, MomentName::REF);
  return 0;
}
