// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QFormLayout>
#include <QGroupBox>
#include <QObject>
#include <QScrollArea>
#include <QString>
#include <QStringList>
#include <QVBoxLayout>

#include <functional>

class QComboBox;
class QDoubleSpinBox;
class vtkImageData;

namespace nexrad::viewer
{

/// Adds a group of settings with a title to a panel's column; its rows are name and widget.
inline QFormLayout* AddGroup(QVBoxLayout* column, const QString& title)
{
  auto* box = new QGroupBox(title);
  auto* form = new QFormLayout(box);
  column->addWidget(box); // whose panel then owns it
  return form;
}

/// Gives a widget a name, for screen readers and tests, and a tool tip.
template <typename Widget>
Widget* Named(Widget* widget, const QString& name, const QString& tip)
{
  widget->setObjectName(name);
  widget->setAccessibleName(name);
  widget->setToolTip(tip);
  return widget;
}

/// Work that is done once the events that wait are done with, however often it is asked for until
/// then.
class Soon : public QObject
{
public:
  /// It goes with the owner.
  Soon(QObject* owner, std::function<void()> toDo);

  void Ask();

private:
  std::function<void()> work;
  bool asked = false;
};

constexpr double kilometre = 1000.0; ///< m

/// In what numbers of the window give places of a volume: km, or degrees on geographic axes.
struct HorizontalUnit
{
  double size = 1000.0; ///< in x and y of the volume
  double metres = 1.0;  ///< of one unit of x and y of the volume; of degrees, along a meridian
  QString suffix = " km";
  int decimals = 1; ///< of the numbers
};

/// `volume` may be nullptr.
HorizontalUnit HorizontalUnitOf(vtkImageData* volume);

/// A number for a coordinate, whose name is its tool tip. It tells of a change once it is typed.
QDoubleSpinBox* MakeCoordinate(const QString& tip, QWidget* parent);

/// Sets the entries of a box. A list that a user has open, to choose from, stays where its entries
/// are the same.
void SetEntries(QComboBox* box, const QStringList& entries);

/// Scrolls a panel of settings that is higher than the window. The wheel scrolls it, also over a
/// setting; it changes a setting only while that setting has the focus, so that nobody changes one
/// by scrolling past it.
class SettingsScroll : public QScrollArea
{
  Q_OBJECT

public:
  /// Takes over a panel that has all its settings already.
  explicit SettingsScroll(QWidget* panel, QWidget* parent = nullptr);

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
};

} // namespace nexrad::viewer
