// SPDX-License-Identifier: BSD-3-Clause
// What the looks at all texels of a volume share: they go along rows, in loops that a compiler can
// do for many texels at a time.
#ifndef vtkTextureSliceRows_h
#define vtkTextureSliceRows_h

#include "vtkDataArray.h"
#include "vtkTextureSliceScalars.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <vector>

namespace vtkTextureSlice
{

/// A volume's scalars and ghost flags row by row.
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
  {
    if (source.Codes)
    {
      this->HiddenCodes = source.Codes->GetHiddenIntervals();
    }
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
    this->MarkFinite(y, z, x, count, visible);
    if (const unsigned char* ghosts = this->GetGhosts(y, z, x))
    {
      for (std::size_t i = 0; i < count; ++i)
      {
        visible[i] = ghosts[i] == 0 ? visible[i] : 0;
      }
    }
  }

  /// Marks texels with 1 where all components are finite, and no code that is hidden, else with 0.
  void MarkFinite(int y, int z, int x, std::size_t count, unsigned char* finite) const
  {
    std::fill_n(finite, count, static_cast<unsigned char>(1));
    if constexpr (std::is_same_v<Scalar, unsigned char>)
    {
      this->UnmarkHiddenCodes(this->GetScalars(y, z, x), count, finite);
    }
    if constexpr (std::is_floating_point_v<Scalar>)
    {
      const Scalar* scalars = this->GetScalars(y, z, x);
      for (std::size_t c = 0; c < this->Components; ++c)
      {
        // A constant step lets the compiler take several texels at a time.
        this->Components == 1 ? UnmarkInfinite(scalars, 1, count, finite)
                              : UnmarkInfinite(scalars + c, this->Components, count, finite);
      }
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

  void UnmarkHiddenCodes(
    const unsigned char* codes, std::size_t count, unsigned char* visible) const
  {
    for (const vtkTextureSliceCodes::Interval interval : this->HiddenCodes)
    {
      const auto span = static_cast<unsigned char>(interval.Last - interval.First);
      for (std::size_t i = 0; i < count; ++i)
      {
        visible[i] = static_cast<unsigned char>(codes[i] - interval.First) > span ? visible[i] : 0;
      }
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
  std::vector<vtkTextureSliceCodes::Interval> HiddenCodes;
};

/// The least and the greatest of each column of several rows.
template <typename Scalar>
class ColumnExtremes
{
public:
  ColumnExtremes(std::size_t length, std::size_t components)
    : Components(components)
    , Low(length * components)
    , High(length * components)
  {
    this->Reset();
  }

  void Reset()
  {
    this->Low.assign(this->Low.size(), std::numeric_limits<Scalar>::max());
    this->High.assign(this->High.size(), std::numeric_limits<Scalar>::lowest());
  }

  /// Takes the texels of a row in where `counts` is not 0.
  void Extend(const Scalar* row, const unsigned char* counts)
  {
    for (std::size_t c = 0; c < this->Components; ++c)
    {
      // A constant step lets the compiler take several texels at a time.
      this->Components == 1 ? this->ExtendComponent(row, counts, c, 1)
                            : this->ExtendComponent(row, counts, c, this->Components);
    }
  }

  /// Extends a range, with members Low and High, by the columns [begin, end) of one component.
  template <typename Range>
  void ExtendRange(std::size_t begin, std::size_t end, std::size_t component, Range& range) const
  {
    for (std::size_t i = begin * this->Components + component; i < end * this->Components;
         i += this->Components)
    {
      if (this->Low[i] <= this->High[i]) // else nothing counted
      {
        range.Low = std::min(range.Low, static_cast<double>(this->Low[i]));
        range.High = std::max(range.High, static_cast<double>(this->High[i]));
      }
    }
  }

private:
  void ExtendComponent(
    const Scalar* row, const unsigned char* counts, std::size_t component, std::size_t step)
  {
    constexpr Scalar most = std::numeric_limits<Scalar>::max();
    constexpr Scalar least = std::numeric_limits<Scalar>::lowest();
    Scalar* low = this->Low.data() + component;
    Scalar* high = this->High.data() + component;
    const std::size_t count = this->Low.size() / this->Components;
    for (std::size_t i = 0; i < count; ++i)
    {
      const Scalar scalar = row[i * step + component];
      const Scalar forLow = counts[i] != 0 ? scalar : most;
      const Scalar forHigh = counts[i] != 0 ? scalar : least;
      low[i * step] = forLow < low[i * step] ? forLow : low[i * step];
      high[i * step] = high[i * step] < forHigh ? forHigh : high[i * step];
    }
  }

  std::size_t Components;
  std::vector<Scalar> Low;
  std::vector<Scalar> High;
};

/// Makes ranges of values of ranges of codes; both have members Low and High.
template <typename Range>
void ToValues(const vtkTextureSliceCodes& codes, std::vector<Range>& ranges)
{
  for (Range& range : ranges)
  {
    if (range.Low <= range.High)
    {
      const auto [low, high] =
        codes.GetRange(static_cast<std::size_t>(range.Low), static_cast<std::size_t>(range.High));
      range = {low, high};
    }
  }
}

} // namespace vtkTextureSlice

#endif
