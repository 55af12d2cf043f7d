// SPDX-License-Identifier: BSD-3-Clause
#include "Sheets/SlicesSheet.h"

#include "Sheets/PictureSheet.h"
#include "Sheets/ScenePictures.h"
#include "Tables/BenchRequest.h"

#include <vtkImageData.h>

#include <cstdio>

namespace nexrad::scene
{
namespace
{

using application::NameColumn;

constexpr int manySlices = 2048; // of the reference
constexpr int sliceCounts[] = {16, 32, 64, 128, 256, 512, 1024, manySlices};

std::string LabelOf(int slices, const PictureDifference& difference)
{
  char text[80];
  std::snprintf(
    text, sizeof text, "%d slices; %.2f of 255 from %d", slices, difference.mean, manySlices);
  return slices == manySlices ? std::to_string(slices) + " slices" : text;
}

} // namespace

Sheet DrawSlicesSheet(const SheetSource& source)
{
  const std::array<int, 3>& dimensions = source.MiddleSize();
  ScenePictures pictures(source.request.camera, source.request.size);
  pictures.Scene().SetVolume(source.MergeAtTime(dimensions)->Load(0, {}));
  const auto draw = [&pictures](int slices)
  {
    SceneOptions options = pictures.Scene().Options();
    options.slices = slices;
    pictures.Scene().Follow(options);
    return pictures.Draw();
  };
  const auto reference = draw(manySlices);
  const auto ground = pictures.DrawWithoutVolume();
  Sheet sheet;
  sheet.table = {"slices",
    source.Title("One volume of " + application::FormatDimensions(dimensions) +
                 " voxels by more and more slices (as figure 4.4 of the thesis)"),
    {NameColumn("slices", "slices"), {"difference", "difference from 2048, of 255", 3},
      {"covered_percent", "the volume covers, %", 1}},
    {}};
  std::vector<SheetPanel> panels;
  for (const int slices : sliceCounts)
  {
    const auto picture = draw(slices);
    const PictureDifference difference = CompareCovered(picture, reference, ground);
    sheet.table.rows.push_back(
      {static_cast<double>(slices), difference.mean, 100.0 * difference.covered});
    panels.push_back({picture, LabelOf(slices, difference)});
  }
  sheet.picture = MakeSheet(sheet.table.title, panels, 4);
  return sheet;
}

} // namespace nexrad::scene
