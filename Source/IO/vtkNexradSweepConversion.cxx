// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNexradSweepConversion.h"

#include "nexrad/Geometry/Beam.h"
#include "nexrad/Geometry/SiteGeoreference.h"
#include "nexrad/Grid/GridSpecification.h"
#include "nexrad/Simulation/ScanStrategy.h"
#include "nexrad/System/Error.h"
#include "vtkNexradFieldData.h"

#include "vtkCompositeDataSet.h"
#include "vtkDataAssembly.h"
#include "vtkFloatArray.h"
#include "vtkInformation.h"
#include "vtkIntArray.h"
#include "vtkMath.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkSMPTools.h"
#include "vtkStructuredGrid.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <functional>
#include <limits>

namespace
{

// Gates at the same ranges, and the moments that are measured there. Gates at negative range are
// left out.
struct GateGrid
{
  int FirstGate = 0;     // m, slant range of the first gate that is not negative
  int GateSpacing = 0;   // m
  std::size_t Gates = 0; // of the longest ray
  std::vector<nexrad::MomentName> Moments;
};

std::size_t NegativeGates(const nexrad::MomentRow& row)
{
  if (row.firstGate >= 0 || row.gateSpacing <= 0)
  {
    return 0;
  }
  const int negative = (-row.firstGate + row.gateSpacing - 1) / row.gateSpacing;
  return std::min(static_cast<std::size_t>(negative), static_cast<std::size_t>(row.gates));
}

int FirstGateKept(const nexrad::MomentRow& row)
{
  return row.firstGate + static_cast<int>(NegativeGates(row)) * row.gateSpacing;
}

// Whether the row's gates are gates of the grid.
bool BelongsTo(const nexrad::MomentRow& row, const GateGrid& grid)
{
  return row.gates > NegativeGates(row) && row.gateSpacing == grid.GateSpacing &&
         FirstGateKept(row) == grid.FirstGate;
}

// One grid for each distinct gate geometry of the moments, in the order of the moments.
std::vector<GateGrid> LayOutSweep(
  const nexrad::Sweep& sweep, const std::vector<nexrad::MomentName>& moments)
{
  std::vector<GateGrid> grids;
  for (const nexrad::MomentName moment : moments)
  {
    for (const nexrad::Ray& ray : sweep.rays)
    {
      const nexrad::MomentRow& row = ray.Row(moment);
      const std::size_t gates = row.gates - NegativeGates(row);
      if (gates == 0 || row.gateSpacing <= 0)
      {
        continue;
      }
      auto grid = std::find_if(
        grids.begin(), grids.end(), [&row](const GateGrid& each) { return BelongsTo(row, each); });
      if (grid == grids.end())
      {
        grids.push_back({FirstGateKept(row), row.gateSpacing, 0, {}});
        grid = grids.end() - 1;
      }
      grid->Gates = std::max(grid->Gates, gates);
      if (grid->Moments.empty() || grid->Moments.back() != moment)
      {
        grid->Moments.push_back(moment);
      }
    }
  }
  return grids;
}

// True when the rays go all the way round: the gap from the last ray on to the first is not longer
// than one and a half times the median step from ray to ray.
bool IsFullCircle(const nexrad::Sweep& sweep)
{
  std::vector<double> steps;
  double turned = 0.0;
  for (std::size_t i = 1; i < sweep.rays.size(); ++i)
  {
    const double step =
      std::remainder(static_cast<double>(sweep.rays[i].azimuth) - sweep.rays[i - 1].azimuth, 360.0);
    turned += step;
    steps.push_back(std::abs(step));
  }
  if (steps.size() < 2)
  {
    return false;
  }
  std::nth_element(
    steps.begin(), steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2), steps.end());
  return 360.0 - std::abs(turned) <= 1.5 * steps[steps.size() / 2];
}

// Places on the ground below a ray, at equal distances.
using Nodes = std::vector<std::array<double, 2>>;
constexpr double NodeSpacing = 20'000.0; // m

