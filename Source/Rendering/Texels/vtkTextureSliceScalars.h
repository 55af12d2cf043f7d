// SPDX-License-Identifier: BSD-3-Clause
// The scalars of a volume, and what hides some of them.
#ifndef vtkTextureSliceScalars_h
#define vtkTextureSliceScalars_h

#include "vtkTextureSliceCodes.h"

#include <array>
#include <optional>
#include <vector>

class vtkDataArray;
class vtkImageData;
class vtkUnsignedCharArray;

/// One texel for each point, or each cell.
struct vtkTextureSliceScalars
{
  vtkDataArray* Scalars = nullptr;
  /// Texels along each axis: points, or cells.
  std::array<int, 3> Size{};
  bool CellData = false;
  /// Every flag hides a texel, as in VTK's ray caster. May be nullptr: nothing is hidden.
  vtkUnsignedCharArray* Ghosts = nullptr;
  /// What the scalars stand for where they are codes.
  std::optional<vtkTextureSliceCodes> Codes = {};
  /// Where the points of a rectilinear grid lie in the box, 0 to 1 along each axis; empty: evenly.
  std::array<std::vector<double>, 3> Places = {};

  /// Texels of an image along each axis.
  static std::array<int, 3> GetSize(vtkImageData* image, bool cellData);
  /// The ghost array of an image's points or cells if it has one flag for each; or nullptr.
  static vtkUnsignedCharArray* FindGhosts(vtkImageData* image, bool ofCells);
  /// An array of an image, with the image's ghost array if that has one flag for each texel.
  static vtkTextureSliceScalars Find(vtkImageData* image, vtkDataArray* scalars, bool cellData);
};

#endif
