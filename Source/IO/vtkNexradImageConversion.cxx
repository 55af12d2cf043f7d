// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNexradImageConversion.h"

#include "nexrad/Grid/GriddedVolume.h"
#include "nexrad/System/Error.h"
#include "vtkNexradFieldData.h"

#include "vtkDataSetAttributes.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkMatrix3x3.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cstdint>
#include <type_traits>

namespace
{

std::string StateName(nexrad::MomentName moment)
{
  return std::string(nexrad::ToString(moment)) + "_state";
}

void AddFieldData(const nexrad::GriddedVolume& volume, vtkFieldData* field)
{
  vtkNexradAddValues<vtkFloatArray, float>(field, "FillValue", {volume.fill});
  vtkNexradAddTexts(field, "Projection", {volume.grid.Projection()});
  vtkNexradAddValues<vtkDoubleArray, double>(
    field, "ProjectionCenter", {volume.grid.centreLatitude, volume.grid.centreLongitude});
  vtkNexradAddValues<vtkDoubleArray, double>(field, "TimeValue", {nexrad::ToSeconds(volume.time)});
  vtkNexradAddTexts(field, "Sites", volume.sites);
  vtkNexradAddTexts(field, "Method", {volume.method});
  vtkNexradAddValues<vtkUnsignedCharArray, unsigned char>(
    field, "Synthetic", {static_cast<unsigned char>(volume.synthetic ? 1 : 0)});
}

void AddPointData(const nexrad::GriddedVolume& volume, vtkPointData* points)
{
  const auto count = static_cast<vtkIdType>(volume.values.size());
  vtkNew<vtkFloatArray> values;
  values->SetName(nexrad::ToString(volume.moment));
  values->GetInformation()->Set(vtkDataArray::UNITS_LABEL(), nexrad::UnitOf(volume.moment));
  values->SetNumberOfTuples(count);
  std::copy(volume.values.begin(), volume.values.end(), values->GetPointer(0));
  vtkNew<vtkUnsignedCharArray> states;
  states->SetName(StateName(volume.moment).c_str());
  states->SetNumberOfTuples(count);
  std::transform(volume.states.begin(), volume.states.end(), states->GetPointer(0),
    [](nexrad::VoxelState state) { return static_cast<unsigned char>(state); });
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  ghosts->SetNumberOfTuples(count);
  constexpr auto hidden = static_cast<unsigned char>(vtkDataSetAttributes::HIDDENPOINT);
  // No echo is a reflectivity below all others, and no value of any other moment: blended with it a
  // velocity would seem to be another.
  const bool isReflectivity = volume.moment == nexrad::MomentName::REF;
  const auto isHidden = [isReflectivity](nexrad::VoxelState state)
  {
    return isReflectivity ? state == nexrad::VoxelState::NotScanned
                          : state != nexrad::VoxelState::Echo;
  };
  std::transform(volume.states.begin(), volume.states.end(), ghosts->GetPointer(0),
    [isHidden](nexrad::VoxelState state)
    { return isHidden(state) ? hidden : static_cast<unsigned char>(0); });
  points->SetScalars(values);
  points->AddArray(states);
  points->AddArray(ghosts);
}

/// The VTK array for a vector of values.
template <class Value>
using ArrayOf = std::conditional_t<sizeof(Value) == 1, vtkUnsignedCharArray, vtkFloatArray>;
template <class Values>
using ArrayFor = ArrayOf<typename std::decay_t<Values>::value_type>;

void AddAncillary(const nexrad::GriddedVolume& volume, vtkPointData* points)
{
  const auto add = [&](const char* name, const auto& values)
  {
    if (values.empty())
    {
      return;
    }
    vtkNew<ArrayFor<decltype(values)>> array;
    array->SetName(nexrad::AncillaryArrayName(volume.moment, name).c_str());
    array->SetNumberOfTuples(static_cast<vtkIdType>(values.size()));
    std::copy(values.begin(), values.end(), array->GetPointer(0));
    points->AddArray(array);
  };
  nexrad::ForEachAncillaryArray(volume.ancillary, add);
}

nexrad::MomentName FindMoment(vtkPointData* points)
{
  for (const nexrad::MomentName moment : nexrad::AllMoments)
  {
    if (points->GetArray(nexrad::ToString(moment)))
    {
      return moment;
    }
  }
  throw nexrad::Error("the image has no array of a radar moment: it needs REF and REF_state");
}

template <class Array>
Array* RequireArray(vtkImageData* image, const std::string& name)
{
  Array* array = Array::SafeDownCast(image->GetPointData()->GetArray(name.c_str()));
  if (!array || array->GetNumberOfComponents() != 1 ||
      array->GetNumberOfTuples() != image->GetNumberOfPoints())
  {
    vtkNew<Array> wanted;
    throw nexrad::Error("the image's point array " + name + " must be of type " +
                        wanted->GetDataTypeAsString() + " with one value a point");
  }
  return array;
}

// Those that the image has.
void TakeAncillaryArrays(vtkImageData* image, nexrad::GriddedVolume& volume)
{
  const auto take = [&](const char* name, auto& values)
  {
    const std::string full = nexrad::AncillaryArrayName(volume.moment, name);
    if (image->GetPointData()->HasArray(full.c_str()))
    {
      auto* array = RequireArray<ArrayFor<decltype(values)>>(image, full);
      values.assign(array->GetPointer(0), array->GetPointer(0) + array->GetNumberOfTuples());
    }
  };
  nexrad::ForEachAncillaryArray(volume.ancillary, take);
}

nexrad::GridSpecification ImageToGrid(vtkImageData* image)
{
  if (!image->GetDirectionMatrix()->IsIdentity())
  {
    throw nexrad::Error("the image's axes are turned: a volume has x east, y north and z up");
  }
  nexrad::GridSpecification grid;
  const int* extent = image->GetExtent();
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    grid.dimensions[axis] = extent[2 * axis + 1] - extent[2 * axis] + 1;
    grid.spacing[axis] = image->GetSpacing()[axis];
    grid.origin[axis] = image->GetOrigin()[axis] + extent[2 * axis] * grid.spacing[axis];
  }
  vtkFieldData* field = image->GetFieldData();
  const std::vector<std::string> projection = vtkNexradGetTexts(field, "Projection");
  const bool geographic =
    !projection.empty() && projection[0].find("+proj=longlat") != std::string::npos;
  grid.axes = geographic ? nexrad::GridAxes::Geographic : nexrad::GridAxes::Projected;
  grid.centreLatitude = vtkNexradGetValue(field, "ProjectionCenter", 0).value_or(0.0);
  grid.centreLongitude = vtkNexradGetValue(field, "ProjectionCenter", 1).value_or(0.0);
  return grid;
}

} // namespace

