// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTextureSliceLightSweep.h"

#include "vtkSMPTools.h"
#include "vtkTextureSliceExtinction.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <utility>

namespace
{

/// exp(-depth), at most 1, within 0.01 %, and without a branch, so that a compiler does several at
/// a time.
inline float Transmit(float depth)
{
  constexpr float perOctave = 1.44269504f;
  constexpr float most = 60.0f; // octaves: nothing is left
  float octaves = depth * perOctave;
  octaves = octaves > 0.0f ? octaves : 0.0f;
  octaves = octaves < most ? octaves : most;
  const auto whole = static_cast<std::int32_t>(octaves + 0.5f);
  const float f = static_cast<float>(whole) - octaves;
  const float power =
    1.0f + f * (0.69314718f + f * (0.24022651f + f * (0.05550411f + f * 0.00961813f)));
  const std::int32_t bits = (127 - whole) << 23; // of 2 to the power of -whole
  float scale;
  std::memcpy(&scale, &bits, sizeof(scale));
  return scale * power;
}

/// A place along an axis of the rays: a whole number of rays, and a fraction.
struct Shift
{
  explicit Shift(double place)
    : Whole(static_cast<int>(std::floor(place)))
    , Fraction(static_cast<float>(place - this->Whole))
  {
  }

  int Whole;
  float Fraction;
};

} // namespace

/// Rays lie at whole places of a raster across the planes. The cell i of plane p lies at the place
/// i + Slope * p + Offset, at which the same ray crosses all planes.
struct vtkTextureSliceLightSweep::Course
{
  const std::vector<Surface>* Surfaces = nullptr;
  const float* Extinctions = nullptr; ///< of the cell 0, 0 of the plane where the light enters
  float* Sums = nullptr;
  float Weight = 1.0f;
  int Planes = 0;
  float Step = 0.0f;   ///< length of a ray from plane to plane
  float Margin = 0.0f; ///< steps from where light enters to the first plane

  /// Across the planes: along the rows, which are contiguous, and from row to row.
  struct Axis
  {
    int Cells = 0;
    int Planes = 0;
    double Slope = 0.0;
    double Offset = 0.0;
    double LowMargin = 0.0; ///< cells from the centres of the outermost ones to the faces
    double HighMargin = 0.0;
    int CountRays() const
    {
      return this->Cells + static_cast<int>(std::ceil(std::abs(this->Slope) * this->Planes)) + 2;
    }
    /// Steps that the ray at a place before the cell 0 of a plane has been inside of the sides of
    /// the volume, and how much more it is for the ray at the next cell.
    std::array<float, 2> GetSteps(float before) const
    {
      // Rays that stay where they are have come in by no side.
      if (std::abs(this->Slope) * this->Planes < 1e-6)
      {
        return {1.0f, 0.0f};
      }
      const double depth =
        this->Slope < 0.0 ? this->LowMargin - before : this->Cells - 1 + this->HighMargin + before;
      return {
        static_cast<float>(depth / std::abs(this->Slope)), static_cast<float>(-1.0 / this->Slope)};
    }
    Shift At(int plane) const
    {
      return Shift(std::max(0.0, this->Slope * plane + this->Offset)); // rounding may pass 0
    }
  };
  Axis Column;
  Axis Row;

  /// Floats from one row, or plane, to the next, the latter away from the light.
  std::ptrdiff_t ExtinctionRow = 0;
  std::ptrdiff_t ExtinctionPlane = 0;
  std::ptrdiff_t SumRow = 0;
  std::ptrdiff_t SumPlane = 0;
};

namespace
{

/// The rays of some rows of the raster.
class RayRows
{
public:
  RayRows(int rows, int columns)
    : Columns(columns)
    , Depths(static_cast<std::size_t>(rows) * static_cast<std::size_t>(columns))
    , Before(this->Depths.size())
    , Scalars(static_cast<std::size_t>(columns))
    , Transmittances(static_cast<std::size_t>(columns))
    , Previous(static_cast<std::size_t>(columns))
  {
  }

  /// How the rays of a row come to the next plane.
  struct Advance
  {
    const float* Near;          ///< extinctions of the row of cells after the rays
    const float* Far;           ///< and before them
    float RowFraction;          ///< how near the rays are to the latter
    std::array<float, 2> Steps; ///< as Course::Axis::GetSteps
    float LeastSteps;           ///< inside of the volume, and most
    float MostSteps;
    float StepLength;
  };

