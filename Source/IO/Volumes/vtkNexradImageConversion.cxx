// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNexradImageConversion.h"

#include "nexrad/Codec/NxvReader.h"
#include "nexrad/Grid/GriddedVolume.h"
#include "nexrad/Grid/SiteGeometry.h"
#include "nexrad/System/Error.h"
#include "vtkNexradFieldData.h"
#include "vtkNexradThreads.h"
#include "vtkNexradVoxels.h"

#include "vtkDataSetAttributes.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkMatrix3x3.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"
#include "vtkTypeTraits.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <mutex>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace
{

constexpr vtkIdType VoxelsAtOnce = vtkIdType(1) << 18; // on one of several threads

// The arrays of a merged volume, whose range is found fast: without infinite values, of one
// component. ParaView asks twice for the range of each array whenever it gets another volume. VTK's
// own loop takes 24 ns a value, together 1.2 s for the values, states and ghost flags of
// 256x256x128 voxels on one core, which is more than merging them takes; the loop here takes a
// twentieth.
template <class Array>
class VoxelArray : public Array
{
public:
  using ValueType = typename Array::ValueType;

  static VoxelArray* New() { VTK_STANDARD_NEW_BODY(VoxelArray<Array>); }

protected:
  using Array::ComputeFiniteScalarRange;
  using Array::ComputeScalarRange;

  bool ComputeScalarRange(double* range) override { return this->FindRange(range); }
  bool ComputeFiniteScalarRange(double* range) override { return this->FindRange(range); }

private:
  // As VTK's loop: of an array without a number, the largest and the least that VTK knows.
  bool FindRange(double* range)
  {
    const vtkIdType count = this->GetNumberOfTuples();
    const ValueType* const values = this->GetPointer(0);
    ValueType least = vtkTypeTraits<ValueType>::Max();
    ValueType most = vtkTypeTraits<ValueType>::Min();
    std::mutex mutex;
    vtkSMPTools::For(0, count, VoxelsAtOnce,
      [&](vtkIdType begin, vtkIdType end)
      {
        ValueType low = vtkTypeTraits<ValueType>::Max();
        ValueType high = vtkTypeTraits<ValueType>::Min();
        for (vtkIdType i = begin; i < end; ++i)
        {
          // What is not a number compares as neither.
          low = values[i] < low ? values[i] : low;
          high = values[i] > high ? values[i] : high;
        }
        const std::lock_guard<std::mutex> lock(mutex);
        least = std::min(least, low);
        most = std::max(most, high);
      });
    range[0] = static_cast<double>(least);
    range[1] = static_cast<double>(most);
    return count > 0;
  }
};

std::string StateName(nexrad::MomentName moment)
{
  return std::string(nexrad::ToString(moment)) + "_state";
}

void AddPositions(const std::vector<nexrad::Position>& positions, vtkFieldData* field)
{
  if (positions.empty())
  {
    return;
  }
  vtkNew<vtkDoubleArray> array;
  array->SetName("SitePositions");
  array->SetNumberOfComponents(3);
  for (const nexrad::Position& position : positions)
  {
    array->InsertNextTuple3(position.latitude, position.longitude, position.altitude);
  }
  field->AddArray(array);
}

std::vector<nexrad::Position> TakePositions(vtkFieldData* field, std::size_t sites)
{
  std::vector<nexrad::Position> positions;
  vtkDataArray* array = field ? field->GetArray("SitePositions") : nullptr;
  if (array && array->GetNumberOfComponents() == 3 &&
      array->GetNumberOfTuples() == static_cast<vtkIdType>(sites))
  {
    for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
    {
      positions.push_back(
        {array->GetComponent(i, 0), array->GetComponent(i, 1), array->GetComponent(i, 2)});
    }
  }
  return positions;
}

void AddFieldData(const nexrad::GriddedVolume& volume, vtkFieldData* field)
{
  vtkNexradAddValues<vtkFloatArray>(field, "FillValue", {volume.fill});
  vtkNexradAddTexts(field, "Projection", {volume.grid.Projection()});
  vtkNexradAddValues<vtkDoubleArray>(
    field, "ProjectionCenter", {volume.grid.centreLatitude, volume.grid.centreLongitude});
  vtkNexradAddValues<vtkDoubleArray>(field, "TimeValue", {nexrad::ToSeconds(volume.time)});
  vtkNexradAddTexts(field, "Sites", volume.sites);
  AddPositions(volume.sitePositions, field);
  vtkNexradAddTexts(field, "Method", {volume.method});
  if (volume.ofOneRadar)
  {
    vtkNexradAddValues<vtkUnsignedCharArray>(field, "OneRadar", {1});
  }
  vtkNexradAddValues<vtkUnsignedCharArray>(field, "Synthetic", {volume.synthetic});
  vtkNexradAddValues<vtkUnsignedCharArray>(field, "Sharpened", {volume.sharpened});
  if (volume.biologicalShare > 0.0F)
  {
    vtkNexradAddValues<vtkFloatArray>(field, "BiologicalShare", {volume.biologicalShare});
  }
  if (!volume.notes.empty())
  {
    vtkNexradAddTexts(field, "Notes", volume.notes);
  }
}

unsigned char GhostTypeOf(nexrad::VoxelState state, nexrad::MomentName moment)
{
  return static_cast<unsigned char>(
    vtkNexradIsHidden(moment, state) ? vtkDataSetAttributes::HIDDENPOINT : 0);
}

// The point data of a volume, to be filled.
struct VoxelArrays
{
  vtkNew<VoxelArray<vtkFloatArray>> Values;
  vtkNew<VoxelArray<vtkUnsignedCharArray>> States;
  vtkNew<VoxelArray<vtkUnsignedCharArray>> Ghosts;

  VoxelArrays(nexrad::MomentName moment, vtkIdType count)
  {
    this->Values->SetName(nexrad::ToString(moment));
    this->Values->GetInformation()->Set(vtkDataArray::UNITS_LABEL(), nexrad::UnitOf(moment));
    this->Values->SetNumberOfTuples(count);
    this->States->SetName(StateName(moment).c_str());
    this->States->SetNumberOfTuples(count);
    this->Ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
    this->Ghosts->SetNumberOfTuples(count);
  }

  void AddTo(vtkPointData* points) const
  {
    points->SetScalars(this->Values);
    points->AddArray(this->States);
    points->AddArray(this->Ghosts);
  }
};

void Fill(const VoxelArrays& arrays, const nexrad::GriddedVolume& volume)
{
  std::array<unsigned char, nexrad::VoxelStateCount> ghostOf{};
  for (std::size_t state = 0; state < ghostOf.size(); ++state)
  {
    ghostOf[state] = GhostTypeOf(static_cast<nexrad::VoxelState>(state), volume.moment);
  }
  float* const values = arrays.Values->GetPointer(0);
  unsigned char* const states = arrays.States->GetPointer(0);
  unsigned char* const ghosts = arrays.Ghosts->GetPointer(0);
  vtkSMPTools::For(0, arrays.Values->GetNumberOfValues(), VoxelsAtOnce,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
      {
        values[i] = volume.values[i];
        states[i] = static_cast<unsigned char>(volume.states[i]);
        ghosts[i] = ghostOf[states[i]];
      }
    });
}

