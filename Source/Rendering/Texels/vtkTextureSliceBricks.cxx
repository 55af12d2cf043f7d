// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTextureSliceBricks.h"

#include "vtkDataArray.h"
#include "vtkSMPTools.h"
#include "vtkTextureSliceRows.h"

#include <algorithm>
#include <cstddef>

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
  constexpr int least = 4;
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
    , Rows(source)
  {
  }

  void operator()(vtkIdType begin, vtkIdType end) const
  {
    vtkTextureSlice::ColumnExtremes<Scalar> extremes(this->Rows.Length, this->Rows.Components);
    std::vector<unsigned char> counts(this->Rows.Length);
    for (auto row = static_cast<int>(begin); row < static_cast<int>(end); ++row)
    {
      const std::array<int, 2> brick{row % this->Count[1], row / this->Count[1]};
      extremes.Reset();
      this->ScanRow(brick, extremes, counts);
      this->SetRanges(brick, extremes);
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

  void ScanRow(const std::array<int, 2>& brick, vtkTextureSlice::ColumnExtremes<Scalar>& extremes,
    std::vector<unsigned char>& counts) const
  {
    const Span y = this->Reach(brick[0], 1);
    const Span z = this->Reach(brick[1], 2);
    for (int k = z.Begin; k < z.End; ++k)
    {
      for (int j = y.Begin; j < y.End; ++j)
      {
        this->Rows.MarkVisible(j, k, 0, this->Rows.Length, counts.data());
        extremes.Extend(this->Rows.GetScalars(j, k), counts.data());
      }
    }
  }

  void SetRanges(
    const std::array<int, 2>& brick, const vtkTextureSlice::ColumnExtremes<Scalar>& extremes) const
  {
    auto range = this->Ranges.begin() + static_cast<std::ptrdiff_t>(this->Rows.Components) *
                                          this->Count[0] * (brick[1] * this->Count[1] + brick[0]);
    for (int i = 0; i < this->Count[0]; ++i)
    {
      const Span x = this->Reach(i, 0);
      for (std::size_t c = 0; c < this->Rows.Components; ++c, ++range)
      {
        extremes.ExtendRange(
          static_cast<std::size_t>(x.Begin), static_cast<std::size_t>(x.End), c, *range);
      }
    }
  }

  const vtkTextureSliceBricks::Source& Source;
  int Edge;
  const std::array<int, 3>& Count;
  std::vector<Range>& Ranges;
  vtkTextureSlice::Rows<Scalar> Rows;
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
  if (source.Codes)
  {
    vtkTextureSlice::ToValues(*source.Codes, this->Ranges);
  }
  this->BuildTime.Modified();
}