void vtkNexradGridToImage(const nexrad::GridSpecification& grid, vtkImageData* image)
{
  image->Initialize();
  image->SetDimensions(grid.dimensions.data());
  image->SetOrigin(grid.origin.data());
  image->SetSpacing(grid.spacing.data());
}

void vtkNexradVolumeToImage(const nexrad::GriddedVolume& volume, vtkImageData* image)
{
  vtkNexradGridToImage(volume.grid, image);
  AddPointData(volume, image->GetPointData());
  AddAncillary(volume, image->GetPointData());
  AddFieldData(volume, image->GetFieldData());
}

nexrad::GriddedVolume vtkNexradImageToVolume(vtkImageData* image)
{
  nexrad::GriddedVolume volume;
  volume.moment = FindMoment(image->GetPointData());
  auto* values = RequireArray<vtkFloatArray>(image, nexrad::ToString(volume.moment));
  auto* states = RequireArray<vtkUnsignedCharArray>(image, StateName(volume.moment));
  volume.grid = ImageToGrid(image);
  volume.values.assign(values->GetPointer(0), values->GetPointer(0) + values->GetNumberOfTuples());
  volume.states.reserve(volume.values.size());
  for (vtkIdType i = 0; i < states->GetNumberOfTuples(); ++i)
  {
    const unsigned char state = states->GetValue(i);
    if (state > static_cast<unsigned char>(nexrad::VoxelState::NotScanned))
    {
      throw nexrad::Error("the image's point array " + StateName(volume.moment) + " holds " +
                          std::to_string(state) + ": a state is 0 to 3");
    }
    volume.states.push_back(static_cast<nexrad::VoxelState>(state));
  }
  TakeAncillaryArrays(image, volume);
  vtkFieldData* field = image->GetFieldData();
  volume.time = nexrad::FromSeconds(vtkNexradGetValue(field, "TimeValue").value_or(0.0));
  volume.sites = vtkNexradGetTexts(field, "Sites");
  const std::vector<std::string> method = vtkNexradGetTexts(field, "Method");
  volume.method = method.empty() ? std::string() : method[0];
  volume.synthetic = vtkNexradGetValue(field, "Synthetic").value_or(0.0) != 0.0;
  volume.fill = static_cast<float>(vtkNexradGetValue(field, "FillValue").value_or(volume.fill));
  return volume;
}
