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

using Function = vtkTextureSliceLightCells::Function;
using CellSource = vtkTextureSliceLightCells::Source;

/// A voxel counts as no denser than this over its shortest edge: light that passes through a few
/// voxels of an opaque cell's edge is not stopped by their mean.
constexpr float MostDepthOfAVoxel = 4.0f;

constexpr float NotANumber = std::numeric_limits<float>::quiet_NaN();

/// A function as the loops over voxels read it.
struct Lookup
{
  explicit Lookup(const Function& function)
    : Entries(function.Entries.data())
    , Component(function.Component)
    , Last(static_cast<float>(function.Entries.size() - 1))
    , Low(static_cast<float>(function.Range[0]))
    , Scale(function.Range[1] > function.Range[0]
              ? this->Last / static_cast<float>(function.Range[1] - function.Range[0])
              : this->Last)
  {
  }

  float operator()(float scalar) const
  {
    const float entry = (scalar - this->Low) * this->Scale;
    // In this order a scalar that is not a number reads the first entry.
    const float inside = entry > 0.0f ? (entry < this->Last ? entry : this->Last) : 0.0f;
    return this->Entries[static_cast<int>(inside + 0.5f)];
  }

  const float* Entries;
  std::size_t Component;
  float Last;
  float Low;
  float Scale;
};

template <typename Scalar>
class RowsOfCells
{
public:
  RowsOfCells(
    const CellSource& source, const vtkTextureSliceLightGrid& grid, std::vector<float>& values)
    : Input(source)
    , Grid(grid)
    , Values(values)
    , Rows(source.Scalars)
    , Most(MostDepthOfAVoxel /
           static_cast<float>(*std::min_element(source.VoxelEdge.begin(), source.VoxelEdge.end())))
  {
    for (const std::vector<Function>& functions : source.Functions)
    {
      this->Lookups.emplace_back(functions.begin(), functions.end());
    }
  }

  void operator()(vtkIdType begin, vtkIdType end) const
  {
    std::vector<unsigned char> visible(this->Rows.Length, 1);
    std::vector<Sum> sums;
    for (auto row = static_cast<int>(begin); row < static_cast<int>(end); ++row)
    {
      const int cellY = row % this->Grid.Size[1];
      const int cellZ = row / this->Grid.Size[1];
      const auto [firstY, endY] = this->Grid.GetRows(cellY, 1);
      const auto [firstZ, endZ] = this->Grid.GetRows(cellZ, 2);
      sums.assign(static_cast<std::size_t>(this->Grid.Size[0]), {});
      for (int z = firstZ; z < endZ; ++z)
      {
        for (int y = firstY; y < endY; ++y)
        {
          this->AddRow(y, z, visible, sums.data());
        }
      }
      const int rows = (endY - firstY) * (endZ - firstZ);
      float* cells = this->Values.data() + std::ptrdiff_t{row} * this->Grid.Size[0];
      for (int x = 0; x < this->Grid.Size[0]; ++x)
      {
        const int first = x * this->Grid.Factor[0];
        const int voxels = std::min(this->Grid.Factor[0], this->Grid.Voxels[0] - first) * rows;
        const bool left =
          !this->Input.Left || this->Input.Left->Leaves({this->Grid.GetPlace(x, 0),
                                 this->Grid.GetPlace(cellY, 1), this->Grid.GetPlace(cellZ, 2)});
        cells[x] = this->Average(left ? sums[static_cast<std::size_t>(x)] : Sum(), voxels);
      }
    }
  }

private:
  /// Over the voxels of a cell.
  struct Sum
  {
    float Value = 0.0f;
    int Visible = 0; ///< with isosurfaces: how many voxels
  };

  bool HasSurfaces() const { return !this->Input.Surfaces.empty(); }

  void AddRow(int y, int z, std::vector<unsigned char>& visible, Sum* sums) const
  {
    if (this->Input.Masked)
    {
      this->Rows.MarkVisible(y, z, 0, this->Rows.Length, visible.data());
    }
    const Scalar* scalars = this->Rows.GetScalars(y, z);
    const unsigned char* mask = this->Input.Mask;
    mask = mask == nullptr ? nullptr
                           : mask + (std::ptrdiff_t{z} * this->Grid.Voxels[1] + y) *
                                      std::ptrdiff_t{this->Grid.Voxels[0]};
    for (std::size_t i = 0; i < this->Rows.Length; ++sums)
    {
      Sum sum = *sums; // a copy, so that the functions need not be read anew
      const std::size_t end =
        std::min(this->Rows.Length, i + static_cast<std::size_t>(this->Grid.Factor[0]));
      for (; i < end; ++i, scalars += this->Rows.Components)
      {
        const std::size_t label = mask == nullptr ? 0 : mask[i];
        if (visible[i] != 0 && !this->HasSurfaces())
        {
          sum.Value += this->FindExtinction(scalars, label);
        }
        else if (visible[i] != 0 && (mask == nullptr || label > 0))
        {
          sum.Value += this->Decode(scalars[this->Input.Component]);
          ++sum.Visible;
        }
      }
      *sums = sum;
    }
  }