// Node k stands at (k - 1) * NodeSpacing, so that a cubic has a node on either side of its piece.
std::array<double, 2> Interpolate(const Nodes& nodes, double groundDistance)
{
  const double position = groundDistance / NodeSpacing;
  const auto piece = static_cast<std::size_t>(
    std::clamp(std::floor(position), 0.0, static_cast<double>(nodes.size()) - 4.0));
  const double t = position - static_cast<double>(piece);
  // Lagrange's polynomials on -1, 0, 1, 2.
  const std::array<double, 4> weights = {-t * (t - 1.0) * (t - 2.0) / 6.0,
    (t + 1.0) * (t - 1.0) * (t - 2.0) / 2.0, -(t + 1.0) * t * (t - 2.0) / 2.0,
    (t + 1.0) * t * (t - 1.0) / 6.0};
  std::array<double, 2> result = {0.0, 0.0};
  for (std::size_t i = 0; i < weights.size(); ++i)
  {
    result[0] += weights[i] * nodes[piece + i][0];
    result[1] += weights[i] * nodes[piece + i][1];
  }
  return result;
}

// Turns slant ranges into points: the beam by Formulas B1, the ground by B3. Local coordinates are
// those of the azimuthal equidistant projection about the site: at the azimuth and the distance
// along the ground. A ray's line on the ground is smooth, so that geodesics are solved at nodes 20
// km apart only, with cubics between them (to better than a millimetre up to 460 km).
class GatePlacement
{
public:
  // Throws nexrad::Error when the coordinates need a position and the site has none.
  GatePlacement(const nexrad::Site& theSite, const vtkNexradSweepOptions& options)
    : beam(options.EffectiveRadiusFactor)
    , coordinates(options.Coordinates)
    , site(theSite.position.value_or(nexrad::Position{}))
  {
    if (coordinates != vtkNexradCoordinates::Local && !theSite.position)
    {
      throw nexrad::Error("the position of site \"" + theSite.name +
                          "\" is unknown: set it, or ask for local coordinates");
    }
    projection.centreLatitude = options.Center ? (*options.Center)[0] : site.latitude;
    projection.centreLongitude = options.Center ? (*options.Center)[1] : site.longitude;
  }

  // Writes x, y, z of the gates of a row of the grid.
  void PlaceRay(const nexrad::Ray& ray, const GateGrid& gates, double* points) const
  {
    const double firstGate = gates.FirstGate;
    const double spacing = gates.GateSpacing;
    const bool local = coordinates == vtkNexradCoordinates::Local;
    const double lastGate = firstGate + spacing * static_cast<double>(gates.Gates);
    const Nodes nodes = local ? Nodes() : this->MakeNodes(ray.azimuth, lastGate);
    const double azimuth = vtkMath::RadiansFromDegrees(static_cast<double>(ray.azimuth));
    const double east = std::sin(azimuth);
    const double north = std::cos(azimuth);
    for (std::size_t gate = 0; gate < gates.Gates; ++gate, points += 3)
    {
      const nexrad::BeamPoint point =
        beam.Locate(firstGate + spacing * static_cast<double>(gate), ray.elevation);
      const std::array<double, 2> place =
        local ? std::array<double, 2>{point.groundDistance * east, point.groundDistance * north}
              : Interpolate(nodes, point.groundDistance);
      points[0] = place[0];
      points[1] = place[1];
      points[2] = local ? point.height : site.altitude + point.height;
    }
  }

private:
  Nodes MakeNodes(double azimuth, double farthest) const
  {
    const nexrad::SiteGeoreference ground(site);
    const auto count = static_cast<std::size_t>(std::max(0.0, farthest) / NodeSpacing) + 4;
    Nodes nodes(count);
    for (std::size_t k = 0; k < count; ++k)
    {
      // Behind the antenna the geodesic goes on at the opposite azimuth.
      const double distance = (static_cast<double>(k) - 1.0) * NodeSpacing;
      const std::array<double, 2> place =
        distance < 0.0 ? ground.Locate({std::fmod(azimuth + 180.0, 360.0), -distance})
                       : ground.Locate({azimuth, distance});
      if (coordinates == vtkNexradCoordinates::Projected)
      {
        nodes[k] = projection.FromGeographic(place[0], place[1]);
      }
      else
      {
        // Longitudes count on across the antimeridian.
        nodes[k] = {site.longitude + std::remainder(place[0] - site.longitude, 360.0), place[1]};
      }
    }
    return nodes;
  }

  nexrad::BeamModel beam;
  vtkNexradCoordinates coordinates;
  nexrad::Position site;
  nexrad::GridSpecification projection;
};

