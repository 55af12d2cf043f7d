// SPDX-License-Identifier: BSD-3-Clause
// Of a sweep only the gates that hold something are kept: each gate reads as the file has it.
#include "SweepMaker.h"
#include "TestData.h"
#include "nexrad/Level2/Level2File.h"
#include "nexrad/Quality/EchoGrid.h"

#include <gtest/gtest.h>

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

} // namespace

TEST(EchoGrid, ReadsGatesOfEchoAndOfNone)
{
  NumberSweep numbers = MakeSweep(1, 0.5, 360, 40);
  for (std::size_t ray = 0; ray < 360; ++ray)
  {
    for (std::size_t gate = ray % 7; gate < (ray * ray) % 41; gate += 1 + ray % 3)
    {
      SetGate(numbers, ray, gate, static_cast<float>(gate) - 10.0F);
    }
  }
  const PolarVolume volume =
    MakeVolume({38.7, -92.0, 200.0}, 0.0, {numbers, MakeSweep(2, 1.5, 360, 40)});
  ExpectGrid(volume.sweeps[0]);
  ExpectGrid(volume.sweeps[1]);
  EXPECT_EQ(EchoGrid(volume.sweeps[1]).Count(), 40U) << "no echo: nothing but the room before";
}

TEST(EchoGrid, ReadsGatesOfRealFiles)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  for (const char* name :
    {"superres/Level2_KFTG_20150430_1419.ar2v", "legacy/KVWX_20050626_221551.gz"})
  {
    SCOPED_TRACE(name);
    const RadarVolume volume = ReadLevel2(data / "level2" / name);
    for (const PolarSweep& sweep : MakePolarVolume(volume, MomentName::REF).sweeps)
    {
      ExpectGrid(sweep);
    }
  }
}
