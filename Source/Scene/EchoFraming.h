// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Scene/Frame/EchoExtent.h"
#include "Scene/Frame/SceneFrame.h"
#include "Scene/SceneOptions.h"

#include <cstddef>
#include <optional>
#include <vector>

class vtkImageData;

namespace nexrad
{
class VolumeSeries;
} // namespace nexrad

namespace nexrad::scene
{

/// The echo of a volume, as the preset of the options shows it (that of its moment where it has
/// none, or draws surfaces alone). Colours and opacities from files do not count: an edited look
/// has the same frame. Nothing where a scene with these options needs none, or no echo is seen.
std::optional<EchoExtent> MeasureEcho(vtkImageData* volume, const SceneOptions& options);

/// The echo of several volumes of a series together, coarse where it merges, of many that of eight
/// which are spread evenly. Those that cannot be read are passed over: they say so when they are
/// shown. Nothing where there is one volume.
std::optional<EchoExtent> MeasureSeries(
  VolumeSeries& series, const std::vector<std::size_t>& steps, const SceneOptions& options);

/// The frame of a volume: about the echo and the radars near it, or about the domain, with the
/// stretch of heights and the distance of opacities that the options have, or that suit it.
SceneFrame FrameVolume(vtkImageData* volume, const VolumeInformation& information,
  const std::optional<EchoExtent>& echo, const SceneOptions& options);

} // namespace nexrad::scene
