// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNexradSweepConversion.h"

#include "nexrad/Simulation/ScanStrategy.h"
#include "vtkNexradFieldData.h"
#include "vtkNexradSweepLayout.h"

#include "vtkCompositeDataSet.h"
#include "vtkDataAssembly.h"
#include "vtkFloatArray.h"
#include "vtkInformation.h"
#include "vtkIntArray.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkSMPTools.h"
#include "vtkStructuredGrid.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>
#include <cstdio>
#include <limits>

namespace
{

void AddVolumeFieldData(const nexrad::RadarVolume& volume, vtkFieldData* field)
{
  vtkNexradAddTexts(field, "File", {volume.file});
  vtkNexradAddTexts(field, "Site", {volume.site.name});
  if (volume.site.position)
  {
    const nexrad::Position& position = *volume.site.position;
    vtkNexradAddValues<vtkDoubleArray, double>(
      field, "Position", {position.latitude, position.longitude, position.altitude});
  }
  if (volume.coveragePatternNumber)
  {
    vtkNexradAddValues<vtkIntArray, int>(field, "VCP", {*volume.coveragePatternNumber});
  }
  if (volume.Start())
  {
    vtkNexradAddValues<vtkDoubleArray, double>(
      field, "StartTime", {nexrad::ToSeconds(*volume.Start())});
    vtkNexradAddValues<vtkDoubleArray, double>(
      field, "EndTime", {nexrad::ToSeconds(*volume.End())});
  }
  vtkNexradAddValues<vtkUnsignedCharArray, unsigned char>(
    field, "Synthetic", {static_cast<unsigned char>(volume.synthetic ? 1 : 0)});
}

/// An array of one value a ray.
template <class Array, class Get>
void AddRayArray(vtkFieldData* field, const char* name, const nexrad::Sweep& sweep, Get get)
{
  vtkNew<Array> array;
  array->SetName(name);
  array->SetNumberOfTuples(static_cast<vtkIdType>(sweep.rays.size()));
  for (std::size_t i = 0; i < sweep.rays.size(); ++i)
  {
    array->SetValue(static_cast<vtkIdType>(i), get(sweep.rays[i]));
  }
  field->AddArray(array);
}

void AddSweepFieldData(const nexrad::Sweep& sweep, std::size_t index,
  const vtkNexradGateGrid& gates, vtkFieldData* field)
{
  vtkNexradAddValues<vtkIntArray, int>(field, "SweepIndex", {static_cast<int>(index)});
  vtkNexradAddValues<vtkIntArray, int>(field, "ElevationNumber", {sweep.elevationNumber});
  vtkNexradAddValues<vtkDoubleArray, double>(field, "GateGeometry",
    {static_cast<double>(gates.FirstGate), static_cast<double>(gates.GateSpacing)});
  AddRayArray<vtkDoubleArray>(
    field, "RayTime", sweep, [](const nexrad::Ray& ray) { return nexrad::ToSeconds(ray.time); });
  AddRayArray<vtkFloatArray>(
    field, "RayAzimuth", sweep, [](const nexrad::Ray& ray) { return ray.azimuth; });
  AddRayArray<vtkFloatArray>(
    field, "RayElevation", sweep, [](const nexrad::Ray& ray) { return ray.elevation; });
  AddRayArray<vtkFloatArray>(
    field, "NyquistVelocity", sweep, [](const nexrad::Ray& ray) { return ray.nyquist; });
  AddRayArray<vtkFloatArray>(
    field, "UnambiguousRange", sweep, [](const nexrad::Ray& ray) { return ray.unambiguousRange; });
  vtkNexradAddValues<vtkIntArray, int>(field, "Waveform", {static_cast<int>(sweep.waveform)});
}

/// Row `row` of a grid shows this ray: the row after the last ray shows the first again.
const nexrad::Ray& RayOfRow(const nexrad::Sweep& sweep, vtkIdType row)
{
  return sweep.rays[static_cast<std::size_t>(row) % sweep.rays.size()];
}

void AddMoment(const nexrad::Sweep& sweep, const vtkNexradGateGrid& gates,
  nexrad::MomentName moment, vtkStructuredGrid* grid)
{
  vtkNew<vtkFloatArray> values;
  values->SetName(nexrad::ToString(moment));
  values->GetInformation()->Set(vtkDataArray::UNITS_LABEL(), nexrad::UnitOf(moment));
  values->SetNumberOfTuples(grid->GetNumberOfPoints());
  values->FillValue(std::numeric_limits<float>::quiet_NaN());
  vtkNew<vtkUnsignedCharArray> states;
  states->SetName((std::string(nexrad::ToString(moment)) + "_state").c_str());
  states->SetNumberOfTuples(grid->GetNumberOfPoints());
  states->FillValue(static_cast<unsigned char>(nexrad::GateState::NotSampled));
  int dimensions[3];
  grid->GetDimensions(dimensions);
  const vtkIdType rows = dimensions[1];
  for (vtkIdType line = 0; line < rows; ++line)
  {
    const nexrad::MomentRow& row = RayOfRow(sweep, line).Row(moment);
    if (!vtkNexradBelongsTo(row, gates))
    {
      continue;
    }
    vtkIdType point = line * static_cast<vtkIdType>(gates.Gates);
    for (std::size_t gate = vtkNexradNegativeGates(row); gate < row.gates; ++gate, ++point)
    {
      const nexrad::GateState state = row.State(gate);
      states->SetValue(point, static_cast<unsigned char>(state));
      if (state == nexrad::GateState::Valid)
      {
        values->SetValue(point, row.Value(gate));
      }
    }
  }
  vtkPointData* points = grid->GetPointData();
  points->AddArray(values);
  points->AddArray(states);
  if (!points->GetScalars())
  {
    points->SetActiveScalars(values->GetName());
  }
}

vtkNew<vtkStructuredGrid> MakeGrid(const nexrad::Sweep& sweep, const vtkNexradGateGrid& gates,
  const vtkNexradGatePlacement& placement)
{
  const auto rows =
    static_cast<vtkIdType>(sweep.rays.size()) + (vtkNexradIsFullCircle(sweep) ? 1 : 0);
  const auto columns = static_cast<vtkIdType>(gates.Gates);
  vtkNew<vtkDoubleArray> coordinates;
  coordinates->SetNumberOfComponents(3);
  coordinates->SetNumberOfTuples(rows * columns);
  double* first = coordinates->GetPointer(0);
  vtkSMPTools::For(0, rows,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType row = begin; row < end; ++row)
      {
        placement.PlaceRay(RayOfRow(sweep, row), gates.FirstGate, gates.GateSpacing, gates.Gates,
          first + 3 * row * columns);
      }
    });
  vtkNew<vtkPoints> points;
  points->SetData(coordinates);
  vtkNew<vtkStructuredGrid> grid;
  grid->SetDimensions(static_cast<int>(columns), static_cast<int>(rows), 1);
  grid->SetPoints(points);
  for (const nexrad::MomentName moment : gates.Moments)
  {
    AddMoment(sweep, gates, moment, grid);
  }
  return grid;
}