void AddVolumeFieldData(const nexrad::RadarVolume& volume, vtkFieldData* field)
{
  vtkNexradAddTexts(field, "File", {volume.file});
  vtkNexradAddTexts(field, "Site", {volume.site.name});
  if (volume.site.position)
  {
    const nexrad::Position& position = *volume.site.position;
    vtkNexradAddValues<vtkDoubleArray>(
      field, "Position", {position.latitude, position.longitude, position.altitude});
  }
  if (volume.coveragePatternNumber)
  {
    vtkNexradAddValues<vtkIntArray>(field, "VCP", {*volume.coveragePatternNumber});
  }
  if (volume.Start())
  {
    vtkNexradAddValues<vtkDoubleArray>(field, "StartTime", {nexrad::ToSeconds(*volume.Start())});
    vtkNexradAddValues<vtkDoubleArray>(field, "EndTime", {nexrad::ToSeconds(*volume.End())});
  }
  vtkNexradAddValues<vtkUnsignedCharArray>(field, "Synthetic", {volume.synthetic});
}

template <class Array, class Get>
void AddRayArray(vtkFieldData* field, const char* name, const nexrad::Sweep& sweep, Get get)
{
  vtkNew<Array> array;
  array->SetName(name);
  array->SetNumberOfTuples(static_cast<vtkIdType>(sweep.rays.size()));
  for (std::size_t i = 0; i < sweep.rays.size(); ++i)
  {
    array->SetValue(static_cast<vtkIdType>(i), std::invoke(get, sweep.rays[i]));
  }
  field->AddArray(array);
}

void AddSweepFieldData(
  const nexrad::Sweep& sweep, std::size_t index, const GateGrid& gates, vtkFieldData* field)
{
  vtkNexradAddValues<vtkIntArray>(field, "SweepIndex", {static_cast<int>(index)});
  vtkNexradAddValues<vtkIntArray>(field, "ElevationNumber", {sweep.elevationNumber});
  vtkNexradAddValues<vtkDoubleArray>(field, "GateGeometry",
    {static_cast<double>(gates.FirstGate), static_cast<double>(gates.GateSpacing)});
  AddRayArray<vtkDoubleArray>(
    field, "RayTime", sweep, [](const nexrad::Ray& ray) { return nexrad::ToSeconds(ray.time); });
  AddRayArray<vtkFloatArray>(field, "RayAzimuth", sweep, &nexrad::Ray::azimuth);
  AddRayArray<vtkFloatArray>(field, "RayElevation", sweep, &nexrad::Ray::elevation);
  AddRayArray<vtkFloatArray>(field, "NyquistVelocity", sweep, &nexrad::Ray::nyquist);
  AddRayArray<vtkFloatArray>(field, "UnambiguousRange", sweep, &nexrad::Ray::unambiguousRange);
  vtkNexradAddValues<vtkIntArray>(field, "Waveform", {static_cast<int>(sweep.waveform)});
}

/// Row `row` of a grid shows this ray: the row after the last ray shows the first again.
const nexrad::Ray& RayOfRow(const nexrad::Sweep& sweep, vtkIdType row)
{
  return sweep.rays[static_cast<std::size_t>(row) % sweep.rays.size()];
}

void AddMoment(const nexrad::Sweep& sweep, const GateGrid& gates, nexrad::MomentName moment,
  vtkStructuredGrid* grid)
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
    if (!BelongsTo(row, gates))
    {
      continue;
    }
    vtkIdType point = line * static_cast<vtkIdType>(gates.Gates);
    for (std::size_t gate = NegativeGates(row); gate < row.gates; ++gate, ++point)
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

vtkNew<vtkStructuredGrid> MakeGrid(
  const nexrad::Sweep& sweep, const GateGrid& gates, const GatePlacement& placement)
{
  const auto rows = static_cast<vtkIdType>(sweep.rays.size()) + (IsFullCircle(sweep) ? 1 : 0);
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
        placement.PlaceRay(RayOfRow(sweep, row), gates, first + 3 * row * columns);
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
  const GatePlacement placement(volume.site, options);
  if (!output->GetDataAssembly())
  {
    vtkNew<vtkDataAssembly> assembly;
    assembly->SetRootNodeName("Volume");
    output->SetDataAssembly(assembly);
  }
  for (std::size_t index = 0; index < volume.sweeps.size(); ++index)
  {
    if (!progress(static_cast<double>(index) / static_cast<double>(volume.sweeps.size())))
    {
      return false;
    }
    const nexrad::Sweep& sweep = volume.sweeps[index];
    vtkNew<vtkPartitionedDataSet> grids;
    const bool wanted = output->GetNumberOfPartitionedDataSets() % options.Pieces == options.Piece;
    for (const GateGrid& gates :
      LayOutSweep(sweep, wanted ? options.Moments : std::vector<nexrad::MomentName>()))
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
