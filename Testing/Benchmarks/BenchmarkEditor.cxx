// SPDX-License-Identifier: BSD-3-Clause
// How fast the picture follows a point of the transfer function: the window opens a volume, the
// mouse drags a point of opacity, then one of red, and each event is timed up to the end of the
// picture that shows it. In turn with it: a picture in which nothing changed, one whose camera
// turned, and one of a function that was changed by a call. Then how long the volume's histogram
// takes, a vertical section through the whole volume, and the readout for a move of the pointer.
// Usage: BenchmarkEditor INPUT, a volume as `nexrad3d grid` writes it, for example with
// `--dims 256x256x128`. Needs an X server.
#include "Viewer/MainWindow.h"
#include "Viewer/SceneView.h"
#include "Viewer/TransferFunctionChart.h"

#include <vtkAlgorithm.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkNexradHistogram.h>
#include <vtkNexradTransferFunction.h>
#include <vtkNexradVerticalSection.h>
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

constexpr int rounds = 11;
constexpr int warmUp = 1;
constexpr double settled = 150.0; // ms, after which nothing is left to draw

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
  Wait([&] { return Milliseconds(begin) > settled; }, 1.0);
}

double Median(std::vector<double> values)
{
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Something that makes a picture, and the times that it took.
struct Action
{
  std::function<void(int)> act;
  std::vector<double> times;

  double Time() const { return Median(times); }
};

/// Each action in each round, so that what else the machine does falls on all alike.
void Run(const std::vector<Action*>& actions)
{
  for (int round = -warmUp; round < rounds; ++round)
  {
    for (Action* action : actions)
    {
      Settle();
      const auto begin = Clock::now();
      action->act(round);
      if (round >= 0)
      {
        action->times.push_back(Milliseconds(begin));
      }
    }
  }
}

class Measurement
{
public:
  explicit Measurement(MainWindow& measured)
    : window(measured)
    , scene(measured.View()->Scene())
    , chart(measured.findChild<TransferFunctionChart*>())
  {
  }

  /// The last but one node of a channel moves up and down.
  void RunWith(int channel)
  {
    auto* function = scene->GetTransferFunction();
    const int index = function->GetNumberOfNodes(channel) - 2;
    double node[2];
    function->GetNode(channel, index, node);
    const double azimuth = scene->GetAzimuth();
    Action unchanged{[&](int) { this->Draw(); }, {}};
    Action turned{[&](int round)
      {
        scene->SetAzimuth(azimuth + round % 2);
        this->Draw();
      },
      {}};
    Action called{[&](int round)
      {
        function->MoveNode(channel, index, node[0], round % 2 == 0 ? 0.55 : 0.85);
        this->Draw();
      },
      {}};
    Action dragged{[&](int round) { this->Drag(node[0], round % 2 == 0 ? 0.5 : 0.9); }, {}};
    this->Send(QEvent::MouseButtonPress, node[0], node[1]);
    Run({&unchanged, &turned, &called, &dragged});
    this->Send(QEvent::MouseButtonRelease, node[0], node[1]);
    std::vector<double> ratios;
    for (std::size_t i = 0; i < dragged.times.size(); ++i)
    {
      ratios.push_back(dragged.times[i] / unchanged.times[i]);
    }
    std::printf("| %s | %.1f | %.1f | %.1f | %.1f | %.2f | %.2f |\n",
      channel == vtkNexradTransferFunction::RED ? "red" : "opacity", unchanged.Time(),
      turned.Time(), called.Time(), dragged.Time(), dragged.Time() / unchanged.Time(),
      Median(ratios));
  }

  /// Of the volume as the window has it.
  double Histogram()
  {
    vtkNew<vtkNexradHistogram> histogram;
    histogram->SetInputData(scene->GetVolume());
    return TimeOf(*histogram);
  }

  /// From the west end of the volume to the east end, through its middle.
  double Section()
  {
    double bounds[6];
    scene->GetVolume()->GetBounds(bounds);
    const double middle = 0.5 * (bounds[2] + bounds[3]);
    vtkNew<vtkNexradVerticalSection> section;
    section->SetInputData(scene->GetVolume());
    section->SetA(bounds[0], middle);
    section->SetB(bounds[1], middle);
    return TimeOf(*section);
  }

  /// For one move of the pointer over the middle of the picture; many moves a time.
  double Readout()
  {
    constexpr int moves = 100;
    const QPoint middle = window.View()->rect().center();
    Action moved{[&](int)
      {
        for (int i = 0; i < moves; ++i)
        {
          QMouseEvent event(QEvent::MouseMove, middle + QPoint(i, i / 2), Qt::NoButton,
            Qt::NoButton, Qt::NoModifier);
          QCoreApplication::sendEvent(window.View(), &event);
        }
      },
      {}};
    Run({&moved});
    return moved.Time() / moves;
  }

private:
  static double TimeOf(vtkAlgorithm& filter)
  {
    Action made{[&](int)
      {
        filter.Modified();
        filter.Update();
      },
      {}};
    Run({&made});
    return made.Time();
  }

  void Draw()
  {
    window.View()->renderWindow()->Render();
    window.View()->renderWindow()->WaitForCompletion();
  }

  /// From the event to the end of the picture.
  void Drag(double value, double level)
  {
    const int drawn = window.View()->Drawn();
    this->Send(QEvent::MouseMove, value, level);
    Wait([&] { return window.View()->Drawn() > drawn; }, 10.0);
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
  vtkNexradVolumeScene* scene;
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
  nexrad::viewer::ViewRequest request;
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
  std::printf(
    "%dx%dx%d voxels, %d x %d pixels, median of %d pictures, milliseconds\n\n"
    "| dragged | nothing changed | camera turned | changed by a call | dragged | dragged / "
    "nothing changed | median of this ratio |\n|---|---|---|---|---|---|---|\n",
    size[0], size[1], size[2], window.View()->width(), window.View()->height(), rounds);
  measurement.RunWith(vtkNexradTransferFunction::OPACITY);
  window.findChild<QToolButton*>("Red channel")->click();
  measurement.RunWith(vtkNexradTransferFunction::RED);
  std::printf("\nHistogram: %.1f ms\nVertical section: %.2f ms\nReadout: %.3f ms\n",
    measurement.Histogram(), measurement.Section(), measurement.Readout());
  return 0;
}
