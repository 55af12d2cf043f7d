// SPDX-License-Identifier: BSD-3-Clause
// Volumes and transfer functions that the tests draw, all from formulas.
#pragma once

#include "vtkSmartPointer.h"

class vtkImageData;
class vtkRectilinearGrid;
class vtkVolumeProperty;

namespace nexrad::testing
{

/**
 * A storm in dBZ: two towers with anvils over a weak stratiform layer, -33 where there is no echo.
 * @param size points along x and y.
 * @param height points along z; 0: half as many.
 * @param scalarType VTK_FLOAT for dBZ as they are; an integer type rounds them after adding 33.
 */
vtkSmartPointer<vtkImageData> MakeStorm(int size, int scalarType, int height = 0);
/// Colours and opacities for MakeStorm, in steps of reflectivity as weather maps have them.
void SetStormFunctions(vtkVolumeProperty* property, int scalarType);

/// A cube of points one unit apart, all of one float value, from the origin on.
vtkSmartPointer<vtkImageData> MakeUniformCube(int points, float value);
/// A grid of so many by two by two points with the scalar 1, in a cube from the origin on.
vtkSmartPointer<vtkRectilinearGrid> MakeRod(int points, double side);
/// White, of that opacity per unit, whatever the scalar.
void SetUniformFunctions(vtkVolumeProperty* property, double opacity);

} // namespace nexrad::testing
