// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNexradVolumeScene.h"

#include "ScenePicture.h"
#include "StormVolume.h"
#include "Tolerance.h"
#include "vtkNexradImageConversion.h"
#include "vtkNexradMessages.h"
#include "vtkNexradTransferFunction.h"

#include "nexrad/System/Error.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPropCollection.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

using namespace nexrad::testing;

namespace
{

constexpr std::array<int, 2> smallSize = {400, 225};

Picture Draw(vtkNexradVolumeScene* scene)
{
  return OffScreenWindow(scene->GetRenderer(), smallSize).Draw();
}

// A picture of the storm with these settings from the beginning.
template <typename Settings>
Picture DrawStorm(const Settings& set)
{
  vtkNew<vtkNexradVolumeScene> scene;
  set(scene.Get());
  scene->SetVolume(MakeStormVolume(true));
  return Draw(scene);
}

void SetNothing(vtkNexradVolumeScene*) {}

// The storm in so many columns along x, in a domain that stays the same.
vtkSmartPointer<vtkImageData> MakeStormOf(int columns)
{
  nexrad::GriddedVolume volume = MakeStorm(true);
  const double width = volume.grid.dimensions[0] * volume.grid.spacing[0];
  volume.grid.origin[0] -= 0.5 * volume.grid.spacing[0];
  volume.grid.dimensions = {columns, 24, 8};
  volume.grid.spacing = {
    width / columns, 2.0 * volume.grid.spacing[1], 2.0 * volume.grid.spacing[2]};
  volume.grid.origin[0] += 0.5 * volume.grid.spacing[0];
  volume.values.assign(volume.grid.VoxelCount(), volume.fill);
  volume.states.assign(volume.values.size(), nexrad::VoxelState::NoEcho);
  for (std::size_t i = 0; i < volume.values.size(); ++i)
  {
    const auto place = [&](std::size_t axis, std::size_t index)
    {
      return (volume.grid.origin[axis] + volume.grid.spacing[axis] * static_cast<double>(index)) /
             1000.0;
    };
    const auto wide = static_cast<std::size_t>(columns);
    const double value =
      Storm(place(0, i % wide), place(1, i / wide % 24), place(2, i / wide / 24));
    if (value > 0.0)
    {
      volume.values[i] = static_cast<float>(value);
      volume.states[i] = nexrad::VoxelState::Echo;
    }
  }
  auto image = vtkSmartPointer<vtkImageData>::New();
  vtkNexradVolumeToImage(volume, image);
  return image;
}

} // namespace

