// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTextureSliceLightVolume.h"

#include "vtkMath.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <utility>

namespace
{

// The transmittance exp(-integral of the extinction) from the centre of each cell to where a
// direction leaves the volume (Formulas L2). A direction is followed plane by plane of cells, along
// the axis on which it takes the fewest steps. Parallel rays, one cell apart, keep the depths that
// they have come through; a plane's extinction is interpolated to where the rays cross it, and the
// transmittance of the rays to the centres of its cells. So shadows have the same edges far from
// what casts them as near to it. A ray crosses an isosurface between two planes where its scalars
// lie on either side of the value.

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

/// A place along an axis of the rays.
struct Shift
{
  int Whole;
  float Fraction;
};

/// Rays lie at whole places of a raster across the planes. The cell i of plane p lies at the place
/// i + Slope * p + Offset, at which the same ray crosses all planes.
struct Axis
{
  int Cells = 0;
  std::ptrdiff_t Stride = 0; ///< from one cell to the next
  double Slope = 0.0;
  double Offset = 0.0;
  int Rays = 0;
  double LowMargin = 0.0; ///< cells from the centres of the outermost ones to the faces
  double HighMargin = 0.0;

  Shift At(int plane) const
  {
    const double place = std::max(0.0, this->Slope * plane + this->Offset); // rounding may pass 0
    return {static_cast<int>(place), static_cast<float>(place - std::floor(place))};
  }
  /// Steps that the ray at a place before the cell 0 of a plane has been inside of the sides of the
  /// volume, and how much more it is for the ray at the next cell.
  std::array<float, 2> FindSteps(float before) const
  {
    // Rays that stay where they are have come in by no side.
    if (std::abs(this->Slope) * this->Rays < 1e-6)
    {
      return {1.0f, 0.0f};
    }
    const double depth = this->Slope < 0.0
                           ? this->LowMargin - static_cast<double>(before)
                           : this->HighMargin + this->Cells - 1 + static_cast<double>(before);
    return {
      static_cast<float>(depth / std::abs(this->Slope)), static_cast<float>(-1.0 / this->Slope)};
  }
};

/// A direction as steps from plane to plane, the first one where the light enters.
struct Course
{
  const vtkTextureSliceLightCells* Cells = nullptr;
  int Planes = 0;
  std::ptrdiff_t First = 0;       ///< the cell 0, 0 of the first plane
  std::ptrdiff_t PlaneStride = 0; ///< away from the light
  float Step = 0.0f;              ///< length of a ray from plane to plane
  float Margin = 0.0f;            ///< steps from where light enters to the first plane
  Axis Column;                    ///< across the planes: along the rows
  Axis Row;                       ///< and from row to row
};

Course FindCourse(const vtkTextureSliceLightCells& cells, const std::array<double, 3>& towards)
{
  const vtkTextureSliceLightGrid& grid = cells.GetGrid();
  // In cells along each axis, for one length of the direction.
  const double length = std::hypot(towards[0], towards[1], towards[2]);
  std::array<double, 3> direction{};
  std::size_t through = 0; // the axis across the planes
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    direction[axis] = towards[axis] / (length * grid.CellEdge[axis]);
    through = std::abs(direction[axis]) > std::abs(direction[through]) ? axis : through;
  }
  const std::array<std::ptrdiff_t, 3> strides{
    1, grid.Size[0], std::ptrdiff_t{grid.Size[0]} * grid.Size[1]};
  const bool fromHigh = direction[through] > 0.0;
  Course course;
  course.Cells = &cells;
  course.Planes = grid.Size[through];
  course.First = fromHigh ? (course.Planes - 1) * strides[through] : 0;
  course.PlaneStride = fromHigh ? -strides[through] : strides[through];
  course.Step = static_cast<float>(1.0 / std::abs(direction[through]));
  course.Margin = static_cast<float>(grid.GetMargin(through, fromHigh));
  const auto find = [&](std::size_t axis)
  {
    const double slope = direction[axis] / std::abs(direction[through]);
    const double way = slope * (course.Planes - 1);
    return Axis{grid.Size[axis], strides[axis], slope, std::max(0.0, -way),
      grid.Size[axis] + static_cast<int>(std::ceil(std::abs(slope) * course.Planes)) + 2,
      grid.GetMargin(axis, false), grid.GetMargin(axis, true)};
  };
  // Rows are contiguous in memory unless the direction follows them.
  course.Column = find(through == 0 ? 1 : 0);
  course.Row = find(through == 2 ? 1 : 2);
  return course;
}

