// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QFormLayout>
#include <QGroupBox>
#include <QString>
#include <QVBoxLayout>

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

} // namespace nexrad::viewer
