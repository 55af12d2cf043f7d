// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTextureSliceVisibility.h"

#include <algorithm>
#include <cmath>

namespace
{

/// What the graphics hardware may err by when it looks an entry up, in entries.
constexpr double LookupError = 0.02;

} // namespace

void vtkTextureSliceVisibility::Build(const float* opacities, std::size_t entries,
  std::size_t stride, const std::function<bool(float)>& isShown)
{
  this->VisibleBefore.assign(1, 0);
  for (std::size_t i = 0; i < entries; ++i)
  {
    this->VisibleBefore.push_back(
      this->VisibleBefore.back() + (isShown(opacities[i * stride]) ? 1 : 0));
  }
}

bool vtkTextureSliceVisibility::IsVisible(double low, double high) const
{
  if (!(low <= high))
  {
    return false;
  }
  // An entry's influence reaches to its neighbours; beyond the ends the last ones hold.
  const double last = static_cast<double>(this->VisibleBefore.size() - 2);
  const double first = std::clamp(std::floor(low * last - LookupError), 0.0, last);
  const double end = std::clamp(std::ceil(high * last + LookupError), 0.0, last) + 1.0;
  return this->VisibleBefore[static_cast<std::size_t>(end)] >
         this->VisibleBefore[static_cast<std::size_t>(first)];
}
