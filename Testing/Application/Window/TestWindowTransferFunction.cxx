// SPDX-License-Identifier: BSD-3-Clause
// The editor of colours and opacities in the window: what clicks, drags and keys do to it and to
// the picture.
#include "StormVolume.h"
#include "Tolerance.h"
#include "Viewer/MainWindow.h"
#include "Viewer/Playback.h"
#include "Viewer/SceneView.h"
#include "Viewer/TransferFunctionChart.h"
#include "WindowTest.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkNexradTransferFunction.h>
#include <vtkNexradVolumeScene.h>
#include <vtkPointData.h>
#include <vtkRenderWindow.h>

#include <QComboBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QMouseEvent>
#include <QSpinBox>
#include <QToolButton>
#include <QtTest/QtTest>

#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <string_view>

using namespace nexrad;
using namespace nexrad::viewer;
using namespace nexrad::testing;

namespace
{

using Function = vtkNexradTransferFunction;

constexpr double onePixel = 0.004; // of the chart's height
constexpr std::string_view halfPixel = "the mouse is off by up to half a pixel of the chart";

class WindowTransferFunction : public WindowTest
{
protected:
  void OpenEditor(int steps = 1)
  {
    this->OpenSteps(steps);
    QTest::keyClick(window.get(), Qt::Key_T);
    this->WaitForPicture();
    QTest::qWait(100); // the chart is drawn after the volume
    chart = this->Find<TransferFunctionChart>("transfer function chart");
    ASSERT_TRUE(chart->isVisible());
  }

  Function* Colours() { return window->View()->Scene()->GetTransferFunction(); }

  std::array<double, 2> Node(int index, int channel = Function::OPACITY)
  {
    std::array<double, 2> node{};
    EXPECT_TRUE(this->Colours()->GetNode(channel, index, node.data()));
    return node;
  }

  int Count(int channel = Function::OPACITY) { return this->Colours()->GetNumberOfNodes(channel); }

  QPoint PlaceOf(const std::array<double, 2>& node)
  {
    return chart->PlaceOf(node[0], node[1]).toPoint();
  }

  // QTest would move the pointer of the screen, which other windows share.
  void Mouse(QEvent::Type type, const QPoint& place, Qt::MouseButton button)
  {
    const bool move = type == QEvent::MouseMove;
    const bool release = type == QEvent::MouseButtonRelease;
    QMouseEvent event(type, place, move ? Qt::NoButton : button,
      release ? Qt::NoButton : Qt::MouseButtons(button), Qt::NoModifier);
    QCoreApplication::sendEvent(chart, &event);
  }

  void ClickAt(const QPoint& place, Qt::MouseButton button = Qt::LeftButton)
  {
    this->Mouse(QEvent::MouseButtonPress, place, button);
    this->Mouse(QEvent::MouseButtonRelease, place, button);
  }

  void Drag(const QPoint& from, const QPoint& to)
  {
    this->Mouse(QEvent::MouseButtonPress, from, Qt::LeftButton);
    this->Mouse(QEvent::MouseMove, (from + to) / 2, Qt::LeftButton);
    this->Mouse(QEvent::MouseMove, to, Qt::LeftButton);
    this->Mouse(QEvent::MouseButtonRelease, to, Qt::LeftButton);
  }

  template <typename Box>
  void Type(const char* name, const char* text)
  {
    auto* box = this->Find<Box>(name);
    box->setFocus();
    box->selectAll();
    QTest::keyClick(box, Qt::Key_Backspace);
    QTest::keyClicks(box, text);
    QTest::keyClick(box, Qt::Key_Return);
  }

  void Undo() { QTest::keyClick(window.get(), Qt::Key_Z, Qt::ControlModifier); }
  void Redo() { QTest::keyClick(window.get(), Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier); }

  /// Presses a button that opens a file dialog, and types a name into it.
  void ChooseFile(const char* button, const std::filesystem::path& path)
  {
    AnswerDialog(path);
    this->Click(button);
  }

  QString Message() { return this->Find<QLabel>("transfer function message")->text(); }

  TransferFunctionChart* chart = nullptr;
};

} // namespace

TEST_F(WindowTransferFunction, TShowsAndHidesIt)
{
  this->OpenEditor();
  chart->grab();
  window->grab().save(QString(NEXRAD_TEST_OUTPUT_DIR) + "/WindowTransferFunction.png");
  auto* dock = this->Find<QDockWidget>("transfer function");
  QTest::keyClick(window.get(), Qt::Key_T);
  EXPECT_FALSE(dock->isVisible());
  QTest::keyClick(window.get(), Qt::Key_T);
  EXPECT_TRUE(dock->isVisible());
  this->Find<QDockWidget>("look")->raise();
  QTest::qWait(50);
  QTest::keyClick(window.get(), Qt::Key_T);
  QTest::qWait(50);
  EXPECT_FALSE(dock->visibleRegion().isEmpty()) << "from behind the settings to the front";
}

