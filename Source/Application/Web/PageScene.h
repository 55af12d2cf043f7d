// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Options/DrawingOptions.h"
#include "Scene/Frame/EchoExtent.h"
#include "Scene/Frame/SceneFrame.h"
#include "Scene/SceneOptions.h"
#include "Web/PageCode.h"

#include <vtkSmartPointer.h>

#include <nlohmann/json_fwd.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

class vtkImageData;
class vtkNexradTransferFunction;

namespace nexrad::application
{

/// One of the presets that a page offers.
struct PagePreset
{
  std::string name;
  vtkSmartPointer<vtkNexradTransferFunction> function;
};

/// The presets of a moment ("REF"), and which of them the page shows first.
struct PagePresets
{
  std::vector<PagePreset> all; ///< at least one
  std::size_t first = 0;
};

/// What the captions of a page say of one of its times.
struct PageTime
{
  Time time{};
  std::vector<std::string> sites;     ///< radars that took part
  std::vector<std::string> siteTexts; ///< words of the caption, with the age of the data
};

/// Volume files beside a page.
struct PageFiles
{
  std::string index;     ///< its name; empty: the volumes are in the page
  bool inBricks = false; ///< the page reads parts of them
};

/// What a page shows beside the voxels: domain, map, radars, presets, camera, colours of the theme
/// (Documentation/Formats/web-page.md).
class PageScene
{
public:
  /// `volume`: the first one of the page. `echo`: what the frame holds; that of the volume where
  /// there is none. Throws Error for a preset or a place to look at that it
  /// cannot have, and for a volume without voxels or without a moment.
  PageScene(const scene::DrawingRequest& request, vtkImageData* volume,
    const std::optional<scene::EchoExtent>& echo);

  std::array<int, 3> Size() const { return volume.grid.dimensions; }

  /// The voxels of a volume, whose codes it has. Throws Error for another grid or moment.
  std::vector<std::uint8_t> Encode(vtkImageData* image) const;

  /// The text for the page's script. `times` says when the volumes in the page are.
  std::string MakeText(const std::vector<PageTime>& times, const PageFiles& files) const;

  /// The picture of the ground: bytes of red, green and blue, from its south-western corner on.
  std::vector<std::uint8_t> GroundTexels() const;

  /// Title of the page: what it shows, of which radars, when.
  std::string Title(const std::vector<PageTime>& times) const;

private:
  nlohmann::ordered_json MakeMap() const;
  nlohmann::ordered_json MakeRadars(const std::vector<PageTime>& times) const;
  nlohmann::ordered_json MakeCamera() const;

  const scene::DrawingRequest& request;
  scene::SceneFrame frame;
  vtkSmartPointer<vtkImageData> ground;
  std::array<double, 6> box{};    ///< of the domain; km, with heights as they are
  std::array<double, 6> framed{}; ///< the part that the camera looks at, likewise
  GriddedVolume volume;           ///< the first one, without its voxels
  std::string array;              ///< that the page shows, as "REF"
  PagePresets presets;
  PageCode code;
};

/// What the captions say of a volume.
PageTime CaptionsOf(vtkImageData* volume, Time time, const scene::SceneOptions& options);

} // namespace nexrad::application
