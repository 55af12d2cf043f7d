// SPDX-License-Identifier: BSD-3-Clause
#include "ColourTable.h"

#include "Model/Error.h"

#include <vtkColorTransferFunction.h>
#include <vtkNew.h>

#include <gtest/gtest.h>

using namespace nexrad;
using namespace nexrad::scene;

// Formulas R4.
TEST(ColourTable, WeatherServiceColours)
{
  const ColourTable& table = WeatherServiceColours();
  ASSERT_EQ(table.size(), 15U);
  for (std::size_t i = 0; i < table.size(); ++i)
  {
    EXPECT_EQ(table[i].from, 5.0 + 5.0 * static_cast<double>(i));
  }
  EXPECT_NEAR(table[0].colour[0], 0x04 / 255.0, 1e-12);
  EXPECT_NEAR(table[0].colour[1], 0xe9 / 255.0, 1e-12);
  EXPECT_NEAR(table[0].colour[2], 0xe7 / 255.0, 1e-12);
  EXPECT_EQ(table[9].from, 50.0);
  EXPECT_EQ(table[9].colour, (Colour{0xfd / 255.0, 0.0, 0.0}));
  EXPECT_EQ(UpperEnd(table), 80.0);
}

TEST(ColourTable, TheVolumesColoursMeetTheTableAtTheCentresOfItsBins)
{
  vtkNew<vtkColorTransferFunction> function;
  FillSmooth(function, WeatherServiceColours());
  for (const ColourBin& bin : WeatherServiceColours())
  {
    double colour[3];
    function->GetColor(bin.from + 2.5, colour);
    for (int component = 0; component < 3; ++component)
    {
      EXPECT_NEAR(colour[component], bin.colour[component], 1e-9) << bin.from;
    }
  }
}

TEST(ColourTable, BadRowsNameTheirLine)
{
  const std::string head = "dbz,colour\n5,#000000\n";
  for (const std::string row : {"5,#ffffff", "4,#ffffff", "10;#ffffff", "10,ffffff", "10,#fffff",
         "10,#ggffff", ",#ffffff", "ten,#ffffff", "10 dBZ,#ffffff", "nan,#ffffff"})
  {
    try
    {
      ParseColourTable(head + row + "\n", "my.csv");
      ADD_FAILURE() << row;
    }
    catch (const Error& error)
    {
      EXPECT_EQ(std::string(error.what()).rfind("my.csv: line 3: '" + row + "'", 0), 0U)
        << error.what();
    }
  }
  EXPECT_THROW(ParseColourTable(head, "one row"), Error);
  EXPECT_THROW(ParseColourTable("", "empty"), Error);
  EXPECT_THROW(ReadColourTable("/nonexistent/table.csv"), Error);
}

TEST(ColourTable, WindowsLineEndsAndBlankLinesAreAllowed)
{
  EXPECT_EQ(ParseColourTable("dbz,colour\r\n5,#000000\r\n\r\n10,#FFFFFF\r\n", "x").size(), 2U);
}
