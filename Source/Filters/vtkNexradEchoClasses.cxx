// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNexradEchoClasses.h"

#include "nexrad/Polar/PolarVolume.h"
#include "nexrad/Quality/EchoClassification.h"
#include "nexrad/System/Error.h"
#include "vtkNexradFieldData.h"
#include "vtkNexradPipeline.h"
#include "vtkNexradThreads.h"

#include "vtkCompositeDataSet.h"
#include "vtkErrorCode.h"
#include "vtkFloatArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStructuredGrid.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <functional>
#include <iterator>
#include <map>
#include <mutex>
#include <string>
#include <vector>

namespace
{

// From the readers' sweeps back to the rays that the classes are found of, the inverse of
// vtkNexradSweepConversion.h: times, angles and gate geometry come from the field data, so that
// nothing is lost on the way through the points' coordinates. The values of a sweep are rounded to
// steps of a power of two, at most 1/32000 of their range (0.002 dB of 60 dB). The half decibels
// that files hold are multiples of such a step, and stay exact.

// Where a polar sweep comes from: its grid, and of each of its rays the row in it.
struct SweepOrigin
{
  vtkStructuredGrid* Grid = nullptr;
  std::vector<int> Rows;
};

// A volume that sweeps make, and where each of its sweeps comes from.
struct FoundVolume
{
  nexrad::PolarVolume Volume;
  std::vector<SweepOrigin> Origins;
};

// The one of the same radar and the same start; the end where there is none.
std::vector<FoundVolume>::iterator FindVolume(
  std::vector<FoundVolume>& volumes, const nexrad::PolarVolume& like)
{
  return std::find_if(volumes.begin(), volumes.end(),
    [&](const FoundVolume& each)
    { return each.Volume.site.name == like.site.name && each.Volume.start == like.start; });
}

constexpr auto NotSampled = static_cast<unsigned char>(nexrad::GateState::NotSampled);

/// One grid of one sweep, with what its arrays must have.
class SweepGrid
{
public:
  SweepGrid(vtkStructuredGrid* theGrid, std::string theName)
    : Grid(theGrid)
    , Field(theGrid->GetFieldData())
    , Name(std::move(theName))
  {
  }

  double Value(const char* name, int component = 0) const
  {
    const std::optional<double> value = vtkNexradGetValue(this->Field, name, component);
    if (!value)
    {
      this->Refuse(name, "is missing from the field data");
    }
    return *value;
  }

  // `rays`: how many values it must have; any number by default.
  vtkDataArray* RayArray(const char* name, vtkIdType rays = -1) const
  {
    vtkDataArray* array = this->Field->GetArray(name);
    if (!array || array->GetNumberOfComponents() != 1 ||
        (rays >= 0 && array->GetNumberOfTuples() != rays))
    {
      this->Refuse(name, "must be in the field data, with one value a ray");
    }
    return array;
  }

  template <class Array>
  Array* PointArray(const std::string& name) const
  {
    Array* array = Array::SafeDownCast(this->Grid->GetPointData()->GetArray(name.c_str()));
    if (!array || array->GetNumberOfComponents() != 1 ||
        array->GetNumberOfTuples() != this->Grid->GetNumberOfPoints())
    {
      vtkNew<Array> wanted;
      this->Refuse(
        name, std::string("must be in the point data, of type ") + wanted->GetDataTypeAsString());
    }
    return array;
  }

  [[noreturn]] void Refuse(const std::string& array, const std::string& why) const
  {
    throw nexrad::Error(this->Name + ": the array " + array + " " + why);
  }

