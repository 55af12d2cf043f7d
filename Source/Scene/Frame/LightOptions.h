// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace nexrad::scene
{

/// Where light comes from.
struct LightDirection
{
  double azimuth = 250.0;  ///< degrees clockwise from north, from the volume to the light
  double elevation = 45.0; ///< degrees of the light above the horizon, -90…90
};

/// The light that the volume stands in; the strengths are those of
/// vtkOpenGLTextureSliceVolumeMapper. With both at 0 the volume is drawn without shadows.
struct LightOptions
{
  double shadow = 0.5;    ///< strength of shadows on the volume and the ground, 0…1
  double occlusion = 0.4; ///< strength of ambient occlusion, 0…1
  LightDirection direction;

  bool HasShadows() const { return shadow > 0.0 || occlusion > 0.0; }

  bool operator==(const LightOptions& other) const
  {
    return shadow == other.shadow && occlusion == other.occlusion &&
           direction.azimuth == other.direction.azimuth &&
           direction.elevation == other.direction.elevation;
  }
};

} // namespace nexrad::scene
