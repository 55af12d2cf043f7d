// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTextureSliceBricks.h"

#include "vtkDataArray.h"
#include "vtkSMPTools.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace
{

using Range = vtkTextureSliceBricks::Range;

/// Texels [Begin, End) along one axis.
struct Span
{
  int Begin;
  int End;
};

/// Intervals between texels that the box spans.
std::array<int, 3> CountIntervals(const vtkTextureSliceBricks::Source& source)
{
  std::array<int, 3> intervals = source.Size;
  for (int& count : intervals)
  {
    count -= source.CellData ? 0 : 1;
  }
  return intervals;
}

/// Intervals along a brick's edge: small bricks follow the data closely, but more than 64 of them
/// along an axis cost more to look at than they save.
int ChooseEdge(const std::array<int, 3>& intervals)
{
  constexpr int least = 2;
  constexpr int mostBricks = 64;
  const int longest = *std::max_element(intervals.begin(), intervals.end());
  return std::max(least, (longest + mostBricks - 1) / mostBricks);
}

/// Finds the ranges of one row of bricks after another.
template <typename Scalar>
class RowScanner
{
public:
  RowScanner(const vtkTextureSliceBricks::Source& source, int edge, const std::array<int, 3>& count,
    std::vector<Range>& ranges)
    : Source(source)
    , Edge(edge)
    , Count(count)
    , Ranges(ranges)
    , Scalars(static_cast<const Scalar*>(source.Scalars->GetVoidPointer(0)))
    , Ghosts(source.Ghosts != nullptr ? source.Ghosts->GetPointer(0) : nullptr)
    , Components(static_cast<std::size_t>(source.Scalars->GetNumberOfComponents()))
  {
  }

  void operator()(vtkIdType begin, vtkIdType end) const
  {
    for (auto row = static_cast<int>(begin); row < static_cast<int>(end); ++row)
    {
      this->ScanRow(row % this->Count[1], row / this->Count[1]);
    }
  }

private:
  /// The texels that samples inside a brick can reach.
  Span Reach(int brick, std::size_t axis) const
  {
    // Point scalars stand on the bricks' faces, cell scalars half a cell inside of them.
    const int first = brick * this->Edge;
    const int before = this->Source.CellData ? 1 : 0;
    return {std::max(0, first - before), std::min(this->Source.Size[axis], first + this->Edge + 1)};
  }

  void ScanRow(int brickY, int brickZ) const
  {
    const auto firstBrick = static_cast<std::size_t>(this->Count[0]) *
                            static_cast<std::size_t>(brickZ * this->Count[1] + brickY);
    Range* ranges = this->Ranges.data() + firstBrick * this->Components;
    const Span z = this->Reach(brickZ, 2);
    const Span y = this->Reach(brickY, 1);
    for (int k = z.Begin; k < z.End; ++k)
    {
      for (int j = y.Begin; j < y.End; ++j)
      {
        const vtkIdType row =
          (static_cast<vtkIdType>(k) * this->Source.Size[1] + j) * this->Source.Size[0];
        for (int brick = 0; brick < this->Count[0]; ++brick)
        {
          const Span x = this->Reach(brick, 0);
          this->Extend(ranges + static_cast<std::size_t>(brick) * this->Components,
            static_cast<std::size_t>(row + x.Begin), static_cast<std::size_t>(row + x.End));
        }
      }
    }
  }

  bool Counts(std::size_t id) const
  {
    if constexpr (std::is_floating_point_v<Scalar>)
    {
      const Scalar* tuple = this->Scalars + id * this->Components;
      if (!std::all_of(tuple, tuple + this->Components, [](Scalar s) { return std::isfinite(s); }))
      {
        return false;
      }
    }
    return this->Ghosts == nullptr || (this->Ghosts[id] & this->Source.HiddenBits) == 0;
  }

  /// Extends the ranges of a brick, one for each component, by texels of a row.
  void Extend(Range* ranges, std::size_t begin, std::size_t end) const
  {
    for (std::size_t c = 0; c < this->Components; ++c)
    {
      Scalar low = std::numeric_limits<Scalar>::max();
      Scalar high = std::numeric_limits<Scalar>::lowest();
      bool any = false;
      for (std::size_t id = begin; id < end; ++id)
      {
        if (this->Counts(id))
        {
          const Scalar scalar = this->Scalars[id * this->Components + c];
          any = true;
          low = std::min(low, scalar);
          high = std::max(high, scalar);
        }
      }
      if (any)
      {
        ranges[c].Low = std::min(ranges[c].Low, static_cast<double>(low));
        ranges[c].High = std::max(ranges[c].High, static_cast<double>(high));
      }
    }
  }

  const vtkTextureSliceBricks::Source& Source;
  int Edge;
  const std::array<int, 3>& Count;
  std::vector<Range>& Ranges;
  const Scalar* Scalars;
  const unsigned char* Ghosts;
  std::size_t Components;
};

} // namespace

void vtkTextureSliceBricks::Build(const Source& source)
{
  const std::array<int, 3> intervals = CountIntervals(source);
  const int edge = ChooseEdge(intervals);
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    this->Count[axis] = (intervals[axis] + edge - 1) / edge;
    this->Edge[axis] = double(edge) / intervals[axis];
  }
  const vtkIdType rows = static_cast<vtkIdType>(this->Count[1]) * this->Count[2];
  this->Ranges.assign(
    static_cast<std::size_t>(rows * this->Count[0] * source.Scalars->GetNumberOfComponents()),
    Range());
  switch (source.Scalars->GetDataType())
  {
    vtkTemplateMacro(
      vtkSMPTools::For(0, rows, RowScanner<VTK_TT>(source, edge, this->Count, this->Ranges)));
  }
  this->BuildTime.Modified();
}