TEST_F(WindowTransferFunction, WorksApartFromTheWindow)
{
  this->OpenEditor();
  this->Find<QDockWidget>("transfer function")->setFloating(true);
  QTest::qWait(300);
  const auto before = this->Node(4);
  this->Drag(this->PlaceOf(before), this->PlaceOf({before[0], 0.02}));
  EXPECT_WITHIN(this->Node(4)[1], 0.02, onePixel, "opacity of a dragged point", halfPixel);
  this->Find<QDockWidget>("transfer function")->setFloating(false);
  QTest::qWait(300);
  this->Drag(this->PlaceOf(this->Node(4)), this->PlaceOf(before));
  EXPECT_WITHIN(this->Node(4)[1], before[1], onePixel, "opacity of a dragged point", halfPixel);
}

TEST_F(WindowTransferFunction, ColoursOfAnotherArrayAreNotEdited)
{
  this->OpenEditor();
  this->Click("Red channel");
  EXPECT_EQ(chart->Channel(), Function::RED);
  window->View()->Scene()->SetOption("colour-by", "REF");
  window->View()->DrawSoon();
  this->WaitForPicture();
  QTest::qWait(50);
  EXPECT_FALSE(this->Find<QToolButton>("Red channel")->isEnabled());
  EXPECT_EQ(chart->Channel(), Function::OPACITY);
}

TEST_F(WindowTransferFunction, DraggingAPointOfOpacityChangesThePicture)
{
  this->OpenEditor();
  constexpr int core = 4; // of 40 dBZ
  const auto before = this->Node(core);
  const QPoint from = this->PlaceOf(before);
  EXPECT_AT_LEAST(this->Changes(
                    [&] {
                      this->Drag(from, this->PlaceOf({before[0], 0.5}));
                    }),
    0.01, "pixels that a dragged opacity changes, part");
  EXPECT_WITHIN(this->Node(core)[1], 0.5, onePixel, "opacity of a dragged point", halfPixel);
  EXPECT_EQ(this->Find<QSpinBox>("Point")->value(), core + 1) << "it is selected";
  EXPECT_EQ(this->Find<QComboBox>("Transfer function preset")->currentText(), "all echo, changed");
  vtkRenderWindow* view = window->View()->renderWindow();
  EXPECT_LT(view->GetDesiredUpdateRate(), 1.0) << "light has all of its cells again";
  this->Mouse(QEvent::MouseButtonPress, this->PlaceOf(this->Node(core)), Qt::LeftButton);
  EXPECT_GT(view->GetDesiredUpdateRate(), 1.0) << "fewer cells while a point is held";
  this->Mouse(QEvent::MouseButtonRelease, this->PlaceOf(this->Node(core)), Qt::LeftButton);
  this->Undo();
  EXPECT_EQ(this->Node(core), before) << "one step for the whole drag";
  this->Redo();
  EXPECT_WITHIN(this->Node(core)[1], 0.5, onePixel, "opacity of a dragged point", halfPixel);
}

TEST_F(WindowTransferFunction, TheVolumeFollowsWhileThePointMoves)
{
  this->OpenEditor();
  const auto node = this->Node(4); // of 40 dBZ
  this->Mouse(QEvent::MouseButtonPress, this->PlaceOf(node), Qt::LeftButton);
  EXPECT_AT_LEAST(this->Changes(
                    [&] {
                      this->Mouse(QEvent::MouseMove, this->PlaceOf({node[0], 0.5}), Qt::LeftButton);
                    }),
    0.01, "pixels that a moving opacity changes, part");
  this->Mouse(QEvent::MouseButtonRelease, this->PlaceOf({node[0], 0.5}), Qt::LeftButton);
}

TEST_F(WindowTransferFunction, AClickAddsAPointAndButtonsDeleteIt)
{
  this->OpenEditor();
  const int count = this->Count();
  const double middle = 0.5 * (this->Node(0)[0] + this->Node(1)[0]);
  this->ClickAt(this->PlaceOf({middle, 0.6}));
  ASSERT_EQ(this->Count(), count + 1);
  EXPECT_WITHIN(this->Node(1)[0], middle, 0.13, "dBZ of an added point");
  EXPECT_WITHIN(this->Node(1)[1], 0.6, onePixel, "opacity of an added point", halfPixel);
  this->ClickAt(this->PlaceOf(this->Node(1)), Qt::RightButton);
  EXPECT_EQ(this->Count(), count);
  this->Undo();
  EXPECT_EQ(this->Count(), count + 1);
  this->ClickAt(this->PlaceOf(this->Node(1)));
  chart->setFocus();
  QTest::keyClick(chart, Qt::Key_Delete);
  EXPECT_EQ(this->Count(), count);
  this->Undo();
  this->Undo();
  EXPECT_EQ(this->Count(), count);
  this->Find<QSpinBox>("Point")->setValue(1);
  this->Click("Add point");
  EXPECT_EQ(this->Count(), count + 1);
  this->Click("Delete point");
  EXPECT_EQ(this->Count(), count);
}

