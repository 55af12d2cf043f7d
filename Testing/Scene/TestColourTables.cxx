// SPDX-License-Identifier: BSD-3-Clause
// The colours of the presets as eyes see them: in CIELAB, for eyes with all cones and, by the
// linear model of Machado, Oliveira and Fernandes (2009) at full severity, for eyes without the
// cones for green (deuteranopia) and for red (protanopia).
#include "Scene/VolumeAppearance.h"
#include "Tolerance.h"

#include "vtkNexradTransferFunction.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

using namespace nexrad::scene;

namespace
{

using Matrix = std::array<std::array<double, 3>, 3>;

constexpr Matrix allCones = {{{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}};
constexpr Matrix deuteranopia = {{{0.367322, 0.860646, -0.227968}, {0.280085, 0.672501, 0.047413},
  {-0.011820, 0.042940, 0.968881}}};
constexpr Matrix protanopia = {{{0.152286, 1.052583, -0.204868}, {0.114503, 0.786281, 0.099216},
  {-0.003882, -0.048116, 1.051998}}};
struct Vision
{
  const char* name;
  Matrix matrix;
};
constexpr std::array<Vision, 3> visions = {{{"with all cones", allCones},
  {"without the cones for green", deuteranopia}, {"without the cones for red", protanopia}}};

// From linear sRGB to CIE XYZ over the white of D65.
constexpr Matrix toXYZ = {{{0.4124 / 0.9505, 0.3576 / 0.9505, 0.1805 / 0.9505},
  {0.2126, 0.7152, 0.0722}, {0.0193 / 1.089, 0.1192 / 1.089, 0.9505 / 1.089}}};

Colour Times(const Matrix& matrix, const Colour& colour)
{
  Colour product{};
  for (std::size_t row = 0; row < 3; ++row)
  {
    for (std::size_t column = 0; column < 3; ++column)
    {
      product[row] += matrix[row][column] * colour[column];
    }
  }
  return product;
}

// L*, a* and b* of a colour as those eyes see it.
Colour LabOf(const Colour& colour, const Matrix& vision)
{
  Colour linear{};
  std::transform(colour.begin(), colour.end(), linear.begin(),
    [](double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); });
  linear = Times(vision, linear);
  for (double& component : linear)
  {
    component = std::clamp(component, 0.0, 1.0);
  }
  Colour f = Times(toXYZ, linear);
  for (double& t : f)
  {
    t = t > 216.0 / 24389.0 ? std::cbrt(t) : (24389.0 / 27.0 * t + 16.0) / 116.0;
  }
  return {116.0 * f[1] - 16.0, 500.0 * (f[0] - f[1]), 200.0 * (f[1] - f[2])};
}

// ΔE of 1976; about 2.3 is just noticed.
double Difference(const Colour& a, const Colour& b, const Matrix& vision)
{
  const Colour left = LabOf(a, vision);
  const Colour right = LabOf(b, vision);
  return std::hypot(left[0] - right[0], left[1] - right[1], left[2] - right[2]);
}

ColourTable TableOf(const std::string& preset, const std::string& array)
{
  SceneOptions options;
  options.preset = preset;
  return ColourStepsOf(MakeTransferFunction(options, array));
}

double LeastDifferenceOfNeighbours(const ColourTable& table, const Matrix& vision)
{
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < table.size(); ++i)
  {
    least = std::min(least, Difference(table[i - 1].colour, table[i].colour, vision));
  }
  return least;
}

} // namespace

