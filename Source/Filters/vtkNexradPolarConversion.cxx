// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNexradPolarConversion.h"

#include "nexrad/System/Error.h"
#include "vtkNexradFieldData.h"

#include "vtkCompositeDataSet.h"
#include "vtkFloatArray.h"
#include "vtkInformation.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPointData.h"
#include "vtkStructuredGrid.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <iterator>
#include <string>
#include <vector>

namespace
{

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

  vtkDataArray* RayArray(const char* name, vtkIdType rays) const
  {
    vtkDataArray* array = this->Field->GetArray(name);
    if (!array || array->GetNumberOfComponents() != 1 ||
        (rays >= 0 && array->GetNumberOfTuples() != rays))
    {
      this->Refuse(name, "must be in the field data, with one value a ray");
    }
    return array;
  }

  // nullptr where the field data do not have it.
  vtkDataArray* OptionalRayArray(const char* name, vtkIdType rays) const
  {
    return this->Field->HasArray(name) ? this->RayArray(name, rays) : nullptr;
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
  const vtkIdType rays = source.RayArray("RayTime", -1)->GetNumberOfTuples();
  vtkDataArray* times = source.RayArray("RayTime", rays);
  vtkDataArray* azimuths = source.RayArray("RayAzimuth", rays);
  vtkDataArray* elevations = source.RayArray("RayElevation", rays);
  vtkDataArray* ranges = source.OptionalRayArray("UnambiguousRange", rays);
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

void AppendGrid(std::vector<nexrad::PolarVolume>& volumes,
  std::vector<std::vector<vtkNexradSweepOrigin>>& origins, const SweepGrid& source,
  nexrad::MomentName moment)
{
  if (!source.Grid->GetPointData()->HasArray(nexrad::ToString(moment)))
  {
    return;
  }
  nexrad::PolarVolume description = DescribeVolume(source, moment);
  auto own = std::find_if(volumes.begin(), volumes.end(),
    [&](const nexrad::PolarVolume& each)
    { return each.site.name == description.site.name && each.start == description.start; });
  if (own == volumes.end())
  {
    volumes.push_back(std::move(description));
    origins.emplace_back();
    own = volumes.end() - 1;
  }
  std::vector<int> rows;
  own->sweeps.push_back(ToPolarSweep(source, moment, rows));
  origins[static_cast<std::size_t>(own - volumes.begin())].push_back(
    {source.Grid, std::move(rows)});
}

} // namespace

std::vector<nexrad::PolarVolume> vtkNexradSweepsToPolar(vtkPartitionedDataSetCollection* sweeps,
  nexrad::MomentName moment, std::vector<std::vector<vtkNexradSweepOrigin>>* origins)
{
  std::vector<nexrad::PolarVolume> volumes;
  std::vector<std::vector<vtkNexradSweepOrigin>> found;
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
        AppendGrid(volumes, found, {grid, name ? name : "data set " + std::to_string(i)}, moment);
      }
    }
  }
  if (origins)
  {
    *origins = std::move(found);
  }
  return volumes;
}
