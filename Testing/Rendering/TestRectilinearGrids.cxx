// SPDX-License-Identifier: BSD-3-Clause
// Rectilinear grids beside images that hold the same field, and beside VTK's GPU ray caster.
#include "RayCasterComparison.h"
#include "Scenes.h"
#include "Tolerance.h"

#include "vtkCellData.h"
#include "vtkContourValues.h"
#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkRectilinearGrid.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <array>
#include <vector>

namespace
{

using namespace nexrad::testing;

class RectilinearGrids : public StormAgainstRayCaster
{
protected:
  /**
   * The storm with more points: between some of them, the more of them the farther along an axis,
   * there are others, whose scalars are interpolated. So the field is the same.
   * @param most points between two that were there before.
   */
  vtkSmartPointer<vtkRectilinearGrid> MakeGrid(int most)
  {
    const int* n = this->Input->GetDimensions();
    std::array<std::vector<double>, 3> places; // in the indices of the image
    auto grid = vtkSmartPointer<vtkRectilinearGrid>::New();
    std::array<vtkNew<vtkFloatArray>, 3> coordinates;
    for (int axis = 0; axis < 3; ++axis)
    {
      const auto a = static_cast<std::size_t>(axis);
      for (int i = 0; i < n[axis]; ++i)
      {
        const int between = i + 1 < n[axis] ? most * i / n[axis] : 0;
        for (int k = 0; k <= between; ++k)
        {
          places[a].push_back(i + double(k) / (between + 1));
          coordinates[a]->InsertNextValue(static_cast<float>(
            this->Input->GetOrigin()[axis] + places[a].back() * this->Input->GetSpacing()[axis]));
        }
      }
    }
    grid->SetDimensions(static_cast<int>(places[0].size()), static_cast<int>(places[1].size()),
      static_cast<int>(places[2].size()));
    grid->SetXCoordinates(coordinates[0]);
    grid->SetYCoordinates(coordinates[1]);
    grid->SetZCoordinates(coordinates[2]);
    vtkNew<vtkFloatArray> scalars;
    for (const double z : places[2])
    {
      for (const double y : places[1])
      {
        for (const double x : places[0])
        {
          scalars->InsertNextValue(static_cast<float>(this->Interpolate(x, y, z)));
        }
      }
    }
    grid->GetPointData()->SetScalars(scalars);
    return grid;
  }

  /// The storm's scalar between its points.
  double Interpolate(double x, double y, double z)
  {
    const std::array<double, 3> place{x, y, z};
    double sum = 0.0;
    for (int corner = 0; corner < 8; ++corner)
    {
      double weight = 1.0;
      std::array<int, 3> index;
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        const int below = static_cast<int>(place[axis]);
        const double beyond = place[axis] - below;
        const bool upper = (corner >> axis & 1) != 0;
        weight *= upper ? beyond : 1.0 - beyond;
        index[axis] = upper ? below + 1 : below;
      }
      if (weight > 0.0)
      {
        sum += weight * this->Input->GetScalarComponentAsDouble(index[0], index[1], index[2], 0);
      }
    }
    return sum;
  }

  Picture Draw(vtkDataSet* input)
  {
    this->Slices->SetInputDataObject(input);
    return this->Stage->Draw(this->Slices);
  }
  /// Draws the storm as an image and as a grid.
  void ExpectSameField(const std::string& name, double bound = 0.1)
  {
    this->Slices->SetNumberOfSlices(256);
    this->Slices->AutoAdjustSampleDistancesOff();
    const Picture background = this->Stage->Draw(nullptr);
    const Picture image = this->Draw(this->Input);
    const Picture grid = this->Draw(this->MakeGrid(4));
    WritePicture(grid, name);
    const Difference difference = Compare(grid, image, background);
    EXPECT_GT(difference.Pixels, 1000);
    EXPECT_AT_MOST(difference.LargestMean(), bound,
      name + ": mean difference of the grid to the image, of 255", OneCode);
  }
};

} // namespace

// Points of equal distances: an image.
TEST_F(RectilinearGrids, EqualDistances)
{
  this->Slices->SetNumberOfSlices(256);
  const Picture background = this->Stage->Draw(nullptr);
  const Picture image = this->Draw(this->Input);
  const Difference difference = Compare(this->Draw(this->MakeGrid(0)), image, background);
  EXPECT_AT_MOST(difference.LargestMean(), 0.1,
    "points of equal distances: mean difference of the grid to the image, of 255", OneCode);
}

// Points are up to five times as close in the north-east and above as in the south-west and below.
TEST_F(RectilinearGrids, UnequalDistances)
{
  this->ExpectSameField("grid-composite");
}

TEST_F(RectilinearGrids, CroppedToTheCorners)
{
  this->Slices->CroppingOn();
  this->Slices->SetCroppingRegionPlanes(-20.0, 8.0, -25.0, 12.0, 4.0, 20.0);
  this->Slices->SetCroppingRegionFlags(0x5145145); // the corners, and the middle
  this->ExpectSameField("grid-cropped");
}

