// SPDX-License-Identifier: BSD-3-Clause
#include "Sheets/SweepLayers.h"

#include "Scene/Elements/LineBuilder.h"
#include "Scene/Elements/SceneText.h"
#include "nexrad/Model/Elevation.h"
#include "vtkNexradFieldData.h"
#include "vtkNexradLevel2Reader.h"
#include "vtkNexradMessages.h"

#include <vtkActor.h>
#include <vtkDataArray.h>
#include <vtkDataArraySelection.h>
#include <vtkDataSetMapper.h>
#include <vtkExtractGrid.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPartitionedDataSet.h>
#include <vtkPartitionedDataSetCollection.h>
#include <vtkPointData.h>
#include <vtkProperty.h>
#include <vtkScalarsToColors.h>
#include <vtkStructuredGrid.h>
#include <vtkTextActor.h>
#include <vtkThreshold.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <utility>
#include <vector>

namespace nexrad::scene
{
namespace
{

constexpr Colour ringColour = {0.45, 0.55, 0.62};
constexpr Colour labelColour = {0.80, 0.85, 0.90};
constexpr double sameElevation = 0.25; // degrees

double ElevationOf(vtkStructuredGrid* grid)
{
  vtkDataArray* elevations = grid->GetFieldData()->GetArray("RayElevation");
  std::vector<double> angles;
  for (vtkIdType ray = 0; ray < elevations->GetNumberOfTuples(); ++ray)
  {
    angles.push_back(elevations->GetComponent(ray, 0));
  }
  return MedianOf(std::move(angles));
}

// How many gates of each ray are shown; rays of a sweep are alike.
int GatesWithin(vtkStructuredGrid* grid, const SweepReach& reach)
{
  const double* geometry = grid->GetFieldData()->GetArray("GateGeometry")->GetTuple(0);
  int gate = 0;
  while (gate < grid->GetDimensions()[0] && grid->GetPoint(gate)[2] <= reach.top &&
         geometry[0] + gate * geometry[1] <= reach.range)
  {
    ++gate;
  }
  return gate;
}

vtkSmartPointer<vtkStructuredGrid> FirstGates(vtkStructuredGrid* grid, int gates)
{
  vtkNew<vtkExtractGrid> extract;
  extract->SetInputData(grid);
  extract->SetVOI(0, gates - 1, 0, grid->GetDimensions()[1] - 1, 0, 0);
  extract->Update();
  return extract->GetOutput();
}

void CountEchoes(SweepLayer& layer, double least)
{
  vtkDataArray* values = layer.grid->GetPointData()->GetArray("REF");
  layer.largest = -std::numeric_limits<double>::infinity();
  // The row that repeats the first ray does not count.
  const auto own = static_cast<vtkIdType>(layer.rays * layer.gates);
  for (vtkIdType i = 0; i < std::min(own, values->GetNumberOfTuples()); ++i)
  {
    const double dBZ = values->GetComponent(i, 0);
    if (dBZ >= least) // not NaN
    {
      ++layer.echoes;
      layer.largest = std::max(layer.largest, dBZ);
    }
  }
}

SweepLayer MakeLayer(vtkStructuredGrid* grid, const SweepReach& reach)
{
  SweepLayer layer;
  layer.elevation = ElevationOf(grid);
  layer.rays =
    static_cast<std::size_t>(grid->GetFieldData()->GetArray("RayElevation")->GetNumberOfTuples());
  const int gates = GatesWithin(grid, reach);
  layer.gates = static_cast<std::size_t>(gates);
  if (gates > 1)
  {
    layer.grid = FirstGates(grid, gates);
    CountEchoes(layer, reach.least);
  }
  return layer;
}

// A file may hold several volumes.
bool IsOf(vtkStructuredGrid* grid, const SeriesVolume& volume)
{
  const auto first = vtkNexradGetValue(grid->GetFieldData(), "RayTime");
  return first && FromSeconds(*first) >= volume.start && FromSeconds(*first) <= volume.end;
}

// The grid with reflectivity of a sweep, if it has one and is of this volume.
vtkStructuredGrid* FindReflectivity(vtkPartitionedDataSet* sweep, const SeriesVolume& volume)
{
  for (unsigned part = 0; part < sweep->GetNumberOfPartitions(); ++part)
  {
    auto* grid = vtkStructuredGrid::SafeDownCast(sweep->GetPartition(part));
    if (grid != nullptr && grid->GetPointData()->GetArray("REF") != nullptr && IsOf(grid, volume))
    {
      return grid;
    }
  }
  return nullptr;
}

// Scene coordinates of a point of the sweep.
ScenePoint Place(vtkStructuredGrid* grid, vtkIdType point, double exaggeration)
{
  const double* metres = grid->GetPoint(point);
  return {metres[0] / 1e3, metres[1] / 1e3, metres[2] / 1e3 * exaggeration};
}

// The last gates, all round.
std::vector<ScenePoint> Ring(vtkStructuredGrid* grid, double exaggeration)
{
  std::vector<ScenePoint> ring;
  const vtkIdType gates = grid->GetDimensions()[0];
  for (vtkIdType ray = 0; ray < grid->GetDimensions()[1]; ++ray)
  {
    ring.push_back(Place(grid, ray * gates + gates - 1, exaggeration));
  }
  return ring;
}

// The point of the ring in that direction.
ScenePoint PointTowards(const std::vector<ScenePoint>& ring, double azimuth)
{
  const double east = std::sin(vtkMath::RadiansFromDegrees(azimuth));
  const double north = std::cos(vtkMath::RadiansFromDegrees(azimuth));
  return *std::max_element(ring.begin(), ring.end(),
    [&](const ScenePoint& a, const ScenePoint& b)
    { return a[0] * east + a[1] * north < b[0] * east + b[1] * north; });
}

vtkSmartPointer<vtkActor> MakeEcho(vtkStructuredGrid* grid, const SweepStyle& style)
{
  vtkNew<vtkThreshold> threshold;
  threshold->SetInputData(grid);
  threshold->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "REF");
  threshold->SetThresholdFunction(vtkThreshold::THRESHOLD_UPPER);
  threshold->SetUpperThreshold(style.least);
  threshold->Update();
  threshold->GetOutput()->GetPointData()->SetActiveScalars("REF");
  vtkNew<vtkDataSetMapper> mapper;
  mapper->SetInputData(threshold->GetOutput());
  mapper->SetLookupTable(style.colours);
  mapper->UseLookupTableScalarRangeOn();
  mapper->InterpolateScalarsBeforeMappingOn();
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->SetScale(1e-3, 1e-3, 1e-3 * style.exaggeration);
  actor->GetProperty()->LightingOff();
  return actor;
}

} // namespace

