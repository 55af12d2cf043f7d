// SPDX-License-Identifier: BSD-3-Clause
// Prepared sweeps store no gates behind the last that holds anything: each gate still reads as the
// file has it.
#include "BeamScene.h"
#include "TestData.h"
#include "nexrad/Beams/BeamVolume.h"
#include "nexrad/Level2/Level2File.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

using namespace nexrad;
using namespace nexrad::testing;

namespace
{

// The ray of an entry, by its azimuth; rays.size() without one.
std::size_t RayOf(const PolarSweep& sweep, float azimuth)
{
  const auto isSame = [azimuth](const PolarRay& ray)
  {
    const float turned = ray.azimuth - azimuth;
    return turned == 0.0F || turned == 360.0F || turned == -360.0F;
  };
  return static_cast<std::size_t>(
    std::find_if(sweep.rays.begin(), sweep.rays.end(), isSame) - sweep.rays.begin());
}

void ExpectPrepared(const PolarSweep& sweep, const BeamSweep& prepared)
{
  ASSERT_EQ(static_cast<std::size_t>(prepared.gates), sweep.gates);
  std::size_t found = 0;
  std::vector<std::uint16_t> codes(sweep.gates);
  for (std::size_t entry = 0; entry < prepared.azimuths.size(); ++entry)
  {
    const std::size_t ray = RayOf(sweep, prepared.azimuths[entry]);
    if (ray == sweep.rays.size())
    {
      continue;
    }
    ++found;
    sweep.Read(ray, codes.data());
    for (int gate = 0; gate < prepared.gates; ++gate)
    {
      ASSERT_EQ(prepared.CodeAt(entry, gate), codes[static_cast<std::size_t>(gate)])
        << entry << ", " << gate;
    }
    const std::uint16_t behind =
      prepared.storedGates < prepared.gates ? std::uint16_t(GateCode::NoEcho) : codes.back();
    EXPECT_EQ(prepared.Row(entry)[prepared.storedGates], behind) << entry;
  }
  EXPECT_GT(10 * found, 9 * sweep.rays.size());
}

} // namespace

TEST(StoredGates, EndWithTheLastThatHoldsSomething)
{
  constexpr std::size_t rays = 360;
  NumberSweep some = MakeSweep(1, 0.5, rays, 40);
  SetGate(some, 17, 30, 20.0F);
  SetGate(some, 18, 3, 25.0F);
  NumberSweep all = MakeSweep(2, 1.5, rays, 40);
  SetGate(all, 200, 39, 20.0F);
  const PolarVolume volume = VolumeOf({some, all, MakeSweep(3, 2.5, rays, 40)});
  const BeamVolume prepared = PrepareBeamVolume(volume);
  ASSERT_EQ(prepared.sweeps.size(), 3U);
  const int expected[] = {31, 40, 0};
  for (std::size_t sweep = 0; sweep < 3; ++sweep)
  {
    SCOPED_TRACE(sweep);
    EXPECT_EQ(prepared.sweeps[sweep].storedGates, expected[sweep]);
    ExpectPrepared(volume.sweeps[sweep], prepared.sweeps[sweep]);
  }
}

TEST(StoredGates, OfRealFiles)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  for (const char* name :
    {"superres/Level2_KFTG_20150430_1419.ar2v", "legacy/KVWX_20050626_221551.gz"})
  {
    SCOPED_TRACE(name);
    const PolarVolume volume = MakePolarVolume(ReadLevel2(data / "level2" / name), MomentName::REF);
    const BeamVolume prepared = PrepareBeamVolume(volume);
    std::size_t compared = 0;
    for (const PolarSweep& sweep : volume.sweeps)
    {
      const auto first = std::min_element(sweep.rays.begin(), sweep.rays.end(),
        [](const PolarRay& a, const PolarRay& b) { return a.time < b.time; });
      for (const BeamSweep& each : prepared.sweeps)
      {
        if (each.begin == first->time)
        {
          ExpectPrepared(sweep, each);
          ++compared;
        }
      }
    }
    EXPECT_GE(compared, 5U);
  }
}
