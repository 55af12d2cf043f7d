// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vtkSmartPointer.h"

class vtkImageData;
class vtkInformation;

/// Asks the input of a filter for the part of the volume that the filter's process has anyway: the
/// field data of each part are those of the whole.
void AskForOwnPart(vtkInformation* input, vtkInformation* output);

/// The whole volume of which a pipeline has a part, without voxels: its place, its size and its
/// field data.
vtkSmartPointer<vtkImageData> DescribeWhole(vtkInformation* input);

/// The volume of which each process has a part, with at most 128 voxels along x and along y: the
/// same in all processes, which must all call this. Values are floats of its scalars' name, very
/// low ones where no process has any.
vtkSmartPointer<vtkImageData> GatherThinned(vtkImageData* part, vtkImageData* whole);
