// SPDX-License-Identifier: BSD-3-Clause
// Where the parts of a picture stand: the scene within the picture and off the captions, labels off
// each other. Needs no display.
#include "Scene/Captions/Captions.h"
#include "Scene/Frame/PictureLayout.h"
#include "Scene/Map/MapLayer.h"
#include "Scene/Scales/ScaleLayer.h"
#include "StormVolume.h"
#include "Tolerance.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCell.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProp.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <limits>
#include <string>
#include <vector>

using namespace nexrad;
using namespace nexrad::scene;
using nexrad::testing::MakeStormVolume;

namespace
{

const Theme& darkTheme = ThemeOf(ThemeChoice::Dark);

std::vector<std::vector<ScenePoint>> PolylinesOf(vtkProp* prop)
{
  vtkPolyData* lines =
    vtkPolyDataMapper::SafeDownCast(vtkActor::SafeDownCast(prop)->GetMapper())->GetInput();
  std::vector<std::vector<ScenePoint>> polylines(
    static_cast<std::size_t>(lines->GetNumberOfCells()));
  for (std::size_t i = 0; i < polylines.size(); ++i)
  {
    vtkPoints* points = lines->GetCell(static_cast<vtkIdType>(i))->GetPoints();
    for (vtkIdType k = 0; k < points->GetNumberOfPoints(); ++k)
    {
      points->GetPoint(k, polylines[i].emplace_back().data());
    }
  }
  return polylines;
}

struct PictureExtent
{
  double left = 1e9, right = -1e9, bottom = 1e9, top = -1e9;

  double Width() const { return right - left; }
  double Height() const { return top - bottom; }
};

PictureExtent ExtentOf(const std::vector<ScenePoint>& points, const Projection& project)
{
  PictureExtent extent;
  for (const ScenePoint& point : points)
  {
    const auto [x, y] = project(point);
    extent.left = std::min(extent.left, x);
    extent.right = std::max(extent.right, x);
    extent.bottom = std::min(extent.bottom, y);
    extent.top = std::max(extent.top, y);
  }
  return extent;
}

// The captions and the scales of a storm seen from some side in a picture of some size.
struct Subject
{
  Subject(const CameraView& cameraView, const std::array<int, 2>& size, bool flat)
    : view(cameraView)
  {
    const auto volume = MakeStormVolume(true);
    SceneFrame frame(volume, 8.0);
    if (flat)
    {
      frame.Flatten();
    }
    textSize = std::max(9, std::min(size[1] / 45, size[0] / 50));
    layer = MakeScaleLayer(frame, view, true, textSize, darkTheme);
    CaptionTexts texts;
    texts.title = "Reflectivity";
    texts.note = "Height above mean sea level, stretched 8 times";
    texts.information = ReadVolumeInformation(volume);
    space.size = size;
    space.right = size[0] - 5.0 * textSize;
    space.taken = MakeCaptions(texts, size, space.right, textSize, darkTheme, pictures).taken;
    FrameScene(camera, view, {layer.outline, layer.labels}, space, pictures);
  }

  CameraView view;
  int textSize = 0;
  ScaleLayer layer;
  FrameSpace space;
  TextPictures pictures;
  vtkNew<vtkCamera> camera;
};

void ExpectFramed(Subject& subject, const std::string& what)
{
  const auto& [width, height] = subject.space.size;
  const Projection project(subject.camera, subject.space.size);
  const PictureExtent extent = ExtentOf(subject.layer.outline, project);
  EXPECT_GE(extent.left, 0.0) << what;
  EXPECT_GE(extent.bottom, 0.0) << what;
  EXPECT_LE(extent.right, subject.space.right) << what;
  EXPECT_LE(extent.top, height) << what;
  for (const Label& label : subject.layer.labels)
  {
    const PixelBox box = subject.pictures.Get(label.text, label.style)
                           .BoxAt(project(label.point), label.sides.front(), label.gap);
    EXPECT_GE(box.left, 0.0) << what << ' ' << label.text;
    EXPECT_GE(box.bottom, 0.0) << what << ' ' << label.text;
    EXPECT_LE(box.right, width) << what << ' ' << label.text;
    for (const PixelBox& caption : subject.space.taken)
    {
      EXPECT_EQ(box.Shared(caption), 0.0) << what << ' ' << label.text;
    }
  }
  for (const PixelBox& caption : subject.space.taken)
  {
    for (const ScenePoint& point : subject.layer.outline)
    {
      const auto [x, y] = project(point);
      EXPECT_EQ(caption.Shared({x - 1.0, y - 1.0, x + 1.0, y + 1.0}), 0.0) << what;
    }
  }
}

Label MakeTestLabel(const std::string& text, const ScenePoint& point)
{
  return {text, point, {14, darkTheme.marker, darkTheme.rim},
    {LabelSide::Right, LabelSide::Left, LabelSide::Above, LabelSide::Below}, 8.0};
}

} // namespace

