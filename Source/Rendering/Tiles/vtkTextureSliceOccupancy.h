// SPDX-License-Identifier: BSD-3-Clause
// Where in the volume there is something to see.
#ifndef vtkTextureSliceOccupancy_h
#define vtkTextureSliceOccupancy_h

#include "vtkNexradRenderingModule.h" // for the export macro

#include <array>
#include <cstddef>
#include <vector>

/**
 * Bricks of the volume, each visible or not, and at once, for any box, whether it touches visible
 * ones: the number of visible bricks from the corner of the volume to each brick is kept.
 */
class VTKNEXRADRENDERING_EXPORT vtkTextureSliceOccupancy
{
public:
  enum class Share
  {
    Nothing,
    Something,
    Everything
  };

  /// One visible brick, the whole volume.
  vtkTextureSliceOccupancy();

  /**
   * @param count bricks along each axis.
   * @param edge a brick's edges in box coordinates (0 to 1 along each axis); the last brick along
   * an axis may be shorter.
   * @param visible not 0 for visible bricks, x fastest.
   */
  void Build(const std::array<int, 3>& count, const std::array<double, 3>& edge,
    const std::vector<unsigned char>& visible);
  /**
   * After Build: bricks of different edges.
   * @param borders where each brick begins in box coordinates, and where the last one ends.
   * @param margin what a sample's position may err by.
   */
  void SetBorders(std::array<std::vector<double>, 3> borders, double margin);

  /// How much a part of the box, in box coordinates, touches of visible bricks. What lies outside
  /// the box does not count.
  Share Find(const std::array<double, 3>& low, const std::array<double, 3>& high) const;

private:
  std::size_t At(int x, int y, int z) const
  {
    return (static_cast<std::size_t>(z) * (this->Count[1] + 1) + y) * (this->Count[0] + 1) + x;
  }

  /// The brick between two borders in which a place of the box lies.
  int FindBrick(std::size_t axis, double place) const;

  std::array<int, 3> Count{1, 1, 1};
  std::array<std::vector<double>, 3> Borders; ///< none: all bricks have the same edges
  double Margin = 0.0;
  std::array<double, 3> PerBox{1.0, 1.0, 1.0}; ///< bricks of full size in the box
  /// Visible bricks before x, y and z; one more than there are bricks along each axis.
  std::vector<int> VisibleBefore;
};

#endif
