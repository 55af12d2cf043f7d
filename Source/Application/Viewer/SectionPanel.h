// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkNew.h>

#include <QWidget>

#include <array>
#include <memory>

class QBoxLayout;
class QDoubleSpinBox;
class QLabel;
class QToolButton;
class vtkNexradVerticalSection;

namespace nexrad::viewer
{

class SceneView;
class SectionChart;
class SectionTool;
class Soon;

/// The vertical section along a line on the ground: the line is drawn with the mouse, or given in
/// numbers, and stays where it is when another time is shown.
class SectionPanel : public QWidget
{
  Q_OBJECT

public:
  /// `view` must outlive it.
  explicit SectionPanel(SceneView& view, QWidget* parent = nullptr);
  ~SectionPanel() override;

  SectionChart* Chart() const { return chart; }
  vtkNexradVerticalSection* Filter() const { return filter; }

public slots:
  /// Makes the section anew once the events that wait are done with: another volume is shown, or
  /// the scene has other colours.
  void FollowSoon();
  /// Lets the next drag on the ground draw the line.
  void DrawLine(bool on);
  /// Takes the line away.
  void Remove();

signals:
  /// The next drag on the ground draws the line.
  void Draws();

protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

private:
  QWidget* MakeRow();
  QDoubleSpinBox* AddNumber(QBoxLayout* row, const QString& name, const QString& tip);
  void TakeNumbers();
  void Follow();
  void FollowNumbers();
  void Cut();
  void Tell(const QPoint& pixel);

  SceneView& view;
  std::unique_ptr<SectionTool> tool;
  SectionChart* chart;
  Soon* follow;
  QToolButton* draw = nullptr;
  QToolButton* remove = nullptr;
  std::array<QDoubleSpinBox*, 4> ends{}; ///< A east, A north, B east, B north
  QLabel* reading = nullptr;
  vtkNew<vtkNexradVerticalSection> filter;
};

} // namespace nexrad::viewer
