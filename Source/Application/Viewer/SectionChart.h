// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QVTKOpenGLNativeWidget.h>

#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <array>
#include <memory>
#include <optional>
#include <vector>

class vtkChartXY;
class vtkContextActor;
class vtkGenericOpenGLRenderWindow;
class vtkImageData;
class vtkPlotHistogram2D;
class vtkProp;
class vtkRenderer;

namespace nexrad::scene
{
struct ColourScale;
class TextPictures;
struct Theme;
} // namespace nexrad::scene

namespace nexrad::viewer
{

/// A vertical section in the colours of a scale, over axes of distance and height in km, with the
/// colour bar at its right.
class SectionChart : public QVTKOpenGLNativeWidget
{
  Q_OBJECT

public:
  explicit SectionChart(QWidget* parent = nullptr);
  ~SectionChart() override;

  /// Shows a section as vtkNexradVerticalSection makes it; nullptr: an empty chart.
  void Show(vtkImageData* section, const scene::ColourScale& colours, const scene::Theme& theme);

  /// Distance from A and height in m that a pixel of the widget shows; nothing outside of the
  /// section.
  std::optional<std::array<double, 2>> PlaceAt(const QPoint& pixel) const;

  QSize sizeHint() const override { return {600, 230}; }

signals:
  /// The mouse points at a pixel of the chart.
  void Pointed(const QPoint& pixel);

protected:
  void mouseMoveEvent(QMouseEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

private:
  struct Shown;

  void Draw();
  void DrawColourBar();
  void DrawAxes();

  vtkNew<vtkGenericOpenGLRenderWindow> window;
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkContextActor> actor;
  vtkNew<vtkChartXY> chart;
  vtkNew<vtkPlotHistogram2D> plot;
  std::unique_ptr<Shown> shown;
  std::unique_ptr<scene::TextPictures> pictures;
  std::vector<vtkSmartPointer<vtkProp>> colourBar;
};

} // namespace nexrad::viewer