// The angle of the cut in the coverage pattern, which is the same in all volumes; where neither the
// file nor the patterns that are known have it, that of the rays.
double NominalElevation(const nexrad::RadarVolume& volume, const nexrad::Sweep& sweep)
{
  const auto cut = static_cast<std::size_t>(sweep.elevationNumber) - 1;
  if (volume.coveragePattern && cut < volume.coveragePattern->cuts.size())
  {
    return volume.coveragePattern->cuts[cut].elevation;
  }
  const auto* known = nexrad::FindScanStrategy(volume.coveragePatternNumber.value_or(0));
  return known && cut < known->size() ? (*known)[cut].cut.elevation : sweep.MedianElevation();
}

// Two volumes of a coverage pattern have the same names, so that what is chosen by name stays
// chosen as time goes on.
std::string SweepName(
  const nexrad::RadarVolume& volume, std::size_t index, const std::string& prefix)
{
  char text[64];
  std::snprintf(text, sizeof text, "Sweep %02zu %.2f deg", index,
    NominalElevation(volume, volume.sweeps[index]));
  return prefix + text;
}

void AppendPartition(
  vtkPartitionedDataSetCollection* output, vtkPartitionedDataSet* grids, const std::string& name)
{
  const unsigned int index = output->GetNumberOfPartitionedDataSets();
  output->SetPartitionedDataSet(index, grids);
  output->GetMetaData(index)->Set(vtkCompositeDataSet::NAME(), name.c_str());
  vtkDataAssembly* assembly = output->GetDataAssembly();
  const int node = assembly->AddNode(vtkDataAssembly::MakeValidNodeName(name.c_str()).c_str());
  assembly->AddDataSetIndex(node, index);
}

} // namespace

bool vtkNexradAppendSweeps(const nexrad::RadarVolume& volume, const vtkNexradSweepOptions& options,
  vtkPartitionedDataSetCollection* output, const nexrad::Progress& progress)
{
  const vtkNexradGatePlacement placement(
    volume.site, options.Coordinates, options.Center, options.EffectiveRadiusFactor);
  if (!output->GetDataAssembly())
  {
    vtkNew<vtkDataAssembly> assembly;
    assembly->SetRootNodeName("Volume");
    output->SetDataAssembly(assembly);
  }
  for (std::size_t index = 0; index < volume.sweeps.size(); ++index)
  {
    if (progress &&
        !progress(static_cast<double>(index) / static_cast<double>(volume.sweeps.size())))
    {
      return false;
    }
    const nexrad::Sweep& sweep = volume.sweeps[index];
    vtkNew<vtkPartitionedDataSet> grids;
    const bool wanted = output->GetNumberOfPartitionedDataSets() % options.Pieces == options.Piece;
    for (const vtkNexradGateGrid& gates :
      vtkNexradLayOutSweep(sweep, wanted ? options.Moments : std::vector<nexrad::MomentName>()))
    {
      const auto grid = MakeGrid(sweep, gates, placement);
      AddVolumeFieldData(volume, grid->GetFieldData());
      AddSweepFieldData(sweep, index, gates, grid->GetFieldData());
      grids->SetPartition(grids->GetNumberOfPartitions(), grid);
    }
    AppendPartition(output, grids, SweepName(volume, index, options.NamePrefix));
  }
  AddVolumeFieldData(volume, output->GetFieldData());
  return true;
}
