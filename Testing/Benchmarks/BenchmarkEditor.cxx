// SPDX-License-Identifier: BSD-3-Clause
// How fast the picture follows a point of the transfer function: the window opens a volume, the
// mouse drags a point of opacity, then one of red, and each event is timed up to the end of the
// picture that shows it. Beside it: the times of a picture in which nothing changed, of one whose
// camera turned, and of the volume's histogram. Usage: BenchmarkEditor INPUT, a volume as `nexrad3d
// grid` writes it, for example with `--dims 256x256x128`. Needs an X server.
#include "Viewer/MainWindow.h"
#include "Viewer/SceneView.h"
#include "Viewer/TransferFunctionChart.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkNexradHistogram.h>
#include <vtkNexradTransferFunction.h>
#include <vtkNexradVolumeScene.h>
#include <vtkRenderWindow.h>

#include <QApplication>
#include <QDockWidget>
#include <QMouseEvent>
#include <QSurfaceFormat>
#include <QToolButton>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <functional>
#include <vector>

namespace
{

using namespace nexrad::viewer;
using Clock = std::chrono::steady_clock;

constexpr int pictures = 40;
constexpr int warmUp = 5;

double Milliseconds(Clock::time_point begin)
{
  return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
}

/// Handles events until a condition holds.
bool Wait(const std::function<bool()>& condition, double seconds)
{
  const auto begin = Clock::now();
  while (!condition() && Milliseconds(begin) < 1000.0 * seconds)
  {
    QCoreApplication::processEvents(QEventLoop::AllEvents, 20);
  }
  return condition();
}

void Settle()
{
  const auto begin = Clock::now();
  Wait([&] { return Milliseconds(begin) > 300.0; }, 1.0);
}

/// Median of the times of an action that makes pictures; what is left over is done in between.
double MedianOf(const std::function<void(int)>& action)
{
  std::vector<double> times;
  for (int i = 0; i < warmUp + pictures; ++i)
  {
    Settle();
    const auto begin = Clock::now();
    action(i);
    times.push_back(Milliseconds(begin));
  }
  times.erase(times.begin(), times.begin() + warmUp);
  std::nth_element(times.begin(), times.begin() + pictures / 2, times.end());
  return times[pictures / 2];
}

class Measurement
{
public:
  explicit Measurement(MainWindow& measured)
    : window(measured)
    , chart(window.findChild<TransferFunctionChart*>())
  {
  }

  double Unchanged()
  {
    return MedianOf([this](int) { this->Draw(); });
  }

  double Turned()
  {
    vtkNexradVolumeScene* scene = window.View()->Scene();
    const double first = scene->GetAzimuth();
    const double time = MedianOf(
      [&](int i)
      {
        scene->SetAzimuth(first + i % 2);
        this->Draw();
      });
    scene->SetAzimuth(first);
    return time;
  }

  /// From the event to the end of the picture, the last node of a channel moving up and down.
  double Dragged(int channel)
  {
    auto* function = window.View()->Scene()->GetTransferFunction();
    double node[2];
    function->GetNode(channel, function->GetNumberOfNodes(channel) - 2, node);
    this->Send(QEvent::MouseButtonPress, node[0], node[1]);
    const double time = MedianOf(
      [&](int i)
      {
        const int drawn = window.View()->Drawn();
        this->Send(QEvent::MouseMove, node[0], i % 2 == 0 ? 0.5 : 0.9);
        Wait([&] { return window.View()->Drawn() > drawn; }, 10.0);
        window.View()->renderWindow()->WaitForCompletion();
      });
    this->Send(QEvent::MouseButtonRelease, node[0], node[1]);
    return time;
  }

  /// Of the volume as the window has it.
  double Histogram()
  {
    vtkNew<vtkNexradHistogram> histogram;
    histogram->SetInputData(window.View()->Scene()->GetVolume());
    return MedianOf(
      [&](int)
      {
        histogram->Modified();
        histogram->Update();
      });
  }

private:
  void Draw()
  {
    window.View()->renderWindow()->Render();
    window.View()->renderWindow()->WaitForCompletion();
  }

  void Send(QEvent::Type type, double value, double level)
  {
    const bool move = type == QEvent::MouseMove;
    QMouseEvent event(type, chart->PlaceOf(value, level), move ? Qt::NoButton : Qt::LeftButton,
      type == QEvent::MouseButtonRelease ? Qt::NoButton : Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(chart, &event);
  }

  MainWindow& window;
  TransferFunctionChart* chart;
};

} // namespace

int main(int argc, char* argv[])
{
  if (argc != 2)
  {
    std::fprintf(stderr, "usage: BenchmarkEditor INPUT\n");
    return 2;
  }
  QSurfaceFormat::setDefaultFormat(QVTKOpenGLNativeWidget::defaultFormat());
  QApplication application(argc, argv);
  QCoreApplication::setOrganizationName("nexrad3d-benchmark");
  nexrad::scene::ViewRequest request;
  request.input.inputs = {argv[1]};
  request.size = {1180, 640};
  MainWindow window(request);
  window.show();
  window.findChild<QDockWidget*>("transfer function")->show();
  window.findChild<QDockWidget*>("transfer function")->raise();
  const auto shown = [&] { return window.View()->Scene()->GetTransferFunction() != nullptr; };
  if (!Wait(shown, 120.0))
  {
    std::fprintf(stderr, "BenchmarkEditor: %s is not shown\n", argv[1]);
    return 1;
  }
  Settle();
  Measurement measurement(window);
  const int* size = window.View()->Scene()->GetVolume()->GetDimensions();
  const double unchanged = measurement.Unchanged();
  const double turned = measurement.Turned();
  const double opacity = measurement.Dragged(vtkNexradTransferFunction::OPACITY);
  window.findChild<QToolButton*>("Red channel")->click();
  const double red = measurement.Dragged(vtkNexradTransferFunction::RED);
  const double histogram = measurement.Histogram();
  std::printf("%d x %d pixels, median of %d pictures, milliseconds\n\n"
              "| volume | nothing changed | camera turned | opacity dragged | red dragged | "
              "opacity dragged / nothing changed | histogram |\n|---|---|---|---|---|---|---|\n"
              "| %dx%dx%d | %.1f | %.1f | %.1f | %.1f | %.2f | %.1f |\n",
    window.View()->width(), window.View()->height(), pictures, size[0], size[1], size[2], unchanged,
    turned, opacity, red, opacity / unchanged, histogram);
  return 0;
}
