// SPDX-License-Identifier: BSD-3-Clause
// Formulas L2: how much light arrives in the cells of volumes with isosurfaces.
#include "vtkTextureSliceLightVolume.h"

#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <vector>

namespace
{

using Lights = vtkTextureSliceLightVolume::Lights;
using Vector = std::array<double, 3>;

constexpr int Voxels = 32; // along each axis, one unit apart

float DepthOf(double opacity)
{
  return static_cast<float>(-std::log(1.0 - opacity));
}

/// A volume whose scalars are a function of the place.
class SurfaceLight : public ::testing::Test
{
protected:
  void Make(const std::function<double(const Vector&)>& scalar)
  {
    this->Scalars->SetNumberOfValues(vtkIdType{Voxels} * Voxels * Voxels);
    this->Source.Scalars = {this->Scalars, {Voxels, Voxels, Voxels}, false, nullptr};
    for (vtkIdType id = 0; id < this->Scalars->GetNumberOfValues(); ++id)
    {
      const Vector at{double(id % Voxels), double(id / Voxels % Voxels),
        double(id / (vtkIdType{Voxels} * Voxels))};
      this->Scalars->SetValue(id, static_cast<float>(scalar(at)));
    }
  }

  void Build(const Vector& toLight, std::size_t voxelsOfACell = 8)
  {
    Lights lights;
    lights.Shadow = true;
    lights.ToLight = toLight;
    this->Volume.Build(
      {this->Source, std::size_t{Voxels} * Voxels * Voxels / voxelsOfACell}, lights);
  }

  /// Light of the cell that contains a voxel, 0 to 1.
  double At(int x, int y, int z) const
  {
    const vtkTextureSliceLightGrid& grid = this->Volume.GetGrid();
    const vtkIdType index =
      (z / grid.Factor[2] * grid.Size[1] + y / grid.Factor[1]) * grid.Size[0] + x / grid.Factor[0];
    return static_cast<double>(this->Volume.GetLight()->GetValue(2 * index));
  }

  vtkNew<vtkFloatArray> Scalars;
  vtkTextureSliceLightCells::Source Source;
  vtkTextureSliceLightVolume Volume;
};

} // namespace

// A slanted plane takes its part once, whatever the direction of the light and the size of cells.
TEST_F(SurfaceLight, ASurfaceTakesItsOpacityWhateverTheCells)
{
  this->Make([](const Vector& at) { return at[2] + 0.3 * at[0] - 0.2 * at[1]; });
  for (const double opacity : {0.0, 0.3, 0.5, 0.99})
  {
    this->Source.Surfaces = {{18.2f, DepthOf(opacity)}};
    for (const std::size_t voxelsOfACell : {1, 8, 64})
    {
      for (const Vector& toLight : {Vector{0, 0, 1}, {0.2, 0.4, 1.0}, {-0.6, 0.1, 1.0}})
      {
        this->Build(toLight, voxelsOfACell);
        EXPECT_NEAR(this->At(16, 16, 2), 1.0 - opacity, 1e-4) << voxelsOfACell;
        EXPECT_EQ(this->At(16, 16, 29), 1.0) << voxelsOfACell;
      }
    }
  }
}

TEST_F(SurfaceLight, SurfacesTakeTheirPartsOneAfterTheOther)
{
  this->Make([](const Vector& at) { return -std::abs(at[2] - 20.0); });
  this->Source.Surfaces = {{-4.5f, DepthOf(0.2)}, {-2.5f, DepthOf(0.5)}};
  this->Build({0, 0, 1});
  EXPECT_NEAR(this->At(16, 16, 20), 0.8 * 0.5, 1e-4) << "through both, into the slab";
  EXPECT_NEAR(this->At(16, 16, 2), std::pow(0.8 * 0.5, 2), 1e-4) << "and out of it";
}

TEST_F(SurfaceLight, AnOpaqueBallShadesWhatLiesBehindIt)
{
  this->Make(
    [](const Vector& at) { return 6.0 - std::hypot(at[0] - 16.0, at[1] - 16.0, at[2] - 20.0); });
  this->Source.Surfaces = {{0.0f, 16.0f}};
  constexpr double slope = 0.5;
  this->Build({slope, 0, 1}, 1);
  for (int x = 0; x < Voxels; ++x)
  {
    // How far the light of the cell passes from the middle of the ball.
    const double apart = std::abs(x + slope * 20.0 - 16.0) / std::hypot(1.0, slope);
    if (apart < 4.5)
    {
      EXPECT_LT(this->At(x, 16, 0), 1e-6) << x;
    }
    else if (apart > 7.5)
    {
      EXPECT_EQ(this->At(x, 16, 0), 1.0) << x;
    }
  }
}