TEST(Framing, TheSceneAndItsWordsAreWithinThePictureAndOffTheCaptions)
{
  double least = std::numeric_limits<double>::infinity();
  for (const std::array<int, 2> size : {std::array<int, 2>{1280, 720}, {640, 360}, {400, 225},
         {900, 800}, {500, 900}, {1000, 300}, {320, 240}})
  {
    for (const bool flat : {false, true})
    {
      for (const bool parallel : {false, true})
      {
        for (double azimuth = 0.0; azimuth < 360.0; azimuth += 40.0)
        {
          Subject subject({azimuth, flat ? 90.0 : 35.0, 1.0, parallel}, size, flat);
          const std::string what = std::to_string(size[0]) + "x" + std::to_string(size[1]) + " " +
                                   std::to_string(azimuth) + (flat ? " flat" : "") +
                                   (parallel ? " parallel" : "");
          ExpectFramed(subject, what);
          const PictureExtent extent =
            ExtentOf(subject.layer.outline, Projection(subject.camera, size));
          least = std::min(
            least, std::max(extent.Width() / subject.space.right, extent.Height() / size[1]));
        }
      }
    }
  }
  EXPECT_AT_LEAST(
    least, 0.35, "width or height of the scene, part of the room beside the colour bar");
}

// A turn moves the camera by little at a time. Measured: 3.8 % in the degree in which the scales go
// from one edge to another, else 2.2 %.
TEST(Framing, ATurnDoesNotJump)
{
  std::vector<double> changes;
  double before = 0.0;
  for (double azimuth = 200.0; azimuth <= 290.0; ++azimuth)
  {
    const Subject subject({azimuth, 35.0, 1.0, false}, {640, 360}, false);
    const double distance = subject.camera->GetDistance();
    const double change = before > 0.0 ? std::abs(distance / before - 1.0) : 0.0;
    changes.push_back(change);
    before = distance;
  }
  std::sort(changes.rbegin(), changes.rend());
  std::cout << "the distance changes by at most " << 100.0 * changes[0] << " % and then "
            << 100.0 * changes[1] << ", " << 100.0 * changes[2] << " % a degree\n";
  EXPECT_GT(changes[0], 0.0);
  EXPECT_AT_MOST(changes[0], 0.05, "change of the camera's distance in a degree, part of it");
}

