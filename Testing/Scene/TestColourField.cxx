// SPDX-License-Identifier: BSD-3-Clause
// Opacity from the moment that is shown, colour from another array.
#include "ScenePicture.h"
#include "StormVolume.h"
#include "TestData.h"
#include "Tolerance.h"
#include "nexrad/Grid/GriddedVolume.h"
#include "vtkNexradImageConversion.h"
#include "vtkNexradMessages.h"
#include "vtkNexradTransferFunction.h"
#include "vtkNexradVolumeScene.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkRenderer.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <fstream>
#include <string>

using namespace nexrad;
using namespace nexrad::testing;

namespace
{

constexpr std::array<int, 2> size = {640, 400};
using Pixel = std::array<int, 3>;

// The storm with a velocity: 22 m/s away from the radar in the western half of its core, towards it
// in the eastern one, range folded north of the core; age 60 s in the west, 600 s in the east.
vtkSmartPointer<vtkImageData> MakeStormWithVelocity()
{
  GriddedVolume storm = MakeStorm(false);
  GriddedVolume velocity = storm;
  velocity.moment = MomentName::VEL;
  for (std::size_t i = 0; i < storm.values.size(); ++i)
  {
    const bool west = i % 48 < 17;
    const bool folded = i / 48 % 48 > 20;
    const bool echo = storm.states[i] == VoxelState::Echo;
    velocity.states[i] = !echo    ? VoxelState::NoEcho
                         : folded ? VoxelState::RangeFolded
                                  : VoxelState::Echo;
    velocity.values[i] = echo && !folded ? (west ? 22.0F : -22.0F) : velocity.fill;
    storm.ancillary.age.push_back(west ? 60.0F : 600.0F);
    storm.ancillary.nearestSite.push_back(west ? 0 : 1);
    storm.ancillary.radars.push_back(1);
  }
  auto image = vtkSmartPointer<vtkImageData>::New();
  vtkNexradVolumeToImage(JoinMoments({storm, velocity}), image);
  return image;
}

template <typename Settings>
Picture DrawStorm(const std::string& name, const Settings& set)
{
  vtkNew<vtkNexradVolumeScene> scene;
  UseClassicLook(scene);
  scene->SetVolume(MakeStormWithVelocity());
  scene->SetAzimuth(180.0);
  scene->SetTilt(60.0);
  set(scene.Get());
  const Picture picture = OffScreenWindow(scene->GetRenderer(), size).Draw();
  KeepPicture(picture, name);
  return picture;
}

Picture DrawBy(const std::string& array)
{
  return DrawStorm(
    array, [&](vtkNexradVolumeScene* scene) { scene->SetOption("colour-by", array.c_str()); });
}

// Pixels left of the colour bar.
template <typename Test>
int Count(const Picture& picture, const Test& test)
{
  int count = 0;
  for (int y = size[1] / 8; y < size[1] * 3 / 4; ++y)
  {
    for (int x = 0; x < size[0] * 85 / 100; ++x)
    {
      count += test(PixelOf(picture, x, y)) ? 1 : 0;
    }
  }
  return count;
}

bool IsRed(const Pixel& rgb)
{
  return rgb[0] > 100 && rgb[0] > 2 * rgb[1] && rgb[0] > 2 * rgb[2];
}

/// The largest difference of a channel where the storm is.
int WorstDifference(const Picture& a, const Picture& b)
{
  int worst = 0;
  for (int y = size[1] / 8; y < size[1] * 3 / 4; ++y)
  {
    for (int x = 0; x < size[0] * 85 / 100; ++x)
    {
      for (std::size_t c = 0; c < 3; ++c)
      {
        worst = std::max(worst, std::abs(PixelOf(a, x, y)[c] - PixelOf(b, x, y)[c]));
      }
    }
  }
  return worst;
}

bool IsGreen(const Pixel& rgb)
{
  return rgb[1] > 90 && rgb[1] > 2 * rgb[0] && rgb[1] > rgb[2] + 20;
}

bool IsBlue(const Pixel& rgb)
{
  return rgb[2] > 90 && rgb[2] > 2 * rgb[0] && rgb[2] > rgb[1];
}

} // namespace

// The picture: the storm's core red in the west, green in the east, brown where velocities are
// range folded; no other colour, although between brown and red lie green and blue velocities.
TEST(ColourField, VelocityGivesTheColoursOfReflectivity)
{
  const Picture picture = DrawBy("VEL");
  ExpectSceneBaseline(picture, "VelocityOnReflectivity");
  EXPECT_AT_LEAST(Count(picture, IsRed), 300, "pixels of velocities away, in red");
  EXPECT_AT_LEAST(Count(picture, IsGreen), 2000, "pixels of velocities towards, in green");
  EXPECT_EQ(Count(picture, IsBlue), 0);
}

