// SPDX-License-Identifier: BSD-3-Clause
#include "Gltf/IsoSurface.h"

#include "Scene/Plan/PlanView.h"
#include "nexrad/Products/VoxelLines.h"
#include "vtkNexradThreads.h"

#include <vtkCellArray.h>
#include <vtkCleanPolyData.h>
#include <vtkClipPolyData.h>
#include <vtkFloatArray.h>
#include <vtkFlyingEdges3D.h>
#include <vtkImageData.h>
#include <vtkMath.h>
#include <vtkPlane.h>
#include <vtkPlaneCollection.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkTriangle.h>
#include <vtkTriangleFilter.h>
#include <vtkTriangleMeshPointNormals.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace nexrad::scene
{
namespace
{

constexpr float noNumber = std::numeric_limits<float>::quiet_NaN();

vtkSmartPointer<vtkFloatArray> CountingValues(const VoxelLines& voxels)
{
  const bool noEchoCounts = voxels.moment == MomentName::REF;
  const auto columns = static_cast<std::size_t>(voxels.grid.dimensions[0]) *
                       static_cast<std::size_t>(voxels.grid.dimensions[1]);
  auto counting = vtkSmartPointer<vtkFloatArray>::New();
  counting->SetName(ToString(voxels.moment));
  counting->SetNumberOfValues(static_cast<vtkIdType>(voxels.grid.VoxelCount()));
  float* const values = counting->GetPointer(0);
  const auto take = [&](const ColumnStretch& stretch)
  {
    float* const taken = values + stretch.first + columns * static_cast<std::size_t>(stretch.level);
    for (std::size_t i = 0; i < stretch.count; ++i)
    {
      const VoxelState state = stretch.states[i];
      const bool counts = noEchoCounts ? IsMeasured(state) : state == VoxelState::Echo;
      taken[i] = counts ? stretch.values[i] : noNumber;
    }
  };
  WalkColumns(voxels, 0, voxels.grid.dimensions[2], vtkNexradRangeLoop(), take);
  return counting;
}

// The points of a surface, each once. Where a voxel has the value of the surface itself, several
// edges meet it at the same place.
class PointMerger
{
public:
  explicit PointMerger(vtkPoints* thePoints)
    : all(vtkFloatArray::SafeDownCast(thePoints->GetData())->GetPointer(0))
    , numbers(static_cast<std::size_t>(thePoints->GetNumberOfPoints()), unseen)
  {
  }

  // The number of the merged point; below 0 where the point is not between two voxels that count.
  vtkIdType Number(vtkIdType point)
  {
    vtkIdType& number = numbers[static_cast<std::size_t>(point)];
    if (number == unseen)
    {
      const float* place = all + 3 * point;
      number = std::all_of(place, place + 3, [](float x) { return std::isfinite(x); })
                 ? this->Merge(place)
                 : open;
    }
    return number;
  }

  vtkPoints* Points() { return points; }

private:
  static constexpr vtkIdType unseen = -2;
  static constexpr vtkIdType open = -1;
  using Place = std::array<float, 3>;
  struct Hash
  {
    std::size_t operator()(const Place& place) const
    {
      return std::hash<std::string_view>()(
        {reinterpret_cast<const char*>(place.data()), sizeof(place)});
    }
  };

  vtkIdType Merge(const float* at)
  {
    const Place place = {at[0], at[1], at[2]};
    const auto [found, isNew] = merged.try_emplace(place, points->GetNumberOfPoints());
    if (isNew)
    {
      points->InsertNextPoint(at);
    }
    return found->second;
  }

  const float* all;
  std::vector<vtkIdType> numbers;
  std::unordered_map<Place, vtkIdType, Hash> merged;
  vtkNew<vtkPoints> points;
};

// The triangles whose corners are all between voxels that count, without those that have no area.
vtkSmartPointer<vtkPolyData> CountingPart(vtkPolyData* surface)
{
  auto part = vtkSmartPointer<vtkPolyData>::New();
  if (surface->GetNumberOfPoints() == 0)
  {
    return part;
  }
  PointMerger merger(surface->GetPoints());
  vtkNew<vtkCellArray> triangles;
  vtkIdType size = 0;
  const vtkIdType* corners = nullptr;
  vtkCellArray* cells = surface->GetPolys();
  for (cells->InitTraversal(); cells->GetNextCell(size, corners) != 0;)
  {
    const std::array<vtkIdType, 3> merged = {
      merger.Number(corners[0]), merger.Number(corners[1]), merger.Number(corners[2])};
    const bool open = *std::min_element(merged.begin(), merged.end()) < 0;
    if (!open && merged[0] != merged[1] && merged[1] != merged[2] && merged[2] != merged[0])
    {
      triangles->InsertNextCell(3, merged.data());
    }
  }
  part->SetPoints(merger.Points());
  part->SetPolys(triangles);
  return part;
}

vtkSmartPointer<vtkPolyData> Cut(vtkSmartPointer<vtkPolyData> surface, vtkPlaneCollection* planes)
{
  for (int i = 0; i < planes->GetNumberOfItems(); ++i)
  {
    vtkNew<vtkClipPolyData> clip;
    clip->SetInputData(surface);
    clip->SetClipFunction(planes->GetItem(i));
    vtkNew<vtkTriangleFilter> triangles;
    triangles->SetInputConnection(clip->GetOutputPort());
    triangles->PassVertsOff();
    triangles->PassLinesOff();
    triangles->Update();
    surface = triangles->GetOutput();
  }
  return surface;
}

// The surface without points that no triangle has: those of a voxel that alone has the value of the
// surface, whose triangles had no area, and those of triangles that are not between voxels that
// count.
vtkSmartPointer<vtkPolyData> WithoutUnusedPoints(vtkPolyData* surface)
{
  vtkNew<vtkCleanPolyData> clean;
  clean->SetInputData(surface);
  clean->PointMergingOff();
  clean->Update();
  return clean->GetOutput();
}

// The normals of triangles cancel at the corner of a sheet, where voxels side by side have the
// value of the surface and lower ones are above and below: such a corner takes that of one
// triangle. Any direction is right where no triangle has an area.
void FillNormals(vtkPolyData* surface)
{
  vtkDataArray* normals = surface->GetPointData()->GetNormals();
  const auto isNone = [normals](vtkIdType point)
  { return vtkMath::Norm(normals->GetTuple3(point)) == 0.0; };
  vtkIdType size = 0;
  const vtkIdType* corners = nullptr;
  vtkCellArray* cells = surface->GetPolys();
  for (cells->InitTraversal(); cells->GetNextCell(size, corners) != 0;)
  {
    for (const vtkIdType* corner = corners; corner != corners + size; ++corner)
    {
      if (isNone(*corner))
      {
        std::array<double, 3> normal{};
        vtkTriangle::ComputeNormal(
          surface->GetPoints(), static_cast<int>(size), corners, normal.data());
        normals->SetTuple(*corner, normal.data());
      }
    }
  }
  for (vtkIdType point = 0; point < surface->GetNumberOfPoints(); ++point)
  {
    if (isNone(point))
    {
      normals->SetTuple3(point, 0.0, 0.0, 1.0);
    }
  }
}

} // namespace

vtkSmartPointer<vtkImageData> MakeCounting(vtkImageData* volume, const SceneFrame& frame)
{
  auto counting = vtkSmartPointer<vtkImageData>::New();
  counting->CopyStructure(volume);
  counting->GetPointData()->SetScalars(CountingValues(SourceOf(volume).voxels));
  frame.MoveToScene(counting);
  return counting;
}

vtkSmartPointer<vtkPolyData> MakeSurface(
  vtkImageData* counting, double value, vtkPlaneCollection* planes)
{
  vtkNew<vtkFlyingEdges3D> contour;
  contour->SetInputData(counting);
  contour->SetValue(0, value);
  contour->ComputeNormalsOff();
  contour->ComputeScalarsOff();
  contour->Update();
  vtkNew<vtkTriangleMeshPointNormals> normals;
  normals->SetInputData(WithoutUnusedPoints(Cut(CountingPart(contour->GetOutput()), planes)));
  normals->Update();
  FillNormals(normals->GetOutput());
  return normals->GetOutput();
}

} // namespace nexrad::scene