// Between what is seen and what is hidden there is no surface, and in what is hidden none either.
TEST_F(SurfaceLight, WhatIsHiddenLetsLightThrough)
{
  this->Make([](const Vector& at) { return at[2]; });
  this->Source.Surfaces = {{16.3f, 16.0f}};
  this->Build({0, 0, 1});
  EXPECT_LT(this->At(4, 16, 2), 1e-6);

  const auto expectHalf = [&](const char* what)
  {
    this->Build({0, 0, 1});
    EXPECT_EQ(this->At(4, 16, 2), 1.0) << what;
    EXPECT_LT(this->At(28, 16, 2), 1e-6) << what;
  };
  std::vector<unsigned char> mask(std::size_t{Voxels} * Voxels * Voxels);
  for (std::size_t i = 0; i < mask.size(); ++i)
  {
    mask[i] = i % Voxels < Voxels / 2 ? 0 : 1;
  }
  this->Source.Mask = mask.data();
  expectHalf("a mask");
  this->Source.Mask = nullptr;
  this->Source.Left = vtkTextureSliceCut{{0.5, 1, 0, 1, 0, 1}};
  expectHalf("a cut");
  this->Source.Left = {};
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetNumberOfTuples(this->Scalars->GetNumberOfValues());
  for (vtkIdType id = 0; id < ghosts->GetNumberOfTuples(); ++id)
  {
    ghosts->SetValue(id, id % Voxels < Voxels / 2 ? 1 : 0);
  }
  this->Source.Masked = true;
  this->Source.Scalars.Ghosts = ghosts;
  expectHalf("ghost flags");
  this->Source.Scalars.Ghosts = nullptr;
  this->Make([](const Vector& at)
    { return at[0] < Voxels / 2 ? std::numeric_limits<double>::quiet_NaN() : at[2]; });
  expectHalf("scalars that are no numbers");
}

// Codes stand for values, of which the surface is one.
TEST_F(SurfaceLight, CodesHaveTheSurfacesOfTheirValues)
{
  std::array<double, vtkTextureSliceCodes::Count> values{};
  const std::array<unsigned char, vtkTextureSliceCodes::Count> hidden{};
  for (std::size_t code = 0; code < values.size(); ++code)
  {
    values[code] = 0.5 * static_cast<double>(code) - 33.0;
  }
  vtkNew<vtkUnsignedCharArray> codes;
  codes->SetNumberOfValues(vtkIdType{Voxels} * Voxels * Voxels);
  for (vtkIdType id = 0; id < codes->GetNumberOfValues(); ++id)
  {
    codes->SetValue(id, static_cast<unsigned char>(id / (Voxels * Voxels)));
  }
  this->Source.Scalars = {
    codes, {Voxels, Voxels, Voxels}, false, nullptr, vtkTextureSliceCodes(values, hidden)};
  this->Source.Surfaces = {{-24.9f, DepthOf(0.5)}, {16.2f, 16.0f}};
  this->Build({0, 0, 1});
  EXPECT_NEAR(this->At(16, 16, 2), 0.5, 1e-4);
  EXPECT_EQ(this->At(16, 16, 29), 1.0);
}

// All directions but the three lowest reach the surface before the sides of the volume.
TEST_F(SurfaceLight, OcclusionIsTheMeanOverTheSky)
{
  this->Make([](const Vector& at) { return at[2]; });
  this->Source.Surfaces = {{28.5f, DepthOf(0.5)}};
  Lights lights;
  lights.Occlusion = true;
  this->Volume.Build({this->Source, std::size_t{Voxels} * Voxels * Voxels}, lights);
  constexpr vtkIdType index = (27 * Voxels + 16) * Voxels + 16;
  constexpr double directions = vtkTextureSliceLightVolume::SkyDirectionsOfSurfaces;
  EXPECT_NEAR(this->Volume.GetLight()->GetValue(2 * index + 1),
    1.0 - 0.5 * (directions - 3.0) / directions, 1e-3);
}
