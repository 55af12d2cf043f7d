// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Scene/Shapes/Theme.h"

#include <QVTKOpenGLNativeWidget.h>

#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <array>

class vtkChartXY;
class vtkContextActor;
class vtkGenericOpenGLRenderWindow;
class vtkLookupTable;
class vtkNexradTransferFunction;
class vtkPlot;
class vtkPlotBar;
class vtkRenderer;
class vtkTable;

namespace nexrad::viewer
{

/// The curves of a colour map, in the order of vtkNexradTransferFunction's channels.
constexpr std::array<const char*, 4> ChannelNames = {"Red", "Green", "Blue", "Opacity"};

class SplinePointsItem;

/// The four splines of a transfer function over the values of a moment, with a histogram behind
/// them. The mouse edits the nodes of one of them, the edited channel.
class TransferFunctionChart : public QVTKOpenGLNativeWidget
{
  Q_OBJECT

public:
  explicit TransferFunctionChart(QWidget* parent = nullptr);
  ~TransferFunctionChart() override;

  /// The function that is shown and edited; nullptr: none.
  void SetFunction(vtkNexradTransferFunction* shown);
  /// Draws the function again after a change.
  void FollowFunction();

  /// The channel that the mouse edits, vtkNexradTransferFunction::RED to OPACITY (the default).
  void SetChannel(int edited);
  int Channel() const { return channel; }

  /// Index of the selected node of that channel; -1: none.
  int SelectedPoint() const;
  void SelectPoint(int index);

  /// A table of vtkNexradHistogram; bars are as high as the logarithms of its counts.
  void SetHistogram(vtkTable* histogram);

  /// Below the axis of the values: name and unit of the moment.
  void SetTitle(const QString& title);
  void SetTheme(scene::ThemeChoice theme);

  /// Whether a button of the mouse holds a node.
  bool IsHeld() const;

  /// Where a value and a level from 0 to 1 are in the widget, in its pixels, as last drawn.
  QPointF PlaceOf(double value, double level) const;

signals:
  /// The mouse changed the function, or selected another node.
  void Edited();
  /// The mouse released the node.
  void EditFinished();

protected:
  bool event(QEvent* event) override;
  void showEvent(QShowEvent* event) override;

private:
  void MakePlots();
  void FollowRange();
  void FollowLabels();
  void FollowCurves();
  void FollowColours();
  void StylePlots();
  void StyleAxes(const scene::Theme& theme);
  void DrawSoon();

  vtkNew<vtkGenericOpenGLRenderWindow> window;
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkContextActor> actor;
  vtkNew<vtkChartXY> chart;
  vtkNew<SplinePointsItem> points;
  vtkSmartPointer<vtkPlotBar> bars;
  vtkNew<vtkTable> barTable;
  vtkNew<vtkLookupTable> barColours;
  vtkNew<vtkTable> curveTable;
  std::array<vtkSmartPointer<vtkPlot>, 4> curves;
  vtkSmartPointer<vtkNexradTransferFunction> function;
  std::array<double, 2> histogramRange = {0.0, 0.0};
  std::array<double, 2> range = {0.0, 1.0}; ///< of the axis of values
  int channel = 3;
  scene::ThemeChoice theme = scene::ThemeChoice::Dark;
};

} // namespace nexrad::viewer
