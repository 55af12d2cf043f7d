// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ColourTable.h"

namespace nexrad::scene
{

/// How the volume is drawn.
enum class MapperChoice
{
  TextureSlice, ///< vtkOpenGLTextureSliceVolumeMapper
  RayCast       ///< VTK's GPU ray caster, for comparison
};

/// What a scene shows beside the data.
struct SceneOptions
{
  ColourTable colours;       ///< empty: the weather service's
  double exaggeration = 8.0; ///< of heights; above 0
  MapperChoice mapper = MapperChoice::TextureSlice;
  int slices = 256;         ///< or samples along the longest ray; from 1 on
  double ringSpacing = 0.0; ///< m, between rings about each radar; 0: none
};

} // namespace nexrad::scene
