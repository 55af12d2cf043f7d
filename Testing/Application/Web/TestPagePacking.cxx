// SPDX-License-Identifier: BSD-3-Clause
#include "PageParts.h"
#include "StormVolume.h"
#include "Tolerance.h"
#include "Web/PageCode.h"
#include "Web/PageText.h"
#include "nexrad/System/Error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace nexrad;
using namespace nexrad::application;
using namespace nexrad::testing;

namespace
{

// Codes of which a share is echo, in any order.
Bytes RandomCodes(const std::array<int, 3>& size, double share, unsigned seed)
{
  std::mt19937 random(seed);
  std::bernoulli_distribution echo(share);
  std::uniform_int_distribution<int> code(1, 255);
  Bytes codes(static_cast<std::size_t>(size[0] * size[1] * size[2]));
  for (auto& voxel : codes)
  {
    voxel = echo(random) ? static_cast<std::uint8_t>(code(random)) : std::uint8_t{0};
  }
  return codes;
}

void ExpectRoundTrip(const std::array<int, 3>& size, const Bytes& codes)
{
  const PackedColumns packed = PackColumns(size, codes);
  EXPECT_EQ(UnpackColumns(size, packed.ends, packed.codes), codes);
}

// Whether a voxel or any of its 26 neighbours has an echo of at least the floor.
bool IsNearVisible(const GriddedVolume& volume, std::size_t voxel, double floor)
{
  const auto& size = volume.grid.dimensions;
  const int place[] = {static_cast<int>(voxel) % size[0],
    static_cast<int>(voxel) / size[0] % size[1], static_cast<int>(voxel) / (size[0] * size[1])};
  for (int k = std::max(place[2] - 1, 0); k <= std::min(place[2] + 1, size[2] - 1); ++k)
  {
    for (int j = std::max(place[1] - 1, 0); j <= std::min(place[1] + 1, size[1] - 1); ++j)
    {
      for (int i = std::max(place[0] - 1, 0); i <= std::min(place[0] + 1, size[0] - 1); ++i)
      {
        const auto other = static_cast<std::size_t>((k * size[1] + j) * size[0] + i);
        if (volume.states[other] == VoxelState::Echo &&
            static_cast<double>(volume.values[other]) >= floor)
        {
          return true;
        }
      }
    }
  }
  return false;
}

} // namespace

TEST(PagePacking, GivesAnyCodesBack)
{
  unsigned seed = 1;
  for (const double share : {0.0, 0.02, 0.5, 1.0})
  {
    ExpectRoundTrip({7, 5, 9}, RandomCodes({7, 5, 9}, share, seed++));
    ExpectRoundTrip({1, 1, 254}, RandomCodes({1, 1, 254}, share, seed++));
    ExpectRoundTrip({33, 2, 1}, RandomCodes({33, 2, 1}, share, seed++));
  }
}

// Echo in every other layer makes as many ends as there can be.
TEST(PagePacking, TakesColumnsWithAsManyEndsAsThereCanBe)
{
  Bytes codes(2 * 254);
  for (std::size_t voxel = 0; voxel < codes.size(); ++voxel)
  {
    codes[voxel] = voxel / 2 % 2 == 0 ? std::uint8_t{255} : std::uint8_t{0};
  }
  ExpectRoundTrip({2, 1, 254}, codes);
}

TEST(PagePacking, RefusesWhatItCannotPack)
{
  EXPECT_THROW(PackColumns({2, 2, 255}, Bytes(4 * 255)), Error);
}

TEST(PagePacking, Base64OfTheStandard) // RFC 4648, section 10
{
  const auto format = [](const std::string& text)
  { return FormatBase64(Bytes(text.begin(), text.end())); };
  EXPECT_EQ(format(""), "");
  EXPECT_EQ(format("f"), "Zg==");
  EXPECT_EQ(format("fo"), "Zm8=");
  EXPECT_EQ(format("foo"), "Zm9v");
  EXPECT_EQ(format("foob"), "Zm9vYg==");
  EXPECT_EQ(FormatBase64({0xff, 0xff, 0xfe}), "///+");
}

TEST(PagePacking, ReflectivityIsKeptWithinHalfAStep)
{
  const GriddedVolume volume = MakeStorm(true);
  const PageCode code = PageCode::OfReflectivity(volume, 5.0);
  ASSERT_TRUE(code.floor);
  EXPECT_DOUBLE_EQ(*code.floor, 5.0);
  const Bytes codes = code.Encode(volume);
  double worst = 0.0;
  int visible = 0;
  for (std::size_t voxel = 0; voxel < codes.size(); ++voxel)
  {
    const auto value = static_cast<double>(volume.values[voxel]);
    const bool echo = volume.states[voxel] == VoxelState::Echo;
    const double kept = code.ValueOf(code.bytes[codes[voxel]]);
    EXPECT_EQ(codes[voxel] != 0, echo && IsNearVisible(volume, voxel, 5.0)) << voxel;
    EXPECT_EQ(kept >= 5.0, echo && value >= 5.0) << voxel << ": " << value;
    if (echo && value >= 5.0)
    {
      ++visible;
      worst = std::max(worst, std::abs(kept - value));
    }
  }
  EXPECT_GT(visible, 500);
  EXPECT_AT_MOST(worst, 1.0, "greatest error of reflectivity in a page, dBZ");
}

TEST(PagePacking, TheFloorIsTheLeastValueThatIsSeen)
{
  const GriddedVolume volume = MakeStorm(true);
  EXPECT_DOUBLE_EQ(*PageCode::OfReflectivity(volume, 20.2).floor, 20.0);
  EXPECT_DOUBLE_EQ(*PageCode::OfReflectivity(volume, -60.0).floor, -32.5);
  EXPECT_EQ(PageCode::OfReflectivity(volume, 5.0).bytes.size(), 48U);
}

TEST(PagePacking, OtherMomentsAreKeptWithinAStepOfTheTexture)
{
  GriddedVolume volume = MakeStorm(true);
  volume.moment = MomentName::VEL;
  for (std::size_t voxel = 0; voxel < volume.values.size(); ++voxel)
  {
    volume.values[voxel] = 0.25F * static_cast<float>(voxel % 480) - 60.0F;
  }
  const PageCode code = PageCode::OfRange({-64.0, 64.0});
  EXPECT_TRUE(code.masked);
  EXPECT_FALSE(code.floor);
  EXPECT_EQ(code.bytes.size(), 128U);
  const Bytes codes = code.Encode(volume);
  double worst = 0.0;
  for (std::size_t voxel = 0; voxel < codes.size(); ++voxel)
  {
    EXPECT_EQ(codes[voxel] != 0, volume.states[voxel] == VoxelState::Echo);
    const double kept = code.ValueOf(code.bytes[codes[voxel]]);
    worst = codes[voxel] == 0
              ? worst
              : std::max(worst, std::abs(kept - static_cast<double>(volume.values[voxel])));
  }
  EXPECT_AT_MOST(worst, 128.0 / 254.0, "greatest error of velocity in a page, m/s");
  volume.values.assign(volume.values.size(), 1000.0F); // beyond the range: its end
  const Bytes high = code.Encode(volume);
  EXPECT_NEAR(code.ValueOf(code.bytes[*std::max_element(high.begin(), high.end())]), 64.0, 1.0);
}