  vtkStructuredGrid* Grid;
  vtkFieldData* Field;

private:
  std::string Name;
};

/// The gates of a sweep's rays, as numbers.
struct SweepGates
{
  std::vector<float> Values;
  std::vector<nexrad::GateState> States;
};

/// Copies one ray's gates unless none of them was sampled; whether it did.
bool AppendRay(nexrad::PolarSweep& sweep, SweepGates& gates, const nexrad::PolarRay& ray,
  const float* values, const unsigned char* states)
{
  const bool sampled = std::any_of(
    states, states + sweep.gates, [&](unsigned char each) { return each < NotSampled; });
  if (!sampled)
  {
    return false;
  }
  sweep.rays.push_back(ray);
  gates.Values.insert(gates.Values.end(), values, values + sweep.gates);
  std::transform(states, states + sweep.gates, std::back_inserter(gates.States),
    [&](unsigned char each) { return static_cast<nexrad::GateState>(std::min(each, NotSampled)); });
  return true;
}

/// The gates up to the last that some ray reaches: another moment of the grid may go on farther.
std::size_t SampledGates(vtkUnsignedCharArray* states, vtkIdType columns)
{
  vtkIdType gates = 0;
  for (vtkIdType i = 0; i < states->GetNumberOfTuples(); ++i)
  {
    if (states->GetValue(i) < NotSampled)
    {
      gates = std::max(gates, i % columns + 1);
    }
  }
  return static_cast<std::size_t>(gates);
}

/// Of the cut; Unknown where the field data do not say, or have no such number.
nexrad::Waveform WaveformOf(const SweepGrid& source)
{
  const double number = vtkNexradGetValue(source.Field, "Waveform").value_or(0.0);
  const bool known =
    number >= 1.0 && number <= static_cast<double>(nexrad::Waveform::StaggeredPulsePair);
  return known ? static_cast<nexrad::Waveform>(static_cast<int>(number))
               : nexrad::Waveform::Unknown;
}

nexrad::PolarSweep ToPolarSweep(
  const SweepGrid& source, nexrad::MomentName moment, std::vector<int>& rows)
{
  const std::string name = nexrad::ToString(moment);
  auto* values = source.PointArray<vtkFloatArray>(name);
  auto* states = source.PointArray<vtkUnsignedCharArray>(name + "_state");
  vtkDataArray* times = source.RayArray("RayTime");
  const vtkIdType rays = times->GetNumberOfTuples();
  vtkDataArray* azimuths = source.RayArray("RayAzimuth", rays);
  vtkDataArray* elevations = source.RayArray("RayElevation", rays);
  vtkDataArray* ranges = source.Field->HasArray("UnambiguousRange")
                           ? source.RayArray("UnambiguousRange", rays)
                           : nullptr;
  int dimensions[3];
  source.Grid->GetDimensions(dimensions);
  if (rays > dimensions[1] || dimensions[2] != 1)
  {
    source.Refuse("RayTime", "has more rays than the grid");
  }
  if (dimensions[0] > nexrad::GateRows::MostGates)
  {
    source.Refuse(name, "has more gates in a ray than the " +
                          std::to_string(nexrad::GateRows::MostGates) + " that a ray can have");
  }
  nexrad::PolarSweep sweep;
  sweep.elevationNumber = static_cast<int>(source.Value("ElevationNumber"));
  sweep.firstGate = source.Value("GateGeometry", 0);
  sweep.gateSpacing = source.Value("GateGeometry", 1);
  sweep.gates = SampledGates(states, dimensions[0]);
  sweep.waveform = WaveformOf(source);
  SweepGates gates;
  for (vtkIdType i = 0; i < rays; ++i)
  {
    const nexrad::PolarRay ray = {static_cast<float>(azimuths->GetComponent(i, 0)),
      static_cast<float>(elevations->GetComponent(i, 0)),
      ranges ? static_cast<float>(ranges->GetComponent(i, 0)) : 0.0F,
      nexrad::FromSeconds(times->GetComponent(i, 0))};
    const vtkIdType first = i * dimensions[0];
    if (AppendRay(sweep, gates, ray, values->GetPointer(first), states->GetPointer(first)))
    {
      rows.push_back(static_cast<int>(i));
    }
  }
  nexrad::SetGates(sweep, gates.Values, gates.States);
  if (moment == nexrad::MomentName::REF)
  {
    nexrad::LimitReach(sweep);
  }
  return sweep;
}

nexrad::PolarVolume DescribeVolume(const SweepGrid& source, nexrad::MomentName moment)
{
  nexrad::PolarVolume volume;
  const std::vector<std::string> names = vtkNexradGetTexts(source.Field, "Site");
  volume.site.name = names.empty() ? std::string() : names[0];
  volume.moment = moment;
  volume.start = nexrad::FromSeconds(source.Value("StartTime"));
  return volume;
}

void AppendGrid(
  std::vector<FoundVolume>& volumes, const SweepGrid& source, nexrad::MomentName moment)
{
  if (!source.Grid->GetPointData()->HasArray(nexrad::ToString(moment)))
  {
    return;
  }
  nexrad::PolarVolume description = DescribeVolume(source, moment);
  auto own = FindVolume(volumes, description);
  if (own == volumes.end())
  {
    own = volumes.insert(own, {std::move(description), {}});
  }
  SweepOrigin origin{source.Grid, {}};
  own->Volume.sweeps.push_back(ToPolarSweep(source, moment, origin.Rows));
  own->Origins.push_back(std::move(origin));
}

// The volumes whose sweeps are in the collection: those of one site with one start time make one
// volume, which has its site's name, its start and its sweeps alone. Grids without the moment are
// passed over, and so are, in each grid, rays that it has no gate of. What decides which gates
// count (`Waveform`, `UnambiguousRange`) may be absent; then all do. The moment is a measured one.
// Throws nexrad::Error, naming the sweep and the array, for a grid with the moment that lacks its
// field data, or in which they do not fit its dimensions.
std::vector<FoundVolume> SweepsToPolar(
  vtkPartitionedDataSetCollection* sweeps, nexrad::MomentName moment)
{
  std::vector<FoundVolume> volumes;
  for (unsigned int i = 0; i < sweeps->GetNumberOfPartitionedDataSets(); ++i)
  {
    const char* name =
      sweeps->HasMetaData(i) ? sweeps->GetMetaData(i)->Get(vtkCompositeDataSet::NAME()) : nullptr;
    vtkPartitionedDataSet* grids = sweeps->GetPartitionedDataSet(i);
    for (unsigned int j = 0; grids && j < grids->GetNumberOfPartitions(); ++j)
    {
      auto* grid = vtkStructuredGrid::SafeDownCast(grids->GetPartition(j));
      if (grid)
      {
        AppendGrid(volumes, {grid, name ? name : "data set " + std::to_string(i)}, moment);
      }
    }
  }
  return volumes;
}

constexpr int classCount = static_cast<int>(nexrad::EchoClassCount);
constexpr int reasonCount = static_cast<int>(nexrad::EchoReasonCount);

void AddNames(vtkFieldData* field)
{
  const auto namesOf = [](int count, const char* (*nameOf)(int))
  {
    std::vector<std::string> names;
    for (int i = 0; i < count; ++i)
    {
      names.emplace_back(nameOf(i));
    }
    return names;
  };
  vtkNexradAddTexts(
    field, "EchoClassNames", namesOf(classCount, vtkNexradEchoClasses::GetEchoClassName));
  vtkNexradAddTexts(
    field, "EchoReasonNames", namesOf(reasonCount, vtkNexradEchoClasses::GetEchoReasonName));
}

// The sweeps with grids of their own, which share the arrays of the input.
void CopySweeps(vtkPartitionedDataSetCollection* input, vtkPartitionedDataSetCollection* output)
{
  output->CopyStructure(input);
  output->GetFieldData()->ShallowCopy(input->GetFieldData());
  for (unsigned int i = 0; i < input->GetNumberOfPartitionedDataSets(); ++i)
  {
    vtkPartitionedDataSet* grids = input->GetPartitionedDataSet(i);
    for (unsigned int j = 0; grids && j < grids->GetNumberOfPartitions(); ++j)
    {
      if (vtkDataSet* grid = grids->GetPartition(j))
      {
        vtkSmartPointer<vtkDataSet> own = vtk::TakeSmartPointer(grid->NewInstance());
        own->ShallowCopy(grid);
        output->SetPartition(i, j, own);
      }
    }
  }
}

vtkNew<vtkUnsignedCharArray> MakeArray(vtkStructuredGrid* grid, const char* name)
{
  vtkNew<vtkUnsignedCharArray> array;
  array->SetName(name);
  array->SetNumberOfTuples(grid->GetNumberOfPoints());
  array->FillValue(0);
  return array;
}

// The row after the last ray shows the first ray again, where the grid has one.
void RepeatFirstRow(vtkStructuredGrid* grid, vtkIdType rays, vtkUnsignedCharArray* array)
{
  int dimensions[3];
  grid->GetDimensions(dimensions);
  for (vtkIdType gate = 0; dimensions[1] > rays && gate < dimensions[0]; ++gate)
  {
    array->SetValue(rays * dimensions[0] + gate, array->GetValue(gate));
  }
}

// `reasons` of the gates of a sweep, in the order of its rays.
void AddArrays(const SweepOrigin& origin, const nexrad::SweepReasons& reasons)
{
  vtkStructuredGrid* grid = origin.Grid;
  int dimensions[3];
  grid->GetDimensions(dimensions);
  const vtkIdType columns = dimensions[0];
  const auto classes = MakeArray(grid, "REF_class");
  const auto numbers = MakeArray(grid, "REF_reason");
  for (std::size_t ray = 0; ray < origin.Rows.size(); ++ray)
  {
    const vtkIdType first = origin.Rows[ray] * columns;
    for (std::size_t gate = 0; gate < reasons.gates; ++gate)
    {
      const nexrad::EchoReason reason = reasons.At(ray, gate);
      const vtkIdType point = first + static_cast<vtkIdType>(gate);
      classes->SetValue(point, static_cast<unsigned char>(nexrad::ClassOf(reason)));
      numbers->SetValue(point, static_cast<unsigned char>(reason));
    }
  }
  const vtkIdType rays = grid->GetFieldData()->GetArray("RayTime")->GetNumberOfTuples();
  for (vtkUnsignedCharArray* array : {classes.Get(), numbers.Get()})
  {
    RepeatFirstRow(grid, rays, array);
    grid->GetPointData()->AddArray(array);
  }
  AddNames(grid->GetFieldData());
}

// False when `progress` asked to stop.
bool ClassifySweeps(
  vtkPartitionedDataSetCollection* sweeps, const std::function<bool(double)>& progress)
{
  const std::vector<FoundVolume> volumes = SweepsToPolar(sweeps, nexrad::MomentName::REF);
  std::map<nexrad::MomentName, std::vector<FoundVolume>> others;
  for (std::size_t i = 0; i < volumes.size(); ++i)
  {
    const auto& [volume, origins] = volumes[i];
    std::mutex oneAtATime;
    const auto measured = [&, &like = volume](nexrad::MomentName moment, const nexrad::WantedRange&)
    {
      const std::lock_guard<std::mutex> lock(oneAtATime);
      const auto [found, isNew] = others.try_emplace(moment);
      if (isNew)
      {
        found->second = SweepsToPolar(sweeps, moment);
      }
      const auto same = FindVolume(found->second, like);
      return same == found->second.end() ? nexrad::PolarVolume() : same->Volume;
    };
    const nexrad::EchoClassification found =
      nexrad::ClassifyEcho(volume, measured, vtkNexradRangeLoop());
    for (std::size_t sweep = 0; sweep < volume.sweeps.size(); ++sweep)
    {
      AddArrays(origins[sweep], found.sweeps[sweep]);
    }
    if (!progress(static_cast<double>(i + 1) / static_cast<double>(volumes.size())))
    {
      return false;
    }
  }
  return true;
}

} // namespace