TEST_F(RectilinearGrids, Integrated)
{
  this->Slices->PreIntegrationOn();
  this->ExpectSameField("grid-integrated");
}

TEST_F(RectilinearGrids, MaximumAndIsosurface)
{
  this->Slices->SetBlendModeToMaximumIntensity();
  this->ExpectSameField("grid-maximum");
  this->Slices->SetBlendModeToIsoSurface();
  this->Stage->GetProperty()->GetIsoSurfaceValues()->SetValue(0, 20.0);
  this->ExpectSameField("grid-isosurface");
}

// Dense, so that what is behind opaque pixels is left out.
TEST_F(RectilinearGrids, Opaque)
{
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(10.0, 0.0);
  opacity->AddPoint(11.0, 1.0);
  this->Stage->GetProperty()->SetScalarOpacity(opacity);
  this->ExpectSameField("grid-opaque");
}

// Scalars of cells, between planes of unequal distances: each cell is cut where the grid says. The
// cells of the image are cut into two, of which one has a quarter of the width.
TEST_F(RectilinearGrids, Cells)
{
  this->Stage->GetProperty()->SetInterpolationTypeToNearest();
  vtkNew<vtkImageData> cells;
  vtkNew<vtkRectilinearGrid> grid;
  const int* n = this->Input->GetDimensions();
  cells->SetDimensions(n[0] + 1, n[1] + 1, n[2] + 1);
  cells->SetSpacing(this->Input->GetSpacing());
  cells->SetOrigin(this->Input->GetOrigin());
  cells->GetCellData()->SetScalars(this->Input->GetPointData()->GetScalars());
  grid->SetDimensions(2 * n[0] + 1, n[1] + 1, n[2] + 1);
  std::array<vtkNew<vtkFloatArray>, 3> coordinates;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int i = 0; i <= n[axis]; ++i)
    {
      const auto place = [&](double index)
      { return static_cast<float>(cells->GetOrigin()[axis] + index * cells->GetSpacing()[axis]); };
      coordinates[static_cast<std::size_t>(axis)]->InsertNextValue(place(i));
      if (axis == 0 && i < n[axis])
      {
        coordinates[0]->InsertNextValue(place(i + 0.25));
      }
    }
  }
  grid->SetXCoordinates(coordinates[0]);
  grid->SetYCoordinates(coordinates[1]);
  grid->SetZCoordinates(coordinates[2]);
  vtkNew<vtkFloatArray> scalars;
  vtkDataArray* values = this->Input->GetPointData()->GetScalars();
  for (vtkIdType id = 0; id < 2 * values->GetNumberOfTuples(); ++id)
  {
    scalars->InsertNextValue(static_cast<float>(values->GetComponent(id / 2, 0)));
  }
  grid->GetCellData()->SetScalars(scalars);
  this->Slices->SetNumberOfSlices(256);
  const Picture background = this->Stage->Draw(nullptr);
  const Picture image = this->Draw(cells);
  const Difference difference = Compare(this->Draw(grid), image, background);
  EXPECT_GT(difference.Pixels, 1000);
  EXPECT_AT_MOST(difference.LargestMean(), 0.1,
    "cells: mean difference of the grid to the image, of 255", OneCode);
}

// The light comes from gradients over the mean distance of the points.
TEST_F(RectilinearGrids, Lit)
{
  this->Stage->GetProperty()->ShadeOn();
  this->ExpectSameField("grid-lit", 0.55);
}

// The light volume has cells of one size: a grid has no shadows, and an image drawn after it has.
TEST_F(RectilinearGrids, NoShadows)
{
  this->Slices->SetNumberOfSlices(64);
  const auto grid = this->MakeGrid(2);
  const Picture background = this->Stage->Draw(nullptr);
  const Picture plain = this->Draw(grid);
  this->Slices->SetShadowStrength(1.0);
  EXPECT_EQ(Compare(this->Draw(grid), plain, background).Worst, 0.0);
  EXPECT_EQ(this->Slices->GetLightVolume(), nullptr);
  this->Draw(this->Input);
  EXPECT_NE(this->Slices->GetLightVolume(), nullptr);
}

// VTK 9.1's ray caster takes a coordinate half a voxel before the right one, and its light does not
// know the coordinates.
TEST_F(RectilinearGrids, BesideTheRayCaster)
{
  const auto grid = this->MakeGrid(4);
  const Picture background = this->Stage->Draw(nullptr);
  this->RayCaster->AutoAdjustSampleDistancesOff();
  this->RayCaster->SetSampleDistance(0.3f);
  this->RayCaster->SetInputDataObject(grid);
  const Picture expected = this->Stage->Draw(this->RayCaster);
  WritePicture(expected, "grid-rays");
  this->Slices->SetNumberOfSlices(256);
  EXPECT_AT_MOST(Compare(this->Draw(grid), expected, background).LargestMean(), 5.0,
    "grid: mean difference to the ray caster, of 255");
}
