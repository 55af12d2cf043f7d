// SPDX-License-Identifier: BSD-3-Clause
// Which ranges of scalars an opacity table shows.
#ifndef vtkTextureSliceVisibility_h
#define vtkTextureSliceVisibility_h

#include <algorithm>
#include <cstddef>
#include <vector>

/**
 * Tells at once, whatever the range, whether an opacity function shows any scalar of it. It keeps
 * how many entries of the function's table before each one are visible. Scalars are 0 at the first
 * entry and 1 at the last.
 */
class vtkTextureSliceVisibility
{
public:
  /// @param opacities one for each entry; those above 0 are visible.
  explicit vtkTextureSliceVisibility(const std::vector<float>& opacities)
  {
    for (const float opacity : opacities)
    {
      this->VisibleBefore.push_back(this->VisibleBefore.back() + (opacity > 0.0f ? 1 : 0));
    }
  }

  /// Whether a scalar from low to high can be visible, its neighbours in the table included.
  bool IsVisible(double low, double high) const
  {
    constexpr double lookupError = 0.02; // of the graphics hardware, in entries
    // An entry's influence reaches to its neighbours; beyond the ends the last ones hold.
    const double last = static_cast<double>(this->VisibleBefore.size() - 2);
    const double first = std::clamp(low * last - lookupError, 0.0, last);
    const double end = std::clamp(high * last + lookupError + 1.0, 0.0, last);
    return low <= high && this->VisibleBefore[static_cast<std::size_t>(end) + 1] >
                            this->VisibleBefore[static_cast<std::size_t>(first)];
  }

private:
  /// Visible entries before each one; one more than there are entries.
  std::vector<std::size_t> VisibleBefore{0};
};

#endif
