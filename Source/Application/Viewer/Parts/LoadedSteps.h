// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QWidget>

#include <vector>

namespace nexrad::viewer
{

/// A thin bar that is filled where the steps of a series are in memory.
class LoadedSteps : public QWidget
{
public:
  explicit LoadedSteps(QWidget* parent = nullptr);

  void Set(const std::vector<bool>& steps);
  QSize sizeHint() const override { return {100, 4}; }

protected:
  void paintEvent(QPaintEvent* event) override;

private:
  std::vector<bool> loaded;
};

} // namespace nexrad::viewer
