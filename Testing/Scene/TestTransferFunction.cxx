// SPDX-License-Identifier: BSD-3-Clause
// Colour and opacity as splines, their presets and files.
#include "vtkNexradTransferFunction.h"

#include "EventCounter.h"
#include "TestData.h"
#include "Tolerance.h"

#include <vtkColorTransferFunction.h>
#include <vtkNew.h>
#include <vtkPiecewiseFunction.h>
#include <vtkSmartPointer.h>
#include <vtkVolumeProperty.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>
#include <vector>

namespace
{

using nexrad::testing::AnyHolds;
using nexrad::testing::EventCounter;
using nexrad::testing::TemporaryFolder;
using Function = vtkNexradTransferFunction;

constexpr double byte = 255.0;

void SetNodes(Function* function, int channel, const std::vector<std::array<double, 2>>& nodes)
{
  function->RemoveAllNodes(channel);
  for (const auto& node : nodes)
  {
    function->AddNode(channel, node[0], node[1]);
  }
}

std::filesystem::path WriteText(
  const TemporaryFolder& folder, const std::string& name, const std::string& text)
{
  const std::filesystem::path path = folder.Path() / name;
  std::ofstream(path) << text;
  return path;
}

// The one line of the error that reading a text of that ending gives.
std::string ErrorOf(const std::string& name, const std::string& text)
{
  const TemporaryFolder folder;
  vtkNew<Function> function;
  vtkNew<EventCounter> events;
  events->Observe(function);
  const double before = function->Evaluate(Function::RED, 22.0);
  EXPECT_FALSE(function->ReadFile(WriteText(folder, name, text).c_str()));
  EXPECT_EQ(function->Evaluate(Function::RED, 22.0), before) << "a failed file changes nothing";
  EXPECT_EQ(events->errors.size(), 1U);
  return events->errors.empty() ? std::string() : events->errors.front();
}

bool Holds(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

} // namespace

TEST(TransferFunction, FormulasT10)
{
  vtkNew<Function> function;
  // Unevenly spaced: the slopes at 1 and 3 are (0.8 - 0) / 3 and (0.9 - 0.2) / 3. Midway,
  // the Hermite form is the mean of the ends and (slope - slope) · width / 8.
  SetNodes(function, Function::RED, {{0, 0.0}, {1, 0.2}, {3, 0.8}, {4, 0.9}});
  EXPECT_NEAR(function->Evaluate(Function::RED, 2.0), 0.5 + (0.8 - 0.7) / 3.0 * 2.0 / 8.0, 1e-12);
  // Slopes of 0 at both ends of [1, 3]: the smooth step.
  SetNodes(function, Function::RED, {{0, 0}, {1, 1}, {3, 0}, {4, 1}});
  EXPECT_NEAR(function->Evaluate(Function::RED, 1.5), 1.0 - 0.15625, 1e-12);
}

TEST(TransferFunction, PassesThroughItsNodesAndKeepsAStraightLineStraight)
{
  vtkNew<Function> function;
  SetNodes(function, Function::OPACITY, {{-10, 0.1}, {0, 0.3}, {5, 0.4}, {25, 0.8}});
  for (double dBZ = -10.0; dBZ <= 25.0; dBZ += 0.5)
  {
    EXPECT_NEAR(function->Evaluate(Function::OPACITY, dBZ), 0.3 + 0.02 * dBZ, 1e-12) << dBZ;
  }
  EXPECT_NEAR(function->Evaluate(Function::OPACITY, -90.0), 0.1, 1e-12);
  EXPECT_NEAR(function->Evaluate(Function::OPACITY, 90.0), 0.8, 1e-12);
}

TEST(TransferFunction, ClampsWhereASplineSwings)
{
  vtkNew<Function> function;
  SetNodes(function, Function::GREEN, {{0, 0}, {10, 0}, {20, 1}, {30, 1}});
  // Without the clamp the spline lies 0.07 below 0 here and 0.07 above 1 there.
  EXPECT_EQ(function->Evaluate(Function::GREEN, 5.0), 0.0);
  EXPECT_EQ(function->Evaluate(Function::GREEN, 25.0), 1.0);
  EXPECT_NEAR(function->Evaluate(Function::GREEN, 15.0), 0.5, 1e-12);
}

TEST(TransferFunction, OneNodeIsAConstantAndNoneIsNothing)
{
  vtkNew<Function> function;
  SetNodes(function, Function::BLUE, {{20, 0.25}});
  EXPECT_EQ(function->Evaluate(Function::BLUE, -5.0), 0.25);
  function->RemoveAllNodes(Function::BLUE);
  EXPECT_EQ(function->Evaluate(Function::BLUE, 20.0), 0.0);
  EXPECT_EQ(function->Evaluate(Function::RED, std::numeric_limits<double>::quiet_NaN()), 0.0);
}

TEST(TransferFunction, NodesStayInOrder)
{
  vtkNew<Function> function;
  function->RemoveAllNodes(Function::RED);
  EXPECT_EQ(function->AddNode(Function::RED, 20, 0.2), 0);
  EXPECT_EQ(function->AddNode(Function::RED, 10, 0.1), 0);
  EXPECT_EQ(function->AddNode(Function::RED, 15, 7.0), 1);
  EXPECT_EQ(function->AddNode(Function::RED, 15, 0.3), 1) << "replaced";
  EXPECT_EQ(function->GetNumberOfNodes(Function::RED), 3);
  EXPECT_EQ(function->MoveNode(Function::RED, 1, 99.0, -1.0), 1);
  double node[2];
  ASSERT_TRUE(function->GetNode(Function::RED, 1, node));
  EXPECT_LT(node[0], 20.0);
  EXPECT_NEAR(node[0], 20.0, 1e-9);
  EXPECT_EQ(node[1], 0.0);
  EXPECT_TRUE(function->RemoveNode(Function::RED, 1));
  EXPECT_FALSE(function->RemoveNode(Function::RED, 2));
  EXPECT_FALSE(function->GetNode(Function::RED, -1, node));
  vtkNew<EventCounter> events;
  events->Observe(function);
  EXPECT_EQ(function->AddNode(4, 0.0, 0.0), -1);
  EXPECT_EQ(function->AddNode(0, std::numeric_limits<double>::infinity(), 0.0), -1);
  EXPECT_EQ(events->errors.size(), 2U);
}

TEST(TransferFunction, FormulasR4InTheMiddleOfEachStep)
{
  vtkNew<Function> function;
  ASSERT_EQ(function->GetNumberOfBins(), 15);
  // 20 up to 25 dBZ: #02fd02.
  EXPECT_NEAR(function->Evaluate(Function::RED, 22.5), 2 / byte, 1e-12);
  EXPECT_NEAR(function->Evaluate(Function::GREEN, 22.5), 253 / byte, 1e-12);
  vtkNew<vtkColorTransferFunction> steps;
  function->FillSteppedColorFunction(steps);
  for (const double dBZ : {20.0, 20.1, 24.9, 24.999999})
  {
    EXPECT_NEAR(steps->GetGreenValue(dBZ), 253 / byte, 1e-9) << dBZ;
  }
  EXPECT_NEAR(steps->GetGreenValue(25.0), 197 / byte, 1e-9) << "#01c501";
  function->AddNode(Function::RED, 33.0, 0.5);
  EXPECT_EQ(function->GetNumberOfBins(), 0) << "the colours are no longer the table's";
}

TEST(TransferFunction, PropertiesFollowTheSplines)
{
  vtkNew<Function> function;
  vtkNew<vtkVolumeProperty> property;
  function->FillProperty(property);
  for (double dBZ = -10.0; dBZ <= 90.0; dBZ += 0.37)
  {
    EXPECT_WITHIN(property->GetRGBTransferFunction()->GetRedValue(dBZ),
      function->Evaluate(Function::RED, dBZ), 0.004, "red of the sampled spline")
      << dBZ;
    EXPECT_WITHIN(property->GetScalarOpacity()->GetValue(dBZ),
      function->Evaluate(Function::OPACITY, dBZ), 0.001, "opacity of the sampled spline")
      << dBZ;
  }
}

TEST(TransferFunction, PresetsShowWhatTheirNamesSay)
{
  const auto opacity = [](const char* preset, double dBZ)
  {
    vtkNew<Function> function;
    EXPECT_TRUE(function->ApplyPreset(preset));
    return function->Evaluate(Function::OPACITY, dBZ);
  };
  EXPECT_EQ(Function::GetNumberOfPresets(), 16);
  EXPECT_STREQ(Function::GetPresetName(0), "all echo");
  EXPECT_EQ(Function::GetPresetName(16), nullptr);
  EXPECT_GT(opacity("all echo", 15.0), 0.0);
  EXPECT_EQ(opacity("all echo", 4.0), 0.0);
  EXPECT_EQ(opacity("storm cores", 25.0), 0.0);
  EXPECT_AT_LEAST(opacity("storm cores", 52.0), 0.7, "opacity of the cores at 52 dBZ");
  EXPECT_EQ(opacity("hail", 44.0), 0.0);
  EXPECT_AT_LEAST(opacity("hail", 58.0), 0.7, "opacity of hail at 58 dBZ");
  EXPECT_GT(opacity("clear air", -15.0), 0.0);
  double outer = 0.0;
  for (const double iso : {20.0, 35.0, 50.0})
  {
    EXPECT_GT(opacity("iso-values", iso), outer) << "inner surfaces are more opaque";
    outer = opacity("iso-values", iso);
    EXPECT_EQ(opacity("iso-values", iso - 4.0), 0.0);
  }
  vtkNew<Function> function;
  vtkNew<EventCounter> events;
  events->Observe(function);
  EXPECT_FALSE(function->ApplyPreset("rainbow"));
  EXPECT_TRUE(AnyHolds(events->errors, "storm cores"));
}

TEST(TransferFunction, EveryMomentHasAPreset)
{
  for (const char* array : {"VEL", "SW", "ZDR", "PHI", "RHO", "CFP"})
  {
    const char* preset = Function::FindPreset(array);
    ASSERT_NE(preset, nullptr) << array;
    vtkNew<Function> function;
    EXPECT_TRUE(function->ApplyPreset(preset)) << array;
    EXPECT_GE(function->GetNumberOfBins(), 11) << array;
    EXPECT_EQ(Function::FindPreset(array, 1), nullptr) << array;
  }
  EXPECT_STREQ(Function::FindPreset("REF"), "all echo");
  EXPECT_STREQ(Function::FindPreset("REF", 4), "iso-values");
  EXPECT_STREQ(Function::FindPreset("REF", 5), "colour-blind safe");
  EXPECT_EQ(Function::FindPreset("REF", 6), nullptr);
  EXPECT_EQ(Function::FindPreset("XYZ"), nullptr);
  EXPECT_EQ(Function::FindPreset(nullptr), nullptr);
  EXPECT_STREQ(Function::GetPresetArray(0), "REF");
  EXPECT_EQ(Function::GetPresetArray(-1), nullptr);
}

// A core of 55 dBZ behind 10 km of 40 dBZ and 10 km of 20 dBZ: most of the colour that is seen is
// that of the core. Yet weak echo is seen, and what is stronger hides more.
TEST(TransferFunction, CoresShowThroughWhatIsAboutThem)
{
  vtkNew<Function> function;
  const auto kept = [&](double dBZ, double steps)
  { return std::pow(1.0 - function->Evaluate(Function::OPACITY, dBZ), steps); };
  const double before = kept(20.0, 2.0) * kept(40.0, 2.0);
  const double core = before * (1.0 - kept(55.0, 2.0));
  EXPECT_AT_LEAST(
    core / (1.0 - before * kept(55.0, 2.0)), 0.6, "part of the colour that is the core's");
  EXPECT_AT_LEAST(1.0 - kept(10.0, 8.0), 0.2, "opacity of 40 km of 10 dBZ");
  for (double dBZ = 5.0; dBZ < 75.0; dBZ += 0.5)
  {
    EXPECT_LE(
      function->Evaluate(Function::OPACITY, dBZ), function->Evaluate(Function::OPACITY, dBZ + 0.5))
      << dBZ;
  }
}

// Green towards the radar, red away from it, grey between; the fast hides more than the slow.
TEST(TransferFunction, VelocityDivergesAboutZero)
{
  vtkNew<Function> function;
  ASSERT_TRUE(function->ApplyPreset("velocity"));
  const auto value = [&](int channel, double speed) { return function->Evaluate(channel, speed); };
  for (const double speed : {7.0, 12.0, 18.0, 23.0})
  {
    EXPECT_GT(value(Function::GREEN, -speed), 2.0 * value(Function::RED, -speed)) << speed;
    EXPECT_GT(value(Function::RED, speed), 2.0 * value(Function::GREEN, speed)) << speed;
    EXPECT_NEAR(value(Function::OPACITY, -speed), value(Function::OPACITY, speed), 1e-12);
    EXPECT_GT(value(Function::OPACITY, speed), value(Function::OPACITY, speed - 5.0));
  }
  EXPECT_EQ(value(Function::RED, 0.0), value(Function::GREEN, 0.0));
  EXPECT_EQ(value(Function::RED, 0.0), value(Function::BLUE, 0.0));
}

// Rain and snow lie near 1 and are told apart by hundredths; what is no weather lies lower and
// shows.
TEST(TransferFunction, CorrelationIsFineNearOneAndOpaqueWhereLow)
{
  vtkNew<Function> function;
  ASSERT_TRUE(function->ApplyPreset("correlation coefficient"));
  EXPECT_AT_LEAST(
    function->Evaluate(Function::OPACITY, 0.7), 0.2, "opacity at a correlation of 0.7");
  EXPECT_AT_MOST(
    function->Evaluate(Function::OPACITY, 0.99), 0.015, "opacity at a correlation of 0.99");
  int fine = 0;
  double range[2];
  double lower[3];
  double upper[3];
  for (int i = 0; function->GetBin(i, range, lower, upper); ++i)
  {
    fine += range[1] - range[0] < 0.011 ? 1 : 0;
  }
  EXPECT_EQ(fine, 5); // 0.95 to 1
}

TEST(TransferFunction, ShellsThatTouchAreOne)
{
  vtkNew<Function> function;
  const std::array<double, 3> values = {45.0, 20.0, 21.0};
  function->SetOpacityToIsoValues(values.data(), 3, 0.5, 2.0);
  EXPECT_EQ(function->Evaluate(Function::OPACITY, 20.0), 0.5);
  EXPECT_EQ(function->Evaluate(Function::OPACITY, 21.0), 0.5);
  EXPECT_GE(function->Evaluate(Function::OPACITY, 20.5), 0.5);
  EXPECT_EQ(function->Evaluate(Function::OPACITY, 45.0), 0.5);
  EXPECT_EQ(function->Evaluate(Function::OPACITY, 30.0), 0.0);
}

// Between two steps the splines mix their colours: the surface of 20 dBZ was teal, half of the blue
// below it and half of the green above, and no such colour is on the bar.
TEST(TransferFunction, SurfacesHaveColoursOfTheBar)
{
  vtkNew<Function> function;
  ASSERT_TRUE(function->ApplyPreset("iso-values"));
  vtkNew<vtkColorTransferFunction> bar;
  function->FillSteppedColorFunction(bar);
  vtkNew<vtkColorTransferFunction> drawn;
  function->FillColorFunction(drawn);
  constexpr double stepOfTables = 0.25; // dBZ, the widest between two entries of a table
  for (const double value : {20.0, 35.0, 50.0})
  {
    std::array<double, 3> onBar{};
    bar->GetColor(value, onBar.data());
    std::array<double, 3> surface{};
    function->GetSurfaceColor(value, surface.data());
    EXPECT_EQ(surface, onBar) << value;
    for (const double place : {value - stepOfTables, value, value + stepOfTables})
    {
      drawn->GetColor(place, surface.data());
      for (std::size_t i = 0; i < 3; ++i)
      {
        EXPECT_NEAR(surface[i], onBar[i], 1e-12) << place;
      }
    }
  }
}

TEST(TransferFunction, SurfacesBetweenStepsKeepTheirColoursApart)
{
  vtkNew<Function> function;
  const std::array<double, 4> values = {20.1, 19.9, 20.1, 90.0}; // two of one value, one above all
  function->SetOpacityToIsoValues(values.data(), 4);
  vtkNew<vtkColorTransferFunction> drawn;
  function->FillColorFunction(drawn);
  EXPECT_AT_MOST(drawn->GetBlueValue(20.1), 0.01, "blue in the green step");
  EXPECT_AT_MOST(drawn->GetGreenValue(19.9), 0.01, "green in the blue step");
  EXPECT_EQ(drawn->GetRedValue(90.0), function->Evaluate(Function::RED, 90.0));
}

TEST(TransferFunction, EachIsoValueHasItsOpacity)
{
  vtkNew<Function> function;
  const std::array<double, 3> values = {45.0, 20.0, 21.0};
  const std::array<double, 3> opacities = {1.0, 0.2, 0.4};
  function->SetOpacityToIsoValues(values.data(), opacities.data(), 3);
  EXPECT_EQ(function->GetNumberOfIsoValues(), 3);
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    EXPECT_EQ(function->GetIsoValue(static_cast<int>(i)), values[i]);
    EXPECT_EQ(function->Evaluate(Function::OPACITY, values[i]), opacities[i]);
  }
  EXPECT_EQ(function->Evaluate(Function::OPACITY, 30.0), 0.0);

