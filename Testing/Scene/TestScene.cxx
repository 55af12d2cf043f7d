// SPDX-License-Identifier: BSD-3-Clause
#include "Filters/Series/VolumeFiles.h"
#include "Scene/Frame/SceneFrame.h"
#include "Scene/Shapes/Theme.h"
#include "Scene/VolumeAppearance.h"
#include "ScenePicture.h"
#include "StormVolume.h"
#include "TestData.h"
#include "Tolerance.h"

#include "nexrad/System/Error.h"
#include "vtkNexradImageConversion.h"
#include "vtkNexradSession.h"
#include "vtkNexradTransferFunction.h"
#include "vtkNexradVolumeScene.h"

#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkNew.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

using namespace nexrad;
using namespace nexrad::scene;
using namespace nexrad::testing;

namespace
{

constexpr std::array<int, 2> sceneSize = {640, 360};

// No light, and no automatic choices.
SceneOptions Classic()
{
  SceneOptions options;
  UseClassicLook(options);
  return options;
}

// Draws a volume, and leaves the picture in the tests' output folder for a person to look at.
Picture Draw(vtkImageData* volume, const std::string& name, const SceneOptions& options = Classic(),
  const CameraView& view = {})
{
  vtkNew<vtkNexradVolumeScene> scene;
  scene->SetOptions(options);
  scene->SetView(view);
  scene->SetVolume(volume);
  const Picture picture = OffScreenWindow(scene->GetRenderer(), sceneSize).Draw();
  KeepPicture(picture, "Scene" + name);
  return picture;
}

// Pixels of a part of the picture (fractions from the lower left corner) for which `test` holds.
template <typename Test>
int Count(const Picture& picture, const PictureArea& part, Test test)
{
  int count = 0;
  for (int y = static_cast<int>(part.bottom * sceneSize[1]); y < part.top * sceneSize[1]; ++y)
  {
    for (int x = static_cast<int>(part.left * sceneSize[0]); x < part.right * sceneSize[0]; ++x)
    {
      count += test(PixelOf(picture, x, y)) ? 1 : 0;
    }
  }
  return count;
}

// Of any colour of any pixel, 0 to 255.
int LargestDifference(const Picture& a, const Picture& b)
{
  int largest = 0;
  for (int y = 0; y < sceneSize[1]; ++y)
  {
    for (int x = 0; x < sceneSize[0]; ++x)
    {
      for (std::size_t colour = 0; colour < 3; ++colour)
      {
        const int difference = PixelOf(a, x, y)[colour] - PixelOf(b, x, y)[colour];
        largest = std::max(largest, std::abs(difference));
      }
    }
  }
  return largest;
}

constexpr PictureArea whole = {0.0, 1.0, 0.0, 1.0};
constexpr PictureArea withoutBar = {0.0, 0.9, 0.1, 0.85};
constexpr PictureArea title = {0.35, 0.65, 0.88, 1.0};

// Yellow to red, as echo from 35 dBZ on is drawn.
bool IsStrongEcho(const std::array<int, 3>& rgb)
{
  return rgb[0] > 120 && rgb[2] < 60;
}

// The grey blue of borders and state lines.
bool IsMapLine(const std::array<int, 3>& rgb)
{
  return rgb[0] > 90 && rgb[0] < 200 && rgb[2] > rgb[0] && rgb[2] - rgb[0] < 60;
}

int Difference(const Picture& a, const Picture& b)
{
  int differing = 0;
  for (int y = 0; y < sceneSize[1]; ++y)
  {
    for (int x = 0; x < sceneSize[0]; ++x)
    {
      differing += PixelOf(a, x, y) != PixelOf(b, x, y) ? 1 : 0;
    }
  }
  return differing;
}

vtkSmartPointer<vtkImageData> MakeEmptyVolume()
{
  const auto volume = MakeStormVolume(false);
  auto* values = static_cast<float*>(volume->GetScalarPointer());
  std::fill(values, values + volume->GetNumberOfPoints(), -33.0F);
  return volume;
}

} // namespace

