// SPDX-License-Identifier: BSD-3-Clause
#include "Sheets/ResolutionSheet.h"

#include "Sheets/PictureSheet.h"
#include "Sheets/ScenePictures.h"
#include "Tables/BenchRequest.h"

#include <vtkImageData.h>

#include <cstdio>

namespace nexrad::scene
{
namespace
{

using application::FormatDimensions;
using application::GivenColumn;
using application::NameColumn;

// One merged volume and what is drawn of it.
struct Resolution
{
  std::string name;              ///< "256x256x128"
  std::array<double, 3> spacing; ///< of the voxels, km
  vtkSmartPointer<vtkImageData> picture;
  PictureDifference difference; ///< from the finest
};

std::string LabelOf(const Resolution& resolution, bool finest)
{
  char text[96];
  std::snprintf(text, sizeof text, "%s voxels of %.1f x %.1f x %.2f km", resolution.name.c_str(),
    resolution.spacing[0], resolution.spacing[1], resolution.spacing[2]);
  if (finest)
  {
    return text;
  }
  char difference[64];
  std::snprintf(
    difference, sizeof difference, "; %.1f of 255 from the finest", resolution.difference.mean);
  return std::string(text) + difference;
}

} // namespace

Sheet DrawResolutionSheet(const SheetSource& source)
{
  std::vector<Resolution> resolutions;
  vtkSmartPointer<vtkImageData> ground;
  for (const std::array<int, 3>& dimensions : source.request.dimensions)
  {
    const vtkSmartPointer<vtkImageData> volume = source.MergeAtTime(dimensions)->Load(0, {});
    ScenePictures pictures(source.request.camera, source.request.size);
    pictures.Scene().SetVolume(volume);
    const double* spacing = volume->GetSpacing();
    resolutions.push_back({FormatDimensions(dimensions),
      {spacing[0] / 1e3, spacing[1] / 1e3, spacing[2] / 1e3}, pictures.Draw(), {}});
    ground = pictures.DrawWithoutVolume();
  }
  Sheet sheet;
  sheet.table = {"resolution",
    source.Title(
      "One time merged into volumes of several sizes, 256 slices (as figure 4.3 of the thesis)"),
    {NameColumn("dimensions", "voxels"), GivenColumn("east_km", "east, km", 2),
      GivenColumn("north_km", "north, km", 2), GivenColumn("up_km", "up, km", 3),
      {"difference", "difference from the finest, of 255", 2},
      {"finest_covers_percent", "the finest covers, %", 1}},
    {}};
  std::vector<SheetPanel> panels;
  for (Resolution& resolution : resolutions)
  {
    resolution.difference = CompareCovered(resolution.picture, resolutions.back().picture, ground);
    sheet.table.rows.push_back({resolution.name, resolution.spacing[0], resolution.spacing[1],
      resolution.spacing[2], resolution.difference.mean, 100.0 * resolution.difference.covered});
    panels.push_back({resolution.picture, LabelOf(resolution, &resolution == &resolutions.back())});
  }
  sheet.picture = MakeSheet(sheet.table.title, panels, panels.size() == 3 ? 3 : 2);
  return sheet;
}

} // namespace nexrad::scene
