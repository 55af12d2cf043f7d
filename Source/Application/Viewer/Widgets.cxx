// SPDX-License-Identifier: BSD-3-Clause
#include "Viewer/Widgets.h"

#include "Scene/Frame/VolumeInformation.h"
#include "nexrad/Geometry/Angles.h"

#include <QAbstractSpinBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QDoubleSpinBox>
#include <QEvent>
#include <QScrollBar>
#include <QTimer>

#include <utility>

namespace nexrad::viewer
{

Soon::Soon(QObject* owner, std::function<void()> toDo)
  : QObject(owner)
  , work(std::move(toDo))
{
}

void Soon::Ask()
{
  if (asked)
  {
    return;
  }
  asked = true;
  QTimer::singleShot(0, this,
    [this]
    {
      asked = false;
      work();
    });
}

HorizontalUnit HorizontalUnitOf(vtkImageData* volume)
{
  const bool geographic = volume != nullptr && scene::PlaceUnitOf(volume) == PlaceUnit::Degrees;
  return geographic ? HorizontalUnit{1.0, MetresPerDegree, "°", 3} : HorizontalUnit{};
}

QDoubleSpinBox* MakeCoordinate(const QString& tip, QWidget* parent)
{
  auto* box = Named(new QDoubleSpinBox(parent), tip, tip);
  box->setRange(-2000.0, 2000.0);
  box->setDecimals(1);
  box->setKeyboardTracking(false);
  return box;
}

void SetEntries(QComboBox* box, const QStringList& entries)
{
  QStringList before;
  for (int i = 0; i < box->count(); ++i)
  {
    before << box->itemText(i);
  }
  if (entries != before)
  {
    box->clear();
    box->addItems(entries);
  }
}

namespace
{

bool IsSetting(const QWidget* widget)
{
  return qobject_cast<const QComboBox*>(widget) != nullptr ||
         qobject_cast<const QAbstractSpinBox*>(widget) != nullptr;
}

} // namespace

SettingsScroll::SettingsScroll(QWidget* panel, QWidget* parent)
  : QScrollArea(parent)
{
  this->setWidget(panel);
  this->setWidgetResizable(true);
  for (QWidget* setting : panel->findChildren<QWidget*>())
  {
    if (IsSetting(setting))
    {
      setting->setFocusPolicy(Qt::StrongFocus); // the wheel does not give it the focus
      setting->installEventFilter(this);
    }
  }
}

bool SettingsScroll::eventFilter(QObject* watched, QEvent* event)
{
  const auto* setting = qobject_cast<QWidget*>(watched);
  if (event->type() == QEvent::Wheel && IsSetting(setting) && !setting->hasFocus())
  {
    return QCoreApplication::sendEvent(this->verticalScrollBar(), event);
  }
  return QScrollArea::eventFilter(watched, event);
}

} // namespace nexrad::viewer