// One colour for all values, of the moment alone and of a velocity that is known everywhere: the
// same picture, since the opacities are those of the moment.
TEST(ColourField, InOneColourItIsThePictureOfTheMoment)
{
  const TemporaryFolder folder;
  const std::string table = folder.Path() / "one.csv";
  std::ofstream(table) << "value,colour\n-40,#40c0ff\n20,#40c0ff\n80,#40c0ff\n";
  GriddedVolume storm = MakeStorm(false);
  GriddedVolume velocity = storm;
  velocity.moment = MomentName::VEL;
  velocity.states.assign(velocity.states.size(), VoxelState::Echo);
  vtkNew<vtkImageData> image;
  vtkNexradVolumeToImage(JoinMoments({storm, velocity}), image);
  const auto draw = [&](const std::string& array, bool integrated)
  {
    return DrawStorm("one-colour" + array,
      [&](vtkNexradVolumeScene* scene)
      {
        scene->SetVolume(image);
        scene->SetOption("classification", integrated ? "pre-integrated" : "sampled");
        scene->SetOption("colours", table.c_str());
        scene->SetOption("colour-by", array.c_str());
      });
  };
  const auto isStorm = [](const Pixel& rgb) { return rgb[2] > 150 && rgb[0] < 80; };
  const Picture moment = draw("", false);
  EXPECT_GT(Count(moment, isStorm), 1000);
  // The table of two fields has more entries: it rises later where the opacity begins.
  EXPECT_AT_MOST(WorstDifference(moment, draw("VEL", false)), 12.0,
    "sampled, in one colour: one field and two, of 255");
  EXPECT_AT_MOST(WorstDifference(draw("", true), draw("VEL", true)), 12.0,
    "integrated, in one colour: one field and two, of 255");
}

// The opacities are those of the moment: where it is clear, nothing is seen of the other array.
TEST(ColourField, OpacityIsThatOfTheMoment)
{
  const auto draw = [](const std::string& name, double threshold)
  {
    return DrawStorm(name,
      [threshold](vtkNexradVolumeScene* scene)
      {
        scene->SetOption("colour-by", "VEL");
        scene->Update();
        vtkNexradTransferFunction* function = scene->GetTransferFunction();
        function->RemoveAllNodes(vtkNexradTransferFunction::OPACITY);
        function->AddNode(vtkNexradTransferFunction::OPACITY, threshold, 0.0);
        function->AddNode(vtkNexradTransferFunction::OPACITY, threshold + 5.0, 0.9);
      });
  };
  const Picture nothing = draw("nothing", 100.0);
  EXPECT_EQ(Count(nothing, IsRed) + Count(nothing, IsGreen), 0);
  const int cores = Count(draw("cores", 45.0), IsRed);
  EXPECT_GT(cores, 100);
  EXPECT_GT(Count(draw("dense", 20.0), IsRed), cores);
}

// The captions and the bar say minutes; two colours, of 1 and of 10 minutes.
TEST(ColourField, AgeAndNearestRadarGiveColours)
{
  const Picture storm = DrawStorm("moment", [](vtkNexradVolumeScene*) {});
  const Picture age = DrawBy("REF_age");
  const Picture site = DrawBy("REF_site");
  EXPECT_AT_LEAST(
    MeanDifference(age, storm), 5.0, "mean difference of age and reflectivity, of 255");
  EXPECT_AT_LEAST(
    MeanDifference(site, age), 6.5, "mean difference of nearest radar and age, of 255");
  // Blue for the first radar, orange for the second; between them no other.
  EXPECT_AT_LEAST(Count(site, IsBlue), 1000, "pixels of the first radar, in blue");
  EXPECT_EQ(Count(site, IsGreen), 0);
}

TEST(ColourField, AnArrayThatIsNotThereIsRefusedByName)
{
  vtkNew<vtkNexradVolumeScene> scene;
  vtkNexradMessages messages;
  messages.Watch(scene);
  scene->SetVolume(MakeStormVolume(false));
  scene->SetOption("colour-by", "VEL");
  EXPECT_FALSE(scene->Update());
  ASSERT_EQ(messages.Errors().size(), 1U);
  EXPECT_NE(messages.Errors()[0].find("no point array VEL"), std::string::npos);
  scene->SetOption("colour-by", "REF_state");
  EXPECT_FALSE(scene->Update());
  scene->SetOption("colour-by", "REF");
  EXPECT_TRUE(scene->Update());
}