  vtkNew<EventCounter> events;
  events->Observe(function);
  const std::array<double, 3> wrong = {1.0, 0.2, 1.4};
  function->SetOpacityToIsoValues(values.data(), wrong.data(), 3);
  ASSERT_EQ(events->errors.size(), 1U);
  EXPECT_TRUE(Holds(events->errors.front(), "opacities of 0 to 1"));
  EXPECT_EQ(function->Evaluate(Function::OPACITY, 21.0), 0.4) << "nothing changed";
}

TEST(TransferFunction, JSONComesBackAsItWas)
{
  const TemporaryFolder folder;
  const std::string path = (folder.Path() / "map.json").string();
  vtkNew<Function> written;
  written->ApplyPreset("hail");
  ASSERT_TRUE(written->WriteFile(path.c_str()));
  EXPECT_EQ(nexrad::testing::FileContent(path), written->FormatJSON());
  vtkNew<Function> read;
  ASSERT_TRUE(read->ReadFile(path.c_str()));
  EXPECT_EQ(read->GetNumberOfBins(), 15);
  for (int channel = Function::RED; channel <= Function::OPACITY; ++channel)
  {
    ASSERT_EQ(read->GetNumberOfNodes(channel), written->GetNumberOfNodes(channel));
    for (double dBZ = 0.0; dBZ < 80.0; dBZ += 0.7)
    {
      EXPECT_EQ(read->Evaluate(channel, dBZ), written->Evaluate(channel, dBZ));
    }
  }
}

