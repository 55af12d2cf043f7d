// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/Pointing/VoxelReader.h"

#include "nexrad/Model/Moment.h"

#include <vtkDataArray.h>
#include <vtkDataSetAttributes.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkPointData.h>

#include <algorithm>
#include <cmath>

namespace nexrad::scene
{

VoxelReader::VoxelReader(vtkImageData* image)
  : volume(image)
  , scalars(image->GetPointData()->GetScalars())
  , hidden(image->GetPointData()->GetArray(vtkDataSetAttributes::GhostArrayName()))
{
  volume->GetDimensions(dimensions.data());
  name = scalars->GetName() != nullptr ? scalars->GetName() : "";
  const std::optional<MomentName> moment = ParseMomentName(name);
  unit = moment ? UnitOf(*moment) : "";
  codeValues = volume->GetFieldData()->GetArray((name + "_code_values").c_str());
  if (codeValues != nullptr)
  {
    hidden = volume->GetFieldData()->GetArray((name + "_code_ghosts").c_str());
  }
}

VoxelReader::Index VoxelReader::IndexAt(const std::array<double, 3>& place) const
{
  Index index{};
  const double* origin = volume->GetOrigin();
  const double* spacing = volume->GetSpacing();
  const int* extent = volume->GetExtent();
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    index[axis] = (place[axis] - origin[axis]) / spacing[axis] - extent[2 * axis];
  }
  return index;
}

bool VoxelReader::Holds(const std::array<double, 3>& place) const
{
  const Index index = this->IndexAt(place);
  bool within = true;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    within = within && index[axis] >= 0.0 && index[axis] <= dimensions[axis] - 1.0;
  }
  return within;
}

std::array<int, 3> VoxelReader::Nearest(const Index& index) const
{
  std::array<int, 3> voxel{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    voxel[axis] =
      static_cast<int>(std::clamp(std::round(index[axis]), 0.0, dimensions[axis] - 1.0));
  }
  return voxel;
}

long long VoxelReader::Number(const std::array<int, 3>& voxel) const
{
  return voxel[0] + static_cast<long long>(dimensions[0]) *
                      (voxel[1] + static_cast<long long>(dimensions[1]) * voxel[2]);
}

std::optional<double> VoxelReader::Value(long long voxel) const
{
  const double scalar = scalars->GetComponent(voxel, 0);
  const long long flagged = codeValues != nullptr ? static_cast<long long>(scalar) : voxel;
  if (hidden != nullptr &&
      (static_cast<int>(hidden->GetComponent(flagged, 0)) & vtkDataSetAttributes::HIDDENPOINT) != 0)
  {
    return std::nullopt;
  }
  const double value = codeValues != nullptr ? codeValues->GetComponent(flagged, 0) : scalar;
  return std::isnan(value) ? std::nullopt : std::optional(value);
}

std::optional<double> VoxelReader::ValueAt(const Index& index) const
{
  const std::optional<double> nearest = this->Value(this->Number(this->Nearest(index)));
  if (!nearest)
  {
    return std::nullopt;
  }
  std::array<int, 3> first{};
  std::array<int, 3> second{};
  std::array<double, 3> share{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const double place = std::clamp(index[axis], 0.0, dimensions[axis] - 1.0);
    first[axis] = static_cast<int>(place);
    second[axis] = std::min(first[axis] + 1, dimensions[axis] - 1);
    share[axis] = place - first[axis];
  }
  double sum = 0.0;
  for (int corner = 0; corner < 8; ++corner)
  {
    std::array<int, 3> voxel{};
    double weight = 1.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      const bool upper = (corner >> axis & 1) != 0;
      voxel[axis] = upper ? second[axis] : first[axis];
      weight *= upper ? share[axis] : 1.0 - share[axis];
    }
    sum += weight > 0.0 ? weight * this->Value(this->Number(voxel)).value_or(*nearest) : 0.0;
  }
  return sum;
}

std::optional<double> VoxelReader::NearestOf(const std::string& array, const Index& index) const
{
  vtkDataArray* values = volume->GetPointData()->GetArray(array.c_str());
  const long long voxel = this->Number(this->Nearest(index));
  return values != nullptr && voxel < values->GetNumberOfTuples()
           ? std::optional(values->GetComponent(voxel, 0))
           : std::nullopt;
}

} // namespace nexrad::scene
