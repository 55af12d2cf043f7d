// SPDX-License-Identifier: BSD-3-Clause
#include "Scenes.h"

#include "vtkColorTransferFunction.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkRectilinearGrid.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace nexrad::testing
{

namespace
{

constexpr double NoEcho = -33.0;

/// dBZ at a point of the unit cube.
double StormReflectivity(double x, double y, double z)
{
  const auto blob = [&](double cx, double cy, double cz, double rx, double rz, double peak)
  {
    const double r2 =
      ((x - cx) * (x - cx) + (y - cy) * (y - cy)) / (rx * rx) + (z - cz) * (z - cz) / (rz * rz);
    return peak * std::exp(-r2);
  };
  const double echo =
    std::max({blob(0.35, 0.40, 0.30, 0.11, 0.45, 66.0), blob(0.42, 0.44, 0.78, 0.26, 0.12, 38.0),
      blob(0.70, 0.66, 0.25, 0.08, 0.35, 54.0), blob(0.55, 0.30, 0.15, 0.40, 0.14, 24.0)});
  return echo > 5.0 ? echo : NoEcho;
}

double ScalarOf(double dBZ, int scalarType)
{
  return scalarType == VTK_FLOAT || scalarType == VTK_DOUBLE ? dBZ : std::round(dBZ - NoEcho);
}

} // namespace

vtkSmartPointer<vtkImageData> MakeStorm(int size, int scalarType, int height)
{
  height = height > 0 ? height : size / 2;
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(size, size, height);
  image->SetSpacing(64.0 / (size - 1), 64.0 / (size - 1), 24.0 / (height - 1));
  image->SetOrigin(-32.0, -32.0, 0.0);
  image->AllocateScalars(scalarType, 1);
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  vtkIdType id = 0;
  for (int k = 0; k < height; ++k)
  {
    for (int j = 0; j < size; ++j)
    {
      for (int i = 0; i < size; ++i, ++id)
      {
        const double dBZ = StormReflectivity(
          double(i) / (size - 1), double(j) / (size - 1), double(k) / (height - 1));
        scalars->SetComponent(id, 0, ScalarOf(dBZ, scalarType));
      }
    }
  }
  return image;
}

void SetStormFunctions(vtkVolumeProperty* property, int scalarType)
{
  const auto at = [&](double dBZ)
  { return scalarType == VTK_FLOAT || scalarType == VTK_DOUBLE ? dBZ : dBZ - NoEcho; };
  vtkNew<vtkColorTransferFunction> color;
  color->AddRGBPoint(at(5), 0.02, 0.91, 0.91);
  color->AddRGBPoint(at(20), 0.01, 0.60, 0.96);
  color->AddRGBPoint(at(30), 0.01, 0.80, 0.01);
  color->AddRGBPoint(at(40), 0.99, 0.97, 0.01);
  color->AddRGBPoint(at(50), 0.99, 0.10, 0.00);
  color->AddRGBPoint(at(60), 0.97, 0.00, 0.99);
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(at(5), 0.0);
  opacity->AddPoint(at(20), 0.03);
  opacity->AddPoint(at(40), 0.15);
  opacity->AddPoint(at(60), 0.6);
  property->SetColor(color);
  property->SetScalarOpacity(opacity);
  property->SetScalarOpacityUnitDistance(1.0);
  property->SetInterpolationTypeToLinear();
}

vtkSmartPointer<vtkImageData> MakeUniformCube(int points, float value)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(points, points, points);
  image->AllocateScalars(VTK_FLOAT, 1);
  image->GetPointData()->GetScalars()->Fill(double(value));
  return image;
}

vtkSmartPointer<vtkRectilinearGrid> MakeRod(int points, double side)
{
  auto rod = vtkSmartPointer<vtkRectilinearGrid>::New();
  rod->SetDimensions(points, 2, 2);
  std::array<vtkNew<vtkDoubleArray>, 3> coordinates;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const int last = (axis == 0 ? points : 2) - 1;
    for (int i = 0; i <= last; ++i)
    {
      coordinates[axis]->InsertNextValue(side * i / last);
    }
  }
  rod->SetXCoordinates(coordinates[0]);
  rod->SetYCoordinates(coordinates[1]);
  rod->SetZCoordinates(coordinates[2]);
  vtkNew<vtkUnsignedCharArray> scalars;
  scalars->SetNumberOfTuples(rod->GetNumberOfPoints());
  scalars->Fill(1.0);
  rod->GetPointData()->SetScalars(scalars);
  return rod;
}

void SetUniformFunctions(vtkVolumeProperty* property, double opacity)
{
  vtkNew<vtkColorTransferFunction> color;
  color->AddRGBPoint(0.0, 1.0, 1.0, 1.0);
  vtkNew<vtkPiecewiseFunction> alpha;
  alpha->AddPoint(0.0, opacity);
  property->SetColor(color);
  property->SetScalarOpacity(alpha);
  property->SetScalarOpacityUnitDistance(1.0);
  property->SetInterpolationTypeToLinear();
}

} // namespace nexrad::testing