  float Decode(Scalar scalar) const
  {
    const auto& codes = this->Input.Scalars.Codes;
    return static_cast<float>(codes ? codes->Values[static_cast<std::size_t>(scalar)] : scalar);
  }

  float FindExtinction(const Scalar* scalars, std::size_t label) const
  {
    float extinction = 0.0f;
    for (const Lookup& lookUp : this->Lookups[std::min(label, this->Lookups.size() - 1)])
    {
      extinction += lookUp(this->Decode(scalars[lookUp.Component]));
    }
    return std::min(extinction, this->Most);
  }

  float Average(const Sum& sum, int voxels) const
  {
    if (!this->HasSurfaces())
    {
      return sum.Value / static_cast<float>(voxels);
    }
    return 2 * sum.Visible >= voxels ? sum.Value / static_cast<float>(sum.Visible) : NotANumber;
  }

  const CellSource& Input;
  const vtkTextureSliceLightGrid& Grid;
  std::vector<float>& Values;
  vtkTextureSlice::Rows<Scalar> Rows;
  const float Most;
  std::vector<std::vector<Lookup>> Lookups;
};

} // namespace

vtkTextureSliceLightGrid vtkTextureSliceLightGrid::Choose(const std::array<int, 3>& voxels,
  bool cellData, const std::array<double, 3>& voxelEdge, std::size_t mostCells)
{
  vtkTextureSliceLightGrid grid;
  grid.Voxels = voxels;
  grid.Size = voxels;
  grid.CellEdge = voxelEdge;
  grid.CellData = cellData;
  while (grid.CountCells() > mostCells)
  {
    const auto shortest = static_cast<std::size_t>(
      std::min_element(grid.CellEdge.begin(), grid.CellEdge.end()) - grid.CellEdge.begin());
    // An axis of one cell has nothing left to give.
    const auto longest = static_cast<std::size_t>(
      std::max_element(grid.Size.begin(), grid.Size.end()) - grid.Size.begin());
    const std::size_t axis = grid.Size[shortest] > 1 ? shortest : longest;
    if (grid.Size[axis] == 1)
    {
      break;
    }
    grid.Factor[axis] *= 2;
    grid.CellEdge[axis] *= 2.0;
    grid.Size[axis] = (voxels[axis] + grid.Factor[axis] - 1) / grid.Factor[axis];
  }
  return grid;
}

std::size_t vtkTextureSliceLightGrid::CountCells(int more) const
{
  return static_cast<std::size_t>(this->Size[0] + more) *
         static_cast<std::size_t>(this->Size[1] + more) *
         static_cast<std::size_t>(this->Size[2] + more);
}

std::array<int, 2> vtkTextureSliceLightGrid::GetRows(int cell, std::size_t axis) const
{
  constexpr int mostRows = 4;
  const int inset = std::max(0, (this->Factor[axis] - mostRows) / 2);
  const int end = std::min(this->Voxels[axis], (cell + 1) * this->Factor[axis] - inset);
  return {std::min(cell * this->Factor[axis] + inset, end - 1), end};
}

double vtkTextureSliceLightGrid::GetPlace(int cell, std::size_t axis) const
{
  const double low = this->GetMargin(axis, false);
  const double intervals = low + this->Size[axis] - 1 + this->GetMargin(axis, true);
  return (cell + low) / intervals;
}

double vtkTextureSliceLightGrid::GetMargin(std::size_t axis, bool high) const
{
  const double factor = this->Factor[axis];
  const double face = this->CellData ? 0.5 : 0.0; // voxels beyond the centre of the outermost one
  const double centre =
    high ? factor * (this->Size[axis] - 1) + (factor - 1.0) / 2.0 : (factor - 1.0) / 2.0;
  return (high ? this->Voxels[axis] - 1 + face - centre : centre + face) / factor;
}