// A moment beside the first. The ghost flags are the first one's, so that only what is not a number
// can tell that there is no value.
void AddFurtherMoment(const nexrad::GriddedVolume& volume, vtkPointData* points)
{
  const VoxelArrays arrays(volume.moment, static_cast<vtkIdType>(volume.values.size()));
  Fill(arrays, volume);
  for (std::size_t i = 0; i < volume.states.size(); ++i)
  {
    if (volume.states[i] != nexrad::VoxelState::Echo)
    {
      arrays.Values->SetValue(static_cast<vtkIdType>(i), std::numeric_limits<float>::quiet_NaN());
    }
  }
  points->AddArray(arrays.Values);
  points->AddArray(arrays.States);
}

constexpr std::size_t codeCount = nexrad::VoxelCodes::Count;

// The state and the ghost type of each code.
using ByteOfCode = std::array<unsigned char, codeCount>;
ByteOfCode StatesOf(const nexrad::VoxelCodes& meaning)
{
  ByteOfCode states{};
  std::transform(meaning.states.begin(), meaning.states.end(), states.begin(),
    [](nexrad::VoxelState state) { return static_cast<unsigned char>(state); });
  return states;
}

ByteOfCode GhostTypesOf(const nexrad::VoxelCodes& meaning, nexrad::MomentName moment)
{
  ByteOfCode ghosts{};
  std::transform(meaning.states.begin(), meaning.states.end(), ghosts.begin(),
    [moment](nexrad::VoxelState state) { return GhostTypeOf(state, moment); });
  return ghosts;
}

