// SPDX-License-Identifier: BSD-3-Clause
// What the looks at all texels of a volume share: they go along rows, in loops that a compiler can
// do for many texels at a time.
#ifndef vtkTextureSliceRows_h
#define vtkTextureSliceRows_h

#include "vtkDataArray.h"
#include "vtkTextureSliceScalars.h"
#include "vtkUnsignedCharArray.h"

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
    , HiddenBits(source.HiddenBits)
    , Height(static_cast<std::size_t>(source.Size[1]))
    , Scalars(static_cast<const Scalar*>(source.Scalars->GetVoidPointer(0)))
    , Ghosts(source.Ghosts != nullptr ? source.Ghosts->GetPointer(0) : nullptr)
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

  /// Marks texels with 1 where they are visible (not hidden, all components finite), else with 0.
  void MarkVisible(int y, int z, int x, std::size_t count, unsigned char* visible) const
  {
    this->MarkFinite(y, z, x, count, visible);
    if (const unsigned char* ghosts = this->GetGhosts(y, z, x))
    {
      for (std::size_t i = 0; i < count; ++i)
      {
        visible[i] &= (ghosts[i] & this->HiddenBits) == 0 ? 1 : 0;
      }
    }
  }

  /// Marks texels with 1 where all components are finite, else with 0.
  void MarkFinite(int y, int z, int x, std::size_t count, unsigned char* finite) const
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      finite[i] = 1;
    }
    if constexpr (std::is_floating_point_v<Scalar>)
    {
      constexpr Scalar most = std::numeric_limits<Scalar>::max();
      const Scalar* scalars = this->GetScalars(y, z, x);
      for (std::size_t c = 0; c < this->Components; ++c)
      {
        for (std::size_t i = 0; i < count; ++i)
        {
          finite[i] &= std::abs(scalars[i * this->Components + c]) <= most ? 1 : 0;
        }
      }
    }
  }

  const std::size_t Length; ///< texels of a row
  const std::size_t Components;
  const unsigned char HiddenBits;

private:
  std::size_t Place(int x, int y, int z) const
  {
    return (static_cast<std::size_t>(z) * this->Height + static_cast<std::size_t>(y)) *
             this->Length +
           static_cast<std::size_t>(x);
  }

  const std::size_t Height;
  const Scalar* const Scalars;
  const unsigned char* const Ghosts;
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
    Scalar* low = this->Low.data();
    Scalar* high = this->High.data();
    for (std::size_t i = 0; this->Components == 1 && i < this->Low.size(); ++i)
    {
      low[i] = counts[i] != 0 && row[i] < low[i] ? row[i] : low[i];
      high[i] = counts[i] != 0 && high[i] < row[i] ? row[i] : high[i];
    }
    for (std::size_t i = 0; this->Components != 1 && i < this->Low.size(); ++i)
    {
      const bool count = counts[i / this->Components] != 0;
      low[i] = count && row[i] < low[i] ? row[i] : low[i];
      high[i] = count && high[i] < row[i] ? row[i] : high[i];
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
  std::size_t Components;
  std::vector<Scalar> Low;
  std::vector<Scalar> High;
};

} // namespace vtkTextureSlice

#endif
