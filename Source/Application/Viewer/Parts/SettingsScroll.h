// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QScrollArea>

namespace nexrad::viewer
{

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
