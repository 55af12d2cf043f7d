// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/Frame/EchoExtent.h"

#include "Scene/EchoFraming.h"
#include "Scene/Frame/SceneFrame.h"
#include "Scene/Frame/VolumeInformation.h"
#include "Scene/VolumeAppearance.h"
#include "StormVolume.h"
#include "vtkNexradImageConversion.h"
#include "vtkNexradTransferFunction.h"

#include <gtest/gtest.h>

#include <vtkImageData.h>
#include <vtkNew.h>

#include <algorithm>
#include <cmath>

using namespace nexrad;
using namespace nexrad::scene;
using nexrad::testing::MakeStorm;
using nexrad::testing::Storm;

namespace
{

EchoExtent ExtentOf(const GriddedVolume& volume)
{
  vtkNew<vtkImageData> image;
  vtkNexradVolumeToImage(volume, image);
  const auto echo = MeasureEcho(image, SceneOptions());
  EXPECT_TRUE(echo.has_value());
  return echo.value_or(EchoExtent());
}

void SetEcho(GriddedVolume& volume, int x, int y, int z, float value)
{
  const auto& size = volume.grid.dimensions;
  const auto voxel = static_cast<std::size_t>((z * size[1] + y) * size[0] + x);
  volume.values[voxel] = value;
  volume.states[voxel] = VoxelState::Echo;
}

// Echo of 35 dBZ in 3 × 3 columns about one, up to a layer.
void AddCell(GriddedVolume& volume, int x, int y, int layers)
{
  for (int i = 0; i < 9 * layers; ++i)
  {
    SetEcho(volume, x - 1 + i % 3, y - 1 + i / 3 % 3, i / 9, 35.0F);
  }
}

// A storm in the middle as large as 24 of these cells.
GriddedVolume MakeWideStorm()
{
  GriddedVolume volume = MakeStorm(false);
  std::fill(volume.values.begin(), volume.values.end(), volume.fill);
  std::fill(volume.states.begin(), volume.states.end(), VoxelState::NoEcho);
  for (int cell = 0; cell < 24; ++cell)
  {
    AddCell(volume, 17 + 3 * (cell % 6), 18 + 3 * (cell / 6), 8);
  }
  return volume;
}

} // namespace

// The storm of 62 dBZ about 80 km west and south of the centre.
TEST(EchoExtent, TheBoxIsAboutTheStorm)
{
  const auto [west, east, south, north, bottom, top] = ExtentOf(MakeStorm(false)).box;
  EXPECT_GT(Storm(0.5e-3 * (west + east), 0.5e-3 * (south + north), 3.0), 15.0);
  EXPECT_LT(east - west, 240e3);
  EXPECT_LT(north - south, 240e3);
  EXPECT_EQ(bottom, 0.0);
  EXPECT_GT(top, 8e3);
  EXPECT_LT(top, 20e3);
}

TEST(EchoExtent, SpecksDoNotDecide)
{
  GriddedVolume specked = MakeStorm(false);
  const EchoExtent without = ExtentOf(specked);
  SetEcho(specked, 46, 46, 1, 35.0F);
  SetEcho(specked, 1, 47, 12, 35.0F);
  SetEcho(specked, 47, 1, 15, 35.0F);
  EXPECT_EQ(ExtentOf(specked).box, without.box);
}

// Cells in the corners of the domain, each with 1 in 30 of the echo, widen the frame neither alone
// nor together. A second storm with a fifth of the echo does.
TEST(EchoExtent, DistantCellsDoNotDecideTogether)
{
  const EchoExtent alone = ExtentOf(MakeWideStorm());
  GriddedVolume cells = MakeWideStorm();
  GriddedVolume storms = MakeWideStorm();
  for (int i = 0; i < 6; ++i)
  {
    AddCell(cells, i % 2 == 0 ? 2 : 45, i < 2 ? 2 : (i < 4 ? 24 : 45), 8);
    AddCell(storms, 38 + 3 * (i % 3), 42 + 3 * (i / 3), 8);
  }
  EXPECT_EQ(ExtentOf(cells).box, alone.box);
  EXPECT_GE(ExtentOf(storms).box[1], 210e3);
  EXPECT_GE(ExtentOf(storms).box[3], 210e3);
}

TEST(EchoExtent, NothingIsFoundWithoutVisibleEcho)
{
  GriddedVolume weak = MakeStorm(false);
  for (float& value : weak.values)
  {
    value -= 60.0F;
  }
  vtkNew<vtkImageData> image;
  vtkNexradVolumeToImage(weak, image);
  EXPECT_FALSE(MeasureEcho(image, SceneOptions()));
  const SceneFrame frame =
    FrameVolume(image, ReadVolumeInformation(image), std::nullopt, SceneOptions());
  EXPECT_EQ(frame.Framed(), frame.Bounds());
  EXPECT_EQ(frame.OpacityDistance(), OpacityUnitDistance);
}

// Codes are measured as the values that they stand for.
TEST(EchoExtent, ASeriesHoldsAllOfIt)
{
  const EchoExtent one = ExtentOf(MakeStorm(false));
  EchoExtent other = one;
  other.box = {one.box[0] + 50e3, one.box[1] + 50e3, one.box[2], one.box[3], 0.0, 1e3};
  const EchoExtent both = Join(one, other);
  EXPECT_EQ(both.box[0], one.box[0]);
  EXPECT_EQ(both.box[1], other.box[1]);
  EXPECT_EQ(both.box[5], one.box[5]);
  EXPECT_DOUBLE_EQ(OpacityDistanceOf(both, 3.0), OpacityDistanceOf(one, 3.0));
}

// Echo that is 25 dB weaker is drawn denser; and less stretched echo, too.
TEST(EchoExtent, OpacityFollowsTheEcho)
{
  const EchoExtent strong = ExtentOf(MakeStorm(false));
  GriddedVolume weak = MakeStorm(false);
  for (float& value : weak.values)
  {
    value -= 25.0F;
  }
  const double distance = OpacityDistanceOf(strong, 3.0);
  EXPECT_LT(OpacityDistanceOf(ExtentOf(weak), 3.0), 0.8 * distance);
  EXPECT_LT(OpacityDistanceOf(strong, 1.0), distance);
  EXPECT_GE(OpacityDistanceOf(ExtentOf(weak), 1.0), 0.1 * OpacityUnitDistance);
  EXPECT_LE(OpacityDistanceOf(strong, 100.0), 4.01 * OpacityUnitDistance);
}

// An edited look has the same frame and opacity: what the window saved is drawn alike.
TEST(EchoExtent, TheFrameIsThatOfThePreset)
{
  SceneOptions surfaces;
  surfaces.preset = "iso-values";
  vtkNew<vtkImageData> image;
  vtkNexradVolumeToImage(MakeStorm(false), image);
  EXPECT_EQ(MeasureEcho(image, surfaces)->box, MeasureEcho(image, SceneOptions())->box);
  SceneOptions cores;
  cores.preset = "hail";
  EXPECT_LT(MeasureEcho(image, cores)->box[1] - MeasureEcho(image, cores)->box[0],
    MeasureEcho(image, SceneOptions())->box[1] - MeasureEcho(image, SceneOptions())->box[0]);
}