TEST_F(WindowTransferFunction, NumbersSetThePointExactly)
{
  this->OpenEditor();
  this->Find<QSpinBox>("Point")->setValue(2);
  const auto before = this->Node(1);
  this->Type<QDoubleSpinBox>("Level of the point", "0.345");
  EXPECT_EQ(this->Node(1)[1], 0.345);
  const double wanted = before[0] + 1.25;
  this->Type<QDoubleSpinBox>("Value of the point", qPrintable(QString::number(wanted)));
  EXPECT_EQ(this->Node(1)[0], wanted);
  QTest::keyClick(this->Find<QDoubleSpinBox>("Value of the point"), Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(this->Node(1)[0], before[0]) << "from where the number was typed";
  this->Undo();
  EXPECT_EQ(this->Node(1), before);
}

TEST_F(WindowTransferFunction, EachColourHasItsCurve)
{
  this->OpenEditor();
  this->Click("Red channel");
  const auto before = this->Node(3, Function::RED);
  this->Drag(this->PlaceOf(before), this->PlaceOf({before[0], 0.5}));
  EXPECT_WITHIN(
    this->Node(3, Function::RED)[1], 0.5, onePixel, "red of a dragged point", halfPixel);
  EXPECT_EQ(this->Colours()->GetNumberOfBins(), 0);
  this->Undo();
  EXPECT_GT(this->Colours()->GetNumberOfBins(), 0) << "the steps of the colour bar come back";
}

TEST_F(WindowTransferFunction, APresetDropsEditsAndUndoBringsThemBack)
{
  this->OpenEditor();
  const QImage usual = this->WaitForPicture();
  const auto before = this->Node(1);
  this->Drag(this->PlaceOf(before), this->PlaceOf({before[0], 0.7}));
  const auto edited = this->Node(1);
  this->Choose("Transfer function preset", 1);
  EXPECT_EQ(this->Node(1), before) << "chosen again, the preset begins anew";
  EXPECT_EQ(Difference(usual, this->WaitForPicture()), 0.0);
  this->Choose("Transfer function preset", 1);
  EXPECT_EQ(window->View()->Scene()->GetPreset(), "storm cores");
  EXPECT_EQ(this->Find<QComboBox>("Preset")->currentText(), "storm cores") << "in the settings";
  this->Undo();
  EXPECT_EQ(this->Find<QComboBox>("Preset")->currentText(), "all echo");
  this->Undo();
  EXPECT_EQ(this->Node(1), edited);
}

TEST_F(WindowTransferFunction, APresetOfTheSettingsIsFollowedAndUndone)
{
  this->OpenEditor();
  this->Choose("Preset", 1);
  this->WaitForPicture();
  QTest::qWait(50);
  EXPECT_EQ(this->Find<QComboBox>("Transfer function preset")->currentText(), "storm cores");
  this->Undo();
  EXPECT_EQ(this->Find<QComboBox>("Preset")->currentText(), "all echo");
}

TEST_F(WindowTransferFunction, EditsStayInTheNextStep)
{
  this->OpenEditor(2);
  const auto before = this->Node(1);
  this->Drag(this->PlaceOf(before), this->PlaceOf({before[0], 0.7}));
  const auto edited = this->Node(1);
  EXPECT_NE(edited, before);
  QTest::keyClick(window.get(), Qt::Key_Right);
  this->WaitForPicture();
  EXPECT_EQ(window->Player()->Step(), 1U);
  EXPECT_EQ(this->Node(1), edited);
  this->Undo();
  EXPECT_EQ(this->Node(1), before);
}

TEST_F(WindowTransferFunction, AnotherMomentBeginsAnew)
{
  this->OpenEditor();
  this->Choose("Transfer function preset", 1);
  const auto node = this->Node(1);
  this->Drag(this->PlaceOf(node), this->PlaceOf({node[0], 0.7}));
  const auto velocity = MakeStormVolume(true);
  velocity->GetPointData()->GetArray("REF")->SetName("VEL");
  velocity->GetPointData()->GetArray("REF_state")->SetName("VEL_state");
  window->View()->SetVolume(velocity);
  this->WaitForPicture();
  QTest::qWait(50);
  EXPECT_EQ(this->Find<QComboBox>("Transfer function preset")->currentText(), "velocity");
  EXPECT_EQ(this->Find<QDoubleSpinBox>("Value of the point")->suffix(), " m/s");
  EXPECT_FALSE(this->Find<QToolButton>("Undo")->isEnabled());
}

TEST_F(WindowTransferFunction, IsoValuesAreSurfaces)
{
  this->OpenEditor();
  const QImage usual = this->WaitForPicture();
  EXPECT_AT_LEAST(this->Changes([&] { this->Type<QLineEdit>("Iso-values", "20:0.3, 40:0.6, 50"); }),
    0.035, "pixels that surfaces change, part");
  ASSERT_EQ(this->Colours()->GetNumberOfIsoValues(), 3);
  EXPECT_EQ(this->Colours()->Evaluate(Function::OPACITY, 40.0), 0.6);
  this->Type<QLineEdit>("Iso-values", "20:0.3, forty");
  EXPECT_TRUE(this->Message().contains("forty")) << this->Message().toStdString();
  EXPECT_EQ(this->Colours()->GetNumberOfIsoValues(), 3) << "nothing is lost";
  this->Type<QLineEdit>("Iso-values", "");
  EXPECT_EQ(this->Colours()->GetNumberOfIsoValues(), 0);
  EXPECT_EQ(Difference(usual, this->WaitForPicture()), 0.0) << "the opacity of the first preset";
}

TEST_F(WindowTransferFunction, IsoValuesOfTheCommandAreShown)
{
  request.scene.isoValues = {{20.0, 0.25}, {45.0, {}}};
  this->OpenEditor();
  EXPECT_EQ(this->Find<QLineEdit>("Iso-values")->text(), "20:0.25, 45:0.95");
  this->Choose("Transfer function preset", 1);
  EXPECT_EQ(this->Colours()->GetNumberOfIsoValues(), 0);
  this->Undo();
  EXPECT_EQ(this->Colours()->GetNumberOfIsoValues(), 2);
}

TEST_F(WindowTransferFunction, AFileComesBackAsItWas)
{
  this->OpenEditor();
  const auto node = this->Node(1);
  this->Drag(this->PlaceOf(node), this->PlaceOf({node[0], 0.7}));
  this->Type<QLineEdit>("Iso-values", "25:0.5, 45");
  const QImage saved = this->WaitForPicture();
  const std::filesystem::path path = folder.Path() / "mine.json";
  this->ChooseFile("Save transfer function", path);
  ASSERT_TRUE(std::filesystem::exists(path)) << this->Message().toStdString();
  this->Choose("Preset", 1);
  EXPECT_AT_LEAST(
    Difference(saved, this->WaitForPicture()), 0.013, "pixels that another preset changes, part");
  this->ChooseFile("Open transfer function", path);
  EXPECT_EQ(Difference(saved, this->WaitForPicture()), 0.0);
  EXPECT_EQ(this->Find<QLineEdit>("Iso-values")->text(), "25:0.5, 45:0.95");
}

TEST_F(WindowTransferFunction, ATableInKnotsIsEditedInKnots)
{
  this->OpenEditor();
  const std::filesystem::path table = folder.Path() / "knots.pal";
  std::ofstream(table) << "Units: KTS\nScale: 1.94384\nColor: 0 0 255 0\nColor: 140 255 0 0\n";
  this->ChooseFile("Open transfer function", table);
  this->WaitForPicture();
  auto* value = this->Find<QDoubleSpinBox>("Value of the point");
  this->Find<QSpinBox>("Point")->setValue(2);
  EXPECT_EQ(value->suffix(), " kt");
  EXPECT_NEAR(value->value(), 1.94384 * this->Node(1)[0], 0.01);
  this->Type<QDoubleSpinBox>("Value of the point", "17");
  EXPECT_NEAR(this->Node(1)[0], 17.0 / 1.94384, 1e-6);
  this->Type<QLineEdit>("Iso-values", "20:0.5, 40");
  ASSERT_EQ(this->Colours()->GetNumberOfIsoValues(), 2);
  EXPECT_NEAR(this->Colours()->GetIsoValue(0), 20.0 / 1.94384, 1e-6);
  EXPECT_NEAR(this->Colours()->GetIsoValue(1), 40.0 / 1.94384, 1e-6);
  EXPECT_EQ(this->Find<QLineEdit>("Iso-values")->text(), "20:0.5, 40:0.95");
}

TEST_F(WindowTransferFunction, AFileThatIsNoColourMapIsOneLine)
{
  this->OpenEditor();
  const std::filesystem::path bad = folder.Path() / "bad.pal";
  std::ofstream(bad) << "hello\n";
  const auto node = this->Node(1);
  this->ChooseFile("Open transfer function", bad);
  EXPECT_TRUE(this->Message().contains("bad.pal")) << this->Message().toStdString();
  EXPECT_EQ(this->Message().count('\n'), 0);
  EXPECT_EQ(this->Node(1), node);
}
