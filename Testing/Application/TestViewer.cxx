// SPDX-License-Identifier: BSD-3-Clause
// The window of `nexrad3d view` and its keys.
#include "Drawing/PictureWindow.h"
#include "Drawing/Viewer.h"
#include "Scene/RadarSession.h"
#include "Scene/Series/VolumeFiles.h"
#include "StormVolume.h"
#include "TestData.h"
#include "Tolerance.h"

#include "nexrad/System/Error.h"

#include <vtkImageData.h>
#include <vtkRenderWindow.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

using namespace nexrad;
using namespace nexrad::scene;
using nexrad::testing::TemporaryFolder;
using nexrad::testing::WriteStormFiles;

namespace
{

// Pixels that differ visibly, of all.
double Difference(vtkImageData* a, vtkImageData* b)
{
  const auto* first = static_cast<unsigned char*>(a->GetScalarPointer());
  const auto* second = static_cast<unsigned char*>(b->GetScalarPointer());
  const vtkIdType count = a->GetNumberOfPoints();
  vtkIdType different = 0;
  for (vtkIdType i = 0; i < 3 * count; i += 3)
  {
    int most = 0;
    for (vtkIdType channel = i; channel < i + 3; ++channel)
    {
      most = std::max(most, std::abs(first[channel] - second[channel]));
    }
    different += most > 8 ? 1 : 0;
  }
  return static_cast<double>(different) / static_cast<double>(count);
}

class ViewerTest : public ::testing::Test
{
protected:
  ViewerTest()
    : session(OpenVolumeFiles({WriteStormFiles(folder.Path(), 3)}), {0, 1, 2}, {})
  {
    Viewer::Options options;
    options.size = {480, 300};
    options.pictures = folder.Path();
    viewer = std::make_unique<Viewer>(session, options);
    viewer->Press("h"); // the keys would hide what is compared
  }

  vtkSmartPointer<vtkImageData> Picture() { return GrabPicture(viewer->Window()); }

  // How much of the window a key changes.
  double Changes(const std::string& key)
  {
    const auto before = this->Picture();
    viewer->Press(key);
    return Difference(before, this->Picture());
  }

  TemporaryFolder folder;
  RadarSession session;
  std::unique_ptr<Viewer> viewer;
};

} // namespace

TEST_F(ViewerTest, KeysChangeThePictureAsTheySay)
{
  EXPECT_AT_LEAST(this->Changes("a"), 0.12, "pixels that turning changes, part") << "turned";
  EXPECT_AT_LEAST(this->Changes("w"), 0.11, "pixels that tilting changes, part") << "tilted";
  EXPECT_AT_LEAST(this->Changes("plus"), 0.17, "pixels that going nearer changes, part")
    << "nearer";
  EXPECT_AT_LEAST(this->Changes("2"), 0.06, "pixels that the preset of the cores changes, part")
    << "cores alone";
  EXPECT_AT_LEAST(this->Changes("i"), 0.011, "pixels that a shell changes, part") << "a shell";
  EXPECT_AT_LEAST(this->Changes("period"), 0.01, "pixels that the next shell changes, part")
    << "another";
  EXPECT_AT_LEAST(this->Changes("h"), 0.024, "pixels that the list of keys changes, part")
    << "the keys";
  EXPECT_EQ(this->Changes("z"), 0.0) << "a key without a meaning";
}

// The window as it opens, left in the tests' output folder for a person to look at: the storm over
// its map, the keys on the left, the state of the player below.
TEST(Viewer, OpensWithItsKeysOnTheScreen)
{
  const TemporaryFolder folder;
  RadarSession session(OpenVolumeFiles({WriteStormFiles(folder.Path(), 3)}), {0, 1, 2}, {});
  Viewer::Options options;
  options.pictures = folder.Path();
  Viewer viewer(session, options);
  const auto picture = GrabPicture(viewer.Window());
  WritePng(picture, std::filesystem::path(NEXRAD_TEST_OUTPUT_DIR) / "Viewer.png");
  viewer.Press("h");
  EXPECT_AT_LEAST(Difference(picture, GrabPicture(viewer.Window())), 0.007,
    "pixels that the list of keys changes, part");
}

