// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Scene/RadarScene.h"
#include "Scene/SceneOptions.h"
#include "Scene/Series/VolumeSeries.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

namespace nexrad::scene
{

/// What is looked at: a series of merged volumes, the time that is shown, its colours and
/// opacities, and the scene that shows it. Pictures, movies and the viewer all work on one; it
/// knows no window.
class RadarSession
{
public:
  /// `chosen`: indices of the volumes that take part, in the order in which they are shown; not
  /// empty. `box`: is merged again in finer voxels for each step, of radar files; then nothing is
  /// loaded ahead.
  RadarSession(std::unique_ptr<VolumeSeries> series, std::vector<std::size_t> chosen,
    const SceneOptions& options, const std::optional<BoxRequest>& box = std::nullopt);

  RadarScene& Scene() { return scene; }
  std::vector<std::string> Problems() const { return series->Problems(); }

  /// Number of times, at least 1.
  std::size_t Count() const { return chosen.size(); }
  Time TimeAt(std::size_t step) const { return series->Times()[chosen[step]]; }

  /// The step that is shown; nothing before the first.
  std::optional<std::size_t> Shown() const { return shown; }

  /// Loads and shows a step, unless it is shown already. False when `progress` asked to stop; then
  /// the scene stays as it is. Throws Error when the volume cannot be loaded.
  bool Show(std::size_t step, const Progress& progress = {});

  /// The first half of Show: loads the step, which Show then finds loaded.
  bool Load(std::size_t step, const Progress& progress = {});

private:
  /// A step until it is shown, and the box of it.
  struct Loaded
  {
    std::size_t step = 0;
    vtkSmartPointer<vtkImageData> volume;
    vtkSmartPointer<vtkImageData> box;
  };

  std::optional<EchoExtent> echo; ///< of all that is shown, where that is more than one time
  std::unique_ptr<VolumeSeries> series;
  std::vector<std::size_t> chosen;
  std::optional<std::size_t> shown;
  const std::optional<BoxRequest> box;
  Loaded loaded;
  RadarScene scene;
};

} // namespace nexrad::scene
