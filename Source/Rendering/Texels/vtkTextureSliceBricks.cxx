// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTextureSliceBricks.h"

#include "vtkDataArray.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstring>

namespace
{

using Range = vtkTextureSliceBricks::Range;

/// Intervals along a brick's edge: small bricks follow the data closely, but more than 64 of them
/// along an axis cost more to look at than they save.
int ChooseEdge(int longest)
{
  constexpr int least = 4;
  constexpr int mostBricks = 64;
  return std::max(least, (longest + mostBricks - 1) / mostBricks);
}

template <typename Scalar>
class RowScanner
{
public:
  RowScanner(const vtkTextureSliceScalars& source, int edge, const std::array<int, 3>& count)
    : Source(source)
    , Edge(edge)
    , Count(count)
    , Rows(source)
    , Marks(Rows.Length)
    , Low(Rows.Length * Rows.Components)
    , High(Rows.Length * Rows.Components)
  {
  }

  /// @return whether there are texels that do not count
  bool Scan(int row, Range* ranges)
  {
    std::fill(this->Low.begin(), this->Low.end(), std::numeric_limits<Scalar>::max());
    std::fill(this->High.begin(), this->High.end(), std::numeric_limits<Scalar>::lowest());
    const auto [firstY, endY] = this->Reach(row % this->Count[1], 1);
    const auto [firstZ, endZ] = this->Reach(row / this->Count[1], 2);
    bool invisible = false;
    for (int z = firstZ; z < endZ; ++z)
    {
      for (int y = firstY; y < endY; ++y)
      {
        this->Rows.MarkVisible(y, z, 0, this->Rows.Length, this->Marks.data());
        invisible = invisible || std::memchr(this->Marks.data(), 0, this->Rows.Length) != nullptr;
        const std::size_t components = this->Rows.Components;
        for (std::size_t c = 0; c < components; ++c)
        {
          // A constant step lets the compiler take several texels at a time.
          components == 1 ? this->Extend(this->Rows.GetScalars(y, z), 0, 1)
                          : this->Extend(this->Rows.GetScalars(y, z), c, components);
        }
      }
    }
    for (int brick = 0; brick < this->Count[0]; ++brick, ranges += this->Rows.Components)
    {
      this->SetRanges(brick, ranges);
    }
    return invisible;
  }

private:
  /// The first texel that samples inside a brick can reach along an axis, and the end of them.
  std::array<int, 2> Reach(int brick, std::size_t axis) const
  {
    int first = brick * this->Edge; // interval between points
    int end = first + this->Edge;
    const std::vector<double>& places = this->Source.Places[axis];
    if (!places.empty())
    {
      // The intervals that an equal part of the box touches.
      constexpr double margin = 1.0 / 1024; // what the shaders' places may be off at most
      const double edge = this->Edge / static_cast<double>(places.size() - 1);
      const auto low =
        std::upper_bound(places.begin() + 1, places.end() - 1, brick * edge - margin);
      const auto high =
        std::lower_bound(places.begin() + 1, places.end() - 1, (brick + 1) * edge + margin);
      first = static_cast<int>(low - places.begin()) - 1;
      end = static_cast<int>(high - places.begin());
    }
    // Point scalars stand at the intervals' ends, cell scalars half a cell inside of them.
    return {std::max(0, this->Source.CellData ? first - 1 : first),
      std::min(this->Source.Size[axis], end + 1)};
  }

  /// Takes one component of a row of texels into the extremes of the columns.
  void Extend(const Scalar* row, std::size_t component, std::size_t step)
  {
    constexpr Scalar most = std::numeric_limits<Scalar>::max();
    constexpr Scalar least = std::numeric_limits<Scalar>::lowest();
    Scalar* low = this->Low.data() + component;
    Scalar* high = this->High.data() + component;
    const unsigned char* counts = this->Marks.data();
    const std::size_t length = this->Rows.Length;
    for (std::size_t i = 0; i < length; ++i)
    {
      const Scalar scalar = row[i * step + component];
      const Scalar forLow = counts[i] != 0 ? scalar : most;
      const Scalar forHigh = counts[i] != 0 ? scalar : least;
      low[i * step] = forLow < low[i * step] ? forLow : low[i * step];
      high[i * step] = high[i * step] < forHigh ? forHigh : high[i * step];
    }
  }

  void SetRanges(int brick, Range* ranges) const
  {
    const std::size_t components = this->Rows.Components;
    const auto [first, end] = this->Reach(brick, 0);
    for (std::size_t i = static_cast<std::size_t>(first) * components;
         i < static_cast<std::size_t>(end) * components; ++i)
    {
      if (this->Low[i] <= this->High[i]) // else nothing counted
      {
        Range& range = ranges[i % components];
        range.Low = std::min(range.Low, static_cast<double>(this->Low[i]));
        range.High = std::max(range.High, static_cast<double>(this->High[i]));
      }
    }
  }

  const vtkTextureSliceScalars& Source;
  int Edge;
  const std::array<int, 3>& Count;
  vtkTextureSlice::Rows<Scalar> Rows;
  std::vector<unsigned char> Marks; ///< 1 for texels of a row that count
  std::vector<Scalar> Low;          ///< of each component of each column of texels
  std::vector<Scalar> High;
};

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

} // namespace

void vtkTextureSliceBricks::Build(const vtkTextureSliceScalars& source)
{
  std::array<int, 3> intervals = source.Size; // between the texels that the box spans
  std::for_each(intervals.begin(), intervals.end(),
    [&source](int& count) { count -= source.CellData ? 0 : 1; });
  const int edge = ChooseEdge(*std::max_element(intervals.begin(), intervals.end()));
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    this->Count[axis] = (intervals[axis] + edge - 1) / edge;
    this->Edge[axis] = double(edge) / intervals[axis];
  }
  const vtkIdType rows = static_cast<vtkIdType>(this->Count[1]) * this->Count[2];
  const vtkIdType rangesOfRow =
    static_cast<vtkIdType>(this->Count[0]) * source.Scalars->GetNumberOfComponents();
  this->Ranges.assign(static_cast<std::size_t>(rows * rangesOfRow), Range());
  std::atomic<bool> invisible(false);
  const auto scan = [&](auto scalar)
  {
    vtkSMPTools::For(0, rows,
      [&](vtkIdType begin, vtkIdType end)
      {
        RowScanner<decltype(scalar)> scanner(source, edge, this->Count);
        for (vtkIdType row = begin; row < end; ++row)
        {
          const bool found =
            scanner.Scan(static_cast<int>(row), this->Ranges.data() + row * rangesOfRow);
          invisible = invisible || found;
        }
      });
  };
  switch (source.Scalars->GetDataType())
  {
    vtkTemplateMacro(scan(VTK_TT()));
  }
  this->HasInvisible = invisible;
  if (source.Codes)
  {
    ToValues(*source.Codes, this->Ranges);
  }
  vtkTimeStamp now;
  now.Modified();
  this->BuildTime = now.GetMTime();
}