void Expand(const nexrad::CodedVolume& coded, const VoxelArrays& arrays)
{
  const ByteOfCode stateOf = StatesOf(coded.meaning);
  const ByteOfCode ghostOf = GhostTypesOf(coded.meaning, coded.volume.moment);
  float* const values = arrays.Values->GetPointer(0);
  unsigned char* const states = arrays.States->GetPointer(0);
  unsigned char* const ghosts = arrays.Ghosts->GetPointer(0);
  vtkSMPTools::For(0, arrays.Values->GetNumberOfValues(), VoxelsAtOnce,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
      {
        const std::uint8_t code = coded.codes[i];
        values[i] = coded.meaning.values[code];
        states[i] = stateOf[code];
        ghosts[i] = ghostOf[code];
      }
    });
}

std::string CodeTableName(nexrad::MomentName moment, const char* column)
{
  return std::string(nexrad::ToString(moment)) + "_code_" + column;
}

template <class Array, class Values>
vtkSmartPointer<Array> MakeArray(const std::string& name, const Values& values)
{
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name.c_str());
  array->SetNumberOfTuples(static_cast<vtkIdType>(values.size()));
  std::copy(values.begin(), values.end(), array->GetPointer(0));
  return array;
}

template <class Values>
using ArrayFor = std::conditional_t<sizeof(typename std::decay_t<Values>::value_type) == 1,
  vtkUnsignedCharArray, vtkFloatArray>;

void AddAncillary(const nexrad::GriddedVolume& volume, vtkPointData* points)
{
  const auto add = [&](const char* name, const auto& values)
  {
    if (!values.empty())
    {
      points->AddArray(MakeArray<VoxelArray<ArrayFor<decltype(values)>>>(
        nexrad::AncillaryArrayName(volume.moment, name), values));
    }
  };
  nexrad::ForEachAncillaryArray(volume.ancillary, add);
}

// The moment of the active scalars, or the first that the image has.
nexrad::MomentName FindMoment(vtkImageData* image)
{
  if (const auto active = nexrad::ParseMomentName(vtkNexradScalarsName(image)))
  {
    return *active;
  }
  for (const nexrad::MomentName moment : nexrad::KnownMoments)
  {
    if (image->GetPointData()->GetArray(nexrad::ToString(moment)))
    {
      return moment;
    }
  }
  throw nexrad::Error("the image has no array of a radar moment: it needs REF and REF_state");
}