// The picture: a dark ground with state and county lines, a green anvil with a yellow and red core
// south west of its middle, the colour bar on the right, captions in three corners.
TEST(Scene, ShowsStormMapAndColourBar)
{
  const auto picture = Draw(MakeStormVolume(false), "Storm");
  EXPECT_AT_LEAST(Count(picture, withoutBar, IsStrongEcho), 1'000, "pixels of strong echo");
  for (const ColourBin& bin : ColourStepsOf(MakeTransferFunction({})))
  {
    const auto isBin = [&](const std::array<int, 3>& rgb)
    {
      return rgb[0] == std::lround(255.0 * bin.colour[0]) &&
             rgb[1] == std::lround(255.0 * bin.colour[1]) &&
             rgb[2] == std::lround(255.0 * bin.colour[2]);
    };
    // A box is 2 % of the width by a fifteenth of 78 % of the height: 12 by 18 pixels.
    EXPECT_AT_LEAST(Count(picture, {0.9, 1.0, 0.0, 1.0}, isBin), 120, "pixels of a bin's colour")
      << bin.from;
  }
}

// 20 m/s towards the radar in the west, away from it in the east, no echo elsewhere. The picture:
// two slabs, one green and one red, and the bar from -60 to 50 m/s.
TEST(Scene, VelocitiesOfBothSignsAreSeen)
{
  GriddedVolume volume = nexrad::testing::MakeStorm(false);
  volume.moment = MomentName::VEL;
  for (std::size_t i = 0; i < volume.values.size(); ++i)
  {
    const std::size_t column = i % 48;
    const bool echo = i / (48 * 48) < 8 && (column / 12 == 1 || column / 12 == 2);
    volume.states[i] = echo ? VoxelState::Echo : VoxelState::NoEcho;
    volume.values[i] = !echo ? volume.fill : column < 24 ? -20.0F : 20.0F;
  }
  vtkNew<vtkImageData> image;
  vtkNexradVolumeToImage(volume, image);
  const auto isGreen = [](const std::array<int, 3>& rgb)
  { return rgb[1] > 100 && rgb[1] > 2 * rgb[0] && 2 * rgb[1] > 3 * rgb[2]; };
  const auto isRed = [](const std::array<int, 3>& rgb)
  { return rgb[0] > 100 && 2 * rgb[0] > 3 * rgb[1] && 2 * rgb[0] > 3 * rgb[2]; };
  const auto picture = Draw(image, "Velocity");
  EXPECT_AT_LEAST(Count(picture, withoutBar, isGreen), 10'000, "green pixels");
  EXPECT_AT_LEAST(Count(picture, withoutBar, isRed), 10'000, "red pixels");
  // No echo has no velocity: the fill value is not drawn as 33 m/s.
  volume.states.assign(volume.states.size(), VoxelState::NoEcho);
  volume.values.assign(volume.values.size(), volume.fill);
  vtkNexradVolumeToImage(volume, image);
  const auto nothing = Draw(image, "VelocityOfNothing");
  EXPECT_EQ(Count(nothing, withoutBar, isGreen), 0);
}

// The same without any echo: the map alone.
TEST(Scene, WithoutEchoTheMapAloneIsLeft)
{
  const auto picture = Draw(MakeEmptyVolume(), "Empty");
  EXPECT_EQ(Count(picture, withoutBar, IsStrongEcho), 0);
  EXPECT_AT_LEAST(Count(picture, withoutBar, IsMapLine), 700, "pixels of map lines");
}

// The storm without map lines, because the volume does not say where it is.
TEST(Scene, WithoutProjectionThereIsNoMap)
{
  const auto volume = MakeStormVolume(false);
  volume->GetFieldData()->RemoveArray("Projection");
  const auto picture = Draw(volume, "NoMap");
  EXPECT_AT_LEAST(Count(picture, withoutBar, IsStrongEcho), 1'000, "pixels of strong echo");
  // Letters and scales have the lines' colour too.
  const auto map = Draw(MakeStormVolume(false), "Map");
  EXPECT_AT_LEAST(Count(map, withoutBar, IsMapLine) - Count(picture, withoutBar, IsMapLine), 400,
    "pixels of map lines");
}

// The title says SYNTHETIC in yellow letters, 16 pixels high here, or nothing stands there.
TEST(Scene, SyntheticDataSaySo)
{
  const auto isYellow = [](const std::array<int, 3>& rgb)
  { return rgb[0] > 200 && rgb[1] > 140 && rgb[2] < 90; };
  const auto synthetic = Draw(MakeStormVolume(true), "Synthetic");
  const auto real = Draw(MakeStormVolume(false), "Real");
  EXPECT_AT_LEAST(Count(synthetic, title, isYellow), 400, "pixels of the title");
  EXPECT_EQ(Count(real, title, isYellow), 0);
}

// The storm from above, from the east and with heights as they are.
TEST(Scene, CameraAndExaggerationChangeThePicture)
{
  const auto volume = MakeStormVolume(false);
  const auto first = Draw(volume, "First");
  EXPECT_EQ(Difference(first, Draw(volume, "FirstAgain")), 0);
  EXPECT_AT_LEAST(Difference(first, Draw(volume, "Above", Classic(), {200.0, 90.0, 1.0, false})),
    40'000, "pixels changed from above");
  EXPECT_AT_LEAST(Difference(first, Draw(volume, "East", Classic(), {90.0, 35.0, 1.0, false})),
    30'000, "pixels changed from the east");
  EXPECT_AT_LEAST(Difference(first, Draw(volume, "Parallel", Classic(), {200.0, 35.0, 1.0, true})),
    30'000, "pixels changed by the parallel projection");
  SceneOptions flat = Classic();
  flat.exaggeration = 1.0;
  EXPECT_AT_LEAST(
    Difference(first, Draw(volume, "Flat", flat)), 50'000, "pixels changed by the exaggeration");
}

// Slices and rays of the same storm: nearly the same colours everywhere.
TEST(Scene, BothMappersDrawTheSameStorm)
{
  const auto volume = MakeStormVolume(false);
  SceneOptions rays = Classic();
  rays.mapper = MapperChoice::RayCast;
  const auto sliced = Draw(volume, "Slices");
  EXPECT_AT_MOST(MeanDifference(sliced, Draw(volume, "Rays", rays)), 0.041,
    "mean difference of both mappers, of 255");
}

// A map of the composite, seen from above: flat colours of the table alone. The storm stands in the
// south west quarter; where the volume was not scanned the ground is grey.
TEST(Scene, AMapShowsTheTablesColoursAndWhatWasNotScanned)
{
  SceneOptions options = Classic();
  options.plan = PlanOptions();
  const CameraView above = {180.0, 90.0, 1.0, true};
  GriddedVolume storm = nexrad::testing::MakeStorm(false);
  for (std::size_t i = 0; i < storm.values.size(); ++i)
  {
    if (i % 48 >= 36) // the eastern quarter
    {
      storm.states[i] = VoxelState::NotScanned;
      storm.values[i] = storm.fill;
    }
  }
  vtkNew<vtkImageData> volume;
  vtkNexradVolumeToImage(storm, volume);
  const auto picture = Draw(volume, "Composite", options, above);
  const auto isColour = [](const Colour& colour)
  {
    return [colour](const std::array<int, 3>& rgb)
    {
      return rgb[0] == std::lround(255.0 * colour[0]) && rgb[1] == std::lround(255.0 * colour[1]) &&
             rgb[2] == std::lround(255.0 * colour[2]);
    };
  };
  // The grey strip is as high as the domain and a quarter as wide.
  const auto isGrey = isColour(ThemeOf(ThemeChoice::Dark).notScanned);
  PictureArea strip = {1.0, 0.0, 1.0, 0.0};
  for (int y = 0; y < sceneSize[1]; ++y)
  {
    for (int x = 0; x < sceneSize[0]; ++x)
    {
      if (isGrey(PixelOf(picture, x, y)))
      {
        strip = {std::min(strip.left, x / 640.0), std::max(strip.right, (x + 1) / 640.0),
          std::min(strip.bottom, y / 360.0), std::max(strip.top, (y + 1) / 360.0)};
      }
    }
  }
  const double height = (strip.top - strip.bottom) * 360.0;
  EXPECT_AT_LEAST(height, 200.0, "height of the domain, pixels");
  EXPECT_WITHIN((strip.right - strip.left) * 640.0, height / 4.0, 1.25,
    "width of the grey strip, pixels", "edges of the strip are those of whole pixels");
  EXPECT_AT_LEAST(Count(picture, strip, isGrey) / (height * height / 4.0), 0.8,
    "part that was not scanned, in grey");
  // The echo of 35 dBZ and more, in the south west, covers a disc of a radius of 33 km or more.
  const double west = strip.right - height / 640.0;
  const double east = strip.right - 0.5 * height / 640.0;
  const double middle = 0.5 * (strip.bottom + strip.top);
  const PictureArea southWest = {west, east, strip.bottom, middle};
  const Colour core = ColourStepsOf(MakeTransferFunction({}))[11].colour; // 60 to 65 dBZ, 4 voxels
  EXPECT_AT_LEAST(Count(picture, southWest, isColour(core)), 90, "pixels of the core's colour");
  EXPECT_AT_LEAST(Count(picture, southWest, IsStrongEcho), 750, "pixels of strong echo");
  EXPECT_EQ(Count(picture, {east, strip.right, strip.bottom, strip.top}, isColour(core)), 0);
}

TEST(Scene, AVolumeThatChangesIsDrawnAnew)
{
  vtkNew<vtkNexradVolumeScene> scene;
  scene->SetVolume(MakeStormVolume(false));
  OffScreenWindow window(scene->GetRenderer(), sceneSize);
  EXPECT_AT_LEAST(Count(window.Draw(), withoutBar, IsStrongEcho), 1'000, "pixels of strong echo");
  scene->SetVolume(MakeEmptyVolume());
  EXPECT_EQ(Count(window.Draw(), withoutBar, IsStrongEcho), 0);
}

// An empty map and one with a storm have the words in the middle that tell them apart.
TEST(Scene, AMapWithoutAValueSaysSo)
{
  SceneOptions options = Classic();
  options.plan = PlanOptions();
  options.plan->level = PlanLevel::LiquidDensity;
  vtkNew<vtkNexradVolumeScene> scene;
  scene->SetOptions(options);
  scene->SetVolume(MakeEmptyVolume());
  OffScreenWindow window(scene->GetRenderer(), sceneSize);
  constexpr PictureArea middle = {0.25, 0.7, 0.5, 0.6};
  const auto isBright = [](const std::array<int, 3>& rgb) { return rgb[0] > 200 && rgb[2] > 200; };
  const Picture said = window.Draw();
  KeepPicture(said, "SceneEmptyMap");
  EXPECT_AT_LEAST(Count(said, middle, isBright), 600, "bright pixels of letters");
}

// What the program shows of a series of files, read as codes, beside the values read from the same
// file: at most one of 255 apart.
TEST(Scene, AFileIsDrawnFromItsCodesAsFromItsValues)
{
  const TemporaryFolder folder;
  const std::filesystem::path index = WriteStormFiles(folder.Path(), 1);
  const auto series = OpenVolumeFiles({index});
  const auto values = series->Load(0, {});
  EXPECT_EQ(values->GetScalarType(), VTK_FLOAT);
  series->AllowCodes(true);
  const auto codes = series->Load(0, {});
  EXPECT_EQ(codes->GetScalarType(), VTK_UNSIGNED_CHAR);

  const Picture expected = Draw(values, "OfValues");
  EXPECT_GT(Count(expected, withoutBar, IsStrongEcho), 300);
  vtkNew<vtkNexradSession> session;
  session->GetScene()->SetOptions(Classic());
  session->AddFileName(index.c_str());
  ASSERT_TRUE(session->ShowTimeStep(0));
  EXPECT_EQ(session->GetScene()->GetVolume()->GetScalarType(), VTK_UNSIGNED_CHAR);
  const Picture ofSession = OffScreenWindow(session->GetScene()->GetRenderer(), sceneSize).Draw();
  for (const Picture& drawn : {Draw(codes, "OfCodes"), ofSession})
  {
    EXPECT_AT_MOST(LargestDifference(drawn, expected), 1,
      "largest difference of codes and values, of 255", OneCode);
  }
}

// The tower, which is lit from the left behind the camera, is as bright in the light as without.
TEST(Scene, TheLitSideKeepsItsBrightness)
{
  const auto volume = MakeStormVolume(false);
  SceneOptions dark; // its sky and ground are not as bright as echo
  dark.theme = ThemeChoice::Dark;
  SceneOptions unlit = dark;
  unlit.light.shadow = 0.0;
  unlit.light.occlusion = 0.0;
  const auto brightest = [](const Picture& picture)
  {
    std::vector<int> channels;
    for (int y = 40; y < 300; ++y)
    {
      for (int x = 0; x < 550; ++x)
      {
        const auto rgb = PixelOf(picture, x, y);
        const auto [least, most] = std::minmax_element(rgb.begin(), rgb.end());
        if (*most - *least > 60)
        {
          channels.push_back(*most);
        }
      }
    }
    std::sort(channels.begin(), channels.end());
    double sum = 0.0; // of the brighter half
    for (std::size_t i = channels.size() / 2; i < channels.size(); ++i)
    {
      sum += channels[i];
    }
    return sum / (0.5 * static_cast<double>(channels.size()));
  };
  const double ratio =
    brightest(Draw(volume, "Lit", dark)) / brightest(Draw(volume, "Unlit", unlit));
  EXPECT_AT_LEAST(ratio, 0.9, "brightness of the lit half of the echo, part of that without light");
}

// Of a series whose end nobody knows, the frame grows when the echo leaves it, and does not shrink.
TEST(Scene, AFrameGrowsOnlyWhenEchoLeavesIt)
{
  const TemporaryFolder folder;
  const auto series = OpenVolumeFiles({WriteStormFiles(folder.Path(), 4)});
  vtkNew<vtkNexradVolumeScene> scene;
  const auto framed = [&](std::size_t step)
  {
    scene->SetVolume(series->Load(step, {}));
    scene->Draw();
    return scene->GetSceneFrame()->Framed();
  };
  const auto first = framed(0);
  const auto grown = framed(3);
  EXPECT_GT(grown[1], first[1]);
  EXPECT_LE(grown[0], first[0] + 1.0);
  EXPECT_EQ(framed(0), grown);
}

TEST(Scene, NothingToDrawIsAnError)
{
  vtkNew<vtkNexradVolumeScene> scene;
  scene->SetVolume(vtkNew<vtkImageData>());
  EXPECT_THROW(scene->Draw(), Error);
}
