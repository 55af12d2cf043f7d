// SPDX-License-Identifier: BSD-3-Clause
#pragma once

class QDockWidget;
class QMainWindow;

namespace nexrad::viewer
{

class LookPanel;
class SceneView;
class TransferFunctionEditor;

/// Puts the editor of colours and opacities into a dock behind that of the settings, hidden at
/// first, with T to show and hide it.
TransferFunctionEditor* MakeTransferFunctionDock(
  QMainWindow& window, SceneView& view, LookPanel& look, QDockWidget* lookDock);

} // namespace nexrad::viewer
