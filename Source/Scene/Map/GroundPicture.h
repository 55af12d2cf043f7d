// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Scene/Frame/SceneFrame.h"
#include "Scene/Map/MapData.h"
#include "Scene/Shapes/Theme.h"

#include <vtkNew.h>
#include <vtkSmartPointer.h>
#include <vtkType.h>

#include <cstdint>
#include <vector>

class vtkActor;
class vtkImageData;
class vtkTexture;

namespace nexrad::scene
{

/// Which points of the domain are land: `columns` from its western to its eastern edge times `rows`
/// from its southern to its northern one, in the middles of equal cells, row by row. Needs HasMap.
std::vector<std::uint8_t> PaintLand(
  const SceneFrame& frame, const std::vector<MapPolyline>& areas, int columns, int rows);

/// Heights in m in the middles of equal cells, row by row from the south-western one on.
struct HeightGrid
{
  int columns = 0;
  int rows = 0;
  double cellWidth = 1.0;  ///< km
  double cellHeight = 1.0; ///< km
  std::vector<double> heights;
};

/// How much brighter (above 0) or darker each cell is than level ground, -1…1, in light from a
/// direction, with heights stretched so that slopes of 1 in 30 stand out: Lambert's reflection,
/// compressed so that it stays within the bounds.
std::vector<float> ShadeRelief(const HeightGrid& ground, const LightDirection& light);

/// Colours of the ground under a domain, from its south-western corner on: land with shaded relief,
/// and water. A domain outside of the embedded data, or without a map, has one colour. `longSide`:
/// texels along the longer side of the domain.
vtkSmartPointer<vtkImageData> MakeGroundPicture(
  const SceneFrame& frame, const Theme& theme, int longSide = 1024);

/// The shadow of the volume on the ground: how much light arrives in the lowest layer of the
/// mapper's light volume darkens the picture of the ground.
class GroundShadow
{
public:
  GroundShadow();
  ~GroundShadow();

  /// Brings the shadow up to date and puts it on the ground, which has its picture
  /// (MakeGroundPicture) as texture, with coordinates 0 to 1 over the voxels. `light`:
  /// vtkOpenGLTextureSliceVolumeMapper::GetLightVolume; nullptr: there is no shadow. `volume`: what
  /// the mapper draws. `keeps`: the shadow that is there already stays.
  void Show(vtkActor* ground, vtkImageData* light, const LightOptions& options,
    vtkImageData* volume, bool keeps = false);

private:
  void Fill(vtkImageData* light, const LightOptions& options, vtkImageData* volume);

  vtkSmartPointer<vtkTexture> lit; ///< the ground's own
  vtkNew<vtkTexture> texture;
  vtkNew<vtkImageData> image;
  vtkMTimeType made = 0; ///< when the light volume was made that the image shows
  double shadow = 0.0;   ///< strengths that the image shows
  double occlusion = 0.0;
};

} // namespace nexrad::scene