  /// Takes the rays [column.Whole, column.Whole + cells] of a row on to the next plane.
  void Take(int row, const Shift& column, int cells, const Advance& advance)
  {
    const std::size_t at = static_cast<std::size_t>(row) * static_cast<std::size_t>(this->Columns) +
                           static_cast<std::size_t>(column.Whole);
    float* depths = this->Depths.data() + at;
    float* before = this->Before.data() + at;
    std::swap(this->Transmittances, this->Previous);
    float* transmittances = this->Transmittances.data() + column.Whole;
    const float f = column.Fraction;
    const float g = advance.RowFraction;
    const float* near = advance.Near;
    const float* far = advance.Far;
    for (int i = 0; i <= cells; ++i)
    {
      const float nearer = (1.0f - f) * near[i] + f * near[i - 1];
      const float farther = (1.0f - f) * far[i] + f * far[i - 1];
      const float extinction = (1.0f - g) * nearer + g * farther;
      float steps = advance.Steps[0] + static_cast<float>(i) * advance.Steps[1];
      steps = steps < advance.MostSteps ? steps : advance.MostSteps;
      steps = steps > advance.LeastSteps ? steps : advance.LeastSteps;
      // Where a ray has come in on its way from the plane before, it knows this plane alone.
      const float mean = steps < 1.0f ? steps * extinction : 0.5f * (before[i] + extinction);
      const float depth = depths[i] + advance.StepLength * mean;
      depths[i] = depth;
      before[i] = extinction;
      transmittances[i] = Transmit(depth);
    }
  }

  /// The same across surfaces: the extinctions are scalars.
  void TakeAcross(const std::vector<vtkTextureSliceSurfaceScalars::Surface>& surfaces, int row,
    const Shift& column, int cells, const Advance& advance)
  {
    const std::size_t at = static_cast<std::size_t>(row) * static_cast<std::size_t>(this->Columns) +
                           static_cast<std::size_t>(column.Whole);
    float* depths = this->Depths.data() + at;
    float* before = this->Before.data() + at;
    std::swap(this->Transmittances, this->Previous);
    float* transmittances = this->Transmittances.data() + column.Whole;
    float* scalars = this->Scalars.data();
    const float f = column.Fraction;
    const float g = advance.RowFraction;
    for (int i = 0; i <= cells; ++i)
    {
      const float nearer = (1.0f - f) * advance.Near[i] + f * advance.Near[i - 1];
      const float farther = (1.0f - f) * advance.Far[i] + f * advance.Far[i - 1];
      scalars[i] = (1.0f - g) * nearer + g * farther;
      float steps = advance.Steps[0] + static_cast<float>(i) * advance.Steps[1];
      steps = steps < advance.MostSteps ? steps : advance.MostSteps;
      // There is nothing to cross from outside of the volume, and to or from what is hidden (not a
      // number, so that the comparison is false).
      const bool inside = steps >= 1.0f && std::abs(scalars[i] - before[i]) <= Most;
      before[i] = inside ? before[i] : scalars[i];
    }
    for (const auto& [value, depth] : surfaces)
    {
      for (int i = 0; i <= cells; ++i)
      {
        depths[i] += (before[i] > value) != (scalars[i] > value) ? depth : 0.0f;
      }
    }
    for (int i = 0; i <= cells; ++i)
    {
      before[i] = scalars[i];
      transmittances[i] = Transmit(depths[i]);
    }
  }

  /// Adds what arrives in a row of cells, which lies between the last two rows of rays.
  void AddRow(const Shift& column, int cells, float rowFraction, float weight, float* sums) const
  {
    const float* lower = this->Previous.data() + column.Whole;
    const float* upper = this->Transmittances.data() + column.Whole;
    const float f = column.Fraction;
    const float low = weight * (1.0f - rowFraction);
    const float high = weight * rowFraction;
    for (int i = 0; i < cells; ++i)
    {
      sums[i] += low * ((1.0f - f) * lower[i] + f * lower[i + 1]) +
                 high * ((1.0f - f) * upper[i] + f * upper[i + 1]);
    }
  }

private:
  static constexpr float Most = std::numeric_limits<float>::max();

  int Columns;
  std::vector<float> Depths;  ///< optical, from where the light enters
  std::vector<float> Before;  ///< extinctions (or scalars) at the plane before
  std::vector<float> Scalars; ///< at this plane, of one row
  std::vector<float> Transmittances;
  std::vector<float> Previous; ///< those of the row before
};

} // namespace

