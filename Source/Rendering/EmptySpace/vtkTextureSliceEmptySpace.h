// SPDX-License-Identifier: BSD-3-Clause
// What of a volume a request leaves invisible.
#ifndef vtkTextureSliceEmptySpace_h
#define vtkTextureSliceEmptySpace_h

#include "vtkTextureSliceDistanceMap.h"
#include "vtkType.h"

#include <array>
#include <string>
#include <tuple>
#include <vector>

struct vtkTextureSliceUniforms;

/**
 * Marks the bricks of a volume that can add to the picture. Changes of the functions alone cost a
 * look at each brick, not at each voxel. What counts depends on the blend mode:
 *
 * - composite: the opacities of the functions, or of a label's, are above 0 somewhere in the range
 *   of a brick's scalars; of two-dimensional functions, at some gradient;
 * - maximum, minimum: the same, of all that a brick's scalars could hide;
 * - additive: the same as composite; a sample without opacity adds 0;
 * - average: the scalars that the average counts, whatever their opacity;
 * - isosurface: an iso-value is in the range.
 */
class vtkTextureSliceEmptySpace
{
public:
  /// Does nothing where nothing has changed of the scalars, the functions and the cropping.
  void Update(const vtkTextureSliceUniforms& source);

  /// How far it is to the next visible brick.
  vtkTextureSliceDistanceMap& GetDistances() { return this->Distances; }
  /// Whether so much is empty that looking for it costs less than it saves.
  bool IsSkippingWorthwhile() const
  {
    constexpr double mostVisible = 0.75;
    return this->Distances.GetVisibleShare() < mostVisible;
  }
  /// Where all that can be seen lies: lower x, upper x, lower y and so on, in box coordinates.
  const std::array<double, 6>& GetSeen() const { return this->Seen; }
  /// Whether no sample can be seen.
  bool IsNothingVisible() const { return this->Distances.GetVisibleShare() <= 0.0; }

private:
  /// All that the answers depend on, the order that of MakeKey.
  using Key =
    std::tuple<vtkMTimeType, vtkMTimeType, vtkMTimeType, vtkMTimeType, std::array<double, 2>,
      std::vector<double>, std::string, bool, std::array<float, 3>, std::array<float, 3>, int>;
  static Key MakeKey(const vtkTextureSliceUniforms& source);

  void FindVisible(const vtkTextureSliceUniforms& source);
  void HideCropped(const vtkTextureSliceUniforms& source);

  Key Last;
  std::array<double, 3> Edge{}; ///< of the bricks that the distances are of
  vtkTextureSliceDistanceMap Distances;
  std::array<double, 6> Seen{0, 1, 0, 1, 0, 1};
  std::vector<unsigned char> Visible; ///< not 0 where a brick counts
};

#endif