nexrad::VoxelState ToState(unsigned char state, const std::string& array)
{
  if (state > static_cast<unsigned char>(nexrad::VoxelState::Filtered))
  {
    throw nexrad::Error(
      "the image's array " + array + " holds " + std::to_string(state) + ": a state is 0 to 4");
  }
  return static_cast<nexrad::VoxelState>(state);
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

// The table of a column as an image of codes has it.
template <class Array>
const auto* RequireCodeTable(vtkImageData* image, nexrad::MomentName moment, const char* column)
{
  const std::string name = CodeTableName(moment, column);
  Array* table = Array::SafeDownCast(image->GetFieldData()->GetArray(name.c_str()));
  if (!table || table->GetNumberOfValues() != static_cast<vtkIdType>(codeCount))
  {
    throw nexrad::Error("the image has codes; its field data must have " + name + " with " +
                        std::to_string(codeCount) + " values");
  }
  return table->GetPointer(0);
}

void TakeCodes(vtkUnsignedCharArray* codes, vtkImageData* image, nexrad::GriddedVolume& volume)
{
  const float* values = RequireCodeTable<vtkFloatArray>(image, volume.moment, "values");
  const unsigned char* states =
    RequireCodeTable<vtkUnsignedCharArray>(image, volume.moment, "states");
  const std::string name = CodeTableName(volume.moment, "states");
  nexrad::VoxelCodes meaning;
  for (std::size_t code = 0; code < codeCount; ++code)
  {
    meaning.values[code] = values[code];
    meaning.states[code] = ToState(states[code], name);
  }
  const auto count = static_cast<std::size_t>(codes->GetNumberOfTuples());
  volume.values.resize(count);
  volume.states.resize(count);
  nexrad::ExpandCodes(meaning, codes->GetPointer(0), count, volume.values.data(),
    volume.states.data(), vtkNexradRangeLoop());
}

void TakeValues(vtkImageData* image, nexrad::GriddedVolume& volume)
{
  const std::string stateName = StateName(volume.moment);
  auto* values = RequireArray<vtkFloatArray>(image, nexrad::ToString(volume.moment));
  const unsigned char* states = RequireArray<vtkUnsignedCharArray>(image, stateName)->GetPointer(0);
  volume.values.assign(values->GetPointer(0), values->GetPointer(0) + values->GetNumberOfTuples());
  volume.states.reserve(volume.values.size());
  for (std::size_t i = 0; i < volume.values.size(); ++i)
  {
    volume.states.push_back(ToState(states[i], stateName));
    const bool isEcho = volume.states[i] == nexrad::VoxelState::Echo;
    volume.values[i] = !isEcho && std::isnan(volume.values[i]) ? volume.fill : volume.values[i];
  }
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

void TakeFieldData(vtkFieldData* field, nexrad::GriddedVolume& volume)
{
  volume.time = nexrad::FromSeconds(vtkNexradGetValue(field, "TimeValue").value_or(0.0));
  volume.sites = vtkNexradGetTexts(field, "Sites");
  volume.sitePositions = TakePositions(field, volume.sites.size());
  const std::vector<std::string> method = vtkNexradGetTexts(field, "Method");
  volume.method = method.empty() ? std::string() : method[0];
  volume.synthetic = vtkNexradGetValue(field, "Synthetic").value_or(0.0) != 0.0;
  volume.sharpened = vtkNexradGetValue(field, "Sharpened").value_or(0.0) != 0.0;
  volume.biologicalShare =
    static_cast<float>(vtkNexradGetValue(field, "BiologicalShare").value_or(0.0));
  volume.notes = vtkNexradGetTexts(field, "Notes");
  volume.ofOneRadar =
    vtkNexradGetValue(field, "OneRadar").value_or(0.0) != 0.0 && volume.sitePositions.size() == 1;
  volume.fill = static_cast<float>(vtkNexradGetValue(field, "FillValue").value_or(volume.fill));
}

// A moment of the image; the rest is that of `description`.
nexrad::GriddedVolume TakeMoment(
  vtkImageData* image, nexrad::MomentName moment, const nexrad::GriddedVolume& description)
{
  nexrad::GriddedVolume volume = description;
  volume.moment = moment;
  const char* const name = nexrad::ToString(moment);
  if (vtkUnsignedCharArray::SafeDownCast(image->GetPointData()->GetArray(name)))
  {
    TakeCodes(RequireArray<vtkUnsignedCharArray>(image, name), image, volume);
  }
  else
  {
    TakeValues(image, volume);
  }
  TakeAncillaryArrays(image, volume);
  return volume;
}

// Sets extent, origin and spacing of the image, without arrays.
void SetGrid(const nexrad::GridSpecification& grid, vtkImageData* image)
{
  image->Initialize();
  image->SetDimensions(grid.dimensions.data());
  image->SetOrigin(grid.origin.data());
  image->SetSpacing(grid.spacing.data());
}

// The image of values, which are expanded of the codes.
void CodesToValues(const nexrad::CodedVolume& coded, vtkImageData* image)
{
  const nexrad::GriddedVolume& volume = coded.volume;
  SetGrid(volume.grid, image);
  const VoxelArrays arrays(volume.moment, image->GetNumberOfPoints());
  Expand(coded, arrays);
  arrays.AddTo(image->GetPointData());
  AddAncillary(volume, image->GetPointData());
  AddFieldData(volume, image->GetFieldData());
}

// The image of the codes as they are. It takes them over.
void CodesToImage(nexrad::CodedVolume& coded, vtkImageData* image)
{
  const nexrad::GriddedVolume& volume = coded.volume;
  SetGrid(volume.grid, image);
  vtkNew<vtkUnsignedCharArray> codes;
  codes->SetName(nexrad::ToString(volume.moment));
  codes->GetInformation()->Set(vtkDataArray::UNITS_LABEL(), nexrad::UnitOf(volume.moment));
  codes->SetArray(coded.codes.release(), image->GetNumberOfPoints(), 0,
    vtkUnsignedCharArray::VTK_DATA_ARRAY_DELETE);
  image->GetPointData()->SetScalars(codes);
  AddAncillary(volume, image->GetPointData());
  vtkFieldData* field = image->GetFieldData();
  AddFieldData(volume, field);
  field->AddArray(
    MakeArray<vtkFloatArray>(CodeTableName(volume.moment, "values"), coded.meaning.values));
  field->AddArray(MakeArray<vtkUnsignedCharArray>(
    CodeTableName(volume.moment, "states"), StatesOf(coded.meaning)));
  field->AddArray(MakeArray<vtkUnsignedCharArray>(
    CodeTableName(volume.moment, "ghosts"), GhostTypesOf(coded.meaning, volume.moment)));
}

} // namespace

nexrad::GridSpecification vtkNexradImageToGrid(vtkImageData* image)
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

bool vtkNexradIsHidden(nexrad::MomentName moment, nexrad::VoxelState state)
{
  // No echo is a reflectivity below all others, and no value of any other moment: blended with it a
  // velocity would seem to be another.
  return moment == nexrad::MomentName::REF ? state == nexrad::VoxelState::NotScanned
                                           : state != nexrad::VoxelState::Echo;
}

void vtkNexradVolumeToImage(const nexrad::GriddedVolume& volume, vtkImageData* image)
{
  SetGrid(volume.grid, image);
  const VoxelArrays arrays(volume.moment, image->GetNumberOfPoints());
  Fill(arrays, volume);
  arrays.AddTo(image->GetPointData());
  AddAncillary(volume, image->GetPointData());
  for (const nexrad::GriddedVolume& further : volume.further)
  {
    AddFurtherMoment(further, image->GetPointData());
    AddAncillary(further, image->GetPointData());
  }
  AddFieldData(volume, image->GetFieldData());
}

void vtkNexradAddRadarView(vtkImageData* image, const std::vector<std::string>& leaveOut)
{
  nexrad::GriddedVolume volume;
  TakeFieldData(image->GetFieldData(), volume);
  if (!volume.ofOneRadar)
  {
    return;
  }
  const nexrad::RadarView view = nexrad::MakeRadarView(
    vtkNexradImageToGrid(image), volume.sitePositions.front(), vtkNexradRangeLoop());
  const auto add = [&](const char* name, const std::vector<float>& values)
  {
    if (std::find(leaveOut.begin(), leaveOut.end(), name) != leaveOut.end())
    {
      return;
    }
    const auto array = MakeArray<VoxelArray<vtkFloatArray>>(name, values);
    const bool distance = name == std::string("slant_range");
    array->GetInformation()->Set(vtkDataArray::UNITS_LABEL(), distance ? "m" : "degrees");
    image->GetPointData()->AddArray(array);
  };
  nexrad::ForEachArray(view, add);
}

void vtkNexradReadVolumeFile(
  const std::string& path, const nexrad::NxvReadOptions& options, bool codes, vtkImageData* image)
{
  constexpr std::size_t ofImage = 6; // bytes of a voxel: value, state, ghost type
  nexrad::NxvReadOptions reading = options;
  reading.bytesBesides += codes ? 0 : ofImage;
  reading.loop = vtkNexradRangeLoop();
  std::optional<nexrad::CodedVolume> coded = nexrad::ReadNxvCodes(path, reading, !codes);
  if (!coded)
  {
    reading.bytesBesides = options.bytesBesides + ofImage;
    vtkNexradVolumeToImage(nexrad::ReadNxv(path, reading), image);
  }
  else if (codes)
  {
    CodesToImage(*coded, image);
  }
  else
  {
    CodesToValues(*coded, image);
  }
}

nexrad::GriddedVolume vtkNexradImageToVolume(vtkImageData* image)
{
  nexrad::GriddedVolume volume;
  volume.grid = vtkNexradImageToGrid(image);
  TakeFieldData(image->GetFieldData(), volume);
  const nexrad::MomentName first = FindMoment(image);
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
