// SPDX-License-Identifier: BSD-3-Clause
// How much light arrives in each cell of a volume from given directions.
#ifndef vtkTextureSliceLightSweep_h
#define vtkTextureSliceLightSweep_h

#include "vtkNexradRenderingModule.h" // for the export macro
#include "vtkTextureSliceLightGrid.h"
#include "vtkTextureSliceSurfaceScalars.h"

#include <array>
#include <vector>

class vtkTextureSliceExtinction;

/**
 * The sum, over directions, of the transmittance exp(-integral of the extinction) from the centre
 * of each cell to where the direction leaves the volume (Formulas L2).
 *
 * A direction is followed plane by plane of cells, from where it enters, along the axis on which it
 * takes the fewest steps. Parallel rays, one cell apart, keep the depths that they have come
 * through; a plane's extinction is interpolated to where the rays cross it, and the transmittance
 * of the rays to the centres of its cells. So light is interpolated twice however long its way is,
 * and shadows have the same edges far from what casts them as near to it.
 *
 * Of isosurfaces, the scalars are interpolated to the rays. A ray crosses a surface between two
 * planes where its scalars lie on either side of the value, and loses what the surface takes: the
 * same whatever the size of the cells.
 */
class VTKNEXRADRENDERING_EXPORT vtkTextureSliceLightSweep
{
public:
  using Surface = vtkTextureSliceSurfaceScalars::Surface;

  /// What the arguments hold must stay as long as the sweep.
  explicit vtkTextureSliceLightSweep(const vtkTextureSliceExtinction& extinction);
  vtkTextureSliceLightSweep(
    const vtkTextureSliceSurfaceScalars& scalars, const std::vector<Surface>& surfaces);

  /**
   * Adds the transmittance times a weight, on several threads.
   * @param towards to the light, in data lengths along the axes of the volume; of any length but 0.
   */
  void Add(const std::array<double, 3>& towards, double weight);

  /// The sums, x varying fastest, and starts anew from 0.
  std::vector<float> TakeSums();

private:
  /// Extinctions (or scalars) and sums in one order of the axes. All round the extinctions stand
  /// those of the outermost cells once more.
  struct Layout
  {
    std::array<std::size_t, 3> Axes{0, 1, 2}; ///< the first varies fastest
    std::vector<float> Extinctions;
    std::vector<float> Sums;
  };
  /// A direction as steps from plane to plane.
  struct Course;

  Layout& Prepare(Layout& layout) const;
  Course FindCourse(const std::array<double, 3>& towards);
  static void SweepRows(const Course& course, int begin, int end);

  const vtkTextureSliceLightGrid& Grid;
  const std::vector<float>& Values;
  const std::vector<Surface> Surfaces; ///< none: the values are extinctions
  Layout RowsAlongX{{0, 1, 2}, {}, {}};
  Layout RowsAlongY{{1, 0, 2}, {}, {}};
};

#endif