TEST(LabelLayout, LabelsGiveWayToEachOther)
{
  vtkNew<vtkCamera> camera;
  const std::array<int, 2> size = {400, 400};
  PointCamera(camera, {180.0, 90.0, 1.0, true}, {-200.0, 200.0, -200.0, 200.0, 0.0, 0.0}, 1.0, {});
  const Projection project(camera, size);
  EXPECT_NEAR(project({50.0, -50.0, 0.0})[0], 250.0, 1e-6);
  EXPECT_NEAR(project({50.0, -50.0, 0.0})[1], 150.0, 1e-6);
  const std::array<ScenePoint, 4> ground = {ScenePoint{-60.0, -100.0, 0.0},
    ScenePoint{60.0, -100.0, 0.0}, ScenePoint{60.0, 100.0, 0.0}, ScenePoint{-60.0, 100.0, 0.0}};
  TextPictures pictures;
  const auto choose = [&](std::vector<Label> labels, const std::vector<PixelBox>& taken = {})
  { return ChooseSides(labels, ground, project, pictures, taken); };

  const Label alone = MakeTestLabel("KLSX", {0.0, 0.0, 0.0});
  EXPECT_EQ(choose({alone}).front(), LabelSide::Right);
  // Another radar close to the right, a caption on the right, the picture's edge.
  const auto both = choose({alone, MakeTestLabel("KILX", {20.0, 0.0, 0.0})});
  EXPECT_EQ(both[0], LabelSide::Left);
  EXPECT_EQ(both[1], LabelSide::Right);
  EXPECT_EQ(choose({alone}, {{205.0, 150.0, 400.0, 250.0}}).front(), LabelSide::Left);
  EXPECT_EQ(choose({MakeTestLabel("KLSX", {190.0, 0.0, 0.0})}).front(), LabelSide::Left);
  // What may be left out is, and what may not takes the side that covers least.
  const std::vector<PixelBox> everything = {{0.0, 0.0, 400.0, 400.0}};
  Label optional = alone;
  optional.optional = true;
  EXPECT_TRUE(choose({optional}).front());
  EXPECT_FALSE(choose({optional}, everything).front());
  EXPECT_TRUE(choose({alone}, everything).front());
  optional.point = {40.0, 0.0, 0.0};
  EXPECT_FALSE(choose({optional}).front()) << "it would end beyond the ground";
}

// Seen from above, 1 pixel a unit.
TEST(LabelLayout, TownsKeepOffTheNamesOfRadars)
{
  vtkNew<vtkCamera> camera;
  PointCamera(camera, {180.0, 90.0, 1.0, true}, {-200.0, 200.0, -200.0, 200.0, 0.0, 0.0}, 1.0, {});
  const Projection project(camera, {400, 400});
  const std::array<ScenePoint, 4> ground = {ScenePoint{-200.0, -200.0, 0.0},
    ScenePoint{200.0, -200.0, 0.0}, ScenePoint{200.0, 200.0, 0.0}, ScenePoint{-200.0, 200.0, 0.0}};
  TextPictures pictures;
  const Label radar = MakeTestLabel("KLSX", {0.0, 0.0, 0.0});
  const PixelBox letters =
    pictures.Get(radar.text, radar.style).BoxAt(project(radar.point), LabelSide::Right, radar.gap);
  Label town = MakeTestLabel("Alton", {});
  town.optional = true;
  town.dot = 2.0;
  const double height = letters.top - letters.bottom;
  const auto townAt = [&](double x, double y, LabelSide side)
  {
    town.point = {x - 200.0, y - 200.0, 0.0};
    town.sides = {side};
    return ChooseSides({radar, town}, ground, project, pictures, {})[1].has_value();
  };
  const double above = letters.top + 0.5 * height;
  EXPECT_TRUE(townAt(letters.left, above + 1.5 * town.gap, LabelSide::Right));
  EXPECT_FALSE(townAt(letters.left, above + 0.5 * town.gap, LabelSide::Right))
    << "its letters would touch";
  EXPECT_TRUE(townAt(letters.right + 3.0, 200.0, LabelSide::Right));
  EXPECT_FALSE(townAt(letters.right - 1.0, 200.0, LabelSide::Right))
    << "its dot would lie on the letters";
}

TEST(LabelLayout, NamesOfStatesMayBeLeftOut)
{
  const SceneFrame frame(MakeStormVolume(false), 8.0); // 240 km about 39° north, 90° west
  const auto labels = [&](bool names) {
    return MakeMapLayer(frame, {{"KLSX"}, 0.0, names}, 16, darkTheme).labels;
  };
  const auto find = [](const std::vector<Label>& all, const std::string& text)
  {
    return std::find_if(
      all.begin(), all.end(), [&](const Label& label) { return label.text == text; });
  };
  const auto without = labels(false);
  EXPECT_EQ(without[0].text, "KLSX");
  EXPECT_FALSE(without[0].optional);
  EXPECT_EQ(find(without, "Illinois"), without.end());
  const auto with = labels(true);
  const auto illinois = find(with, "Illinois");
  ASSERT_NE(illinois, with.end());
  EXPECT_TRUE(illinois->optional);
  EXPECT_EQ(find(with, "Texas"), with.end());
}

