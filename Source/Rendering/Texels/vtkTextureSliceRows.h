// SPDX-License-Identifier: BSD-3-Clause
// What the looks at all texels of a volume share: they go along rows, in loops that a compiler can
// do for many texels at a time.
#ifndef vtkTextureSliceRows_h
#define vtkTextureSliceRows_h

#include "vtkDataArray.h"
#include "vtkTextureSliceScalars.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>

namespace vtkTextureSlice
{

/// A volume's scalars and ghost flags row by row. The source must stay as it is meanwhile.
template <typename Scalar>
class Rows
{
public:
  explicit Rows(const vtkTextureSliceScalars& source)
    : Length(static_cast<std::size_t>(source.Size[0]))
    , Components(static_cast<std::size_t>(source.Scalars->GetNumberOfComponents()))
    , Height(static_cast<std::size_t>(source.Size[1]))
    , Scalars(static_cast<const Scalar*>(source.Scalars->GetVoidPointer(0)))
    , Ghosts(source.Ghosts != nullptr ? source.Ghosts->GetPointer(0) : nullptr)
    , VisibleCodes(source.Codes ? source.Codes->GetVisible() : nullptr)
    , CodeInterval(
        source.Codes ? source.Codes->FindInterval() : std::array<unsigned char, 2>{255, 0})
  {
  }

  /// The scalars of the row at (x, y, z) and after it, component after component of each texel.
  const Scalar* GetScalars(int y, int z, int x = 0) const
  {
    return this->Scalars + this->Place(x, y, z) * this->Components;
  }
  /// nullptr: nothing is hidden.
  const unsigned char* GetGhosts(int y, int z, int x = 0) const
  {
    return this->Ghosts != nullptr ? this->Ghosts + this->Place(x, y, z) : nullptr;
  }

  /// Marks texels with 1 where they are visible (not hidden, all components finite, no code that is
  /// hidden), else with 0.
  void MarkVisible(int y, int z, int x, std::size_t count, unsigned char* visible) const
  {
    const Scalar* scalars = this->GetScalars(y, z, x);
    std::fill_n(visible, count, static_cast<unsigned char>(1));
    if constexpr (std::is_same_v<Scalar, unsigned char>)
    {
      // Copies of members, because bytes that are written could be these.
      const unsigned char* const ofCode = this->VisibleCodes;
      const auto [first, last] = this->CodeInterval;
      // Two comparisons are done for many texels at a time, look-ups are not.
      const bool compares = first <= last;
      for (std::size_t i = 0; compares && i < count; ++i)
      {
        visible[i] = scalars[i] >= first && scalars[i] <= last ? 1 : 0;
      }
      for (std::size_t i = 0; !compares && ofCode != nullptr && i < count; ++i)
      {
        visible[i] = ofCode[scalars[i]];
      }
    }
    if constexpr (std::is_floating_point_v<Scalar>)
    {
      for (std::size_t c = 0; c < this->Components; ++c)
      {
        // A constant step lets the compiler take several texels at a time.
        this->Components == 1 ? UnmarkInfinite(scalars, 1, count, visible)
                              : UnmarkInfinite(scalars + c, this->Components, count, visible);
      }
    }
    const unsigned char* ghosts = this->GetGhosts(y, z, x);
    for (std::size_t i = 0; ghosts != nullptr && i < count; ++i)
    {
      visible[i] = ghosts[i] == 0 ? visible[i] : 0;
    }
  }

  const std::size_t Length; ///< texels of a row
  const std::size_t Components;

private:
  static void UnmarkInfinite(
    const Scalar* scalars, std::size_t step, std::size_t count, unsigned char* finite)
  {
    constexpr Scalar most = std::numeric_limits<Scalar>::max();
    for (std::size_t i = 0; i < count; ++i)
    {
      finite[i] = std::abs(scalars[i * step]) <= most ? finite[i] : 0;
    }
  }

  std::size_t Place(int x, int y, int z) const
  {
    return (static_cast<std::size_t>(z) * this->Height + static_cast<std::size_t>(y)) *
             this->Length +
           static_cast<std::size_t>(x);
  }

  const std::size_t Height;
  const Scalar* const Scalars;
  const unsigned char* const Ghosts;
  const unsigned char* const VisibleCodes; ///< nullptr: the scalars are no codes
  const std::array<unsigned char, 2> CodeInterval;
};

} // namespace vtkTextureSlice

#endif