std::array<float, 3> vtkTextureSliceLightGrid::GetTextureScale() const
{
  std::array<float, 3> scale{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    scale[axis] = static_cast<float>(this->Voxels[axis]) /
                  static_cast<float>(this->Factor[axis] * this->Size[axis]);
  }
  return scale;
}

bool vtkTextureSliceCut::Leaves(const std::array<double, 3>& at) const
{
  int region = 0;
  constexpr std::array<int, 3> weights{1, 3, 9};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    if (at[axis] < this->Part[2 * axis] || at[axis] > this->Part[2 * axis + 1])
    {
      return false;
    }
    region += weights[axis] * ((at[axis] >= this->CropLow[axis] ? 1 : 0) +
                                (at[axis] > this->CropHigh[axis] ? 1 : 0));
  }
  return (this->CropFlags >> region & 1) != 0 &&
         std::all_of(this->Planes.begin(), this->Planes.end(),
           [&](const std::array<double, 4>& plane)
           { return plane[0] * at[0] + plane[1] * at[1] + plane[2] * at[2] + plane[3] >= 0.0; });
}

vtkTextureSliceLightCells::vtkTextureSliceLightCells(const Source& source, std::size_t mostCells)
  : Grid(vtkTextureSliceLightGrid::Choose(
      source.Scalars.Size, source.Scalars.CellData, source.VoxelEdge, mostCells))
  , Surfaces(source.Surfaces)
  , Values(this->Grid.CountCells())
{
  const vtkIdType rows = vtkIdType{this->Grid.Size[1]} * this->Grid.Size[2];
  switch (source.Scalars.Scalars->GetDataType())
  {
    vtkTemplateMacro(
      vtkSMPTools::For(0, rows, RowsOfCells<VTK_TT>(source, this->Grid, this->Values)));
  }
}

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

using Course = vtkTextureSliceLightCourse;

Course FindCourse(
  const vtkTextureSliceLightGrid& grid, const std::array<double, 3>& towards, double weight)
{
  // In cells along each axis, for one length of the direction.
  const double length = std::hypot(towards[0], towards[1], towards[2]);
  std::array<double, 3> direction{};
  std::size_t through = 0; // the axis across the planes
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    direction[axis] = towards[axis] / (length * grid.CellEdge[axis]);
    through = std::abs(direction[axis]) > std::abs(direction[through]) ? axis : through;
  }
  const std::array<int, 3> strides{1, grid.Size[0], grid.Size[0] * grid.Size[1]};
  const bool fromHigh = direction[through] > 0.0;
  Course course{};
  course.Planes = grid.Size[through];
  course.First = fromHigh ? (course.Planes - 1) * strides[through] : 0;
  course.PlaneStride = fromHigh ? -strides[through] : strides[through];
  course.Step = static_cast<float>(1.0 / std::abs(direction[through]));
  course.Margin = static_cast<float>(grid.GetMargin(through, fromHigh));
  course.Weight = static_cast<float>(weight);
  // Rows are contiguous in memory unless the direction follows them.
  const std::array<std::size_t, 2> axes{through == 0 ? 1U : 0U, through == 2 ? 1U : 2U};
  for (std::size_t i = 0; i < 2; ++i)
  {
    const std::size_t axis = axes[i];
    const double slope = direction[axis] / std::abs(direction[through]);
    course.Cells[i] = grid.Size[axis];
    course.Stride[i] = strides[axis];
    course.Rays[i] =
      grid.Size[axis] + static_cast<int>(std::ceil(std::abs(slope) * course.Planes)) + 2;
    course.Slope[i] = std::abs(slope) * course.Rays[i] < 1e-6 ? 0.0f : static_cast<float>(slope);
    course.Offset[i] = std::max(0.0f, -course.Slope[i] * static_cast<float>(course.Planes - 1));
    course.LowMargin[i] = static_cast<float>(grid.GetMargin(axis, false));
    course.HighMargin[i] = static_cast<float>(grid.GetMargin(axis, true));
  }
  return course;
}

/// Where the rays cross a plane, along one axis of their raster.
struct Crossing
{
  Crossing(const Course& course, std::size_t axis, int plane)
  {
    const float slope = course.Slope[axis];
    const float place = std::max(0.0f, slope * static_cast<float>(plane) + course.Offset[axis]);
    this->Whole = static_cast<int>(place);
    this->Fraction = place - static_cast<float>(this->Whole);
    if (slope != 0.0f)
    {
      const float first = slope < 0.0f ? course.LowMargin[axis] - this->Fraction
                                       : course.HighMargin[axis] + this->Fraction +
                                           static_cast<float>(course.Cells[axis] - 1);
      this->FirstSteps = first / std::abs(slope);
      this->MoreSteps = -1.0f / slope;
    }
  }