TEST(TransferFunction, IsoValuesComeBackFromJSON)
{
  const TemporaryFolder folder;
  const std::string path = (folder.Path() / "map.json").string();
  vtkNew<Function> written;
  const std::array<double, 3> values = {20.0, 40.0, 50.0};
  const std::array<double, 3> opacities = {0.3, 0.6, 1.0};
  written->SetOpacityToIsoValues(values.data(), opacities.data(), 3);
  ASSERT_TRUE(written->WriteFile(path.c_str()));
  vtkNew<Function> read;
  EXPECT_FALSE(read->IsEqual(written));
  ASSERT_TRUE(read->ReadFile(path.c_str()));
  ASSERT_EQ(read->GetNumberOfIsoValues(), 3);
  EXPECT_EQ(read->GetIsoValue(2), 50.0);
  EXPECT_EQ(read->Evaluate(Function::OPACITY, 40.0), 0.6);
  EXPECT_TRUE(read->IsEqual(written));
}

TEST(TransferFunction, ACopyHasAllAndIsApart)
{
  vtkNew<Function> function;
  function->ApplyPreset("iso-values");
  vtkNew<Function> copy;
  EXPECT_FALSE(copy->IsEqual(function));
  copy->DeepCopy(function);
  EXPECT_TRUE(copy->IsEqual(function));
  EXPECT_EQ(copy->GetNumberOfIsoValues(), 3);
  EXPECT_EQ(copy->GetNumberOfBins(), function->GetNumberOfBins());
  copy->MoveNode(Function::RED, 0, 5.0, 0.5);
  EXPECT_FALSE(copy->IsEqual(function));
  EXPECT_GT(function->GetNumberOfBins(), 0) << "it keeps its own";
}

