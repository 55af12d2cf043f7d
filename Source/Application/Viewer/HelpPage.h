// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QDialog>
#include <QList>

class QAction;

namespace nexrad::viewer
{

/// The page of the menu Help: how to begin, what the mouse does, and the keys of all actions.
class HelpPage : public QDialog
{
public:
  /// Lists those of the actions that have a shortcut, in their order.
  HelpPage(const QList<QAction*>& actions, QWidget* parent);
};

} // namespace nexrad::viewer
