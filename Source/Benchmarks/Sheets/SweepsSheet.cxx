// SPDX-License-Identifier: BSD-3-Clause
#include "Sheets/SweepsSheet.h"

#include "Sheets/PictureSheet.h"
#include "Sheets/ScenePictures.h"
#include "Sheets/SweepLayers.h"
#include "nexrad/Grid/MakeGrid.h"
#include "nexrad/System/Error.h"
#include "vtkNexradImageConversion.h"
#include "vtkNexradTransferFunction.h"

#include <vtkColorTransferFunction.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkProp.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <chrono>

namespace nexrad::scene
{
namespace
{

using application::BenchCell;
using application::BenchTable;
using application::NameColumn;

constexpr double domainTop = 20'000.0; // m above mean sea level
constexpr double leastEcho = 5.0;      // dBZ, the first step of the colours

const SeriesVolume& NearestVolume(const SiteSeries& site, Time time)
{
  return *std::min_element(site.volumes.begin(), site.volumes.end(),
    [time](const SeriesVolume& a, const SeriesVolume& b)
    { return std::chrono::abs(a.start - time) < std::chrono::abs(b.start - time); });
}

// A volume without echo about the site: it gives the scene its map, its scales and its captions.
vtkSmartPointer<vtkImageData> MakeEmptyDomain(const SiteSeries& site, const SeriesVolume& radar)
{
  GriddedVolume volume;
  GridRequest box;
  box.dimensions = {2, 2, 2};
  box.top = domainTop;
  volume.grid = MakeGrid(box, {*site.site.position});
  volume.time = radar.start;
  volume.sites = {site.site.name};
  volume.synthetic = radar.synthetic;
  volume.values.assign(volume.grid.VoxelCount(), volume.fill);
  volume.states.assign(volume.grid.VoxelCount(), VoxelState::NoEcho);
  auto image = vtkSmartPointer<vtkImageData>::New();
  vtkNexradVolumeToImage(volume, image);
  return image;
}

// East and west by turns, and farther and farther south, so that neighbours do not cover each
// other's labels, from above or from the south.
double LabelAzimuth(std::size_t layer)
{
  const double turned = 10.0 * static_cast<double>(layer);
  return layer % 2 == 0 ? std::min(50.0 + turned, 170.0) : std::max(310.0 - turned, 190.0);
}

vtkSmartPointer<vtkImageData> DrawLayers(const std::vector<SweepLayer>& layers, double least,
  vtkImageData* domain, const CameraView& view, const std::array<int, 2>& size)
{
  ScenePictures pictures(view, size);
  RadarScene& scene = pictures.Scene();
  scene.SetVolume(domain);
  scene.ShowVolume(false); // the layers are what is seen
  vtkNew<vtkColorTransferFunction> colours;
  scene.TransferFunction()->FillSteppedColorFunction(colours);
  SweepStyle style{colours, least, scene.Frame().Exaggeration()};
  style.textSize = std::max(9, size[1] / 45);
  for (std::size_t i = 0; i < layers.size(); ++i)
  {
    style.labelAzimuth = LabelAzimuth(i);
    for (const auto& prop : MakeSweepProps(layers[i], style))
    {
      scene.GetRenderer()->AddViewProp(prop);
    }
  }
  return pictures.Draw();
}

BenchTable MakeSweepTable(const std::vector<SweepLayer>& layers, const std::string& title)
{
  BenchTable table = {"sweeps", title,
    {NameColumn("elevation_deg", "elevation, degrees"), {"rays", "rays"}, {"gates", "gates a ray"},
      {"echoes", "gates of 5 dBZ or more"}, {"largest_dbz", "largest, dBZ", 1}},
    {}};
  table.columns[0].decimals = 2;
  for (const SweepLayer& layer : layers)
  {
    table.rows.push_back({layer.elevation, static_cast<double>(layer.rays),
      static_cast<double>(layer.gates), static_cast<double>(layer.echoes),
      layer.echoes > 0 ? BenchCell(layer.largest) : BenchCell()});
  }
  return table;
}

} // namespace

Sheet DrawSweepsSheet(const SheetSource& source)
{
  const SiteSeries& site = source.scan.sites.front();
  const SeriesVolume& volume = NearestVolume(site, source.time);
  const auto domain = MakeEmptyDomain(site, volume);
  const GridSpecification grid = vtkNexradImageToVolume(domain).grid;
  SweepReach reach;
  reach.centre = {grid.centreLatitude, grid.centreLongitude};
  reach.top = domainTop;
  reach.least = leastEcho;
  const std::vector<SweepLayer> layers = ReadSweepLayers(volume, reach);
  if (layers.empty())
  {
    throw Error(volume.file.string() + ": has no sweep with reflectivity");
  }
  Sheet sheet;
  sheet.table = MakeSweepTable(
    layers, source.Title("The sweeps of " + site.site.name + ", " +
                         FormatIso8601(volume.start).substr(0, 19) +
                         "Z, to 230 km and 20 km height (as figure 3.8 of the thesis)"));
  const std::array<int, 2>& size = source.request.size;
  const auto draw = [&](const CameraView& view)
  { return DrawLayers(layers, leastEcho, domain, view, size); };
  sheet.picture = MakeSheet(sheet.table.title,
    {{draw({180.0, 8.0, 1.0, false}), "From the side, looking north"},
      {draw({180.0, 90.0, 1.0, true}), "From above"}},
    2);
  return sheet;
}

} // namespace nexrad::scene