TEST(TransferFunction, ReadsWhatParaViewExports)
{
  const TemporaryFolder folder;
  vtkNew<Function> function;
  ASSERT_TRUE(function->ReadFile(WriteText(folder, "map.json",
    R"([{"ColorSpace":"RGB","Name":"two","NanColor":[1,1,0],
         "RGBPoints":[0,0,0,0.5, 1,1,0.5,0.5],
         "Points":[0,0,0.5,0, 1,0.6,0.5,0]}])")
                                   .c_str()));
  function->Rescale(0.0, 80.0);
  EXPECT_NEAR(function->Evaluate(Function::RED, 20.0), 0.25, 1e-12);
  EXPECT_NEAR(function->Evaluate(Function::GREEN, 40.0), 0.25, 1e-12);
  EXPECT_NEAR(function->Evaluate(Function::BLUE, 33.0), 0.5, 1e-12);
  EXPECT_NEAR(function->Evaluate(Function::OPACITY, 60.0), 0.45, 1e-12);
}

TEST(TransferFunction, OtherColourSpacesLookAsVTKDrawsThem)
{
  const TemporaryFolder folder;
  vtkNew<Function> function;
  ASSERT_TRUE(function->ReadFile(WriteText(folder, "map.json",
    R"({"ColorSpace":"Lab","RGBPoints":[0,0.2,0.3,0.75, 30,0.9,0.85,0.8, 60,0.7,0,0.15]})")
                                   .c_str()));
  vtkNew<vtkColorTransferFunction> expected;
  expected->SetColorSpaceToLab();
  expected->AddRGBPoint(0, 0.2, 0.3, 0.75);
  expected->AddRGBPoint(30, 0.9, 0.85, 0.8);
  expected->AddRGBPoint(60, 0.7, 0, 0.15);
  for (double dBZ = 0.0; dBZ <= 60.0; dBZ += 0.9)
  {
    EXPECT_WITHIN(function->Evaluate(Function::RED, dBZ), expected->GetRedValue(dBZ), 0.01,
      "red in another colour space")
      << dBZ;
    EXPECT_WITHIN(function->Evaluate(Function::BLUE, dBZ), expected->GetBlueValue(dBZ), 0.01,
      "blue in another colour space")
      << dBZ;
  }
}

