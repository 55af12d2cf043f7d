// SPDX-License-Identifier: BSD-3-Clause
// Which ranges of scalars an opacity table shows.
#ifndef vtkTextureSliceVisibility_h
#define vtkTextureSliceVisibility_h

#include "vtkNexradRenderingModule.h" // for the export macro

#include <cstddef>
#include <functional>
#include <vector>

/**
 * Tells at once, whatever the range, whether an opacity function shows any scalar of it. It keeps
 * how many entries of the function's table before each one are visible. Scalars are 0 at the first
 * entry and 1 at the last.
 */
class VTKNEXRADRENDERING_EXPORT vtkTextureSliceVisibility
{
public:
  /**
   * @param opacities one for each entry, every stride-th of these floats.
   * @param isShown which opacities count as visible.
   */
  void Build(const float* opacities, std::size_t entries, std::size_t stride,
    const std::function<bool(float)>& isShown);

  /// Whether a scalar from low to high can be visible, its neighbours in the table included.
  bool IsVisible(double low, double high) const;

private:
  /// Visible entries before each one; one more than there are entries.
  std::vector<std::size_t> VisibleBefore{0, 1};
};

#endif
