// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QWidget>

class QAction;
class QBoxLayout;
class QLabel;
class QSlider;
class QSpinBox;

namespace nexrad::viewer
{

class LoadedSteps;
class Playback;

/// The times of a series as a line, and the buttons that play it.
class TimeLine : public QWidget
{
  Q_OBJECT

public:
  /// `playback` must outlive it.
  explicit TimeLine(Playback& playback, QWidget* parent = nullptr);

private:
  QAction* AddButton(QBoxLayout* row, const QString& name, const QString& tip, const QString& keys);
  void Follow();

  Playback& playback;
  QAction* back = nullptr;
  QAction* play = nullptr;
  QAction* on = nullptr;
  QAction* loop = nullptr;
  QSlider* slider = nullptr;
  LoadedSteps* loaded = nullptr;
  QLabel* first = nullptr;
  QLabel* now = nullptr;
  QLabel* last = nullptr;
  QLabel* rate = nullptr;
  QSpinBox* interval = nullptr;
};

} // namespace nexrad::viewer