std::vector<SweepLayer> ReadSweepLayers(const SeriesVolume& volume, const SweepReach& reach)
{
  vtkNew<vtkNexradLevel2Reader> reader;
  vtkNexradMessages messages;
  messages.Watch(reader);
  reader->SetFileName(volume.file.c_str());
  reader->GetMomentSelection()->DisableAllArrays();
  reader->GetMomentSelection()->EnableArray("REF");
  reader->SetCoordinatesToProjected();
  reader->SetProjectionCenter(reach.centre[0], reach.centre[1]);
  reader->UseProjectionCenterOn();
  reader->Update();
  messages.ThrowFirstError();
  std::vector<SweepLayer> layers;
  auto* sweeps = vtkPartitionedDataSetCollection::SafeDownCast(reader->GetOutputDataObject(0));
  for (unsigned i = 0; i < sweeps->GetNumberOfPartitionedDataSets(); ++i)
  {
    if (auto* grid = FindReflectivity(sweeps->GetPartitionedDataSet(i), volume))
    {
      SweepLayer layer = MakeLayer(grid, reach);
      const bool known = std::any_of(layers.begin(), layers.end(),
        [&layer](const SweepLayer& other)
        { return std::abs(other.elevation - layer.elevation) < sameElevation; });
      if (!known && layer.grid != nullptr)
      {
        layers.push_back(layer);
      }
    }
  }
  std::sort(layers.begin(), layers.end(),
    [](const SweepLayer& a, const SweepLayer& b) { return a.elevation < b.elevation; });
  return layers;
}

std::vector<vtkSmartPointer<vtkProp>> MakeSweepProps(
  const SweepLayer& layer, const SweepStyle& style)
{
  std::vector<vtkSmartPointer<vtkProp>> props;
  if (layer.echoes > 0)
  {
    props.push_back(MakeEcho(layer.grid, style));
  }
  const std::vector<ScenePoint> ring = Ring(layer.grid, style.exaggeration);
  LineBuilder builder;
  builder.Add(ring);
  props.push_back(builder.MakeActor(ringColour, 1.0, 0.7));
  char text[16];
  std::snprintf(text, sizeof text, "%.1f\302\260", layer.elevation);
  props.push_back(MakeLabel(text, PointTowards(ring, style.labelAzimuth), style.textSize,
    labelColour, style.labelAzimuth > 180.0 ? LabelSide::Left : LabelSide::Right));
  return props;
}

} // namespace nexrad::scene