TEST_F(ViewerTest, TheCameraComesBack)
{
  const auto before = this->Picture();
  for (const char* key : {"a", "w", "plus", "d", "r"})
  {
    viewer->Press(key);
  }
  EXPECT_EQ(Difference(before, this->Picture()), 0.0);
}

TEST_F(ViewerTest, StepsGoRound)
{
  EXPECT_EQ(session.Shown(), 0U);
  viewer->Press("Right");
  EXPECT_EQ(session.Shown(), 1U);
  viewer->Press("Left");
  viewer->Press("Left");
  EXPECT_EQ(session.Shown(), 2U);
  viewer->Press("Right");
  EXPECT_EQ(session.Shown(), 0U);
}

TEST_F(ViewerTest, PlaysOnTheClockAlone)
{
  viewer->Tick();
  EXPECT_EQ(session.Shown(), 0U) << "paused";
  viewer->Press("space");
  EXPECT_TRUE(viewer->IsPlaying());
  viewer->Tick();
  viewer->Tick();
  EXPECT_EQ(session.Shown(), 2U);
  viewer->Press("space");
  viewer->Tick();
  EXPECT_EQ(session.Shown(), 2U);
}

TEST_F(ViewerTest, TheIntervalAndTheSlicesHaveBounds)
{
  viewer->Press("Up");
  EXPECT_EQ(viewer->Interval(), std::chrono::milliseconds(250));
  const int slices = session.Scene().Slices();
  viewer->Press("bracketright");
  EXPECT_EQ(session.Scene().Slices(), 2 * slices);
  for (int i = 0; i < 20; ++i)
  {
    viewer->Press("Down");
    viewer->Press("bracketleft");
  }
  EXPECT_EQ(viewer->Interval(), std::chrono::seconds(8));
  EXPECT_EQ(session.Scene().Slices(), 16);
}

TEST_F(ViewerTest, ScreenshotsNeverOverwrite)
{
  viewer->Press("s");
  viewer->Press("s");
  ASSERT_EQ(viewer->Pictures().size(), 2U);
  EXPECT_EQ(viewer->Pictures()[0].filename(), "nexrad3d-20060312T183000Z.png");
  EXPECT_EQ(viewer->Pictures()[1].filename(), "nexrad3d-20060312T183000Z-2.png");
  EXPECT_TRUE(std::filesystem::exists(viewer->Pictures()[0]));
}

TEST(Viewer, AFolderThatIsNotThereIsToldAndNothingEnds)
{
  const TemporaryFolder folder;
  RadarSession session(OpenVolumeFiles({WriteStormFiles(folder.Path(), 1)}), {0}, {});
  Viewer viewer(session, {{320, 200}, {}, std::chrono::milliseconds(500), "/nonexistent"});
  viewer.Press("s");
  EXPECT_TRUE(viewer.Pictures().empty());
  ASSERT_EQ(viewer.Problems().size(), 1U);
  EXPECT_NE(viewer.Problems()[0].find("/nonexistent"), std::string::npos);
  viewer.Press("space");
  EXPECT_FALSE(viewer.IsPlaying()) << "one time alone";
}

TEST(PictureWindow, NoDisplayIsAnErrorAndNotTheEndOfTheProgram)
{
  const char* display = std::getenv("DISPLAY");
  const std::string before = display == nullptr ? "" : display;
  setenv("DISPLAY", ":4711", 1);
  EXPECT_THROW(RequireDisplay(), Error);
  unsetenv("DISPLAY");
  EXPECT_THROW(RequireDisplay(), Error);
  setenv("DISPLAY", before.c_str(), 1);
}