/// The rays of the rows [begin, end] of the raster. The last row belongs to the next range, but
/// cells of this one lie before it.
class RayRows
{
public:
  RayRows(const Course& course, int begin, int end)
    : Way(course)
    , Begin(begin)
    , End(end)
    , Near(static_cast<std::size_t>(course.Column.Cells) + 2)
    , Far(this->Near)
    , Here(this->Near)
    , Depths(
        static_cast<std::size_t>(end - begin + 1) * static_cast<std::size_t>(course.Column.Rays))
    , Before(this->Depths.size())
    , Transmittances(this->Near.size())
    , Previous(this->Near.size())
  {
  }

  void Sweep(float weight, float* sums)
  {
    for (int plane = 0; plane < this->Way.Planes; ++plane)
    {
      const Shift column = this->Way.Column.At(plane);
      const Shift row = this->Way.Row.At(plane);
      const int first = std::max(this->Begin, row.Whole);
      const int last = std::min(this->End, row.Whole + this->Way.Row.Cells);
      const std::array<float, 2> steps = this->Way.Row.FindSteps(row.Fraction);
      // A ray lies between a row of cells and the one before.
      this->Load(plane, first - row.Whole - 1, this->Near);
      for (int ray = first; ray <= last; ++ray)
      {
        const int cell = ray - row.Whole;
        std::swap(this->Near, this->Far);
        this->Load(plane, cell, this->Near);
        this->Interpolate(column.Fraction, row.Fraction);
        this->Take(plane, ray, column, steps[0] + static_cast<float>(cell) * steps[1]);
        if (ray > first)
        {
          this->AddRow(column.Fraction, row.Fraction, weight, sums + this->Place(plane, cell - 1));
        }
      }
    }
  }

private:
  std::ptrdiff_t Place(int plane, int row) const
  {
    return this->Way.First + plane * this->Way.PlaneStride + row * this->Way.Row.Stride;
  }

  /// A row of cells, or the outermost one next to it, and on either side the outermost cell again.
  void Load(int plane, int row, std::vector<float>& cells) const
  {
    const int nearest = std::clamp(row, 0, this->Way.Row.Cells - 1);
    const float* from = this->Way.Cells->GetValues().data() + this->Place(plane, nearest);
    const std::ptrdiff_t stride = this->Way.Column.Stride;
    for (int i = 0; i < this->Way.Column.Cells; ++i)
    {
      cells[static_cast<std::size_t>(i) + 1] = from[i * stride];
    }
    cells.front() = cells[1];
    cells.back() = *(cells.end() - 2);
  }

  /// What the cells are where the rays between two rows of them cross a plane.
  void Interpolate(float f, float g)
  {
    const float* near = this->Near.data() + 1;
    const float* far = this->Far.data() + 1;
    float* here = this->Here.data();
    for (int i = 0; i <= this->Way.Column.Cells; ++i)
    {
      const float nearer = (1.0f - f) * near[i] + f * near[i - 1];
      const float farther = (1.0f - f) * far[i] + f * far[i - 1];
      here[i] = (1.0f - g) * nearer + g * farther;
    }
  }

  /// Takes the rays of a row on to a plane. `mostSteps`: as many as the row has been inside.
  void Take(int plane, int ray, const Shift& column, float mostSteps)
  {
    const std::ptrdiff_t at =
      std::ptrdiff_t{ray - this->Begin} * this->Way.Column.Rays + column.Whole;
    float* depths = this->Depths.data() + at;
    float* before = this->Before.data() + at;
    const std::array<float, 2> steps = this->Way.Column.FindSteps(column.Fraction);
    const float most = std::min(plane == 0 ? this->Way.Margin : 1.0f, mostSteps);
    // The centre of an incomplete cell may be outside, before the face.
    const float least = plane == 0 ? std::min(0.0f, this->Way.Margin) : 0.0f;
    const auto stepsOf = [=](int i)
    {
      const float inside = steps[0] + static_cast<float>(i) * steps[1];
      const float atMost = inside < most ? inside : most;
      return atMost > least ? atMost : least;
    };
    this->Way.Cells->GetSurfaces().empty() ? this->Weaken(stepsOf, before, depths)
                                           : this->Cross(stepsOf, before, depths);
    std::swap(this->Transmittances, this->Previous);
    const float* here = this->Here.data();
    float* transmittances = this->Transmittances.data();
    for (int i = 0; i <= this->Way.Column.Cells; ++i)
    {
      before[i] = here[i];
      transmittances[i] = Transmit(depths[i]);
    }
  }

  template <typename StepsOf>
  void Weaken(const StepsOf& stepsOf, const float* before, float* depths) const
  {
    const float* here = this->Here.data();
    for (int i = 0; i <= this->Way.Column.Cells; ++i)
    {
      // Where a ray has come in on its way from the plane before, it knows this plane alone.
      const float steps = stepsOf(i);
      const float mean = steps < 1.0f ? steps * here[i] : 0.5f * (before[i] + here[i]);
      depths[i] += this->Way.Step * mean;
    }
  }

