// SPDX-License-Identifier: BSD-3-Clause
// The window's section and crop: what dragging in the scene, and numbers, do to them.
#include "Scene/Scales/ColourScale.h"
#include "Scene/VolumeAppearance.h"
#include "StormVolume.h"
#include "Tolerance.h"
#include "Viewer/Playback.h"
#include "Viewer/SceneView.h"
#include "Viewer/SectionChart.h"
#include "Viewer/SectionPanel.h"
#include "WindowTest.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkNexradVerticalSection.h>
#include <vtkNexradVolumeScene.h>
#include <vtkPointData.h>

#include <vtkRenderer.h>

#include <QCheckBox>
#include <QComboBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QMouseEvent>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QToolButton>
#include <QtTest/QtTest>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

using namespace nexrad;
using namespace nexrad::viewer;
using namespace nexrad::testing;

namespace
{

using Place = std::array<double, 2>; // km east and north

class WindowCuttingTest : public WindowTest
{
protected:
  // A window that is large enough for a scene beside the panels.
  void OpenWide(int steps)
  {
    this->OpenSteps(steps);
    window->resize(1200, 900);
    this->WaitForPicture();
  }

  // The pixel of a section that shows a distance from A and a height in m: it reads what is
  // nearest.
  static QPoint PixelInSection(const SectionChart& chart, const std::array<double, 2>& wanted)
  {
    const QPoint middle(chart.width() / 2, chart.height() / 2);
    QPoint found = middle;
    for (const std::size_t axis : {0U, 1U})
    {
      double least = std::numeric_limits<double>::max();
      for (int i = 0; i < (axis == 0 ? chart.width() : chart.height()); ++i)
      {
        const auto place = chart.PlaceAt(axis == 0 ? QPoint(i, middle.y()) : QPoint(middle.x(), i));
        const double away = place ? std::abs((*place)[axis] - wanted[axis]) : least;
        if (away < least)
        {
          least = away;
          (axis == 0 ? found.rx() : found.ry()) = i;
        }
      }
    }
    return found;
  }

  // The pixel of the view at which a place of the ground is.
  QPoint PixelOf(const Place& place)
  {
    SceneView* view = window->View();
    double pixel[2];
    EXPECT_TRUE(view->Scene()->FindPixel(1000.0 * place[0], 1000.0 * place[1], pixel));
    return {static_cast<int>(pixel[0]), view->height() - 1 - static_cast<int>(pixel[1])};
  }

  // A drag with the left button, on its way at `way` places.
  void Drag(const std::vector<QPoint>& way)
  {
    SceneView* view = window->View();
    QTest::mousePress(view, Qt::LeftButton, {}, way.front());
    for (const QPoint& point : way)
    {
      QMouseEvent move(QEvent::MouseMove, point, Qt::NoButton, Qt::LeftButton, Qt::NoModifier);
      QCoreApplication::sendEvent(view, &move);
    }
    QTest::mouseRelease(view, Qt::LeftButton, {}, way.back());
    this->WaitForPicture();
  }

  // A line as a user draws it.
  void DrawLine(const Place& a, const Place& b)
  {
    QTest::keyClick(window.get(), Qt::Key_X);
    this->WaitForPicture(); // the panel makes the scene smaller
    const Place middle = {0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])};
    this->Drag({this->PixelOf(a), this->PixelOf(middle), this->PixelOf(b)});
  }

  // The pixel of the view at which a point in km of the volume is.
  QPoint PixelOfPoint(const std::array<double, 3>& kilometres)
  {
    SceneView* view = window->View();
    const double metres[3] = {
      1000.0 * kilometres[0], 1000.0 * kilometres[1], 1000.0 * kilometres[2]};
    double point[4] = {0.0, 0.0, 0.0, 1.0};
    EXPECT_TRUE(view->Scene()->VolumeToScene(metres, point));
    vtkRenderer* renderer = view->Scene()->GetRenderer();
    renderer->SetWorldPoint(point);
    renderer->WorldToDisplay();
    const double* pixel = renderer->GetDisplayPoint();
    return {static_cast<int>(pixel[0]), view->height() - 1 - static_cast<int>(pixel[1])};
  }

  void Tick(const char* name)
  {
    this->Find<QDockWidget>("cut dock")->raise();
    this->WaitForPicture();
    QTest::mouseClick(this->Find<QCheckBox>(name), Qt::LeftButton, {}, {8, 8});
    this->WaitForPicture();
  }

  void Type(const char* name, const char* keys)
  {
    auto* number = this->Find<QDoubleSpinBox>(name);
    number->setFocus();
    number->selectAll();
    QTest::keyClicks(number, keys);
    this->WaitForPicture();
  }

  SectionPanel* Panel() { return this->Find<SectionPanel>("section panel"); }

  // Distance in km from an end of the line to a place.
  static double Off(const double* end, const Place& place)
  {
    return std::hypot(end[0] / 1000.0 - place[0], end[1] / 1000.0 - place[1]);
  }
};

