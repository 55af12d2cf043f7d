// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/Plan/PlanSource.h"

#include "Scene/Frame/VolumeInformation.h"
#include "nexrad/System/Error.h"
#include "vtkNexradImageConversion.h"

#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <string>

namespace nexrad::scene
{
namespace
{

constexpr vtkIdType codeCount = 256;

// The values of the array of that name; nullptr where there is none of that type and length.
template <class Array>
auto* Find(vtkFieldData* data, const std::string& name, vtkIdType count)
{
  auto* array = Array::SafeDownCast(data->GetArray(name.c_str()));
  const bool right =
    array != nullptr && array->GetNumberOfComponents() == 1 && array->GetNumberOfTuples() >= count;
  return right ? array->GetPointer(0) : nullptr;
}

template <class Array>
auto* Require(vtkFieldData* data, const std::string& name, vtkIdType count)
{
  auto* values = Find<Array>(data, name, count);
  if (values == nullptr)
  {
    throw Error("the volume has no array " + name + " of the type that it should have");
  }
  return values;
}

using ReadVoxels = decltype(VoxelLines::read);

ReadVoxels ReadCodes(vtkImageData* volume, const std::string& name, const unsigned char* codes)
{
  vtkFieldData* field = volume->GetFieldData();
  const float* meant = Require<vtkFloatArray>(field, name + "_code_values", codeCount);
  const unsigned char* known =
    Require<vtkUnsignedCharArray>(field, name + "_code_states", codeCount);
  return [=](std::size_t first, std::size_t count, float* values, VoxelState* states)
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      const unsigned char code = codes[first + i];
      values[i] = meant[code];
      states[i] = ToVoxelState(known[code]);
    }
  };
}

ReadVoxels ReadValues(vtkImageData* volume, const std::string& name)
{
  vtkPointData* points = volume->GetPointData();
  const vtkIdType voxels = volume->GetNumberOfPoints();
  const float* all = Require<vtkFloatArray>(points, name, voxels);
  const unsigned char* known = Require<vtkUnsignedCharArray>(points, name + "_state", voxels);
  return [=](std::size_t first, std::size_t count, float* values, VoxelState* states)
  {
    std::copy_n(all + first, count, values);
    std::transform(known + first, known + first + count, states, ToVoxelState);
  };
}

} // namespace

PlanSource SourceOf(const GriddedVolume& volume)
{
  const AncillaryArrays& arrays = volume.ancillary;
  const auto valuesOf = [](const auto& values) { return values.empty() ? nullptr : values.data(); };
  return {LinesOf(volume), valuesOf(arrays.age), valuesOf(arrays.radars), valuesOf(arrays.weight),
    valuesOf(arrays.nearestSite), volume.sharpened};
}

PlanSource SourceOf(vtkImageData* volume)
{
  const std::string name = ArrayOf(volume);
  const auto moment = ParseMomentName(name);
  if (!moment)
  {
    throw Error("the volume's active scalars are no radar moment: '" + name + "'");
  }
  vtkPointData* points = volume->GetPointData();
  const vtkIdType voxels = volume->GetNumberOfPoints();
  const unsigned char* codes = Find<vtkUnsignedCharArray>(points, name, voxels);
  PlanSource source;
  const GridSpecification grid = vtkNexradImageToGrid(volume);
  const VolumeInformation information = ReadVolumeInformation(volume);
  source.voxels = {grid, *moment,
    codes != nullptr ? ReadCodes(volume, name, codes) : ReadValues(volume, name),
    GroundHeight(grid, information.sites, {})};
  source.age = Find<vtkFloatArray>(points, name + "_age", voxels);
  source.radars = Find<vtkUnsignedCharArray>(points, name + "_radars", voxels);
  source.weight = Find<vtkFloatArray>(points, name + "_weight", voxels);
  source.nearestSite = Find<vtkUnsignedCharArray>(points, name + "_site", voxels);
  source.sharpened = information.sharpened;
  return source;
}

} // namespace nexrad::scene
