// SPDX-License-Identifier: BSD-3-Clause
#pragma once

class QDockWidget;
class QMainWindow;

namespace nexrad::viewer
{

class BoxMouse;
class Playback;
class SceneView;

/// Adds the box in finer voxels to a window: its mouse, and its panel behind another one. The view
/// owns the mouse.
BoxMouse* MakeBoxDock(
  QMainWindow& window, SceneView& view, Playback& playback, QDockWidget* behind);

} // namespace nexrad::viewer
