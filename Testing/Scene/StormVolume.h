// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Grid/GriddedVolume.h"

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <filesystem>

namespace nexrad::testing
{

/// A small merged volume over eastern Missouri as the project's filters make them: 48 × 48 × 16
/// voxels of 10 km × 10 km × 1.25 km with a storm of 62 dBZ that stands 15 km high in the south
/// west quarter, and the sites KLSX and KILX. Marked as synthetic when asked.
GriddedVolume MakeStorm(bool synthetic);
/// Its field in dBZ; x and y in km east and north of the centre, the height in km. Voxels at or
/// below 0 dBZ have no echo.
double Storm(double x, double y, double height);
vtkSmartPointer<vtkImageData> MakeStormVolume(bool synthetic);

/// The same storm, marked as synthetic, at `steps` times five minutes apart, in which it moves 20
/// km to the east from one to the next. Written to a folder as .nxv files; returns their index.
std::filesystem::path WriteStormFiles(const std::filesystem::path& folder, int steps);

/// The storm of MakeStorm in 2100 × 64 × 16 voxels of 229 m × 7.5 km × 1.25 km.
GriddedVolume MakeLargeStorm();
/// It as a .nxv file in bricks, in folder/large.nxv, with coarser levels of 1050 × 32, 525 × 16 and
/// 263 × 8 columns; its path.
std::filesystem::path WriteLargeStorm(const std::filesystem::path& folder);

/// The storm, and velocities from −24 to 24 m/s in it, as one .nxv file of REF and VEL; its path.
std::filesystem::path WriteTwoMoments(const std::filesystem::path& folder);

} // namespace nexrad::testing
