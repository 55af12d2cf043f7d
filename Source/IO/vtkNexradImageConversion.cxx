// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNexradImageConversion.h"

#include "nexrad/Grid/VolumeMoments.h"
#include "nexrad/System/Error.h"
#include "vtkNexradFieldData.h"

#include "vtkDataSetAttributes.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkMatrix3x3.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

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

vtkSmartPointer<vtkFloatArray> MakeValues(const nexrad::GriddedVolume& volume)
{
  auto values = vtkSmartPointer<vtkFloatArray>::New();
  values->SetName(nexrad::ToString(volume.moment));
  values->GetInformation()->Set(vtkDataArray::UNITS_LABEL(), nexrad::UnitOf(volume.moment));
  values->SetNumberOfTuples(static_cast<vtkIdType>(volume.values.size()));
  std::copy(volume.values.begin(), volume.values.end(), values->GetPointer(0));
  return values;
}

vtkSmartPointer<vtkUnsignedCharArray> MakeStates(const nexrad::GriddedVolume& volume)
{
  auto states = vtkSmartPointer<vtkUnsignedCharArray>::New();
  states->SetName(StateName(volume.moment).c_str());
  states->SetNumberOfTuples(static_cast<vtkIdType>(volume.states.size()));
  std::transform(volume.states.begin(), volume.states.end(), states->GetPointer(0),
    [](nexrad::VoxelState state) { return static_cast<unsigned char>(state); });
  return states;
}

vtkSmartPointer<vtkUnsignedCharArray> MakeGhosts(const nexrad::GriddedVolume& volume)
{
  auto ghosts = vtkSmartPointer<vtkUnsignedCharArray>::New();
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  ghosts->SetNumberOfTuples(static_cast<vtkIdType>(volume.states.size()));
  constexpr auto hidden = static_cast<unsigned char>(vtkDataSetAttributes::HIDDENPOINT);
  std::transform(volume.states.begin(), volume.states.end(), ghosts->GetPointer(0),
    [&volume](nexrad::VoxelState state)
    { return vtkNexradIsHidden(volume.moment, state) ? hidden : static_cast<unsigned char>(0); });
  return ghosts;
}

void AddPointData(const nexrad::GriddedVolume& volume, vtkPointData* points)
{
  points->SetScalars(MakeValues(volume));
  points->AddArray(MakeStates(volume));
  points->AddArray(MakeGhosts(volume));
}

// A moment beside the first. The ghost flags are the first one's, so that only what is not a number
// can tell that there is no value.
void AddFurtherMoment(const nexrad::GriddedVolume& volume, vtkPointData* points)
{
  const vtkSmartPointer<vtkFloatArray> values = MakeValues(volume);
  for (std::size_t i = 0; i < volume.states.size(); ++i)
  {
    if (volume.states[i] != nexrad::VoxelState::Echo)
    {
      values->SetValue(static_cast<vtkIdType>(i), std::numeric_limits<float>::quiet_NaN());
    }
  }
  points->AddArray(values);
  points->AddArray(MakeStates(volume));
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

// The moment of the active scalars, or the first that the image has.
nexrad::MomentName FindMoment(vtkPointData* points)
{
  vtkDataArray* scalars = points->GetScalars();
  const char* name = scalars ? scalars->GetName() : nullptr;
  if (const auto active = nexrad::ParseMomentName(name ? name : ""))
  {
    return *active;
  }
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

void TakeFieldData(vtkFieldData* field, nexrad::GriddedVolume& volume)
{
  volume.time = nexrad::FromSeconds(vtkNexradGetValue(field, "TimeValue").value_or(0.0));
  volume.sites = vtkNexradGetTexts(field, "Sites");
  const std::vector<std::string> method = vtkNexradGetTexts(field, "Method");
  volume.method = method.empty() ? std::string() : method[0];
  volume.synthetic = vtkNexradGetValue(field, "Synthetic").value_or(0.0) != 0.0;
  volume.fill = static_cast<float>(vtkNexradGetValue(field, "FillValue").value_or(volume.fill));
}

void TakeStates(vtkImageData* image, nexrad::GriddedVolume& volume)
{
  const std::string name = StateName(volume.moment);
  auto* states = RequireArray<vtkUnsignedCharArray>(image, name);
  volume.states.reserve(volume.values.size());
  for (vtkIdType i = 0; i < states->GetNumberOfTuples(); ++i)
  {
    const unsigned char state = states->GetValue(i);
    if (state > static_cast<unsigned char>(nexrad::VoxelState::NotScanned))
    {
      throw nexrad::Error("the image's point array " + name + " holds " + std::to_string(state) +
                          ": a state is 0 to 3");
    }
    volume.states.push_back(static_cast<nexrad::VoxelState>(state));
  }
}

// A moment of the image; the rest is that of `description`.
nexrad::GriddedVolume TakeMoment(
  vtkImageData* image, nexrad::MomentName moment, const nexrad::GriddedVolume& description)
{
  nexrad::GriddedVolume volume = description;
  volume.moment = moment;
  auto* values = RequireArray<vtkFloatArray>(image, nexrad::ToString(moment));
  volume.values.assign(values->GetPointer(0), values->GetPointer(0) + values->GetNumberOfTuples());
  TakeStates(image, volume);
  for (std::size_t i = 0; i < volume.values.size(); ++i)
  {
    const bool isEcho = volume.states[i] == nexrad::VoxelState::Echo;
    volume.values[i] = !isEcho && std::isnan(volume.values[i]) ? volume.fill : volume.values[i];
  }
  TakeAncillaryArrays(image, volume);
  return volume;
}

} // namespace

void vtkNexradGridToImage(const nexrad::GridSpecification& grid, vtkImageData* image)
{
  image->Initialize();
  image->SetDimensions(grid.dimensions.data());
  image->SetOrigin(grid.origin.data());
  image->SetSpacing(grid.spacing.data());
}

bool vtkNexradIsHidden(nexrad::MomentName moment, nexrad::VoxelState state)
{
  // No echo is a reflectivity below all others, and no value of any other moment: blended with it a
  // velocity would seem to be another.
  return moment == nexrad::MomentName::REF ? state == nexrad::VoxelState::NotScanned
                                           : state != nexrad::VoxelState::Echo;
}

void vtkNexradVolumeToImage(const nexrad::GriddedVolume& volume, vtkImageData* image)
{
  vtkNexradGridToImage(volume.grid, image);
  AddPointData(volume, image->GetPointData());
  AddAncillary(volume, image->GetPointData());
  for (const nexrad::GriddedVolume& further : volume.further)
  {
    AddFurtherMoment(further, image->GetPointData());
    AddAncillary(further, image->GetPointData());
  }
  AddFieldData(volume, image->GetFieldData());
}

nexrad::GriddedVolume vtkNexradImageToVolume(vtkImageData* image)
{
  nexrad::GriddedVolume volume;
  volume.grid = ImageToGrid(image);
  TakeFieldData(image->GetFieldData(), volume);
  const nexrad::MomentName first = FindMoment(image->GetPointData());
  std::vector<nexrad::GriddedVolume> moments = {TakeMoment(image, first, volume)};
  for (int i = 0; i < image->GetPointData()->GetNumberOfArrays(); ++i)
  {
    const char* name = image->GetPointData()->GetArrayName(i);
    const auto moment = nexrad::ParseMomentName(name ? name : "");
    if (moment && *moment != first && image->GetPointData()->HasArray(StateName(*moment).c_str()))
    {
      moments.push_back(TakeMoment(image, *moment, volume));
    }
  }
  return nexrad::JoinMoments(std::move(moments));
}
