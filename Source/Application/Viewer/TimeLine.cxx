// SPDX-License-Identifier: BSD-3-Clause
#include "Viewer/TimeLine.h"

#include "Viewer/Playback.h"

#include <QAction>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QSignalBlocker>
#include <QSlider>
#include <QSpinBox>
#include <QStyle>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <vector>

namespace nexrad::viewer
{

/// A thin bar that is filled where the steps of a series are in memory.
class LoadedSteps : public QWidget
{
public:
  explicit LoadedSteps(QWidget* parent)
    : QWidget(parent)
  {
    this->setFixedHeight(4);
    this->setAccessibleName("Times that are loaded");
  }

  void Set(const std::vector<bool>& steps)
  {
    if (steps != loaded)
    {
      loaded = steps;
      const auto count = std::count(loaded.begin(), loaded.end(), true);
      this->setToolTip(QString("%1 of %2 times are loaded").arg(count).arg(loaded.size()));
      this->update();
    }
  }

  QSize sizeHint() const override { return {100, 4}; }

protected:
  void paintEvent(QPaintEvent*) override
  {
    QPainter painter(this);
    painter.fillRect(this->rect(), this->palette().color(QPalette::Mid));
    const double width =
      static_cast<double>(this->width()) / std::max<std::size_t>(1, loaded.size());
    for (std::size_t i = 0; i < loaded.size(); ++i)
    {
      if (loaded[i])
      {
        painter.fillRect(QRectF(static_cast<double>(i) * width, 0.0, width, this->height()),
          this->palette().color(QPalette::Highlight));
      }
    }
  }

private:
  std::vector<bool> loaded;
};

namespace
{

constexpr int shortestInterval = 16; // ms
constexpr int longestInterval = 8000;

QString TimeOfDay(Time time)
{
  return QString::fromStdString(FormatIso8601(time)).mid(11, 5);
}

} // namespace

TimeLine::TimeLine(Playback& shownPlayback, QWidget* parent)
  : QWidget(parent)
  , playback(shownPlayback)
  , slider(new QSlider(Qt::Horizontal, this))
  , loaded(new LoadedSteps(this))
  , first(new QLabel(this))
  , now(new QLabel(this))
  , last(new QLabel(this))
  , rate(new QLabel(this))
  , interval(new QSpinBox(this))
{
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(6, 2, 6, 2);
  back = this->AddButton(row, "Step back", "The time before", "Left");
  play = this->AddButton(row, "Play", "Play or pause", "Space");
  on = this->AddButton(row, "Step on", "The next time", "Right");
  loop = this->AddButton(row, "Loop", "Begin again after the last time", "L");
  back->setIcon(this->style()->standardIcon(QStyle::SP_MediaSkipBackward));
  on->setIcon(this->style()->standardIcon(QStyle::SP_MediaSkipForward));
  loop->setIcon(this->style()->standardIcon(QStyle::SP_BrowserReload));
  play->setCheckable(true);
  loop->setCheckable(true);
  slider->setAccessibleName("Time");
  slider->setObjectName("time");
  slider->setPageStep(1);
  now->setObjectName("now");
  now->setMinimumWidth(now->fontMetrics().horizontalAdvance("2006-03-12 18:00:00 UTC "));
  interval->setAccessibleName("Time from one step to the next");
  interval->setObjectName("interval");
  interval->setToolTip("Time from one step to the next in playing, in milliseconds");
  interval->setRange(shortestInterval, longestInterval);
  interval->setSingleStep(50);
  interval->setSuffix(" ms");
  interval->setFocusPolicy(Qt::ClickFocus);
  rate->setToolTip("Steps that are shown in a second while the series plays");

  auto* line = new QVBoxLayout;
  line->setSpacing(1);
  line->addWidget(slider);
  line->addWidget(loaded);
  row->addWidget(now);
  row->addWidget(first);
  row->addLayout(line, 1);
  row->addWidget(last);
  row->addWidget(interval);
  row->addWidget(rate);

  connect(back, &QAction::triggered, &playback, [this] { playback.Move(-1); });
  connect(on, &QAction::triggered, &playback, [this] { playback.Move(1); });
  connect(play, &QAction::triggered, &playback, &Playback::Play);
  connect(loop, &QAction::triggered, &playback, &Playback::SetLoops);
  connect(slider, &QSlider::valueChanged, &playback,
    [this](int value) { playback.GoTo(static_cast<std::size_t>(value)); });
  connect(interval, qOverload<int>(&QSpinBox::valueChanged), &playback, &Playback::SetInterval);
  connect(&playback, &Playback::Changed, this, &TimeLine::Follow);
  this->Follow();
}

QAction* TimeLine::AddButton(
  QBoxLayout* row, const QString& name, const QString& tip, const QString& keys)
{
  auto* action = new QAction(name, this);
  action->setToolTip(tip + " (" + keys + ")");
  action->setShortcut(QKeySequence(keys));
  auto* button = new QToolButton(this);
  button->setDefaultAction(action);
  button->setAccessibleName(name);
  button->setObjectName(name);
  button->setAutoRaise(true);
  button->setFocusPolicy(Qt::NoFocus);
  row->addWidget(button);
  return action;
}

void TimeLine::Follow()
{
  const BackgroundSeries::State& state = playback.State();
  const bool any = !state.times.empty();
  this->setEnabled(any);
  for (QAction* action : {back, play, on, loop})
  {
    action->setEnabled(state.times.size() > 1); // one time does not play
  }
  const QSignalBlocker noMove(slider);
  const QSignalBlocker noInterval(interval);
  slider->setRange(0, any ? static_cast<int>(state.times.size()) - 1 : 0);
  slider->setValue(static_cast<int>(playback.Step()));
  loaded->Set(state.loaded);
  first->setText(any ? TimeOfDay(state.times.front()) : QString());
  last->setText(any ? TimeOfDay(state.times.back()) : QString());
  QString shown;
  if (playback.Step() < state.times.size())
  {
    shown = QString::fromStdString(FormatIso8601(state.times[playback.Step()])).left(19);
    shown = shown.replace('T', ' ') + " UTC";
  }
  now->setText(shown);
  slider->setToolTip(shown);
  play->setChecked(playback.IsPlaying());
  play->setIcon(this->style()->standardIcon(
    playback.IsPlaying() ? QStyle::SP_MediaPause : QStyle::SP_MediaPlay));
  loop->setChecked(playback.Loops());
  interval->setValue(playback.Interval());
  const double steps = playback.StepsPerSecond();
  rate->setText(steps > 0.0 ? QString("%1 steps/s").arg(steps, 0, 'f', 1) : QString());
}

} // namespace nexrad::viewer