// A pixel of the view shows up to 3 km of the ground, and the drag ends on a whole pixel.
constexpr double pixelSize = 3.0;
constexpr const char* ofPixel = "within a pixel of the view";

constexpr Place west = {-130.0, -70.0}; // the core is between them
constexpr Place east = {50.0, -50.0};

} // namespace

TEST_F(WindowCuttingTest, ADragOnTheGroundDrawsTheLineOfASection)
{
  this->OpenWide(1);
  vtkNexradVolumeScene* scene = window->View()->Scene();
  const double azimuth = scene->GetAzimuth();
  EXPECT_TRUE(this->Find<QDockWidget>("section dock")->isHidden());
  QTest::keyClick(window.get(), Qt::Key_X);
  EXPECT_FALSE(this->Find<QDockWidget>("section dock")->isHidden());
  EXPECT_TRUE(this->Find<QToolButton>("Draw the line")->isChecked());
  this->WaitForPicture();
  EXPECT_AT_LEAST(this->Changes([&] { this->DrawLine(west, east); }), 0.0014,
    "pixels that the line of a section changes, part");
  EXPECT_TRUE(scene->GetSection());
  EXPECT_AT_MOST(Off(scene->GetSectionA(), west), pixelSize,
    "end A of a dragged line from its place, km", ofPixel);
  EXPECT_AT_MOST(Off(scene->GetSectionB(), east), pixelSize,
    "end B of a dragged line from its place, km", ofPixel);
  EXPECT_EQ(scene->GetAzimuth(), azimuth) << "the camera stands still";
  EXPECT_FALSE(this->Find<QToolButton>("Draw the line")->isChecked());
  window->grab().save(QString(NEXRAD_TEST_OUTPUT_DIR) + "/WindowSection.png");
}