vtkTextureSliceLightSweep::vtkTextureSliceLightSweep(const vtkTextureSliceExtinction& extinction)
  : Grid(extinction.GetGrid())
  , Values(extinction.GetValues())
{
}

vtkTextureSliceLightSweep::vtkTextureSliceLightSweep(
  const vtkTextureSliceSurfaceScalars& scalars, const std::vector<Surface>& surfaces)
  : Grid(scalars.GetGrid())
  , Values(scalars.GetValues())
  , Surfaces(surfaces)
{
}

vtkTextureSliceLightSweep::Layout& vtkTextureSliceLightSweep::Prepare(Layout& layout) const
{
  if (!layout.Extinctions.empty())
  {
    return layout;
  }
  layout.Sums.assign(this->Grid.CountCells(), 0.0f);
  std::array<std::size_t, 3> size{}; // in the order of the layout
  std::array<std::size_t, 3> stride{};
  const std::array<std::size_t, 3> strides{1, static_cast<std::size_t>(this->Grid.Size[0]),
    static_cast<std::size_t>(this->Grid.Size[0]) * static_cast<std::size_t>(this->Grid.Size[1])};
  for (std::size_t i = 0; i < 3; ++i)
  {
    size[i] = static_cast<std::size_t>(this->Grid.Size[layout.Axes[i]]);
    stride[i] = strides[layout.Axes[i]];
  }
  layout.Extinctions.resize((size[0] + 2) * (size[1] + 2) * (size[2] + 2));
  const float* values = this->Values.data();
  const auto inside = [&size](std::size_t place, std::size_t axis)
  { return std::clamp<std::size_t>(place, 1, size[axis]) - 1; };
  vtkSMPTools::For(0, static_cast<vtkIdType>(size[2] + 2),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (auto k = static_cast<std::size_t>(begin); k < static_cast<std::size_t>(end); ++k)
      {
        for (std::size_t j = 0; j < size[1] + 2; ++j)
        {
          const float* from = values + inside(k, 2) * stride[2] + inside(j, 1) * stride[1];
          float* to = layout.Extinctions.data() + (k * (size[1] + 2) + j) * (size[0] + 2) + 1;
          for (std::size_t i = 0; i < size[0]; ++i)
          {
            to[i] = from[i * stride[0]];
          }
          to[-1] = to[0];
          to[size[0]] = to[size[0] - 1];
        }
      }
    });
  return layout;
}

vtkTextureSliceLightSweep::Course vtkTextureSliceLightSweep::FindCourse(
  const std::array<double, 3>& towards)
{
  // In cells along each axis, for one length of the direction.
  const double length = std::hypot(towards[0], towards[1], towards[2]);
  std::array<double, 3> cells{};
  std::size_t through = 0; // the axis across the planes
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    cells[axis] = towards[axis] / (length * this->Grid.CellEdge[axis]);
    through = std::abs(cells[axis]) > std::abs(cells[through]) ? axis : through;
  }
  // Rows of rays are contiguous in memory unless the planes are.
  Layout& layout = this->Prepare(through == 0 ? this->RowsAlongY : this->RowsAlongX);
  const std::size_t column = layout.Axes[0];
  const bool planesInTheMiddle = layout.Axes[1] == through;
  const std::size_t row = planesInTheMiddle ? layout.Axes[2] : layout.Axes[1];
  const auto size = [&](std::size_t axis) { return std::ptrdiff_t{this->Grid.Size[axis]}; };

  Course course;
  course.Surfaces = &this->Surfaces;
  course.Planes = this->Grid.Size[through];
  course.Step = static_cast<float>(1.0 / std::abs(cells[through]));
  const bool fromHigh = cells[through] > 0.0;
  course.Margin = static_cast<float>(this->Grid.GetMargin(through, fromHigh));
  for (const auto& [target, axis] :
    {std::pair<Course::Axis&, std::size_t>(course.Column, column), {course.Row, row}})
  {
    target.Cells = this->Grid.Size[axis];
    target.Planes = course.Planes;
    target.Slope = cells[axis] / std::abs(cells[through]);
    target.LowMargin = this->Grid.GetMargin(axis, false);
    target.HighMargin = this->Grid.GetMargin(axis, true);
    target.Offset = std::max(0.0, -target.Slope * (course.Planes - 1));
  }
  const std::ptrdiff_t columns = size(layout.Axes[0]);
  const std::ptrdiff_t middles = size(layout.Axes[1]);
  const std::ptrdiff_t extinctionMiddle = columns + 2;
  const std::ptrdiff_t extinctionSlow = extinctionMiddle * (middles + 2);
  const std::ptrdiff_t sign = fromHigh ? -1 : 1;
  course.ExtinctionRow = planesInTheMiddle ? extinctionSlow : extinctionMiddle;
  course.ExtinctionPlane = sign * (planesInTheMiddle ? extinctionMiddle : extinctionSlow);
  course.SumRow = planesInTheMiddle ? columns * middles : columns;
  course.SumPlane = sign * (planesInTheMiddle ? columns : columns * middles);
  const std::ptrdiff_t first = fromHigh ? course.Planes - 1 : 0;
  course.Extinctions = layout.Extinctions.data() + extinctionSlow + extinctionMiddle + 1 +
                       first * sign * course.ExtinctionPlane;
  course.Sums = layout.Sums.data() + first * sign * course.SumPlane;
  return course;
}