// The end of a ramp was 1.0000000000000002.
TEST(TransferFunction, RoundingLeadsNoColourBeyondItsRange)
{
  const TemporaryFolder folder;
  vtkNew<Function> function;
  ASSERT_TRUE(function->ReadFile(
    WriteText(folder, "map.pal", "Color: 0 0 0 0\nColor: 809 255 255 255\nColor: 43 1 251 1\n")
      .c_str()));
  ASSERT_GT(function->GetNumberOfNodes(Function::RED), 1);
  for (const int channel : {Function::RED, Function::GREEN, Function::BLUE})
  {
    for (int i = 0; i < function->GetNumberOfNodes(channel); ++i)
    {
      double node[2];
      ASSERT_TRUE(function->GetNode(channel, i, node));
      EXPECT_GE(node[1], 0.0);
      EXPECT_LE(node[1], 1.0);
    }
  }
}

TEST(TransferFunction, ReadsPalTables)
{
  const TemporaryFolder folder;
  vtkNew<Function> function;
  // Descending order, a scale, a ramp with an end of its own, a comment behind a statement.
  ASSERT_TRUE(function->ReadFile(WriteText(folder, "map.pal",
    "Product: BR\nUnits: DBZ\nStep: 10\nScale: 2\nOffset: 10\nND: 0 0 0\n"
    "SolidColor: 130 255 0 0 ; the top\n"
    "Color: 90 0 0 0 0 255 0\n"
    "\n color4: 50 0 0 255 51 0 0 0 51\n")
                                   .c_str()));
  ASSERT_EQ(function->GetNumberOfBins(), 3);
  double range[2];
  double lower[3];
  double upper[3];
  ASSERT_TRUE(function->GetBin(0, range, lower, upper));
  EXPECT_EQ(range[0], 20.0);
  EXPECT_EQ(range[1], 40.0);
  EXPECT_EQ(lower[2], 1.0);
  EXPECT_EQ(upper[2], 0.0);
  ASSERT_TRUE(function->GetBin(2, range, lower, upper));
  EXPECT_EQ(range[0], 60.0);
  EXPECT_EQ(range[1], 80.0) << "as wide as the one before";
  EXPECT_EQ(upper[0], 1.0);
  EXPECT_NEAR(function->Evaluate(Function::RED, 70.0), 1.0, 1e-12) << "in the solid's middle";
  EXPECT_NEAR(function->Evaluate(Function::GREEN, 55.0), 0.75, 1e-12)
    << "in the ramp, near its jump";
  EXPECT_NEAR(function->Evaluate(Function::OPACITY, 30.0), 0.2, 1e-12);
}