// OpenGL takes no texture of 40 000 columns, but their pages.
TEST(VolumeScene, AVolumeThatIsWiderThanATextureIsDrawn)
{
  const auto draw = [](int columns)
  {
    vtkNew<vtkNexradVolumeScene> scene;
    vtkNexradMessages messages;
    messages.Watch(scene->GetRenderer());
    UseClassicLook(scene);
    scene->SetVolume(MakeStormOf(columns));
    OffScreenWindow window(scene->GetRenderer(), smallSize);
    const Picture picture = window.Draw();
    EXPECT_TRUE(messages.Errors().empty());
    EXPECT_TRUE(messages.Warnings().empty());
    return picture;
  };
  const Picture fine = draw(2000);
  EXPECT_AT_MOST(MeanDifference(fine, draw(40'000)), 0.01,
    "wide volume: difference to one that OpenGL takes, of 255",
    "a few pixels round to the next code, by the renderer");
  EXPECT_AT_LEAST(MeanDifference(fine, Draw(vtkNew<vtkNexradVolumeScene>())), 10.0,
    "storm: difference to an empty picture, of 255");
}

// The picture: the lit storm, green with a red core, and its shadow on a pale map with rings about
// two radars, with the colour bar at the right and SYNTHETIC above.
TEST(VolumeScene, DrawsStormMapAndScales)
{
  ExpectSceneBaseline(
    DrawStorm([](vtkNexradVolumeScene* scene) { scene->SetOption("rings", "100km"); }), "Storm");
}

// The picture: discs of flat colours in the south west of a pale square, seen from above.
TEST(VolumeScene, DrawsAPlanView)
{
  const auto set = [](vtkNexradVolumeScene* scene)
  {
    scene->SetOption("map", "composite");
    scene->SetCameraFromAbove();
  };
  ExpectSceneBaseline(DrawStorm(set), "Composite");
}

// The picture: the empty corners of the sky, the captions, and the colour bar of another preset.
TEST(VolumeScene, DrawsAnotherPresetFromAnotherSide)
{
  const auto set = [](vtkNexradVolumeScene* scene)
  {
    UseClassicLook(scene);
    scene->SetPreset("storm cores");
    scene->SetAzimuth(120.0);
    scene->SetTilt(15.0);
    scene->SetZoom(1.5);
    scene->SetOption("exaggeration", 12.0);
    scene->ParallelProjectionOn();
  };
  ExpectSceneBaseline(DrawStorm(set), "StormCores");
}

// The picture: the storm in violet and red and its letters over a pale ground.
TEST(VolumeScene, DrawsALightTheme)
{
  const auto set = [](vtkNexradVolumeScene* scene)
  {
    UseClassicLook(scene);
    scene->SetOption("theme", "light");
    scene->SetOption("names", "on");
    scene->SetPreset("colour-blind safe");
  };
  ExpectSceneBaseline(DrawStorm(set), "StormLight");
}

namespace
{

// How many pixels of a picture from above are not those of `within` where `isWithin` holds for
// the place of the ground, and not those of `beyond` elsewhere, part. Pixels less than a voxel's
// width from the border are not compared.
template <typename Inside>
double WrongPart(vtkNexradVolumeScene* scene, const Picture& shown, const Picture& within,
  const Picture& beyond, const Inside& depth)
{
  int wrong = 0;
  int compared = 0;
  for (int y = 0; y < smallSize[1]; ++y)
  {
    for (int x = 0; x < smallSize[0]; ++x)
    {
      double place[2];
      if (!scene->FindGround(x + 0.5, y + 0.5, place) || std::abs(depth(place)) < 10e3)
      {
        continue;
      }
      const auto pixel = PixelOf(shown, x, y);
      const auto wanted = PixelOf(depth(place) > 0.0 ? within : beyond, x, y);
      bool same = true;
      for (std::size_t i = 0; i < 3; ++i)
      {
        same = same && std::abs(pixel[i] - wanted[i]) <= 8;
      }
      wrong += same ? 0 : 1;
      ++compared;
    }
  }
  EXPECT_GT(compared, 20'000);
  return static_cast<double>(wrong) / compared;
}

void SeeFromAbove(vtkNexradVolumeScene* scene)
{
  UseClassicLook(scene);
  scene->SetCameraFromAbove();
  scene->SetOption("walls", "off");
}

// An empty crop box would say that it is empty.
void ClipAll(vtkNexradVolumeScene* scene)
{
  SeeFromAbove(scene);
  scene->ClippingOn();
  scene->SetClipOrigin(1000e3, 0.0, 0.0);
  scene->SetClipNormal(1.0, 0.0, 0.0);
}

} // namespace

TEST(VolumeScene, TheCropBoxHidesExactlyWhatIsOutside)
{
  const Picture whole = DrawStorm(SeeFromAbove);
  const Picture nothing = DrawStorm(ClipAll);
  ASSERT_GT(MeanDifference(whole, nothing), 1.0);
  vtkNew<vtkNexradVolumeScene> scene;
  SeeFromAbove(scene);
  scene->CroppingOn();
  scene->SetCropBounds(-100e3, -20e3, -75e3, 60e3, -1e3, 30e3);
  scene->SetVolume(MakeStormVolume(true));
  OffScreenWindow window(scene->GetRenderer(), smallSize);
  const Picture cropped = window.Draw();
  const auto depth = [](const double* place)
  {
    return std::min(
      std::min(place[0] + 100e3, -20e3 - place[0]), std::min(place[1] + 75e3, 60e3 - place[1]));
  };
  EXPECT_AT_MOST(WrongPart(scene, cropped, whole, nothing, depth), 0.0005,
    "pixels of a cropped volume that are wrong, part", "drivers round to either neighbour");
  KeepPicture(cropped, "Cropped");
}

TEST(VolumeScene, TheClipPlaneHidesExactlyOneSide)
{
  const Picture whole = DrawStorm(SeeFromAbove);
  const Picture nothing = DrawStorm(ClipAll);
  vtkNew<vtkNexradVolumeScene> scene;
  SeeFromAbove(scene);
  scene->ClippingOn();
  scene->SetClipOrigin(-70e3, -70e3, 0.0);
  scene->SetClipNormal(3.0, 4.0, 0.0);
  scene->SetVolume(MakeStormVolume(true));
  OffScreenWindow window(scene->GetRenderer(), smallSize);
  const Picture clipped = window.Draw();
  const auto depth = [](const double* place)
  { return 0.6 * (place[0] + 70e3) + 0.8 * (place[1] + 70e3); };
  EXPECT_AT_MOST(WrongPart(scene, clipped, whole, nothing, depth), 0.0005,
    "pixels of a clipped volume that are wrong, part", "drivers round to either neighbour");
}

TEST(VolumeScene, ACutWithoutAnInsideOrADirectionIsRefused)
{
  vtkNew<vtkNexradVolumeScene> scene;
  scene->SetVolume(MakeStormVolume(true));
  OffScreenWindow window(scene->GetRenderer(), smallSize);
  window.Draw();
  vtkNexradMessages messages;
  messages.Watch(scene);
  scene->CroppingOn();
  scene->SetCropBounds(10e3, -10e3, -10e3, 10e3, 0.0, 1e3);
  EXPECT_FALSE(scene->Update());
  EXPECT_THROW(messages.ThrowFirstError(), nexrad::Error);
  scene->CroppingOff();
  EXPECT_TRUE(scene->Update());
  scene->ClippingOn();
  scene->SetClipNormal(0.0, 0.0, 0.0);
  EXPECT_FALSE(scene->Update());
}

TEST(VolumeScene, PlacesOfTheGroundAndPixelsBelongTogether)
{
  vtkNew<vtkNexradVolumeScene> scene;
  double place[2];
  EXPECT_FALSE(scene->FindGround(10.0, 10.0, place)) << "before the first picture";
  UseClassicLook(scene);
  scene->SetVolume(MakeStormVolume(true));
  OffScreenWindow window(scene->GetRenderer(), smallSize);
  window.Draw();
  double pixel[2];
  ASSERT_TRUE(scene->FindPixel(-70e3, 35e3, pixel));
  ASSERT_TRUE(scene->FindGround(pixel[0], pixel[1], place));
  EXPECT_NEAR(place[0], -70e3, 1.0);
  EXPECT_NEAR(place[1], 35e3, 1.0);
  const double point[3] = {-70e3, 35e3, 4e3};
  double scenePoint[3];
  double back[3];
  ASSERT_TRUE(scene->VolumeToScene(point, scenePoint));
  EXPECT_DOUBLE_EQ(scenePoint[0], -70.0);
  EXPECT_DOUBLE_EQ(scenePoint[2], 4.0 * 8.0); // stretched 8 times
  ASSERT_TRUE(scene->SceneToVolume(scenePoint, back));
  scene->SetTilt(2.0);
  window.Draw();
  EXPECT_FALSE(scene->FindGround(5.0, smallSize[1] - 5.0, place)) << "the sky";
  EXPECT_NEAR(back[2], 4e3, 1e-6);
}

// A scene whose settings change between two pictures draws the second as one that had them at once.
TEST(VolumeScene, ASettingTakesEffectInTheNextPicture)
{
  using Setting = void (*)(vtkNexradVolumeScene*);
  const std::vector<std::pair<const char*, Setting>> settings = {
    {"azimuth", [](vtkNexradVolumeScene* scene) { scene->SetAzimuth(100.0); }},
    {"tilt", [](vtkNexradVolumeScene* scene) { scene->SetTilt(60.0); }},
    {"zoom", [](vtkNexradVolumeScene* scene) { scene->SetZoom(2.0); }},
    {"place", [](vtkNexradVolumeScene* scene) { scene->SetLookAt(-70e3, -70e3, 0.0); }},
    {"projection", [](vtkNexradVolumeScene* scene) { scene->ParallelProjectionOn(); }},
    {"preset", [](vtkNexradVolumeScene* scene) { scene->SetPreset("hail"); }},
    {"exaggeration", [](vtkNexradVolumeScene* scene) { scene->SetOption("exaggeration", 2.0); }},
    {"mapper", [](vtkNexradVolumeScene* scene) { scene->SetOption("mapper", "ray-cast"); }},
    {"classification",
      [](vtkNexradVolumeScene* scene) { scene->SetOption("classification", "sampled"); }},
    {"slices", [](vtkNexradVolumeScene* scene) { scene->SetOption("slices", "11"); }},
    {"rings", [](vtkNexradVolumeScene* scene) { scene->SetOption("rings", "50km"); }},
    {"theme", [](vtkNexradVolumeScene* scene) { scene->SetOption("theme", "dark"); }},
    {"framing", [](vtkNexradVolumeScene* scene) { scene->SetOption("frame", "domain"); }},
    {"opacities",
      [](vtkNexradVolumeScene* scene) { scene->SetOption("opacity-distance", "20km"); }},
    {"walls", [](vtkNexradVolumeScene* scene) { scene->SetOption("walls", "off"); }},
    {"shadow", [](vtkNexradVolumeScene* scene) { scene->SetOption("shadow", 0.8); }},
    {"occlusion", [](vtkNexradVolumeScene* scene) { scene->SetOption("occlusion", 0.8); }},
    {"echo top", [](vtkNexradVolumeScene* scene) { scene->SetOption("map", "echo-top:30"); }},
    {"liquid", [](vtkNexradVolumeScene* scene) { scene->SetOption("map", "vil"); }},
    {"liquid density", [](vtkNexradVolumeScene* scene) { scene->SetOption("map", "vil-density"); }},
    {"crop",
      [](vtkNexradVolumeScene* scene)
      {
        scene->CroppingOn();
        scene->SetCropBounds(-70e3, 240e3, -240e3, 240e3, 0.0, 20e3);
      }},
    {"clip",
      [](vtkNexradVolumeScene* scene)
      {
        scene->ClippingOn();
        scene->SetClipOrigin(-70e3, -70e3, 5e3);
        scene->SetClipNormal(0.0, 0.1, -1.0);
      }},
    {"section",
      [](vtkNexradVolumeScene* scene)
      {
        scene->SectionOn();
        scene->SetSectionB(100e3, 100e3);
      }},
    {"light",
      [](vtkNexradVolumeScene* scene)
      {
        scene->SetOption("shadow", 0.8);
        scene->SetOption("light", "90,20");
      }},
    {"plan", [](vtkNexradVolumeScene* scene) { scene->SetOption("map", "lowest"); }},
    {"height", [](vtkNexradVolumeScene* scene) { scene->SetOption("map", "9km"); }}};
  const Picture usual = DrawStorm(SetNothing);
  for (const auto& [name, set] : settings)
  {
    vtkNew<vtkNexradVolumeScene> scene;
    scene->SetVolume(MakeStormVolume(true));
    OffScreenWindow window(scene->GetRenderer(), smallSize);
    EXPECT_EQ(MeanDifference(window.Draw(), usual), 0.0) << name;
    set(scene);
    const Picture changed = window.Draw();
    EXPECT_EQ(MeanDifference(changed, DrawStorm(set)), 0.0) << name;
    EXPECT_AT_LEAST(
      MeanDifference(changed, usual), 0.0045, "mean change of the picture by a setting, of 255")
      << name;
  }
}

// The storm stands in the south west and leans to the north east; a low light in the south west
// draws its shadow over the ground in the north east, beyond the echo, and not in the south east.
TEST(VolumeScene, TheVolumeShadesTheGround)
{
  const auto draw = [](double shadow, bool rayCast)
  {
    return DrawStorm(
      [=](vtkNexradVolumeScene* scene)
      {
        UseClassicLook(scene);
        scene->SetCameraFromAbove();
        scene->SetOption("shadow", shadow);
        scene->SetOption("light", "225,20");
        scene->SetOption("mapper", rayCast ? "ray-cast" : "texture-slice");
      });
  };
  const Picture without = draw(0.0, false);
  const Picture with = draw(1.0, false);
  KeepPicture(with, "SceneGroundShadow");
  const auto meanAbout = [](const Picture& picture, int x, int y)
  {
    int sum = 0;
    for (int i = 0; i < 36; ++i)
    {
      sum += PixelOf(picture, x + i % 6, y + i / 6)[2];
    }
    return sum / 36.0;
  };
  // The middle of the domain, of which a pixel shows 3.9 km.
  constexpr int x = 300;
  constexpr int y = 126;
  const double shaded = meanAbout(with, x + 34, y + 28) / meanAbout(without, x + 34, y + 28);
  std::cout << "light on the ground in the shadow: " << shaded << '\n';
  EXPECT_AT_MOST(shaded, 0.8, "light on the ground in the shadow, part of that without");
  EXPECT_EQ(meanAbout(with, x + 35, y - 35), meanAbout(without, x + 35, y - 35));
  EXPECT_EQ(MeanDifference(draw(1.0, true), draw(0.0, true)), 0.0) << "the ray caster has none";
}

// Shadows on surfaces come and go without a trace, and each surface has an opacity of its own.
TEST(VolumeScene, SurfacesHaveShadowsAndOpacities)
{
  const auto useSurfaces = [](vtkNexradVolumeScene* scene)
  {
    UseClassicLook(scene);
    scene->SetPreset("iso-values");
  };
  const auto useShadows = [](vtkNexradVolumeScene* scene)
  {
    UseClassicLook(scene);
    scene->SetPreset("iso-values");
    scene->SetOption("shadow", 0.8);
    scene->SetOption("occlusion", 0.6);
  };
  const Picture usual = DrawStorm(useSurfaces);
  vtkNew<vtkNexradVolumeScene> scene;
  scene->SetVolume(MakeStormVolume(true));
  useSurfaces(scene);
  OffScreenWindow window(scene->GetRenderer(), smallSize);
  EXPECT_EQ(MeanDifference(window.Draw(), usual), 0.0);
  useShadows(scene);
  const Picture shadowed = window.Draw();
  KeepPicture(shadowed, "SceneSurfaceShadow");
  EXPECT_EQ(MeanDifference(shadowed, DrawStorm(useShadows)), 0.0);
  EXPECT_AT_LEAST(
    MeanDifference(shadowed, usual), 0.15, "mean change of surfaces by shadows, of 255");
  scene->SetOption("shadow", 0.0);
  scene->SetOption("occlusion", 0.0);
  EXPECT_EQ(MeanDifference(window.Draw(), usual), 0.0);
  const std::array<double, 3> values{50.0, 20.0, 35.0};
  const std::array<double, 3> opacities{0.95, 0.35, 0.55};
  scene->GetTransferFunction()->SetOpacityToIsoValues(values.data(), opacities.data(), 3);
  EXPECT_EQ(MeanDifference(window.Draw(), usual), 0.0) << "those of the preset";
  const std::array<double, 3> opaque{1.0, 1.0, 1.0};
  scene->GetTransferFunction()->SetOpacityToIsoValues(values.data(), opaque.data(), 3);
  EXPECT_AT_LEAST(
    MeanDifference(window.Draw(), usual), 0.25, "mean change of surfaces by opacities, of 255");
}

TEST(VolumeScene, ChangesOfTheTransferFunctionAreDrawnAndKept)
{
  vtkNew<vtkNexradVolumeScene> scene;
  EXPECT_EQ(scene->GetTransferFunction(), nullptr);
  scene->SetVolume(MakeStormVolume(true));
  OffScreenWindow window(scene->GetRenderer(), smallSize);
  const Picture usual = window.Draw();
  auto* colors = scene->GetTransferFunction();
  ASSERT_NE(colors, nullptr);
  const double dbz = 30.0;
  colors->SetOpacityToIsoValues(&dbz, 1);
  const Picture surface = window.Draw();
  EXPECT_AT_LEAST(
    MeanDifference(usual, surface), 1.3, "mean change of the picture by a shell, of 255");
  // What is changed beside them, and a new volume, leave them as they are.
  scene->SetOption("rings", "100km");
  scene->SetVolume(MakeStormVolume(true));
  window.Draw();
  EXPECT_EQ(scene->GetTransferFunction(), colors);
  scene->SetOption("rings", "0");
  EXPECT_EQ(MeanDifference(window.Draw(), surface), 0.0);
  // The same preset, and another one, begin anew.
  scene->ResetTransferFunction();
  EXPECT_EQ(MeanDifference(window.Draw(), usual), 0.0);
  EXPECT_NE(scene->GetTransferFunction(), colors);
  scene->GetTransferFunction()->SetOpacityToIsoValues(&dbz, 1);
  scene->SetPreset("all echo");
  EXPECT_EQ(MeanDifference(window.Draw(), usual), 0.0);
}

TEST(VolumeScene, DrawsSurfacesOfIsoValues)
{
  vtkNew<vtkNexradVolumeScene> scene;
  scene->SetVolume(MakeStormVolume(true));
  OffScreenWindow window(scene->GetRenderer(), smallSize);
  const Picture usual = window.Draw();
  scene->SetOption("iso-values", "45,20:0.25");
  const Picture surfaces = window.Draw();
  EXPECT_AT_LEAST(
    MeanDifference(usual, surfaces), 1.3, "mean change of the picture by two surfaces, of 255");
  auto* colors = scene->GetTransferFunction();
  ASSERT_EQ(colors->GetNumberOfIsoValues(), 2);
  EXPECT_EQ(colors->Evaluate(vtkNexradTransferFunction::OPACITY, 20.0), 0.25);
  EXPECT_EQ(colors->Evaluate(vtkNexradTransferFunction::OPACITY, 45.0), 0.95);
  scene->SetOption("iso-values", "");
  EXPECT_EQ(MeanDifference(window.Draw(), usual), 0.0);
  vtkNexradMessages messages;
  messages.Watch(scene);
  scene->SetOption("iso-values", "45:1.5");
  EXPECT_EQ(messages.Errors().size(), 1U);
  EXPECT_EQ(scene->GetOption("iso-values"), "");
}

TEST(VolumeScene, AnErrorIsReportedOnceAndLeavesThePicture)
{
  vtkNew<vtkNexradVolumeScene> scene;
  scene->SetVolume(MakeStormVolume(true));
  OffScreenWindow window(scene->GetRenderer(), smallSize);
  const Picture usual = window.Draw();
  vtkNexradMessages messages;
  messages.Watch(scene);
  const auto expectError = [&](const std::string& words)
  {
    EXPECT_FALSE(scene->Update()) << words;
    EXPECT_EQ(MeanDifference(window.Draw(), usual), 0.0) << words;
    EXPECT_FALSE(scene->Update()) << words;
    ASSERT_EQ(messages.Errors().size(), 1u) << words;
    EXPECT_NE(messages.Errors().front().find(words), std::string::npos)
      << messages.Errors().front();
    messages.Clear();
  };
  scene->SetPreset("velocity");
  expectError("'velocity' is of VEL");
  scene->SetPreset("");
  scene->SetOption("colours", "/dev/null");
  expectError("/dev/null");
  scene->SetOption("colours", "");
  scene->SetOption("map", "composite");
  scene->SetOption("array", "REF_age");
  expectError("no array REF_age");
  scene->SetOption("map", "");
  vtkNew<vtkImageData> empty;
  scene->SetVolume(empty);
  expectError("no voxels");
  scene->SetVolume(MakeStormVolume(true));
  EXPECT_TRUE(scene->Update());
  EXPECT_EQ(MeanDifference(window.Draw(), usual), 0.0);
  EXPECT_TRUE(messages.Errors().empty());
  scene->SetOption("rings", "10m");
  EXPECT_EQ(messages.Errors().size(), 1u);
  EXPECT_EQ(scene->GetOption("rings"), "0km");
  messages.Clear();
  scene->SetOption("ring", "10km");
  EXPECT_EQ(messages.Errors().size(), 1u);
}

TEST(VolumeScene, OptionsAreSetByTheirKeys)
{
  vtkNew<vtkNexradVolumeScene> scene;
  scene->SetOption("rings", 50e3);
  EXPECT_EQ(scene->GetOption("rings"), "50km");
  scene->SetOption("tilt", "20");
  EXPECT_EQ(scene->GetTilt(), 20.0);
  scene->SetTilt(30.0);
  EXPECT_EQ(scene->GetOption("tilt"), "30");
  scene->SetOption("walls", 0.0);
  EXPECT_EQ(scene->GetOption("walls"), "off");
  scene->SetOption("crop", "-10000m,20km,-1km,1km,0,15km");
  EXPECT_TRUE(scene->GetCropping());
  EXPECT_EQ(scene->GetCropBounds()[1], 20e3);
  EXPECT_EQ(scene->GetOption("crop"), "-10km,20km,-1km,1km,0km,15km");
  scene->SetOption("crop", "");
  EXPECT_FALSE(scene->GetCropping());
  std::ostringstream text;
  scene->Print(text);
  EXPECT_NE(text.str().find("rings: 50km\n"), std::string::npos) << text.str();
}

TEST(VolumeScene, FollowsTheSizeOfItsWindow)
{
  vtkNew<vtkNexradVolumeScene> scene;
  scene->SetVolume(MakeStormVolume(true));
  OffScreenWindow window(scene->GetRenderer(), {320, 240});
  window.Draw();
  window.Window()->SetSize(smallSize[0], smallSize[1]);
  EXPECT_EQ(MeanDifference(window.Draw(), DrawStorm(SetNothing)), 0.0);
}

TEST(VolumeScene, FillsARendererOfTheCallersAndLeavesItEmpty)
{
  vtkNew<vtkRenderer> renderer;
  OffScreenWindow window(renderer, smallSize);
  {
    vtkNew<vtkNexradVolumeScene> scene;
    scene->SetRenderer(renderer);
    scene->SetVolume(MakeStormVolume(true));
    EXPECT_EQ(MeanDifference(window.Draw(), DrawStorm(SetNothing)), 0.0);
    scene->SetVolume(nullptr);
    window.Draw();
    EXPECT_EQ(renderer->VisibleActorCount() + renderer->VisibleVolumeCount(), 0);
    scene->SetVolume(MakeStormVolume(true));
    EXPECT_EQ(MeanDifference(window.Draw(), DrawStorm(SetNothing)), 0.0);
  }
  EXPECT_EQ(renderer->GetViewProps()->GetNumberOfItems(), 0);
  window.Draw();
}
