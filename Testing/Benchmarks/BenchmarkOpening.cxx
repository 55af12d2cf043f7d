// SPDX-License-Identifier: BSD-3-Clause
// How soon the window of `nexrad3d view` shows its inputs, and how long its thread is busy with
// anything but drawing: while the inputs are opened and loaded, and while they are played. Usage:
// BenchmarkOpening INPUT...
#include "Viewer/MainWindow.h"
#include "Viewer/Playback.h"
#include "Viewer/SceneView.h"

#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkRenderWindow.h>

#include <QApplication>
#include <QEventLoop>
#include <QSurfaceFormat>
#include <QTimer>
#include <QVTKOpenGLNativeWidget.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <functional>
#include <string>

namespace
{

using Clock = std::chrono::steady_clock;
using Milliseconds = std::chrono::duration<double, std::milli>;
using namespace nexrad;

// Times each event that the window's thread works on, without the drawing in it.
class TimedApplication : public QApplication
{
public:
  using QApplication::QApplication;

  bool notify(QObject* receiver, QEvent* event) override
  {
    if (depth > 0)
    {
      return QApplication::notify(receiver, event); // a part of the event that is timed
    }
    ++depth;
    drawing = Milliseconds(0);
    // The receiver may be gone afterwards, and the event.
    const QEvent::Type type = event->type();
    const std::string name = std::string(receiver->metaObject()->className()) + ", event " +
                             std::to_string(static_cast<int>(type));
    const Clock::time_point begin = Clock::now();
    const bool handled = QApplication::notify(receiver, event);
    const Milliseconds taken = Milliseconds(Clock::now() - begin) - drawing;
    // In an UpdateRequest, Qt puts the picture into its window and waits for OpenGL.
    if (taken > longest && type != QEvent::UpdateRequest)
    {
      longest = taken;
      longestName = name;
    }
    --depth;
    return handled;
  }

  // Notes when the window draws.
  void Watch(vtkRenderWindow* window)
  {
    vtkNew<vtkCallbackCommand> command;
    command->SetClientData(this);
    command->SetCallback(
      [](vtkObject*, unsigned long event, void* own, void*)
      {
        auto* timed = static_cast<TimedApplication*>(own);
        if (event == vtkCommand::StartEvent)
        {
          timed->drawn = Clock::now();
        }
        else
        {
          timed->drawing += Clock::now() - timed->drawn;
        }
      });
    window->AddObserver(vtkCommand::StartEvent, command);
    window->AddObserver(vtkCommand::EndEvent, command);
  }

  // Works on events until the condition holds; it is asked every 5 ms.
  static void RunUntil(const std::function<bool()>& condition)
  {
    QEventLoop loop;
    QTimer clock;
    QObject::connect(&clock, &QTimer::timeout, &loop,
      [&]
      {
        if (condition())
        {
          loop.quit();
        }
      });
    clock.start(5);
    loop.exec();
  }

  // Since it was asked for last, with the type of the event (QEvent::Type) and of its receiver.
  std::string TakeLongest()
  {
    char text[200];
    std::snprintf(text, sizeof(text), "%.1f ms (%s)", longest.count(), longestName.c_str());
    longest = Milliseconds(0);
    return text;
  }

private:
  int depth = 0;
  Clock::time_point drawn;
  Milliseconds drawing{0};
  Milliseconds longest{0};
  std::string longestName;
};

bool IsFailed(const viewer::Playback& playback)
{
  return playback.State().phase == BackgroundSeries::Phase::Failed;
}

// Until the first volume is on the screen. False when the inputs cannot be opened.
bool MeasureOpening(
  TimedApplication& application, viewer::MainWindow& window, Clock::time_point begin)
{
  const viewer::SceneView& view = *window.View();
  const viewer::Playback& playback = *window.Player();
  int drawnBefore = -1; // the volume came
  QObject::connect(&playback, &viewer::Playback::Loaded, &playback,
    [&] { drawnBefore = drawnBefore < 0 ? view.Drawn() : drawnBefore; });
  window.show();
  application.RunUntil([&] { return view.Drawn() > 0; });
  const Milliseconds shown = Clock::now() - begin;
  application.TakeLongest(); // so long as it took until the window was on the screen
  application.RunUntil(
    [&] { return IsFailed(playback) || (drawnBefore >= 0 && view.Drawn() > drawnBefore); });
  const Milliseconds first = Clock::now() - begin;
  std::printf("the window is on the screen after %.0f ms, with the first volume after %.2f s\n",
    shown.count(), first.count() / 1000.0);
  return !IsFailed(playback);
}

// Until as many times are loaded as the memory holds.
void MeasureLoading(
  TimedApplication& application, const viewer::Playback& playback, Clock::time_point begin)
{
  constexpr Milliseconds quiet(1000); // without loading: between two times there are short pauses
  Clock::time_point last = Clock::now();
  application.RunUntil(
    [&]
    {
      const Clock::time_point now = Clock::now();
      last = playback.State().loads ? now : last;
      return now - last > quiet;
    });
  const auto& loaded = playback.State().loaded;
  const Milliseconds all = last - begin;
  std::printf("%d of %d times are loaded after %.2f s; longest event besides drawing: %s\n",
    static_cast<int>(std::count(loaded.begin(), loaded.end(), true)),
    static_cast<int>(loaded.size()), all.count() / 1000.0, application.TakeLongest().c_str());
}

void MeasurePlaying(TimedApplication& application, viewer::Playback& playback)
{
  constexpr Milliseconds played(3000);
  playback.SetInterval(1);
  playback.Play(true);
  const Clock::time_point begin = Clock::now();
  application.RunUntil([&] { return Clock::now() - begin > played; });
  std::printf("%.1f times a second are played; longest event besides drawing: %s\n",
    playback.StepsPerSecond(), application.TakeLongest().c_str());
}

} // namespace

int main(int count, char* arguments[])
{
  if (count < 2)
  {
    std::fprintf(stderr, "usage: BenchmarkOpening INPUT...\n");
    return 2;
  }
  viewer::ViewRequest request;
  request.input.inputs.assign(arguments + 1, arguments + count);
  QSurfaceFormat::setDefaultFormat(QVTKOpenGLNativeWidget::defaultFormat());
  TimedApplication application(count, arguments);
  QCoreApplication::setOrganizationName("nexrad3d-benchmark"); // settings of its own

  const Clock::time_point begin = Clock::now();
  viewer::MainWindow window(request);
  application.Watch(window.View()->renderWindow());
  if (!MeasureOpening(application, window, begin))
  {
    std::fprintf(stderr, "%s\n", window.Player()->State().failure.c_str());
    return 1;
  }
  MeasureLoading(application, *window.Player(), begin);
  MeasurePlaying(application, *window.Player());
  return 0;
}