// GRLevelX's specification of colour tables: a statement is a ramp up to the next one's colour, or
// up to its own second colour; a solid one is a step; one without alpha is opaque.
TEST(TransferFunction, OpacitiesOfPalTablesAreRampsAndSteps)
{
  const TemporaryFolder folder;
  const auto read = [&folder](const char* text)
  {
    auto function = vtkSmartPointer<Function>::New();
    EXPECT_TRUE(function->ReadFile(WriteText(folder, "map.pal", text).c_str()));
    return function;
  };
  const auto opacity = [](Function* function, double dBZ)
  { return function->Evaluate(Function::OPACITY, dBZ); };
  const auto mixed = read("Color4: -10 0 0 0 0\nColor: 10 106 90 205\nColor: 50 72 61 139\n");
  EXPECT_NEAR(opacity(mixed, 0.0), 0.5, 1e-12);
  EXPECT_EQ(opacity(mixed, 10.0), 1.0);
  EXPECT_EQ(opacity(mixed, 49.0), 1.0);
  const auto solid = read("SolidColor4: 0 0 0 255 0\nSolidColor4: 20 0 255 0 255\n"
                          "SolidColor4: 40 255 0 0 255\n");
  EXPECT_EQ(opacity(solid, 15.0), 0.0);
  EXPECT_NEAR(opacity(solid, 19.99), 0.0, 1e-12);
  EXPECT_EQ(opacity(solid, 20.0), 1.0);
  const auto pairs = read("Color4: 0 0 0 255 0 0 0 255 128\nColor4: 20 0 255 0 255 0 255 0 255\n"
                          "Color4: 40 255 0 0 255 255 0 0 255\n");
  EXPECT_NEAR(opacity(pairs, 10.0), 64.0 / byte, 1e-12);
  EXPECT_NEAR(opacity(pairs, 19.99), 127.9 / byte, 2e-4);
  EXPECT_EQ(opacity(pairs, 20.0), 1.0);
  const auto opaque = read("Color4: 5 0 0 255 255\nColor: 20 0 255 0\n");
  EXPECT_EQ(opacity(opaque, 4.9), 0.0) << "below the table";
  EXPECT_EQ(opacity(opaque, 5.0), 1.0);
  // What the volume property gets has the step as well.
  vtkNew<vtkPiecewiseFunction> filled;
  solid->FillOpacityFunction(filled);
  EXPECT_NEAR(filled->GetValue(19.99), 0.0, 1e-12);
  EXPECT_EQ(filled->GetValue(20.0), 1.0);
}

TEST(TransferFunction, RampsOfPalTablesAreStraightAndJumpWhereTheTableDoes)
{
  const TemporaryFolder folder;
  vtkNew<Function> function;
  const std::string path = WriteText(folder, "map.pal",
    "\xEF\xBB\xBF"
    "Product: BR\r\nUnits: dBZ\r\nND: 0 0 0\r\nRF: 124 24 124\r\n"
    "Color: 60 255 0 0 128 0 0\r\nColor: 40 255 255 0 255 128 0\r\n"
    "Color: 20 0 255 0 0 128 0\r\nSolidColor: 5 0 0 255\r\n");
  ASSERT_TRUE(function->ReadFile(path.c_str()));
  const auto green = [&](double dBZ) { return byte * function->Evaluate(Function::GREEN, dBZ); };
  EXPECT_EQ(green(19.99), 0.0);
  EXPECT_EQ(green(20.0), 255.0);
  EXPECT_NEAR(green(30.0), 191.5, 1e-2);
  EXPECT_NEAR(green(39.99), 128.1, 0.1);
  EXPECT_EQ(green(40.0), 255.0);
  double rangeFolded[3];
  ASSERT_TRUE(function->GetRangeFoldedColor(rangeFolded));
  EXPECT_EQ(rangeFolded[1], 24.0 / byte);
  // As the window saves it and reads it again.
  const std::string json = (folder.Path() / "map.json").string();
  ASSERT_TRUE(function->WriteFile(json.c_str()));
  vtkNew<Function> again;
  ASSERT_TRUE(again->ReadFile(json.c_str()));
  EXPECT_TRUE(again->IsEqual(function));
  ASSERT_TRUE(function->WriteFile(path.c_str()));
  ASSERT_TRUE(again->ReadFile(path.c_str()));
  EXPECT_NEAR(byte * again->Evaluate(Function::GREEN, 30.0), 191.5, 1e-2);
}

TEST(TransferFunction, PalTablesNameTheirUnitByTheirScale)
{
  const TemporaryFolder folder;
  vtkNew<EventCounter> events;
  const auto read = [&](const std::string& head)
  {
    auto function = vtkSmartPointer<Function>::New();
    events->Observe(function);
    EXPECT_TRUE(function->ReadFile(
      WriteText(folder, "map.pal", head + "color: -90 0 255 0\ncolor: 90 255 0 0\n").c_str()));
    return function;
  };
  const auto knots = read("units: KTS\nstep: 05\nscale: 1.9426\nDecimals: 1\n");
  EXPECT_STREQ(knots->GetLabelUnit(), "kt");
  EXPECT_EQ(knots->GetLabelFactor(), 1.9426);
  EXPECT_EQ(knots->GetLabelStep(), 5.0);
  EXPECT_EQ(knots->GetLabelDecimals(), 1);
  double range[2];
  double lower[3];
  double upper[3];
  ASSERT_TRUE(knots->GetBin(0, range, lower, upper));
  EXPECT_NEAR(range[0], -90.0 / 1.9426, 1e-12) << "m/s";
  EXPECT_STREQ(read("Scale: 2.23694\n")->GetLabelUnit(), "mph") << "without Units";
  EXPECT_STREQ(read("Units: in\nScale: 0.5\n")->GetLabelUnit(), "in");
  EXPECT_STREQ(read("Units: \xB0/km\nScale: 2\n")->GetLabelUnit(), "\xEF\xBF\xBD/km")
    << "a letter of Latin-1 is replaced";
  EXPECT_TRUE(events->warnings.empty());
  EXPECT_STREQ(read("Units: MPH\nScale: 1.94384\n")->GetLabelUnit(), "kt");
  ASSERT_EQ(events->warnings.size(), 1U);
  EXPECT_PRED2(Holds, events->warnings[0], "map.pal: passed over: line 1: the unit MPH");
}