// White, black and sRGB's primary red, whose L*, a*, b* are 53.24, 80.09, 67.20.
TEST(ColourTables, LabOfKnownColours)
{
  EXPECT_NEAR(LabOf({1.0, 1.0, 1.0}, allCones)[0], 100.0, 1e-9);
  EXPECT_NEAR(LabOf({0.0, 0.0, 0.0}, allCones)[0], 0.0, 1e-9);
  const Colour red = LabOf({1.0, 0.0, 0.0}, allCones);
  EXPECT_WITHIN(red[0], 53.24, 0.012, "L* of red");
  EXPECT_WITHIN(red[1], 80.09, 0.03, "a* of red");
  EXPECT_WITHIN(red[2], 67.20, 0.04, "b* of red");
  // Grey stays grey to every eye.
  EXPECT_AT_MOST(Difference({0.5, 0.5, 0.5}, Times(deuteranopia, {0.5, 0.5, 0.5}), allCones),
    0.0003, "change of grey without the cones for green, in CIELAB");
  EXPECT_AT_MOST(Difference({0.5, 0.5, 0.5}, Times(protanopia, {0.5, 0.5, 0.5}), allCones), 0.0001,
    "change of grey without the cones for red, in CIELAB");
}

TEST(ColourTables, TheSafeColoursGrowLighterAndDifferToEveryEye)
{
  const ColourTable table = TableOf("colour-blind safe", "REF");
  ASSERT_EQ(table.size(), 15U);
  EXPECT_EQ(table.front().from, 5.0);
  EXPECT_EQ(table.back().from, 75.0);
  const std::array<double, 3> leastSteps = {4.0, 3.0, 1.2};
  for (std::size_t eye = 0; eye < visions.size(); ++eye)
  {
    const auto& [name, vision] = visions[eye];
    double leastStep = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i < table.size(); ++i)
    {
      leastStep = std::min(
        leastStep, LabOf(table[i].colour, vision)[0] - LabOf(table[i - 1].colour, vision)[0]);
    }
    EXPECT_AT_LEAST(leastStep, leastSteps[eye], std::string("least step of L* ") + name);
    EXPECT_AT_LEAST(LeastDifferenceOfNeighbours(table, vision), 6.0,
      std::string("least difference of neighbours in CIELAB ") + name);
  }
}

// Green and red of the same speed have the same lightness, which grows with the speed, and differ
// to every eye.
TEST(ColourTables, VelocitiesOfBothSignsAreAlikeInLightness)
{
  const ColourTable table = TableOf("velocity", "VEL");
  ASSERT_EQ(table.size() % 2, 1U) << "the middle is about zero";
  const std::size_t middle = table.size() / 2;
  EXPECT_EQ(table[middle].from, -table[middle + 1].from);
  const std::array<double, 3> least = {40.0, 10.0, 6.0};
  for (std::size_t step = 1; step <= middle; ++step)
  {
    const Colour towards = table[middle - step].colour;
    const Colour away = table[middle + step].colour;
    const double lightness = LabOf(away, allCones)[0];
    EXPECT_WITHIN(
      LabOf(towards, allCones)[0], lightness, 0.4, "L* of the same speed in both directions")
      << table[middle + step].from;
    if (step > 1)
    {
      EXPECT_AT_LEAST(lightness - LabOf(table[middle + step - 1].colour, allCones)[0], 4.0,
        "step of L* from speed to speed");
      EXPECT_EQ(table[middle - step + 1].from, -table[middle + step].from) << "the steps' edges";
    }
    for (std::size_t eye = 0; eye < visions.size(); ++eye)
    {
      const auto& [name, vision] = visions[eye];
      EXPECT_AT_LEAST(Difference(towards, away, vision), least[eye],
        std::string("difference of both directions in CIELAB ") + name)
        << table[middle + step].from;
    }
  }
}

// What a colour bar shows of each moment: steps that every eye tells from their neighbours.
TEST(ColourTables, NeighboursOfEveryMomentDiffer)
{
  struct Moment
  {
    const char* array;
    double least;
  };
  for (const auto& [array, bound] :
    {Moment{"VEL", 4.0}, {"SW", 7.5}, {"ZDR", 5.5}, {"PHI", 7.5}, {"RHO", 8.0}, {"CFP", 8.0}})
  {
    const ColourTable table = TableOf("", array);
    double least = std::numeric_limits<double>::infinity();
    for (const Vision& vision : visions)
    {
      least = std::min(least, LeastDifferenceOfNeighbours(table, vision.matrix));
    }
    EXPECT_AT_LEAST(
      least, bound, array + std::string(": least difference of neighbours to any eye, in CIELAB"));
  }
}
