// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cmath>
#include <optional>
#include <vector>

namespace nexrad::scene
{

/// Red, green and blue, 0…1.
using Colour = std::array<double, 3>;

/// A part of a colour, 0…1, as a byte.
inline unsigned char ToByte(double part)
{
  return static_cast<unsigned char>(std::lround(255.0 * part));
}

/// Where a ramp of colours ends, and in which.
struct ColourEnd
{
  double at = 0.0; ///< unit of what is shown
  Colour colour{};
};

/// One colour, or a ramp, from a value up to that of the next bin.
struct ColourBin
{
  double from = 0.0; ///< unit of what is shown
  Colour colour{};   ///< of a ramp, that at its beginning
  std::optional<ColourEnd> ramp = std::nullopt;
};

/// At least two bins, their values ascending.
using ColourTable = std::vector<ColourBin>;

/// Which colours a scene has beside those of the data.
enum class ThemeChoice
{
  Dark, ///< light letters over a dark sky and a grey ground
  Light ///< dark letters over a white sky and a pale ground
};

/// The colours of a scene beside those of the data.
struct Theme
{
  Colour skyBottom, skyTop;
  Colour ground;
  Colour notScanned, rangeFolded, filtered; ///< of a map, where there is no value
  Colour country, state, county;            ///< lines of the map
  Colour ring;                              ///< of range, about a radar
  Colour marker;                            ///< of a radar, with its name
  Colour placeName;
  Colour frame;   ///< edges of the domain
  Colour wall;    ///< lines of height on the far walls
  Colour scale;   ///< ticks and numbers
  Colour title;   ///< the time
  Colour note;    ///< the other captions
  Colour warning; ///< the word SYNTHETIC
  Colour rim;     ///< about letters that may lie over echo
  Colour water;
  double relief = 0.12; ///< how much brighter or darker than the ground its slopes are at most
};

const Theme& ThemeOf(ThemeChoice choice);

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