void vtkTextureSliceLightSweep::SweepRows(const Course& course, int begin, int end)
{
  // The last row of rays belongs to the next range, but cells of this one lie before it.
  RayRows rays(end - begin + 1, course.Column.CountRays());
  for (int plane = 0; plane < course.Planes; ++plane)
  {
    const Shift column = course.Column.At(plane);
    const Shift row = course.Row.At(plane);
    const float* extinctions = course.Extinctions + plane * course.ExtinctionPlane;
    float* sums = course.Sums + plane * course.SumPlane;
    const int first = std::max(begin, row.Whole);
    const int last = std::min(end, row.Whole + course.Row.Cells);
    const std::array<float, 2> rowSteps = course.Row.GetSteps(row.Fraction);
    for (int ray = first; ray <= last; ++ray)
    {
      const int cell = ray - row.Whole; // the ray lies between this row of cells and the one before
      const float* near = extinctions + cell * course.ExtinctionRow;
      const float mostSteps = rowSteps[0] + static_cast<float>(cell) * rowSteps[1];
      const RayRows::Advance advance{near, near - course.ExtinctionRow, row.Fraction,
        course.Column.GetSteps(column.Fraction), plane == 0 ? std::min(0.0f, course.Margin) : 0.0f,
        std::min(plane == 0 ? course.Margin : 1.0f, mostSteps), course.Step};
      course.Surfaces->empty()
        ? rays.Take(ray - begin, column, course.Column.Cells, advance)
        : rays.TakeAcross(*course.Surfaces, ray - begin, column, course.Column.Cells, advance);
      if (ray > first)
      {
        rays.AddRow(column, course.Column.Cells, row.Fraction, course.Weight,
          sums + (cell - 1) * course.SumRow);
      }
    }
  }
}

void vtkTextureSliceLightSweep::Add(const std::array<double, 3>& towards, double weight)
{
  Course course = this->FindCourse(towards);
  course.Weight = static_cast<float>(weight);
  // Few rows in a task would compute too many rows of rays twice.
  constexpr vtkIdType rowsOfATask = 16;
  vtkSMPTools::For(0, course.Row.CountRays(), rowsOfATask,
    [&](vtkIdType begin, vtkIdType end)
    { SweepRows(course, static_cast<int>(begin), static_cast<int>(end)); });
}

std::vector<float> vtkTextureSliceLightSweep::TakeSums()
{
  this->Prepare(this->RowsAlongX);
  std::vector<float> sums = std::move(this->RowsAlongX.Sums);
  this->RowsAlongX.Sums.assign(sums.size(), 0.0f);
  if (this->RowsAlongY.Sums.empty())
  {
    return sums;
  }
  const auto nx = static_cast<std::size_t>(this->Grid.Size[0]);
  const auto ny = static_cast<std::size_t>(this->Grid.Size[1]);
  vtkSMPTools::For(0, this->Grid.Size[2],
    [&](vtkIdType begin, vtkIdType end)
    {
      for (auto z = static_cast<std::size_t>(begin); z < static_cast<std::size_t>(end); ++z)
      {
        for (std::size_t y = 0; y < ny; ++y)
        {
          for (std::size_t x = 0; x < nx; ++x)
          {
            sums[(z * ny + y) * nx + x] += this->RowsAlongY.Sums[(z * nx + x) * ny + y];
          }
        }
      }
    });
  this->RowsAlongY.Sums.assign(sums.size(), 0.0f);
  return sums;
}