TEST(TextPicture, StandsBesideItsPoint)
{
  const TextPicture picture("KLSX\nKILX", {16, darkTheme.marker, darkTheme.rim});
  const TextPicture line("KLSX", {16, darkTheme.marker, darkTheme.rim});
  EXPECT_AT_LEAST(line.Size()[0], 35, "width of four letters of size 16, pixels");
  EXPECT_AT_LEAST(picture.Size()[1], 2 * 16 + 1, "height of two lines of size 16, pixels");
  EXPECT_AT_MOST(picture.Size()[1], 2.5 * 16, "height of two lines of size 16, pixels");
  const PixelBox box = line.BoxAt({100.0, 50.0}, LabelSide::Right, 5.0);
  EXPECT_EQ(box.left, 105.0);
  EXPECT_NEAR((box.bottom + box.top) / 2.0, 50.0, 1e-9);
  EXPECT_EQ(line.BoxAt({100.0, 50.0}, LabelSide::Left, 5.0).right, 95.0);
  EXPECT_EQ(line.BoxAt({100.0, 50.0}, LabelSide::Above, 5.0).bottom, 55.0);
  EXPECT_EQ(line.BoxAt({100.0, 50.0}, LabelSide::Below, 5.0).top, 45.0);
  EXPECT_EQ(box.Shared({0.0, 0.0, 105.0, 100.0}), 0.0);
  EXPECT_NEAR(box.Shared({0.0, 0.0, 107.0, 50.0}), 2.0 * (50.0 - box.bottom), 1e-9);
}

// Bold letters are wider: the two faces that are compiled in are read.
TEST(TextPicture, HasTwoFaces)
{
  const std::string text = "Reflectivity 0123456789";
  const TextPicture usual(text, {24, darkTheme.marker, darkTheme.rim});
  const TextPicture bold(text, {24, darkTheme.marker, darkTheme.rim, true});
  EXPECT_AT_LEAST(static_cast<double>(bold.Size()[0]) / usual.Size()[0], 1.02,
    "width of bold letters, part of that of usual ones");
}

TEST(HeightWalls, StandAtRoundHeightsFarFromTheCamera)
{
  const SceneFrame frame(MakeStormVolume(false), 8.0); // 0 to 20 km
  const auto& box = frame.Bounds();
  // From the south-south-west: the far walls are those in the north and in the east.
  const ScaleLayer layer = MakeScaleLayer(frame, {200.0, 35.0, 1.0, false}, true, 16, darkTheme);
  ASSERT_GE(layer.labels.size(), 5U);
  for (std::size_t i = 0; i < 5; ++i)
  {
    EXPECT_EQ(layer.labels[i].text, (std::array{"0", "5", "10", "15", "20 km"})[i]);
  }
  const auto lines = PolylinesOf(layer.props[1]);
  ASSERT_EQ(lines.size(), 3U) << "not along the edges";
  for (std::size_t i = 0; i < lines.size(); ++i)
  {
    ASSERT_EQ(lines[i].size(), 3U);
    EXPECT_EQ(lines[i][1], (ScenePoint{box[1], box[3], frame.Height(5000.0 * (i + 1.0))}));
    for (const ScenePoint& point : lines[i])
    {
      EXPECT_TRUE(point[0] == box[1] || point[1] == box[3]);
    }
  }
  const auto edges = PolylinesOf(layer.props[0]);
  EXPECT_EQ(edges.size(), 9U);
  for (const auto& edge : edges)
  {
    const ScenePoint nearest = {box[0], box[2], box[5]};
    EXPECT_TRUE(edge[0] != nearest && edge[1] != nearest);
  }
  const ScaleLayer fromAbove =
    MakeScaleLayer(frame, {200.0, 80.0, 1.0, false}, true, 16, darkTheme);
  EXPECT_EQ(PolylinesOf(fromAbove.props[0]).size(), 12U);
}
