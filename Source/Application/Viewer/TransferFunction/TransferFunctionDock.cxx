// SPDX-License-Identifier: BSD-3-Clause
#include "Viewer/TransferFunction/TransferFunctionDock.h"

#include "Viewer/Parts/LookPanel.h"
#include "Viewer/Parts/SceneView.h"
#include "Viewer/TransferFunction/TransferFunctionChart.h"
#include "Viewer/TransferFunction/TransferFunctionEditor.h"

#include <vtkRenderWindow.h>

#include <QAction>
#include <QDockWidget>
#include <QMainWindow>
#include <QShortcut>

namespace nexrad::viewer
{
namespace
{

// Pictures a second that are asked for. While a point is dragged, light comes in larger cells, and
// pixels become larger only where a picture takes half a second.
constexpr double rateOfDrag = 2.0;
constexpr double rateOfRest = 0.0001; // that of a window in which nothing moves

// A dock behind another one is not hidden for Qt, but is for the user.
void ShowOrHide(QDockWidget* dock)
{
  const bool seen = dock->isVisible() && !dock->visibleRegion().isEmpty();
  dock->setVisible(!seen);
  if (!seen)
  {
    dock->raise();
  }
}

} // namespace

TransferFunctionEditor* MakeTransferFunctionDock(
  QMainWindow& window, SceneView& view, LookPanel& look, QDockWidget* lookDock)
{
  auto* editor = new TransferFunctionEditor(view.Scene(), &window);
  auto* dock = new QDockWidget("Transfer function", &window);
  dock->setObjectName("transfer function");
  dock->setWidget(editor);
  window.addDockWidget(Qt::RightDockWidgetArea, dock);
  window.tabifyDockWidget(lookDock, dock);
  dock->hide();
  // The menu names the key, which is not the action's: the action hides a dock that is behind.
  dock->toggleViewAction()->setText("Transfer function\tT");
  QObject::connect(dock->toggleViewAction(), &QAction::triggered, dock,
    [dock](bool on)
    {
      if (on)
      {
        dock->raise();
      }
    });
  auto* shortcut = new QShortcut(QKeySequence("T"), &window);
  QObject::connect(shortcut, &QShortcut::activated, dock, [dock] { ShowOrHide(dock); });
  QObject::connect(editor, &TransferFunctionEditor::Changed, &view,
    [editor, &view]
    {
      const bool held = editor->Chart()->IsHeld();
      view.renderWindow()->SetDesiredUpdateRate(held ? rateOfDrag : rateOfRest);
      view.DrawSoon();
    });
  QObject::connect(editor, &TransferFunctionEditor::PresetChanged, &look, &LookPanel::Follow);
  return editor;
}

} // namespace nexrad::viewer
