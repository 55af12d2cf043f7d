// SPDX-License-Identifier: BSD-3-Clause
// The ranges of the scalars in each small part of a volume.
#ifndef vtkTextureSliceBricks_h
#define vtkTextureSliceBricks_h

#include "vtkNexradRenderingModule.h" // for the export macro
#include "vtkTextureSliceScalars.h"
#include "vtkTimeStamp.h"

#include <array>
#include <limits>
#include <vector>

/// A volume cut into small bricks of voxels (those of a rectilinear grid are equal parts of its
/// box), and for each the least and the greatest scalar that a sample inside it can meet: those on
/// its faces, or just outside where cell scalars are interpolated across them, count as well.
/// Points (or cells) that are hidden, or of which a component is not finite, do not count.
struct VTKNEXRADRENDERING_EXPORT vtkTextureSliceBricks
{
  /// Low is above High where there is nothing that counts.
  struct Range
  {
    double Low = std::numeric_limits<double>::infinity();
    double High = -std::numeric_limits<double>::infinity();
  };

  /// Goes once over all scalars, on several threads.
  void Build(const vtkTextureSliceScalars& source);

  std::array<int, 3> Count{};   ///< along each axis
  std::array<double, 3> Edge{}; ///< in box coordinates (0 to 1 along each axis)
  /// One for each component of each brick; the component varies fastest, then x.
  std::vector<Range> Ranges;
  bool HasInvisible = false; ///< texels that do not count
  vtkMTimeType BuildTime = 0;
};

#endif