  /// Steps that the ray before a cell has been inside of the sides of the volume.
  float CountSteps(int cell) const
  {
    return this->FirstSteps + static_cast<float>(cell) * this->MoreSteps;
  }

  int Whole;      ///< the ray before the cell 0
  float Fraction; ///< of a cell, by which rays lie before cells
  float FirstSteps = 1.0f;
  float MoreSteps = 0.0f;
};

/// The rays of the rows [begin, end] of the raster. The last row belongs to the next range, but
/// cells of this one lie before it.
class RayRows
{
public:
  RayRows(const vtkTextureSliceLightCells& cells, const Course& course, int begin, int end)
    : Cells(cells)
    , Way(course)
    , Columns(course.Cells[0])
    , Begin(begin)
    , End(end)
    , Near(static_cast<std::size_t>(course.Cells[0]) + 2)
    , Far(this->Near)
    , Here(this->Near)
    , Before(static_cast<std::size_t>((end - begin + 1) * course.Rays[0]))
    , Depths(this->Before)
    , Transmittances(this->Near)
    , Previous(this->Near)
  {
  }

  void AddTo(float* sums)
  {
    for (int plane = 0; plane < this->Way.Planes; ++plane)
    {
      const Crossing column(this->Way, 0, plane);
      const Crossing row(this->Way, 1, plane);
      const int first = std::max(this->Begin - row.Whole, 0);
      const int last = std::min(this->End - row.Whole, this->Way.Cells[1]);
      // A ray lies between a row of cells and the one before.
      this->Load(plane, first - 1, this->Near);
      for (int cell = first; cell <= last; ++cell)
      {
        std::swap(this->Near, this->Far);
        this->Load(plane, cell, this->Near);
        this->Interpolate(column.Fraction, row.Fraction);
        this->Take(plane, (row.Whole + cell - this->Begin) * this->Way.Rays[0] + column.Whole,
          column, row.CountSteps(cell));
        if (cell > first)
        {
          this->AddRow(column.Fraction, row.Fraction, sums + this->Place(plane, cell - 1));
        }
      }
    }
  }

private:
  std::ptrdiff_t Place(int plane, int row) const
  {
    return this->Way.First + plane * this->Way.PlaneStride + row * this->Way.Stride[1];
  }

