// SPDX-License-Identifier: BSD-3-Clause
#include "ErrorMessage.h"
#include "Scene/VolumeAppearance.h"
#include "TestData.h"

#include "nexrad/System/Error.h"
#include "vtkNexradTransferFunction.h"

#include <gtest/gtest.h>

#include <fstream>
#include <string>

using namespace nexrad;
using namespace nexrad::scene;
using nexrad::testing::MessageOf;
using nexrad::testing::TemporaryFolder;

// Formulas R4.
TEST(VolumeAppearance, TheBarShowsTheWeatherServicesSteps)
{
  const ColourTable table = ColourStepsOf(MakeTransferFunction({}));
  ASSERT_EQ(table.size(), 15U);
  for (std::size_t i = 0; i < table.size(); ++i)
  {
    EXPECT_EQ(table[i].from, 5.0 + 5.0 * static_cast<double>(i));
  }
  EXPECT_NEAR(table[0].colour[0], 0x04 / 255.0, 1e-12);
  EXPECT_NEAR(table[0].colour[1], 0xe9 / 255.0, 1e-12);
  EXPECT_NEAR(table[0].colour[2], 0xe7 / 255.0, 1e-12);
  EXPECT_EQ(table[9].colour, (Colour{0xfd / 255.0, 0.0, 0.0}));
}

TEST(VolumeAppearance, ColoursWithoutStepsAreShownEveryFiveDecibels)
{
  const auto transferFunction = MakeTransferFunction({});
  transferFunction->AddNode(vtkNexradTransferFunction::RED, 7.5, 0.25);
  const ColourTable table = ColourStepsOf(transferFunction);
  EXPECT_EQ(table[0].from, 5.0);
  EXPECT_EQ(table[0].colour[0], 0.25);
  EXPECT_EQ(table[1].from, 10.0);
}

TEST(VolumeAppearance, EveryMomentHasItsOwnLook)
{
  EXPECT_EQ(ColourStepsOf(MakeTransferFunction({}, "VEL")).front().from, -60.0);
  EXPECT_EQ(ColourStepsOf(MakeTransferFunction({}, "RHO")).back().from, 1.0);
  EXPECT_EQ(ColourStepsOf(MakeTransferFunction({}, "my own array")).front().from, 5.0)
    << "that of reflectivity";
  SceneOptions options;
  options.preset = "velocity";
  EXPECT_EQ(ColourStepsOf(MakeTransferFunction(options, "VEL")).front().from, -60.0);
  const std::string error = MessageOf([&] { MakeTransferFunction(options, "REF"); });
  EXPECT_EQ(error, "preset 'velocity' is of VEL, and REF is shown; choose 'all echo' or no preset");
}

TEST(VolumeAppearance, ColoursWithoutStepsHaveBoxesOfARoundWidth)
{
  const auto transferFunction = MakeTransferFunction({}, "RHO");
  transferFunction->AddNode(vtkNexradTransferFunction::RED, 0.5, 0.25); // drops the steps
  const ColourTable table = ColourStepsOf(transferFunction);
  ASSERT_GE(table.size(), 8U);
  EXPECT_LE(table.size(), 16U);
  EXPECT_NEAR(table[1].from - table[0].from, 0.1, 1e-12);
}

TEST(VolumeAppearance, AWrongPresetOrFileIsAnError)
{
  SceneOptions options;
  options.preset = "rainbow";
  EXPECT_THROW(MakeTransferFunction(options), Error);
  const TemporaryFolder folder;
  options = {};
  options.colours = folder.Path() / "my.csv";
  std::ofstream(options.colours) << "dbz,colour\n5,#000000\n1,#ffffff\n";
  const std::string error = MessageOf([&] { MakeTransferFunction(options); });
  EXPECT_NE(error.find("my.csv: line 3"), std::string::npos) << error;
}

