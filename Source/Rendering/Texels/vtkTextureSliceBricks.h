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

/**
 * A volume cut into small bricks of voxels (the last ones along an axis may be shorter; those of a
 * rectilinear grid are equal parts of its box, and touch as many voxels as lie there), and for
 * each the least and the greatest scalar that a sample inside it can meet: those on its faces, or
 * just outside where cell scalars are interpolated across them, count as well. Points (or cells)
 * that are hidden, or of which a component is not finite, do not count.
 */
class VTKNEXRADRENDERING_EXPORT vtkTextureSliceBricks
{
public:
  /// Low is above High where there is nothing that counts.
  struct Range
  {
    double Low = std::numeric_limits<double>::infinity();
    double High = -std::numeric_limits<double>::infinity();

    bool operator==(const Range& other) const
    {
      return this->Low == other.Low && this->High == other.High;
    }
  };

  /// Goes once over all scalars, on several threads.
  void Build(const vtkTextureSliceScalars& source);

  /// Bricks along each axis.
  const std::array<int, 3>& GetCount() const { return this->Count; }
  /// Their edges in box coordinates (0 to 1 along each axis).
  const std::array<double, 3>& GetEdge() const { return this->Edge; }
  /// One for each component of each brick; the component varies fastest, then x.
  const std::vector<Range>& GetRanges() const { return this->Ranges; }
  /// Whether there are texels that do not count.
  bool HasInvisible() const { return this->Invisible; }
  vtkMTimeType GetBuildTime() const { return this->BuildTime.GetMTime(); }

private:
  std::array<int, 3> Count{};
  std::array<double, 3> Edge{};
  std::vector<Range> Ranges;
  bool Invisible = false;
  vtkTimeStamp BuildTime;
};

#endif