// As other programs do, with a warning for each.
TEST(TransferFunction, LinesOfPalTablesThatCannotBeReadArePassedOver)
{
  const TemporaryFolder folder;
  vtkNew<Function> function;
  vtkNew<EventCounter> events;
  events->Observe(function);
  ASSERT_TRUE(function->ReadFile(WriteText(folder, "map.pal",
    "TABLE BY somebody#9800\nProduct: BR\nColor: 0 0 0 255\nColor: 10 1 2\nScale: 0\n"
    "Color: 20 0 255 0\nColour: 30 0 0 0\nColor: 20 255 255 0 ; the later counts\n"
    "Color: 40 255 0 256\nColor: 60 255 0 0\n")
                                   .c_str()));
  ASSERT_EQ(function->GetNumberOfBins(), 3);
  EXPECT_EQ(function->Evaluate(Function::RED, 20.0), 1.0);
  ASSERT_EQ(events->warnings.size(), 5U);
  EXPECT_PRED2(
    Holds, events->warnings[0], "map.pal: passed over: line 1: 'TABLE BY somebody#9800'");
  EXPECT_PRED2(Holds, events->warnings[1], "line 4: 'Color: 10 1 2' must hold a value and three");
  EXPECT_PRED2(Holds, events->warnings[2], "line 5: 'Scale: 0'");
  EXPECT_PRED2(Holds, events->warnings[3], "line 7: 'Colour: 30 0 0 0' is no statement");
  EXPECT_PRED2(Holds, events->warnings[4], "line 9: 'Color: 40 255 0 256'");
}

TEST(TransferFunction, NothingShowsBelowATableOfColours)
{
  const TemporaryFolder folder;
  vtkNew<Function> function;
  const double before = function->Evaluate(Function::OPACITY, 60.0);
  ASSERT_TRUE(function->ReadFile(
    WriteText(folder, "map.csv", "dbz,colour\n30,#00ff00\n40,#ff0000\n").c_str()));
  EXPECT_EQ(function->Evaluate(Function::OPACITY, 29.9), 0.0);
  EXPECT_GT(function->Evaluate(Function::OPACITY, 35.0), 0.0);
  EXPECT_EQ(function->Evaluate(Function::OPACITY, 60.0), before);
}

TEST(TransferFunction, PalTablesComeBackToAByte)
{
  const TemporaryFolder folder;
  const std::string path = (folder.Path() / "map.pal").string();
  vtkNew<Function> steps;
  ASSERT_TRUE(steps->WriteFile(path.c_str()));
  vtkNew<Function> read;
  ASSERT_TRUE(read->ReadFile(path.c_str()));
  EXPECT_EQ(read->GetNumberOfBins(), 15);
  vtkNew<Function> splines;
  SetNodes(splines, Function::RED, {{0, 0.1}, {30, 0.9}, {60, 0.2}});
  ASSERT_TRUE(splines->WriteFile(path.c_str()));
  vtkNew<Function> sampled;
  ASSERT_TRUE(sampled->ReadFile(path.c_str()));
  for (double dBZ = 0.0; dBZ < 75.0; dBZ += 0.7)
  {
    EXPECT_NEAR(read->Evaluate(Function::GREEN, dBZ), steps->Evaluate(Function::GREEN, dBZ), 1e-9);
    EXPECT_WITHIN(sampled->Evaluate(Function::RED, dBZ), splines->Evaluate(Function::RED, dBZ),
      0.0039, "red that comes back");
    EXPECT_WITHIN(sampled->Evaluate(Function::OPACITY, dBZ),
      splines->Evaluate(Function::OPACITY, dBZ), 0.0039, "opacity that comes back");
  }
}