  /// A row of cells, or the outermost one next to it, and on either side the outermost cell again.
  void Load(int plane, int row, std::vector<float>& cells) const
  {
    const int nearest = std::clamp(row, 0, this->Way.Cells[1] - 1);
    const float* from = this->Cells.Values.data() + this->Place(plane, nearest);
    for (int i = 0; i < this->Columns; ++i)
    {
      cells[static_cast<std::size_t>(i) + 1] = from[i * this->Way.Stride[0]];
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
    for (int i = 0; i <= this->Columns; ++i)
    {
      const float nearer = (1.0f - f) * near[i] + f * near[i - 1];
      const float farther = (1.0f - f) * far[i] + f * far[i - 1];
      here[i] = (1.0f - g) * nearer + g * farther;
    }
  }

  /// Takes the rays on to a plane. @param mostSteps as many as the row has been inside
  void Take(int plane, int ray, const Crossing& column, float mostSteps)
  {
    float* before = this->Before.data() + ray;
    float* depths = this->Depths.data() + ray;
    const float most = std::min(plane == 0 ? this->Way.Margin : 1.0f, mostSteps);
    // The centre of an incomplete cell may be outside, before the face.
    const float least = plane == 0 ? std::min(0.0f, this->Way.Margin) : 0.0f;
    const auto stepsOf = [=](int i)
    {
      const float inside = column.CountSteps(i);
      const float atMost = inside < most ? inside : most;
      return atMost > least ? atMost : least;
    };
    this->Cells.Surfaces.empty() ? this->Weaken(stepsOf, before, depths)
                                 : this->Cross(stepsOf, before, depths);
    std::swap(this->Transmittances, this->Previous);
    const float* here = this->Here.data();
    float* transmittances = this->Transmittances.data();
    for (int i = 0; i <= this->Columns; ++i)
    {
      before[i] = here[i];
      transmittances[i] = Transmit(depths[i]);
    }
  }

  template <typename StepsOf>
  void Weaken(const StepsOf& stepsOf, const float* before, float* depths) const
  {
    const float* here = this->Here.data();
    const float step = this->Way.Step;
    for (int i = 0; i <= this->Columns; ++i)
    {
      // Where a ray has come in on its way from the plane before, it knows this plane alone.
      const float steps = stepsOf(i);
      const float alone = steps * here[i];
      const float both = 0.5f * (before[i] + here[i]);
      depths[i] += step * (steps < 1.0f ? alone : both);
    }
  }

  template <typename StepsOf>
  void Cross(const StepsOf& stepsOf, float* before, float* depths) const
  {
    const float* here = this->Here.data();
    for (int i = 0; i <= this->Columns; ++i)
    {
      // There is nothing to cross from outside of the volume, and to or from what is hidden (not a
      // number, so that the comparison is false).
      const bool inside = stepsOf(i) >= 1.0f && std::abs(here[i] - before[i]) <= Most;
      before[i] = inside ? before[i] : here[i];
    }
    for (const auto& surface : this->Cells.Surfaces)
    {
      const auto [value, depth] = surface; // a copy, which no depth overwrites
      for (int i = 0; i <= this->Columns; ++i)
      {
        depths[i] += (before[i] > value) != (here[i] > value) ? depth : 0.0f;
      }
    }
  }

  /// Adds what arrives in a row of cells, which lies between the last two rows of rays.
  void AddRow(float f, float g, float* sums) const
  {
    const float* lower = this->Previous.data();
    const float* upper = this->Transmittances.data();
    const float low = this->Way.Weight * (1.0f - g);
    const float high = this->Way.Weight * g;
    for (int i = 0; i < this->Columns; ++i)
    {
      sums[i * this->Way.Stride[0]] += low * ((1.0f - f) * lower[i] + f * lower[i + 1]) +
                                       high * ((1.0f - f) * upper[i] + f * upper[i + 1]);
    }
  }

  static constexpr float Most = std::numeric_limits<float>::max();

  const vtkTextureSliceLightCells& Cells;
  const Course& Way;
  const int Columns;
  const int Begin;
  const int End;
  std::vector<float> Near; ///< rows of cells
  std::vector<float> Far;
  std::vector<float> Here;           ///< the cells where the rays cross them
  std::vector<float> Before;         ///< for each ray, the cell at the plane before
  std::vector<float> Depths;         ///< optical, from where the light enters
  std::vector<float> Transmittances; ///< of a row
  std::vector<float> Previous;       ///< of the row before
};

void SweepOnProcessor(const vtkTextureSliceLightCells& cells,
  const vtkTextureSliceLightVolume::Courses& courses, std::vector<float>& sums)
{
  // Few rows in a task would compute too many rows of rays twice.
  constexpr vtkIdType rowsOfATask = 16;
  for (const Course& course : courses)
  {
    vtkSMPTools::For(0, course.Rays[1], rowsOfATask,
      [&](vtkIdType begin, vtkIdType end) {
        RayRows(cells, course, static_cast<int>(begin), static_cast<int>(end)).AddTo(sums.data());
      });
  }
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
  const vtkTextureSliceLightCells& cells, const Lights& lights, const Sweep& sweep)
{
  this->Grid = cells.Grid;
  std::array<Courses, 2> courses; // to the light, and over the sky
  if (lights.Shadow)
  {
    courses[0].push_back(FindCourse(this->Grid, lights.ToLight, 1.0));
  }
  const int count = cells.Surfaces.empty() ? SkyDirections : SkyDirectionsOfSurfaces;
  for (const auto& direction : GetSkyDirections(lights.Occlusion ? count : 0))
  {
    std::array<double, 3> towards{};
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      towards[axis] = lights.Sky[0][axis] * direction[0] + lights.Sky[1][axis] * direction[1] +
                      lights.Sky[2][axis] * direction[2];
    }
    courses[1].push_back(FindCourse(this->Grid, towards, 1.0 / count));
  }
  this->Light = vtkSmartPointer<vtkFloatArray>::New();
  this->Light->SetName("light");
  this->Light->SetNumberOfComponents(2);
  this->Light->SetNumberOfTuples(static_cast<vtkIdType>(this->Grid.CountCells()));
  for (std::size_t component = 0; component < courses.size(); ++component)
  {
    std::vector<float> sums(this->Grid.CountCells(), courses[component].empty() ? 1.0f : 0.0f);
    if (!courses[component].empty() && !(sweep && sweep(cells, courses[component], sums)))
    {
      SweepOnProcessor(cells, courses[component], sums);
    }
    for (std::size_t i = 0; i < sums.size(); ++i)
    {
      this->Light->GetPointer(0)[2 * i + component] = sums[i];
    }
  }
}
