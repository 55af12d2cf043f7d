// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Filters/Series/VolumeFiles.h"
#include "Scene/Frame/SceneFrame.h"
#include "Scene/Plan/PlanView.h"
#include "Scene/Shapes/Theme.h"
#include "Scene/VolumeCut.h"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

namespace nexrad::scene
{

/// How the volume is drawn.
enum class MapperChoice
{
  TextureSlice, ///< vtkOpenGLTextureSliceVolumeMapper
  RayCast       ///< VTK's GPU ray caster, for comparison
};

/// What the camera looks at, with walls and scales about it.
enum class FrameChoice
{
  Echo,  ///< the echo, and the radars near it
  Domain ///< the whole domain
};

/// A value whose surface is drawn.
struct IsoValue
{
  double value = 0.0;            ///< in the unit of the moment
  std::optional<double> opacity; ///< of the surface, 0 to 1; empty: by its rank among the values

  bool operator==(const IsoValue& other) const
  {
    return value == other.value && opacity == other.opacity;
  }
};

/// What a scene shows beside the data.
struct SceneOptions
{
  std::string
    preset; ///< of vtkNexradTransferFunction; empty: the first of the moment that is shown
  std::filesystem::path
    colours; ///< colours, and opacities if it has any, in place of the preset's:
             ///< a file that vtkNexradTransferFunction reads; empty: none
  std::filesystem::path opacities; ///< opacities alone, in place of those of the preset and of
                                   ///< `colours`: such a file; empty: none
  std::vector<IsoValue> isoValues; ///< surfaces to draw, with the colours of preset or file; none:
                                   ///< those of the preset
  std::string colourBy; ///< array that gives the colours, as "VEL" or "REF_age", in place of the
                        ///< moment, which gives the opacities; empty: the moment gives both
  std::optional<double> exaggeration; ///< of heights; above 0; empty: DefaultExaggeration
  MapperChoice mapper = MapperChoice::TextureSlice;
  bool preIntegration = true; ///< vtkOpenGLTextureSliceVolumeMapper::SetPreIntegration
  bool linearInterpolation =
    true;         ///< between voxels; else each place has its nearest voxel's value
  int slices = 0; ///< or samples along the longest ray; 0: about three for every eight voxels along
                  ///< the view
  std::size_t textureMemory = VolumeFileRequest::UsualMemory; ///< bytes that voxels may take of it
  std::optional<double> opacityDistance; ///< km of the scene to which opacities belong, above 0;
                                         ///< empty: OpacityDistanceOf the echo
  FrameChoice framing = FrameChoice::Echo;
  double ringSpacing = 0.0; ///< m, between rings about each radar; 0: none
  ThemeChoice theme = ThemeChoice::Light;
  bool heightWalls = true;  ///< lines of equal height on the walls behind the volume
  bool placeNames = false;  ///< names of states and provinces on the map
  bool namesOptions = true; ///< captions name options of the program; else settings
  LightOptions light;
  std::optional<PlanOptions> plan;
  CutOptions cut;

  bool operator==(const SceneOptions& other) const
  {
    const auto all = [](const SceneOptions& of)
    {
      return std::tie(of.preset, of.colours, of.opacities, of.isoValues, of.colourBy,
        of.exaggeration, of.mapper, of.preIntegration, of.linearInterpolation, of.slices,
        of.textureMemory, of.opacityDistance, of.framing, of.ringSpacing, of.theme, of.heightWalls,
        of.placeNames, of.namesOptions, of.light, of.plan, of.cut);
    };
    return all(*this) == all(other);
  }
};

/// Options with the colours and opacities of others.
inline SceneOptions WithColoursOf(SceneOptions options, const SceneOptions& others)
{
  options.preset = others.preset;
  options.colours = others.colours;
  options.opacities = others.opacities;
  options.isoValues = others.isoValues;
  options.colourBy = others.colourBy;
  return options;
}

/// The look of earlier versions: a dark, unlit scene about the whole domain, stretched eight times.
inline void UseClassicLook(SceneOptions& options)
{
  options.theme = ThemeChoice::Dark;
  options.light.shadow = 0.0;
  options.light.occlusion = 0.0;
  options.framing = FrameChoice::Domain;
  options.exaggeration = 8.0;
  options.opacityDistance = OpacityUnitDistance;
  options.slices = 256;
}

} // namespace nexrad::scene