TEST(TransferFunction, WrongFilesAreNamedInOneLine)
{
  EXPECT_PRED2(Holds, ErrorOf("a.json", "[1, 2"), "a.json: this is not JSON");
  EXPECT_PRED2(Holds, ErrorOf("a.json", "[]"), "no colour map");
  EXPECT_PRED2(Holds, ErrorOf("a.json", R"({"RGBPoints":[1,2,3]})"), "RGBPoints");
  EXPECT_PRED2(Holds, ErrorOf("a.json", R"({"RGBPoints":[5,0,0,0, 1,0,0,0]})"), "ascending");
  EXPECT_PRED2(
    Holds, ErrorOf("a.json", R"({"RGBPoints":[1,0,0,0],"Points":[1,"x",0,0]})"), "Points");
  EXPECT_PRED2(Holds, ErrorOf("a.json", R"({"vtkNexradNodes":[]})"), "red, green");
  const std::string nodes = R"({"vtkNexradNodes":{"red":[],"green":[],"blue":[],"opacity":[]},)";
  EXPECT_PRED2(
    Holds, ErrorOf("a.json", nodes + R"("vtkNexradIsoValues":[40, 20]})"), "vtkNexradIsoValues");
  EXPECT_PRED2(Holds, ErrorOf("a.pal", "Color: 20 2 253\n"), "line 1");
  EXPECT_PRED2(Holds, ErrorOf("a.pal", "Color: 20 2 253 256\n"), "0 to 255");
  EXPECT_PRED2(Holds, ErrorOf("a.pal", "Scale: 0\n"), "line 1");
  EXPECT_PRED2(Holds, ErrorOf("a.pal", "hello\n"), "no statement");
  EXPECT_PRED2(Holds, ErrorOf("a.pal", ""), "two colours");
  EXPECT_PRED2(Holds, ErrorOf("a.pal", "Color: 5 1 1 1\nColor: 5 2 2 2\n"), "two colours");
  EXPECT_PRED2(Holds, ErrorOf("a.csv", "dbz,rgb\n5,#000000\n5,#ffffff\n"), "line 3");
  EXPECT_PRED2(Holds, ErrorOf("a.csv", "dbz,rgb\n5,#00000g\n"), "line 2");
  EXPECT_PRED2(Holds, ErrorOf("a.txt", ""), ".json, .pal or .csv");
}

// Slopes between such places were infinite, and values at nodes no numbers.
TEST(TransferFunction, PlacesBetweenWhichNoSlopeCanBeComputedAreErrors)
{
  const std::string colors = "\nColor: 1e308 0 0 0\nColor: -1e308 9 9 9\n";
  EXPECT_NE(ErrorOf("far.pal", colors).find("beyond 1e30"), std::string::npos);
  EXPECT_NE(
    ErrorOf("scaled.pal", "Scale: 1e-300\nColor: 1e20 0 0 0\nColor: 2 9 9 9\n").find("beyond"),
    std::string::npos);
  EXPECT_NE(ErrorOf("near.pal", "Color: 0 0 0 0\nColor: 5e-324 9 9 9\n").find("two colours"),
    std::string::npos);
  EXPECT_NE(
    ErrorOf("near.csv", "dbz,colour\n1,#000000\n1.0000000000000002,#ffffff\n").find("line 3"),
    std::string::npos);
  EXPECT_NE(ErrorOf("far.json", R"({"RGBPoints":[-1e308,0,0,0,1e308,1,1,1]})").find("RGBPoints"),
    std::string::npos);
  const std::string nodes =
    R"({"vtkNexradNodes":{"red":[0,0,5e-324,1],"green":[],"blue":[],"opacity":[]})";
  EXPECT_NE(
    ErrorOf("near.json", nodes + R"(,"vtkNexradBins":[0,5e-324,0,0,0,1,1,1]})").find("Bins"),
    std::string::npos);
  const TemporaryFolder folder;
  vtkNew<Function> function;
  ASSERT_TRUE(function->ReadFile(WriteText(folder, "nodes.json", nodes + "}").c_str()));
  EXPECT_EQ(function->GetNumberOfNodes(Function::RED), 1) << "two nodes at one place are one";
  EXPECT_EQ(function->Evaluate(Function::RED, 0.0), 1.0);
}

TEST(TransferFunction, ColoursOfBinsAreClamped)
{
  const TemporaryFolder folder;
  vtkNew<Function> function;
  ASSERT_TRUE(function->ReadFile(WriteText(folder, "bins.json",
    R"({"vtkNexradNodes":{"red":[],"green":[],"blue":[],"opacity":[]},)"
    R"("vtkNexradBins":[0,5,-1,0,0,1e300,1,1]})")
                                   .c_str()));
  double range[2];
  std::array<double, 3> lower{};
  std::array<double, 3> upper{};
  ASSERT_TRUE(function->GetBin(0, range, lower.data(), upper.data()));
  EXPECT_EQ(lower, (std::array<double, 3>{0.0, 0.0, 0.0}));
  EXPECT_EQ(upper, (std::array<double, 3>{1.0, 1.0, 1.0}));
}

// The name of such a file became the name of the map, which JSON cannot hold: an exception that
// nobody caught.
TEST(TransferFunction, AFileNameInAnotherEncodingCanBeWritten)
{
  const TemporaryFolder folder;
  vtkNew<Function> function;
  const auto palette = WriteText(folder, "Gew\xE4hlt.pal", "Color: 0 0 0 0\nColor: 9 9 9 9\n");
  ASSERT_TRUE(function->ReadFile(palette.c_str()));
  EXPECT_NE(function->FormatJSON().find("Gew\xEF\xBF\xBDhlt"), std::string::npos);
  EXPECT_TRUE(function->WriteFile((folder.Path() / "map.json").c_str()));
}

TEST(TransferFunction, AFileThatCannotBeWrittenIsAnError)
{
  vtkNew<Function> function;
  vtkNew<EventCounter> events;
  events->Observe(function);
  EXPECT_FALSE(function->WriteFile("/nonexistent/map.json"));
  EXPECT_FALSE(function->WriteFile("map.csv"));
  EXPECT_FALSE(function->WriteFile(nullptr));
  EXPECT_EQ(events->errors.size(), 3U);
}
