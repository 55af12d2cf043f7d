// SPDX-License-Identifier: BSD-3-Clause
// How much light arrives in each cell of a volume from a given direction.
#ifndef vtkTextureSliceLightSweep_h
#define vtkTextureSliceLightSweep_h

#include <array>
#include <vector>

class vtkTextureSliceLightCells;

/**
 * The transmittance exp(-integral of the extinction) from the centre of each cell to where a
 * direction leaves the volume (Formulas L2).
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
class vtkTextureSliceLightSweep
{
public:
  /**
   * Adds the transmittance times a weight to the sum of each cell, x varying fastest, on several
   * threads.
   * @param towards to the light, in data lengths along the axes of the volume; of any length but 0.
   */
  static void Add(const vtkTextureSliceLightCells& cells, const std::array<double, 3>& towards,
    double weight, std::vector<float>& sums);
};

#endif