// Voxels are 10 km wide, and the field between two of them is curved.
TEST_F(WindowCuttingTest, TheSectionHasTheValuesOfTheVolume)
{
  this->OpenWide(1);
  this->DrawLine(west, east);
  vtkNexradVolumeScene* scene = window->View()->Scene();
  vtkImageData* section = this->Panel()->Filter()->GetOutput();
  ASSERT_GT(section->GetNumberOfPoints(), 0);
  vtkDataArray* values = section->GetPointData()->GetScalars();
  double bounds[6];
  section->GetBounds(bounds);
  const double length =
    bounds[1] + bounds[0]; // the first point is as far from A as the last from B
  double sum = 0.0;
  double largest = 0.0;
  int count = 0;
  for (vtkIdType i = 0; i < section->GetNumberOfPoints(); ++i)
  {
    double point[3];
    section->GetPoint(i, point);
    const double share = point[0] / length;
    const auto between = [&](int axis)
    {
      const double from = scene->GetSectionA()[axis];
      return (from + share * (scene->GetSectionB()[axis] - from)) / 1000.0;
    };
    const double truth = Storm(between(0), between(1), point[1] / 1000.0);
    const bool inside = point[1] > 700.0 && point[1] < 14'000.0;
    if (inside && truth > 20.0 && !std::isnan(values->GetTuple1(i)))
    {
      sum += std::abs(values->GetTuple1(i) - truth);
      largest = std::max(largest, values->GetTuple1(i));
      ++count;
    }
  }
  ASSERT_GT(count, 10'000);
  EXPECT_AT_MOST(sum / count, 1.0, "mean error of the values of a section, dBZ");
  EXPECT_AT_LEAST(largest, 55.0, "largest value of a section through the core, dBZ");
}

TEST_F(WindowCuttingTest, TheChartShowsTheSectionInTheColoursOfTheBar)
{
  this->OpenWide(1);
  this->DrawLine(west, east);
  SectionChart* chart = this->Panel()->Chart();
  const QImage picture = chart->grabFramebuffer();
  const scene::ColourScale colours =
    scene::MomentScale("REF", scene::ColourStepsOf(window->View()->Scene()->GetTransferFunction()));
  vtkImageData* section = this->Panel()->Filter()->GetOutput();
  int right = 0;
  int count = 0;
  for (int k = 8; k < 250; k += 8)
  {
    for (int i = 8; i < 500; i += 8)
    {
      const double value = section->GetScalarComponentAsDouble(i, k, 0, 0);
      const int bin = std::isnan(value) ? -1 : scene::FindBin(colours, value);
      if (bin < 0)
      {
        continue;
      }
      double point[3];
      int index[3] = {i, k, 0};
      section->GetPoint(section->ComputePointId(index), point);
      const QColor shown = picture.pixelColor(PixelInSection(*chart, {point[0], point[1]}));
      const scene::Colour& wanted = colours.bins[static_cast<std::size_t>(bin)].colour;
      const bool same = std::abs(shown.redF() - wanted[0]) < 0.02 &&
                        std::abs(shown.greenF() - wanted[1]) < 0.02 &&
                        std::abs(shown.blueF() - wanted[2]) < 0.02;
      right += same ? 1 : 0;
      ++count;
    }
  }
  ASSERT_GT(count, 300);
  // The rest lies at the border of two colours.
  EXPECT_AT_LEAST(static_cast<double>(right) / count, 0.9,
    "places of a chart that have the colour of their value, part");
  picture.save(QString(NEXRAD_TEST_OUTPUT_DIR) + "/SectionChart.png");
}

TEST_F(WindowCuttingTest, TheMouseReadsValuesInTheSection)
{
  this->OpenWide(1);
  this->DrawLine(west, east);
  SectionChart* chart = this->Panel()->Chart();
  const QPoint pixel = PixelInSection(*chart, {60'000.0, 3'000.0});
  QMouseEvent move(QEvent::MouseMove, pixel, Qt::NoButton, Qt::NoButton, Qt::NoModifier);
  QCoreApplication::sendEvent(chart, &move);
  const QString text = this->Find<QLabel>("section reading")->text();
  EXPECT_TRUE(text.contains("km from A") && text.contains("REF") && text.contains("dBZ"))
    << text.toStdString();
  EXPECT_WITHIN(text.section(": REF ", 1).section(' ', 0, 0).toDouble(),
    Storm(-130.0 + 60.0 * 180.0 / 181.1, -70.0 + 60.0 * 20.0 / 181.1, 3.0), 1.0,
    "value read in a section, dBZ",
    "the field changes by 1 dBZ from one pixel of the panel to the next");
}

TEST_F(WindowCuttingTest, AnEndOfTheLineCanBeMoved)
{
  this->OpenWide(1);
  this->DrawLine(west, east);
  vtkNexradVolumeScene* scene = window->View()->Scene();
  const double a = scene->GetSectionA()[0];
  const Place there = {60.0, 40.0};
  this->Drag({this->PixelOf(east), this->PixelOf(there)});
  EXPECT_EQ(scene->GetSectionA()[0], a);
  EXPECT_AT_MOST(
    Off(scene->GetSectionB(), there), pixelSize, "moved end of a line from its place, km", ofPixel);
  EXPECT_WITHIN(this->Find<QDoubleSpinBox>("How far east the end B is")->value(), 60.0, pixelSize,
    "number of a moved end, km", ofPixel);
}

TEST_F(WindowCuttingTest, BeyondTheDomainTheLineEndsAtItsEdge)
{
  this->OpenWide(1);
  this->DrawLine(west, {-20.0, -20.0});
  this->Drag({this->PixelOf({-20.0, -20.0}), this->PixelOf({-20.0, -300.0})});
  EXPECT_EQ(window->View()->Scene()->GetSectionB()[1], -240'000.0);
}

TEST_F(WindowCuttingTest, NumbersMoveTheLineAndRemoveTakesItAway)
{
  this->OpenWide(1);
  QTest::keyClick(window.get(), Qt::Key_X);
  this->WaitForPicture();
  auto* number = this->Find<QDoubleSpinBox>("How far east the end A is");
  number->setFocus();
  number->selectAll();
  QTest::keyClicks(number, "-120\t");
  this->WaitForPicture();
  vtkNexradVolumeScene* scene = window->View()->Scene();
  EXPECT_EQ(scene->GetSectionA()[0], -120'000.0);
  EXPECT_TRUE(scene->GetSection());
  EXPECT_GT(this->Panel()->Filter()->GetOutput()->GetNumberOfPoints(), 0);
  this->Click("Remove");
  EXPECT_FALSE(scene->GetSection());
}

TEST_F(WindowCuttingTest, TheLineStaysAndTheSectionFollowsTheTime)
{
  this->OpenWide(2);
  this->DrawLine(west, east);
  vtkNexradVolumeScene* scene = window->View()->Scene();
  const double b = scene->GetSectionB()[0];
  const QImage before = this->Panel()->Chart()->grabFramebuffer();
  this->Click("Step on");
  this->WaitForPicture();
  EXPECT_EQ(scene->GetSectionB()[0], b);
  EXPECT_AT_LEAST(Difference(before, this->Panel()->Chart()->grabFramebuffer()), 0.2,
    "pixels of the section that a step changes, part");
}

TEST_F(WindowCuttingTest, TheCropBoxHidesWhatIsOutsideByNumbers)
{
  this->OpenWide(1);
  vtkNexradVolumeScene* scene = window->View()->Scene();
  scene->SetOption("frame", "echo");
  EXPECT_TRUE(scene->Update());
  this->Tick("Crop");
  EXPECT_TRUE(scene->GetCropping());
  std::array<double, 6> frame{};
  EXPECT_TRUE(scene->GetFrameBounds(frame.data()));
  EXPECT_LT(frame[1], 200'000.0);
  for (std::size_t i = 0; i < frame.size(); ++i)
  {
    EXPECT_NEAR(scene->GetCropBounds()[i], frame[i], 1.0) << "first the frame";
  }
  scene->SetOption("frame", "domain");
  this->Find<QPushButton>("Whole volume")->click();
  EXPECT_EQ(scene->GetCropBounds()[0], -240'000.0);
  EXPECT_AT_LEAST(this->Changes(
                    [&]
                    {
                      this->Type("East face of the crop box, km east or north of the centre, or "
                                 "degrees on geographic axes",
                        "-70\t");
                    }),
    0.035, "pixels that cropping half of the storm changes, part");
  EXPECT_EQ(scene->GetCropBounds()[1], -70'000.0);
  this->Tick("Crop");
  EXPECT_FALSE(scene->GetCropping());
}

TEST_F(WindowCuttingTest, TheCropBoxIsChangedByItsHandles)
{
  this->OpenWide(1);
  vtkNexradVolumeScene* scene = window->View()->Scene();
  this->Tick("Crop");
  this->Find<QPushButton>("Whole volume")->click();
  this->WaitForPicture();
  const double azimuth = scene->GetAzimuth();
  const QPoint ball = this->PixelOfPoint({240.0, 0.0, 10.0});
  const QPoint there = this->PixelOfPoint({-70.0, 0.0, 10.0});
  EXPECT_AT_LEAST(this->Changes(
                    [&] {
                      this->Drag({ball, 0.5 * (ball + there), there});
                    }),
    0.03, "pixels that dragging a face of the crop box changes, part");
  EXPECT_WITHIN(scene->GetCropBounds()[1] / 1000.0, -70.0, 40.0,
    "dragged face of the crop box from its place, km");
  EXPECT_EQ(scene->GetCropBounds()[0], -240'000.0);
  EXPECT_EQ(scene->GetAzimuth(), azimuth) << "the camera stands still";
  window->grab().save(QString(NEXRAD_TEST_OUTPUT_DIR) + "/WindowCrop.png");
}

TEST_F(WindowCuttingTest, TheClipPlaneHidesOneSideAndIsTurnedByNumbers)
{
  this->OpenWide(1);
  vtkNexradVolumeScene* scene = window->View()->Scene();
  this->Tick("Clip");
  EXPECT_TRUE(scene->GetClipping());
  this->Type("A point of the clip plane: km north of the centre", "-70\t");
  EXPECT_EQ(scene->GetClipOrigin()[1], -70'000.0);
  EXPECT_AT_LEAST(
    this->Changes([&]
      { this->Type("Direction to the part that is shown, degrees clockwise from north", "90\t"); }),
    0.07, "pixels that turning the clip plane changes, part");
  EXPECT_NEAR(scene->GetClipNormal()[0], 1.0, 1e-12);
  EXPECT_NEAR(scene->GetClipNormal()[1], 0.0, 1e-12);
  window->grab().save(QString(NEXRAD_TEST_OUTPUT_DIR) + "/WindowClip.png");
}

TEST_F(WindowCuttingTest, TheClipPlaneIsPushedWithTheMouse)
{
  this->OpenWide(1);
  vtkNexradVolumeScene* scene = window->View()->Scene();
  this->Tick("Clip");
  const QPoint from = this->PixelOfPoint({120.0, 0.0, 10.0});
  const QPoint there = this->PixelOfPoint({120.0, -80.0, 10.0});
  EXPECT_AT_LEAST(this->Changes(
                    [&] {
                      this->Drag({from, 0.5 * (from + there), there});
                    }),
    0.02, "pixels that pushing the clip plane changes, part");
  EXPECT_AT_LEAST(-scene->GetClipOrigin()[1] / 1000.0, 17.0,
    "way of a clip plane that the mouse pushes over 80 km of the picture, km");
  EXPECT_NEAR(scene->GetClipNormal()[1], 1.0, 1e-9) << "it was pushed, not turned";
}

// No number is out of sight on the smallest screens that are common.
TEST_F(WindowCuttingTest, TheCutPageFitsASmallWindow)
{
  this->OpenWide(1);
  window->resize(1024, 600);
  auto* dock = this->Find<QDockWidget>("cut dock");
  dock->raise();
  QTest::qWait(300);
  auto* scroll = qobject_cast<QScrollArea*>(dock->widget());
  ASSERT_NE(scroll, nullptr);
  EXPECT_EQ(window->height(), 600);
  EXPECT_EQ(scroll->verticalScrollBar()->maximum(), 0) << "pixels out of sight";
  EXPECT_EQ(scroll->horizontalScrollBar()->maximum(), 0) << "pixels out of sight";
  window->grab().save(QString(NEXRAD_TEST_OUTPUT_DIR) + "/WindowCutPage.png");
}

TEST_F(WindowCuttingTest, HandlesCanBeHidden)
{
  this->OpenWide(1);
  this->Tick("Crop");
  EXPECT_AT_LEAST(this->Changes([&] { this->Tick("Handles"); }), 0.015,
    "pixels of the handles of the crop box, part");
}

// A tower of 62 dBZ on the ground that is 15 km high.
TEST_F(WindowCuttingTest, TheViewShowsEchoTopsAndLiquid)
{
  this->OpenWide(1);
  vtkNexradVolumeScene* scene = window->View()->Scene();
  this->Choose("View", 3);
  EXPECT_EQ(scene->GetOption("map"), "echo-top:18");
  window->grab().save(QString(NEXRAD_TEST_OUTPUT_DIR) + "/WindowEchoTop.png");
  EXPECT_AT_LEAST(this->Changes([&] { this->Choose("View", 1); }), 0.12,
    "pixels that differ between echo tops and liquid, part");
  EXPECT_EQ(scene->GetOption("map"), "vil");
  window->grab().save(QString(NEXRAD_TEST_OUTPUT_DIR) + "/WindowLiquid.png");
  this->Choose("View", 1);
  EXPECT_EQ(scene->GetOption("map"), "vil-density:18");
}
