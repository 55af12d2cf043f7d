// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QString>

namespace nexrad::viewer
{

/// Gives a widget a name, for screen readers and tests, and a tool tip.
template <typename Widget>
Widget* Named(Widget* widget, const QString& name, const QString& tip)
{
  widget->setObjectName(name);
  widget->setAccessibleName(name);
  widget->setToolTip(tip);
  return widget;
}

} // namespace nexrad::viewer
