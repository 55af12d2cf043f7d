// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTextureSliceCoordinates.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPointData.h"
#include "vtkRectilinearGrid.h"
#include "vtkTextureSliceOpenGL.h"

#include <algorithm>

namespace
{

constexpr std::size_t LeastWidth = 1024;
constexpr std::size_t MostWidth = 16384; // every OpenGL 4.1 has textures of this size

std::array<vtkDataArray*, 3> GetCoordinates(vtkRectilinearGrid* grid)
{
  return {grid->GetXCoordinates(), grid->GetYCoordinates(), grid->GetZCoordinates()};
}

bool Ascends(vtkDataArray* coordinates)
{
  for (vtkIdType i = 1; i < coordinates->GetNumberOfTuples(); ++i)
  {
    if (!(coordinates->GetComponent(i - 1, 0) < coordinates->GetComponent(i, 0)))
    {
      return false;
    }
  }
  return true;
}

} // namespace

const char* vtkTextureSliceCoordinates::FindUnsupported(vtkRectilinearGrid* grid)
{
  const int* dimensions = grid->GetDimensions();
  const auto coordinates = GetCoordinates(grid);
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const bool complete =
      coordinates[axis] != nullptr && coordinates[axis]->GetNumberOfTuples() == dimensions[axis];
    if (!complete || !Ascends(coordinates[axis]))
    {
      return "a rectilinear grid must have a coordinate for each point along each axis, and they "
             "must ascend: sort them";
    }
  }
  return nullptr;
}

void vtkTextureSliceCoordinates::Set(vtkRectilinearGrid* grid)
{
  std::array<std::vector<double>, 3> places;
  double shortest = 1.0;
  for (std::size_t axis = 0; axis < 3 && grid != nullptr; ++axis)
  {
    vtkDataArray* coordinates = GetCoordinates(grid)[axis];
    const vtkIdType points = coordinates->GetNumberOfTuples();
    const double first = coordinates->GetComponent(0, 0);
    const double length = coordinates->GetComponent(points - 1, 0) - first;
    for (vtkIdType i = 0; i < points; ++i)
    {
      const double place = (coordinates->GetComponent(i, 0) - first) / length;
      places[axis].push_back(points > 1 ? place : 0.0);
      shortest = i > 0 ? std::min(shortest, place - *(places[axis].end() - 2)) : shortest;
    }
  }
  if (places != this->Places)
  {
    this->Places = places;
    this->Filled = false;
    const auto wanted = static_cast<std::size_t>(std::min(16.0 / shortest, 1.0 * MostWidth));
    this->Width = std::clamp(wanted, LeastWidth, MostWidth);
  }
}

vtkSmartPointer<vtkImageData> vtkTextureSliceCoordinates::MakeImage(vtkRectilinearGrid* grid)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  int extent[6];
  double bounds[6];
  grid->GetExtent(extent);
  grid->GetBounds(bounds);
  double spacing[3];
  double origin[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    const int intervals = extent[2 * axis + 1] - extent[2 * axis];
    spacing[axis] = intervals > 0 ? (bounds[2 * axis + 1] - bounds[2 * axis]) / intervals : 1.0;
    origin[axis] = bounds[2 * axis] - extent[2 * axis] * spacing[axis];
  }
  image->SetExtent(extent);
  image->SetSpacing(spacing);
  image->SetOrigin(origin);
  image->GetPointData()->ShallowCopy(grid->GetPointData());
  image->GetCellData()->ShallowCopy(grid->GetCellData());
  image->GetFieldData()->ShallowCopy(grid->GetFieldData());
  return image;
}

void vtkTextureSliceCoordinates::Fill(std::vector<float>& entries) const
{
  entries.assign(4 * this->Width, 0.0f);
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const std::vector<double>& places = this->Places[axis];
    std::size_t next = 1; // the first point that is not before the entry
    for (std::size_t i = 0; i < this->Width; ++i)
    {
      const double place = static_cast<double>(i) / static_cast<double>(this->Width - 1);
      while (next + 1 < places.size() && places[next] < place)
      {
        ++next;
      }
      const double beyond = (place - places[next - 1]) / (places[next] - places[next - 1]);
      entries[4 * i + axis] = static_cast<float>(
        (static_cast<double>(next - 1) + beyond) / static_cast<double>(places.size() - 1));
    }
  }
}

void vtkTextureSliceCoordinates::Update(vtkOpenGLRenderWindow* window)
{
  if (this->Texture->GetHandle() != 0 && this->Texture->GetContext() == window && this->Filled)
  {
    return;
  }
  std::vector<float> entries;
  this->Fill(entries);
  this->Texture->SetContext(window);
  vtkTextureSliceSetSampling(this->Texture, false);
  this->Texture->Create1DFromRaw(
    static_cast<unsigned int>(this->Width), 4, VTK_FLOAT, entries.data());
  this->Filled = true;
}
