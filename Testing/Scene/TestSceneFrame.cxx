// SPDX-License-Identifier: BSD-3-Clause
#include "Filters/Series/InputSeries.h"
#include "Scene/Frame/SceneFrame.h"
#include "Scene/Frame/VolumeInformation.h"
#include "Scene/Scales/ScaleLayer.h"
#include "Scene/Shapes/Shapes.h"

#include "ErrorMessage.h"
#include "StormVolume.h"
#include "Tolerance.h"

#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>

#include <gtest/gtest.h>

#include <string>
#include <utility>

using namespace nexrad;
using namespace nexrad::scene;
using nexrad::testing::MakeStormVolume;
using nexrad::testing::MessageOf;

namespace
{

// 48 voxels over 4° of longitude and 2° of latitude.
vtkSmartPointer<vtkImageData> MakeGeographicVolume()
{
  const auto volume = MakeStormVolume(false);
  volume->SetOrigin(-92.0, 38.0, 625.0);
  volume->SetSpacing(4.0 / 47.0, 2.0 / 47.0, 1'250.0);
  vtkNew<vtkStringArray> projection;
  projection->SetName("Projection");
  projection->InsertNextValue("+proj=longlat +datum=WGS84 +no_defs");
  volume->GetFieldData()->AddArray(projection);
  return volume;
}

} // namespace

// 48 voxels of 10 km about 39° N, 90° W; 16 of 1.25 km from the ground up.
TEST(SceneFrame, BoundsAreTheOuterFacesInKilometres)
{
  const SceneFrame frame(MakeStormVolume(false), 8.0);
  const std::array<double, 6> expected = {-240.0, 240.0, -240.0, 240.0, 0.0, 160.0};
  for (std::size_t i = 0; i < expected.size(); ++i)
  {
    EXPECT_NEAR(frame.Bounds()[i], expected[i], 1e-9) << i;
  }
  EXPECT_NEAR(frame.Height(10'000.0), 80.0, 1e-12);
}

// 3 to 4 times for what one radar sees, up to 8 for many; less where a frame is high for its width.
TEST(SceneFrame, HeightsAreStretchedByTheFrame)
{
  EXPECT_EQ(DefaultExaggeration(178.0, 16.0), 3.0);
  EXPECT_EQ(DefaultExaggeration(460.0, 16.0), 3.5);
  EXPECT_EQ(DefaultExaggeration(1400.0, 16.0), 8.0);
  EXPECT_EQ(DefaultExaggeration(48.0, 18.0), 2.0);
  EXPECT_EQ(DefaultExaggeration(15.0, 20.0), 1.0);
}

TEST(SceneFrame, AFrameIsAPartOfTheDomain)
{
  SceneFrame frame(MakeStormVolume(false), 8.0);
  EXPECT_EQ(frame.Framed(), frame.Bounds());
  frame.SetFramed({-300e3, 0.0, -100e3, 100e3, 0.0, 15e3});
  const std::array<double, 6> expected = {-240.0, 0.0, -100.0, 100.0, 0.0, 120.0};
  for (std::size_t i = 0; i < expected.size(); ++i)
  {
    EXPECT_NEAR(frame.Framed()[i], expected[i], 1e-9) << i;
  }
  EXPECT_TRUE(frame.Holds({-200e3, -50e3, -90e3, 90e3, 0.0, 10e3}));
  EXPECT_FALSE(frame.Holds({-200e3, 50e3, -90e3, 90e3, 0.0, 10e3}));
}

TEST(SceneFrame, PlacesAreKilometresFromTheCentre)
{
  const SceneFrame frame(MakeStormVolume(false), 8.0);
  ASSERT_TRUE(frame.HasMap());
  EXPECT_NEAR(frame.Place(-90.0, 39.0)[0], 0.0, 1e-9);
  EXPECT_NEAR(frame.Place(-90.0, 39.0)[1], 0.0, 1e-9);
  // A degree of latitude on WGS84 from 39° to 40° is 111.03 km.
  EXPECT_WITHIN(frame.Place(-90.0, 40.0)[1], 111.03, 0.0095, "degree of latitude, km");
  const auto place = frame.Place(-91.25, 38.5);
  const auto back = frame.Geographic(place[0], place[1]);
  EXPECT_NEAR(back[0], -91.25, 1e-9);
  EXPECT_NEAR(back[1], 38.5, 1e-9);
}

TEST(SceneFrame, AVolumeOnGeographicAxesHasTheSameShape)
{
  const SceneFrame frame(MakeGeographicVolume(), 8.0);
  ASSERT_TRUE(frame.HasMap());
  EXPECT_WITHIN(
    frame.Place(-90.0, 40.0)[1], 111.2, 0.01, "degree of latitude on geographic axes, km");
  // cos 39° = 0.7771
  EXPECT_WITHIN(
    frame.Place(-89.0, 39.0)[0], 86.4, 0.028, "degree of longitude on geographic axes, km");
  EXPECT_WITHIN(frame.Bounds()[3] - frame.Bounds()[2], 111.2 * 2.0 * 48.0 / 47.0, 0.02,
    "width on geographic axes, km");
}

TEST(VolumeInformation, FacesAreHalfAVoxelBeyondTheMiddles)
{
  const auto volume = MakeStormVolume(false);
  const std::array<double, 6> expected = {-240e3, 240e3, -240e3, 240e3, 0.0, 20e3};
  for (std::size_t i = 0; i < expected.size(); ++i)
  {
    EXPECT_NEAR(FacesOf(volume)[i], expected[i], 1e-9) << i;
    EXPECT_TRUE(i >= 4 || SidesOf(volume)[i] == FacesOf(volume)[i]) << i;
  }
}

TEST(VolumeInformation, PlacesAreInTheUnitOfTheAxes)
{
  EXPECT_EQ(PlaceUnitOf(MakeStormVolume(false)), PlaceUnit::Metres);
  EXPECT_EQ(PlaceUnitOf(MakeGeographicVolume()), PlaceUnit::Degrees);
}

// The files are not there; the box is looked at first.
TEST(InputSeries, ABoxInAnotherUnitIsRefused)
{
  const auto refusal = [](GridAxes axes, PlaceUnit unit)
  {
    InputRequest request;
    request.inputs = {"/nonexistent"};
    request.grid.grid.axes = axes;
    request.box.emplace();
    request.boxUnit = unit;
    return MessageOf([&] { OpenInputs(request); });
  };
  const std::string metres = "the box is in m or km, and the volume is on axes of longitude and "
                             "latitude; write degrees, as in -97.5deg";
  const std::string degrees =
    "the box is in degrees, and the volume is in metres about its centre; "
    "write lengths, as in -20km";
  EXPECT_EQ(refusal(GridAxes::Geographic, PlaceUnit::Metres), metres);
  EXPECT_EQ(refusal(GridAxes::Projected, PlaceUnit::Degrees), degrees);
  for (const auto& [axes, unit] : {std::pair(GridAxes::Geographic, PlaceUnit::Degrees),
         std::pair(GridAxes::Projected, PlaceUnit::Metres),
         std::pair(GridAxes::Geographic, PlaceUnit::OfVolume)})
  {
    EXPECT_NE(refusal(axes, unit).find("/nonexistent"), std::string::npos) << refusal(axes, unit);
  }
}

TEST(SceneFrame, FieldDataAreUnderstood)
{
  const VolumeInformation information = ReadVolumeInformation(MakeStormVolume(true));
  ASSERT_TRUE(information.time);
  EXPECT_EQ(FormatIso8601(*information.time), "2006-03-12T18:30:00.000Z");
  EXPECT_EQ(information.sites, (std::vector<std::string>{"KLSX", "KILX"}));
  EXPECT_EQ(information.method, "thesis");
  EXPECT_TRUE(information.synthetic);
  vtkNew<vtkImageData> bare;
  EXPECT_FALSE(ReadVolumeInformation(bare).time);
}

TEST(SceneParts, SegmentsAreCutAtTheRectangle)
{
  const std::array<double, 4> rectangle = {-1.0, 3.0, -2.0, 2.0};
  double enters = 0.0;
  double leaves = 0.0;
  EXPECT_TRUE(ClipToRectangle({0.0, 0.0}, {1.0, 1.0}, rectangle, enters, leaves));
  EXPECT_EQ(enters, 0.0);
  EXPECT_EQ(leaves, 1.0);
  EXPECT_TRUE(ClipToRectangle({-5.0, 0.0}, {5.0, 0.0}, rectangle, enters, leaves));
  EXPECT_NEAR(enters, 0.4, 1e-12);
  EXPECT_NEAR(leaves, 0.8, 1e-12);
  EXPECT_TRUE(ClipToRectangle({0.0, 0.0}, {0.0, -4.0}, rectangle, enters, leaves));
  EXPECT_NEAR(leaves, 0.5, 1e-12);
  EXPECT_FALSE(ClipToRectangle({4.0, -5.0}, {4.0, 5.0}, rectangle, enters, leaves));
  EXPECT_FALSE(ClipToRectangle({-5.0, 0.0}, {0.0, 9.0}, rectangle, enters, leaves));
}

TEST(SceneParts, RoundLengths)
{
  EXPECT_EQ(RoundLength(100.0), 100.0);
  EXPECT_EQ(RoundLength(99.0), 50.0);
  EXPECT_EQ(RoundLength(49.0), 20.0);
  EXPECT_EQ(RoundLength(19.0), 10.0);
  EXPECT_NEAR(RoundLength(0.3), 0.2, 1e-12);
}
