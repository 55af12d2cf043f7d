// SPDX-License-Identifier: BSD-3-Clause
#include "Viewer/Parts/SettingsScroll.h"

#include <QAbstractSpinBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QEvent>
#include <QScrollBar>

namespace nexrad::viewer
{
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
