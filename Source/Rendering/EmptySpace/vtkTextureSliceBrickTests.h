// SPDX-License-Identifier: BSD-3-Clause
// Which bricks of a volume a request can show something of.
#ifndef vtkTextureSliceBrickTests_h
#define vtkTextureSliceBrickTests_h

#include "vtkTextureSliceBricks.h"
#include "vtkTextureSliceEmptySpace.h"

#include <functional>
#include <vector>

/**
 * A brick counts if one of the tests is true. Each is given the ranges of the scalars of a brick,
 * one for each component, and knows what the blend mode asks:
 *
 * - composite: the opacities of the functions are above 0 somewhere in the range; of
 *   two-dimensional functions, at some gradient;
 * - maximum, minimum: the same, of all that a brick's scalars could hide;
 * - additive: the same as composite; a sample without opacity adds 0;
 * - average: the scalars that the average counts, whatever their opacity;
 * - isosurface: an iso-value is in the range.
 */
namespace vtkTextureSliceBrickTests
{

using Test = std::function<bool(const vtkTextureSliceBricks::Range* ranges)>;

/// The request's component functions decide; those of labels as well.
std::vector<Test> Make(const vtkTextureSliceEmptySpace::Source& source);

} // namespace vtkTextureSliceBrickTests

#endif
