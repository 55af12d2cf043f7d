// SPDX-License-Identifier: BSD-3-Clause
// Sweeps of which only the gates that hold something are kept: each gate reads as the file has it.
#include "BeamScene.h"
#include "TestData.h"
#include "nexrad/Beams/BeamVolume.h"
#include "nexrad/Level2/Level2File.h"
#include "nexrad/Quality/EchoGrid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

using namespace nexrad;
using namespace nexrad::testing;

namespace
{

std::vector<std::uint16_t> CodesOf(const PolarSweep& sweep, std::size_t ray)
{
  std::vector<std::uint16_t> codes(sweep.gates);
  sweep.Read(ray, codes.data());
  return codes;
}

float ValueOf(const PolarSweep& sweep, std::uint16_t code)
{
  return code >= GateCode::FirstValue ? sweep.scale.ValueOf(code) : NoNumber;
}

// Each gate of a sweep, one before the first and some behind the last that are held.
void ExpectGrid(const PolarSweep& sweep)
{
  const EchoGrid grid(sweep);
  ASSERT_EQ(grid.Rays(), sweep.rays.size());
  for (std::size_t place = 0; place < grid.Rays(); ++place)
  {
    std::vector<float> expected;
    for (const std::uint16_t code : CodesOf(sweep, grid.RayAt(place)))
    {
      expected.push_back(ValueOf(sweep, code));
    }
    const GateRange held = grid.Held(place);
    std::vector<float> read(sweep.gates);
    grid.Read(place, {0, sweep.gates}, read.data());
    ASSERT_EQ(read, expected) << place;
    for (std::size_t gate = 0; gate < sweep.gates; ++gate)
    {
      ASSERT_EQ(grid.At(place, gate), expected[gate]) << place << ", " << gate;
      ASSERT_TRUE(!held.Holds(gate) || grid.Row(place)[gate] == expected[gate]);
      ASSERT_TRUE(held.Holds(gate) || expected[gate] == NoNumber);
    }
    if (!held.IsEmpty())
    {
      ASSERT_LT(grid.Index(place, held.end - 1), grid.Count());
      grid.Read(place, {held.end - 1, held.end + 3}, read.data());
      ASSERT_EQ(std::vector<float>(read.begin(), read.begin() + 4),
        std::vector<float>({expected[held.end - 1], NoNumber, NoNumber, NoNumber}));
    }
  }
  EXPECT_TRUE(grid.Held(grid.Rays()).IsEmpty());
  EXPECT_EQ(grid.At(grid.Rays(), 0), NoNumber);
}

// Entries of the prepared sweep find their rays by the azimuth.
void ExpectPrepared(const PolarSweep& sweep, const BeamSweep& prepared)
{
  std::size_t found = 0;
  for (std::size_t entry = 0; entry < prepared.azimuths.size(); ++entry)
  {
    const auto isSame = [&](const PolarRay& ray)
    {
      const float turned = ray.azimuth - prepared.azimuths[entry];
      return turned == 0.0F || turned == 360.0F || turned == -360.0F;
    };
    const auto ray = std::find_if(sweep.rays.begin(), sweep.rays.end(), isSame);
    if (ray == sweep.rays.end())
    {
      continue;
    }
    ++found;
    const std::vector<std::uint16_t> codes =
      CodesOf(sweep, static_cast<std::size_t>(ray - sweep.rays.begin()));
    for (int gate = 0; gate < prepared.gates; ++gate)
    {
      ASSERT_EQ(prepared.CodeAt(entry, gate), codes[static_cast<std::size_t>(gate)]);
    }
    EXPECT_EQ(prepared.CodeAt(entry, prepared.gates), GateCode::NoEcho);
  }
  EXPECT_GT(10 * found, 9 * sweep.rays.size());
}

} // namespace

TEST(HeldGates, ReadAsTheGatesOfEchoAndOfNone)
{
  NumberSweep numbers = MakeSweep(1, 0.5, 360, 40);
  for (std::size_t ray = 0; ray < 360; ++ray)
  {
    for (std::size_t gate = ray % 7; gate < (ray * ray) % 41; gate += 1 + ray % 3)
    {
      SetGate(numbers, ray, gate, static_cast<float>(gate) - 10.0F);
    }
  }
  const PolarVolume volume = VolumeOf({numbers, MakeSweep(2, 1.5, 360, 40)}); // of no echo
  const BeamVolume prepared = PrepareBeamVolume(volume);
  ASSERT_EQ(prepared.sweeps.size(), 2U);
  for (std::size_t sweep = 0; sweep < 2; ++sweep)
  {
    ExpectGrid(volume.sweeps[sweep]);
    ExpectPrepared(volume.sweeps[sweep], prepared.sweeps[sweep]);
  }
  EXPECT_EQ(prepared.sweeps[1].CodeCount(), 40U) << "nothing is held but the room before";
}

TEST(HeldGates, OfRealFiles)
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
      ExpectGrid(sweep);
      for (const BeamSweep& each : prepared.sweeps)
      {
        if (each.begin == std::min_element(sweep.rays.begin(), sweep.rays.end(),
                            [](const PolarRay& a, const PolarRay& b) { return a.time < b.time; })
                            ->time)
        {
          ExpectPrepared(sweep, each);
          ++compared;
        }
      }
    }
    EXPECT_GE(compared, 5U);
  }
}
