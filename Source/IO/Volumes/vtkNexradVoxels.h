// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file   vtkNexradVoxels.h
 * @brief  which arrays an image has, and values and states of a moment, in values or in codes
 *
 * The arrays are those of vtkNexradImageConversion.h.
 */
#ifndef vtkNexradVoxels_h
#define vtkNexradVoxels_h

#include "nexrad/Grid/GriddedVolume.h"
#include "nexrad/Grid/MomentCode.h"
#include "nexrad/System/Error.h"

#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkUnsignedCharArray.h>

#include <cstddef>
#include <optional>
#include <string>

/// The values of the array of that name; nullptr where there is none of that type, with one
/// component and at least so many values.
template <class Array>
auto* vtkNexradFindValues(vtkFieldData* data, const std::string& name, vtkIdType count)
{
  auto* array = Array::SafeDownCast(data->GetArray(name.c_str()));
  const bool fits =
    array != nullptr && array->GetNumberOfComponents() == 1 && array->GetNumberOfTuples() >= count;
  return fits ? array->GetPointer(0) : nullptr;
}

/// Name of the active scalars, as "REF"; empty where they have none, and where there are no
/// scalars.
inline std::string vtkNexradScalarsName(vtkImageData* image)
{
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  return scalars != nullptr && scalars->GetName() != nullptr ? scalars->GetName() : "";
}

/// The moment of the active scalars. Throws nexrad::Error where they are of none.
inline nexrad::MomentName vtkNexradScalarsMoment(vtkImageData* image)
{
  const std::string name = vtkNexradScalarsName(image);
  const auto moment = nexrad::ParseMomentName(name);
  if (!moment)
  {
    throw nexrad::Error("the volume's active scalars are no radar moment: '" + name + "'");
  }
  return *moment;
}

/// What each code of an array stands for, 256 numbers of any type; nullptr where the array has no
/// codes.
inline vtkDataArray* vtkNexradFindCodeValues(vtkImageData* image, const std::string& name)
{
  vtkDataArray* values = image->GetFieldData()->GetArray((name + "_code_values").c_str());
  vtkDataArray* codes = image->GetPointData()->GetArray(name.c_str());
  constexpr auto codeCount = static_cast<vtkIdType>(nexrad::VoxelCodes::Count);
  const bool fits = vtkUnsignedCharArray::SafeDownCast(codes) != nullptr && values != nullptr &&
                    values->GetNumberOfValues() == codeCount;
  return fits ? values : nullptr;
}

/// A moment's voxels where they are, without a copy; valid while the image keeps its arrays.
class vtkNexradVoxels
{
public:
  /// Nothing where the image lacks one of the arrays, or has it of another type or length.
  static std::optional<vtkNexradVoxels> Find(vtkImageData* image, const std::string& moment)
  {
    constexpr auto codeCount = static_cast<vtkIdType>(nexrad::VoxelCodes::Count);
    vtkNexradVoxels voxels;
    vtkFieldData* data = image->GetPointData();
    const vtkIdType count = image->GetNumberOfPoints();
    voxels.Codes = vtkNexradFindValues<vtkUnsignedCharArray>(data, moment, count);
    if (voxels.Codes != nullptr)
    {
      data = image->GetFieldData();
      voxels.Values = vtkNexradFindValues<vtkFloatArray>(data, moment + "_code_values", codeCount);
      voxels.States =
        vtkNexradFindValues<vtkUnsignedCharArray>(data, moment + "_code_states", codeCount);
    }
    else
    {
      voxels.Values = vtkNexradFindValues<vtkFloatArray>(data, moment, count);
      voxels.States = vtkNexradFindValues<vtkUnsignedCharArray>(data, moment + "_state", count);
    }
    return voxels.Values != nullptr && voxels.States != nullptr ? std::optional(voxels)
                                                                : std::nullopt;
  }

  /// Throws nexrad::Error where Find gives nothing.
  static vtkNexradVoxels Require(vtkImageData* image, const std::string& moment)
  {
    const auto voxels = Find(image, moment);
    if (!voxels)
    {
      throw nexrad::Error("the volume needs the arrays " + moment + " (float) and " + moment +
                          "_state (unsigned char), or codes with their tables");
    }
    return *voxels;
  }

  float Value(std::size_t voxel) const { return this->Values[this->Place(voxel)]; }
  nexrad::VoxelState State(std::size_t voxel) const
  {
    return nexrad::ToVoxelState(this->States[this->Place(voxel)]);
  }

private:
  std::size_t Place(std::size_t voxel) const
  {
    return this->Codes != nullptr ? this->Codes[voxel] : voxel;
  }

  const unsigned char* Codes = nullptr; ///< nullptr: an image of values
  const float* Values = nullptr;        ///< of each code, or voxel
  const unsigned char* States = nullptr;
};

#endif