vtkStandardNewMacro(vtkNexradEchoClasses);

int vtkNexradEchoClasses::GetNumberOfEchoClasses()
{
  return classCount;
}

int vtkNexradEchoClasses::GetNumberOfEchoReasons()
{
  return reasonCount;
}

const char* vtkNexradEchoClasses::GetEchoClassName(int echoClass)
{
  return echoClass >= 0 && echoClass < classCount
           ? nexrad::ToString(static_cast<nexrad::EchoClass>(echoClass))
           : nullptr;
}

const char* vtkNexradEchoClasses::GetEchoReasonName(int reason)
{
  return reason >= 0 && reason < reasonCount
           ? nexrad::ToString(static_cast<nexrad::EchoReason>(reason))
           : nullptr;
}

int vtkNexradEchoClasses::GetClassOfReason(int reason)
{
  return reason >= 0 && reason < reasonCount
           ? static_cast<int>(nexrad::ClassOf(static_cast<nexrad::EchoReason>(reason)))
           : -1;
}

bool vtkNexradEchoClasses::IsTakenOut(int quality, int echoClass)
{
  return quality >= 0 && quality <= static_cast<int>(nexrad::QualityLevel::Strict) &&
         echoClass >= 0 && echoClass < classCount &&
         nexrad::RemovesClass(
           static_cast<nexrad::QualityLevel>(quality), static_cast<nexrad::EchoClass>(echoClass));
}

int vtkNexradEchoClasses::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** input, vtkInformationVector*)
{
  // A gate's class depends on the tilts above it, so that no part of the sweeps is enough.
  vtkInformation* info = input[0]->GetInformationObject(0);
  info->Set(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER(), 0);
  info->Set(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_PIECES(), 1);
  info->Set(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
  return 1;
}

int vtkNexradEchoClasses::RequestData(
  vtkInformation*, vtkInformationVector** input, vtkInformationVector* output)
{
  this->SetErrorCode(vtkErrorCode::NoError);
  vtkNexradForgetAbort(this);
  auto* sweeps = vtkPartitionedDataSetCollection::GetData(output);
  CopySweeps(vtkPartitionedDataSetCollection::GetData(input[0]), sweeps);
  try
  {
    AddNames(sweeps->GetFieldData());
    if (!ClassifySweeps(sweeps, vtkNexradProgress(this)))
    {
      sweeps->Initialize();
    }
  }
  catch (const nexrad::Error& error)
  {
    sweeps->Initialize();
    this->SetErrorCode(vtkErrorCode::UserError);
    return vtkNexradFail(this, error.what());
  }
  return 1;
}