  template <typename StepsOf>
  void Cross(const StepsOf& stepsOf, float* before, float* depths) const
  {
    const float* here = this->Here.data();
    for (int i = 0; i <= this->Way.Column.Cells; ++i)
    {
      // There is nothing to cross from outside of the volume, and to or from what is hidden (not a
      // number, so that the comparison is false).
      const bool inside = stepsOf(i) >= 1.0f && std::abs(here[i] - before[i]) <= Most;
      before[i] = inside ? before[i] : here[i];
    }
    for (const auto& [value, depth] : this->Way.Cells->GetSurfaces())
    {
      for (int i = 0; i <= this->Way.Column.Cells; ++i)
      {
        depths[i] += (before[i] > value) != (here[i] > value) ? depth : 0.0f;
      }
    }
  }

  /// Adds what arrives in a row of cells, which lies between the last two rows of rays.
  void AddRow(float f, float g, float weight, float* sums) const
  {
    const float* lower = this->Previous.data();
    const float* upper = this->Transmittances.data();
    const float low = weight * (1.0f - g);
    const float high = weight * g;
    const std::ptrdiff_t stride = this->Way.Column.Stride;
    for (int i = 0; i < this->Way.Column.Cells; ++i)
    {
      sums[i * stride] += low * ((1.0f - f) * lower[i] + f * lower[i + 1]) +
                          high * ((1.0f - f) * upper[i] + f * upper[i + 1]);
    }
  }

  static constexpr float Most = std::numeric_limits<float>::max();

  const Course& Way;
  const int Begin;
  const int End;
  std::vector<float> Near; ///< rows of cells
  std::vector<float> Far;
  std::vector<float> Here;           ///< the cells where a row of rays crosses them
  std::vector<float> Depths;         ///< of all rays: optical, from where the light enters
  std::vector<float> Before;         ///< the cells at the plane before
  std::vector<float> Transmittances; ///< of a row
  std::vector<float> Previous;       ///< of the row before
};

/// Adds the transmittance times a weight to the sum of each cell, x varying fastest.
/// @param towards to the light, in data lengths along the axes of the volume; of any length but 0.
void AddLight(const vtkTextureSliceLightCells& cells, const std::array<double, 3>& towards,
  double weight, std::vector<float>& sums)
{
  const Course course = FindCourse(cells, towards);
  // Few rows in a task would compute too many rows of rays twice.
  constexpr vtkIdType rowsOfATask = 16;
  vtkSMPTools::For(0, course.Row.Rays, rowsOfATask,
    [&](vtkIdType begin, vtkIdType end)
    {
      RayRows rays(course, static_cast<int>(begin), static_cast<int>(end));
      rays.Sweep(static_cast<float>(weight), sums.data());
    });
}

} // namespace

std::vector<std::array<double, 3>> vtkTextureSliceLightVolume::GetSkyDirections(int count)
{
  // A spiral with one direction in each of equal slices of height, turned by the golden angle.
  const double turn = vtkMath::Pi() * (3.0 - std::sqrt(5.0));
  std::vector<std::array<double, 3>> directions;
  for (int i = 0; i < count; ++i)
  {
    const double height = (i + 0.5) / count;
    const double radius = std::sqrt(1.0 - height * height);
    const double angle = turn * i;
    directions.push_back({radius * std::cos(angle), radius * std::sin(angle), height});
  }
  return directions;
}

void vtkTextureSliceLightVolume::Build(
  const vtkTextureSliceLightCells::Source& source, const Lights& lights, std::size_t mostCells)
{
  const vtkTextureSliceLightCells cells(source, mostCells);
  this->Grid = cells.GetGrid();
  std::vector<float> shadow(this->Grid.CountCells(), lights.Shadow ? 0.0f : 1.0f);
  std::vector<float> occlusion(this->Grid.CountCells(), lights.Occlusion ? 0.0f : 1.0f);
  if (lights.Shadow)
  {
    AddLight(cells, lights.ToLight, 1.0, shadow);
  }
  if (lights.Occlusion)
  {
    const int count = source.Surfaces.empty() ? SkyDirections : SkyDirectionsOfSurfaces;
    for (const auto& direction : GetSkyDirections(count))
    {
      std::array<double, 3> towards{};
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        towards[axis] = lights.Sky[0][axis] * direction[0] + lights.Sky[1][axis] * direction[1] +
                        lights.Sky[2][axis] * direction[2];
      }
      AddLight(cells, towards, 1.0 / count, occlusion);
    }
  }
  this->Light = vtkSmartPointer<vtkFloatArray>::New();
  this->Light->SetName("light");
  this->Light->SetNumberOfComponents(2);
  this->Light->SetNumberOfTuples(static_cast<vtkIdType>(shadow.size()));
  float* light = this->Light->GetPointer(0);
  for (std::size_t i = 0; i < shadow.size(); ++i)
  {
    *light++ = shadow[i];
    *light++ = occlusion[i];
  }
}