TEST(VolumeAppearance, RampsOfATableAreRampsOfTheScale)
{
  const TemporaryFolder folder;
  SceneOptions options;
  options.colours = folder.Path() / "two.pal";
  std::ofstream(options.colours) << "Color: 40 255 255 0 255 128 0\nColor: 20 0 255 0 0 128 0\n"
                                    "SolidColor: 5 0 0 255\nRF: 255 0 255\nhello\n";
  const auto look = MakeTransferFunction(options);
  const ColourScale scale = ScaleOf("REF", look);
  EXPECT_TRUE(scale.bins[1].ramp);
  EXPECT_FALSE(ColourAt(scale, 4.9));
  EXPECT_EQ(ColourAt(scale, 19.9), (Colour{0.0, 0.0, 1.0}));
  EXPECT_EQ(ColourAt(scale, 20.0), (Colour{0.0, 1.0, 0.0}));
  EXPECT_NEAR((*ColourAt(scale, 30.0))[1], 191.5 / 255.0, 1e-12);
  EXPECT_NEAR((*ColourAt(scale, 39.99))[1], 128.1 / 255.0, 1e-3);
  EXPECT_NEAR((*ColourAt(scale, 99.0))[1], 128.0 / 255.0, 1e-12) << "above the last";
  EXPECT_EQ(scale.rangeFolded, (Colour{1.0, 0.0, 1.0}));
  const ColourScale flat = WithoutRamps(scale);
  for (const ColourBin& bin : flat.bins)
  {
    EXPECT_FALSE(bin.ramp);
  }
  EXPECT_NEAR((*ColourAt(flat, 30.1))[1], 191.5 / 255.0, 0.01);
  EXPECT_EQ(ColourAt(flat, 6.0), (Colour{0.0, 0.0, 1.0}));
  const std::vector<std::string> lines = LinesPassedOver(options);
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_NE(lines[0].find("two.pal: passed over: line 5"), std::string::npos) << lines[0];
  EXPECT_TRUE(LinesPassedOver({}).empty());
}

TEST(VolumeAppearance, ATableInKnotsHasAScaleInKnots)
{
  const TemporaryFolder folder;
  SceneOptions options;
  options.colours = folder.Path() / "knots.pal";
  std::ofstream(options.colours) << "Units: KTS\nScale: 1.94384\nStep: 10\n"
                                    "Color: -90 0 255 0\nColor: 0 9 9 9\nColor: 90 255 0 0\n";
  const ColourScale scale = ScaleOf("VEL", MakeTransferFunction(options, "VEL"));
  EXPECT_EQ(scale.unit, "kt");
  EXPECT_NEAR(scale.bins[0].from, -90.0, 1e-9);
  EXPECT_EQ(scale.step, 10.0);
  // 45 kt towards the radar are 23.15 m/s.
  EXPECT_NEAR((*ColourAt(scale, -45.0 / 1.94384))[1], 132.0 / 255.0, 1e-6);
  std::ofstream(options.colours) << "Scale: 7\nColor: 0 0 255 0\nColor: 70 255 0 0\n";
  const ColourScale own = ScaleOf("VEL", MakeTransferFunction(options, "VEL"));
  EXPECT_EQ(own.unit, "m/s") << "of what the seventh part is nobody knows";
  EXPECT_NEAR(own.bins[1].from, 10.0, 1e-9);
}

// As the window writes them, where another array gives the colours.
TEST(VolumeAppearance, OpacitiesAreTakenFromAFileWithoutItsColours)
{
  const TemporaryFolder folder;
  const auto edited = MakeTransferFunction({});
  edited->AddNode(vtkNexradTransferFunction::BLUE, 40.0, 0.125);
  edited->AddNode(vtkNexradTransferFunction::OPACITY, 33.0, 0.75);
  SceneOptions options;
  options.opacities = folder.Path() / "edited.json";
  ASSERT_TRUE(edited->WriteFile(options.opacities.c_str()));
  const auto taken = MakeTransferFunction(options);
  const auto usual = MakeTransferFunction({});
  for (const double value : {10.0, 30.0, 33.0, 40.0, 60.0})
  {
    EXPECT_EQ(taken->Evaluate(vtkNexradTransferFunction::OPACITY, value),
      edited->Evaluate(vtkNexradTransferFunction::OPACITY, value));
    EXPECT_EQ(taken->Evaluate(vtkNexradTransferFunction::BLUE, value),
      usual->Evaluate(vtkNexradTransferFunction::BLUE, value));
  }
  const double shell = 35.0;
  edited->SetOpacityToIsoValues(&shell, 1, 0.5);
  ASSERT_TRUE(edited->WriteFile(options.opacities.c_str()));
  EXPECT_EQ(MakeTransferFunction(options)->GetIsoValue(0), shell);
  std::ofstream(folder.Path() / "colours.csv") << "dbz,colour\n5,#000000\n10,#ffffff\n";
  options.opacities = folder.Path() / "colours.csv";
  EXPECT_THROW(MakeTransferFunction(options), Error);
}
