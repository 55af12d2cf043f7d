// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTextureSliceScalars.h"

#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPointData.h"
#include "vtkRectilinearGrid.h"
#include "vtkTextureSliceOpenGL.h"

#include <string>

namespace
{

/// An array of one number for each code; nullptr where there is none.
vtkDataArray* FindTable(vtkImageData* image, vtkDataArray* scalars, const char* ending)
{
  const char* name = scalars->GetName();
  vtkDataArray* table = name != nullptr
                          ? image->GetFieldData()->GetArray((std::string(name) + ending).c_str())
                          : nullptr;
  const bool fits = table != nullptr && table->GetNumberOfComponents() == 1 &&
                    table->GetNumberOfTuples() == vtkIdType{vtkTextureSliceCodes::Count};
  return fits ? table : nullptr;
}

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

std::optional<vtkTextureSliceCodes> vtkTextureSliceCodes::Find(
  vtkImageData* image, vtkDataArray* scalars)
{
  vtkDataArray* values = FindTable(image, scalars, "_code_values");
  if (scalars->GetDataType() != VTK_UNSIGNED_CHAR || scalars->GetNumberOfComponents() != 1 ||
      values == nullptr)
  {
    return std::nullopt;
  }
  vtkDataArray* ghosts = FindTable(image, scalars, "_code_ghosts");
  std::array<double, Count> valueOf;
  std::array<unsigned char, Count> hidden;
  for (std::size_t code = 0; code < Count; ++code)
  {
    const auto tuple = static_cast<vtkIdType>(code);
    valueOf[code] = values->GetComponent(tuple, 0);
    hidden[code] = ghosts != nullptr && ghosts->GetComponent(tuple, 0) != 0.0 ? 1 : 0;
  }
  return vtkTextureSliceCodes(valueOf, hidden);
}

vtkTextureSliceCodes::vtkTextureSliceCodes(
  const std::array<double, Count>& values, const std::array<unsigned char, Count>& hidden)
  : Values(values)
{
  std::vector<double> seen;
  for (std::size_t code = 0; code < Count; ++code)
  {
    if (!std::isfinite(values[code]))
    {
      this->Values[code] = std::numeric_limits<double>::infinity(); // equals itself, unlike NaN
    }
    else if (hidden[code] == 0)
    {
      this->Visible[code] = 1;
      seen.push_back(values[code]);
    }
  }
  std::sort(seen.begin(), seen.end());
  seen.erase(std::unique(seen.begin(), seen.end()), seen.end());
  if (!seen.empty())
  {
    this->FindBytes(seen);
  }
}

void vtkTextureSliceCodes::FindBytes(const std::vector<double>& seen)
{
  // The least distance of two values, of which all others must be a multiple. Values may be rounded
  // to floats: it is made exact by the whole range.
  constexpr double tolerance = 1e-3;
  const double width = seen.back() - seen.front();
  double least = width > 0.0 ? width : 1.0;
  for (std::size_t i = 1; i < seen.size(); ++i)
  {
    least = std::min(least, seen[i] - seen[i - 1]);
  }
  const double steps = std::round(width / least);
  const double step = steps > 0.0 ? width / steps : 1.0;
  const auto place = [&](double value) { return (value - seen.front()) / step; };
  const bool even = std::all_of(seen.begin(), seen.end(),
    [&](double value) { return std::abs(place(value) - std::round(place(value))) < tolerance; });
  if (steps > 255.0 || !even)
  {
    return;
  }
  this->Step = step;
  this->Base = seen.front();
  for (std::size_t code = 0; code < Count; ++code)
  {
    this->Bytes[code] = this->Visible[code] == 0
                          ? 0
                          : static_cast<unsigned char>(std::lround(place(this->Values[code])));
  }
}

std::array<unsigned char, 2> vtkTextureSliceCodes::FindInterval() const
{
  const auto begin = this->Visible.begin();
  const auto first = std::find(begin, this->Visible.end(), 1);
  const auto end = std::find(first, this->Visible.end(), 0);
  if (first == end || std::find(end, this->Visible.end(), 1) != this->Visible.end())
  {
    return {255, 0};
  }
  return {static_cast<unsigned char>(first - begin), static_cast<unsigned char>(end - begin - 1)};
}

std::array<double, 2> vtkTextureSliceCodes::GetRange(std::size_t low, std::size_t high) const
{
  std::array<double, 2> range{
    std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (std::size_t code = low; code <= high; ++code)
  {
    if (this->Visible[code] != 0)
    {
      range = {std::min(range[0], this->Values[code]), std::max(range[1], this->Values[code])};
    }
  }
  return range;
}

std::array<int, 3> vtkTextureSliceScalars::GetSize(vtkImageData* image, bool cellData)
{
  std::array<int, 3> size;
  image->GetDimensions(size.data());
  for (int& texels : size)
  {
    texels -= cellData ? 1 : 0;
  }
  return size;
}

vtkUnsignedCharArray* vtkTextureSliceScalars::FindGhosts(vtkImageData* image, bool ofCells)
{
  vtkDataSetAttributes* attributes =
    ofCells ? static_cast<vtkDataSetAttributes*>(image->GetCellData()) : image->GetPointData();
  const vtkIdType count = ofCells ? image->GetNumberOfCells() : image->GetNumberOfPoints();
  auto* ghosts = vtkUnsignedCharArray::SafeDownCast(
    attributes->GetArray(vtkDataSetAttributes::GhostArrayName()));
  return ghosts != nullptr && ghosts->GetNumberOfTuples() == count ? ghosts : nullptr;
}

vtkTextureSliceScalars vtkTextureSliceScalars::Find(
  vtkImageData* image, vtkDataArray* scalars, bool cellData)
{
  return {scalars, GetSize(image, cellData), cellData, FindGhosts(image, cellData),
    vtkTextureSliceCodes::Find(image, scalars)};
}

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

void vtkTextureSliceCoordinates::Update(vtkOpenGLRenderWindow* window)
{
  if (this->Texture->GetHandle() != 0 && this->Texture->GetContext() == window && this->Filled)
  {
    return;
  }
  std::vector<float> entries(4 * this->Width, 0.0f);
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
  this->Texture->SetContext(window);
  vtkTextureSliceSetSampling(this->Texture, false);
  this->Texture->Create1DFromRaw(
    static_cast<unsigned int>(this->Width), 4, VTK_FLOAT, entries.data());
  this->Filled = true;
}
