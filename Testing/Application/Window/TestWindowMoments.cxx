// SPDX-License-Identifier: BSD-3-Clause
// The moment that the window shows, the array that gives the colours, and interpolation.
#include "StormVolume.h"
#include "TestData.h"
#include "Tolerance.h"
#include "Viewer/MainWindow.h"
#include "Viewer/Playback.h"
#include "Viewer/SceneView.h"
#include "WindowTest.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkNexradVolumeScene.h>
#include <vtkPointData.h>

#include <QCheckBox>
#include <QComboBox>
#include <QListWidget>
#include <QtTest/QtTest>

#include <gtest/gtest.h>

#include <string>

using namespace nexrad;
using namespace nexrad::viewer;
using namespace nexrad::testing;

namespace
{

class WindowMomentsTest : public WindowTest
{
protected:
  void OpenFirst(const std::filesystem::path& path)
  {
    request.input.inputs = {path};
    this->OpenWindow();
    ASSERT_TRUE(this->Wait([&] { return window->View()->Scene()->GetVolume() != nullptr; }));
    this->WaitForPicture();
  }

  std::string ShownArray()
  {
    return window->View()->Scene()->GetVolume()->GetPointData()->GetScalars()->GetName();
  }

  QString Entries(const char* name)
  {
    QStringList entries;
    for (int i = 0; i < this->Find<QComboBox>(name)->count(); ++i)
    {
      entries << this->Find<QComboBox>(name)->itemText(i);
    }
    return entries.join(",");
  }
};

} // namespace

TEST_F(WindowMomentsTest, ShowsTheMomentThatIsChosen)
{
  this->OpenFirst(WriteTwoMoments(folder.Path()));
  EXPECT_EQ(this->Entries("Moment"), "REF,VEL");
  EXPECT_EQ(this->Entries("Colours of"),
    "Same moment,VEL,Number of radars,Age of the data,Nearest radar,Weight");
  this->Choose("Preset", 1);
  EXPECT_AT_LEAST(this->Changes(
                    [&]
                    {
                      this->Choose("Moment", 1);
                      EXPECT_TRUE(this->Wait([&] { return this->ShownArray() == "VEL"; }));
                    }),
    0.1, "pixels that velocity changes, part");
  EXPECT_EQ(this->Find<QComboBox>("Preset")->currentText(), "velocity");
  EXPECT_EQ(this->Entries("Moment"), "REF,VEL");
  EXPECT_EQ(this->Find<QComboBox>("Moment")->currentText(), "VEL");
  this->Choose("Moment", -1);
  EXPECT_TRUE(this->Wait([&] { return this->ShownArray() == "REF"; }));
  EXPECT_TRUE(window->Problems().isEmpty());
}

TEST_F(WindowMomentsTest, AnotherMomentGivesTheColours)
{
  this->OpenFirst(WriteTwoMoments(folder.Path()));
  const QImage before = this->WaitForPicture();
  const auto choose = [&](int down, const std::string& array)
  {
    this->Choose("Colours of", down);
    EXPECT_TRUE(
      this->Wait([&] { return window->View()->Scene()->GetOption("colour-by") == array; }));
    return this->WaitForPicture();
  };
  EXPECT_AT_LEAST(
    Difference(before, choose(1, "VEL")), 0.12, "pixels that colours of velocity change, part");
  EXPECT_EQ(this->ShownArray(), "REF");
  EXPECT_EQ(this->Find<QComboBox>("Colours of")->currentText(), "VEL");
  EXPECT_EQ(Difference(before, choose(-1, "")), 0.0);
}

TEST_F(WindowMomentsTest, InterpolationIsSwitchedOff)
{
  this->OpenSteps(1);
  auto* interpolated = this->Find<QCheckBox>("Interpolated");
  EXPECT_AT_LEAST(this->Changes(
                    [&] {
                      QTest::mouseClick(interpolated, Qt::LeftButton, {}, {8, 8});
                    }),
    0.016, "pixels that the nearest voxels change, part");
  EXPECT_EQ(window->View()->Scene()->GetOption("interpolation"), "nearest");
}

// They are merged again for the moment, at the time that is shown.
TEST_F(WindowMomentsTest, RadarFilesAreMergedAgain)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  request.input.grid.grid.dimensions = {32, 32, 16};
  this->OpenFirst(data / "level2" / "run-kbgm-20050821");
  EXPECT_EQ(this->Entries("Moment"), "REF,VEL,SW,SRV,AZSHEAR,DIV");
  this->Click("Step on");
  EXPECT_TRUE(this->Wait([&] { return !window->Player()->IsWaiting(); }));
  this->Choose("Moment", 1);
  EXPECT_TRUE(this->Wait([&] { return this->ShownArray() == "VEL"; }));
  EXPECT_EQ(window->Player()->Step(), 1U);
}
