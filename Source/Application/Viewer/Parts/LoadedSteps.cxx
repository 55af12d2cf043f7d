// SPDX-License-Identifier: BSD-3-Clause
#include "Viewer/Parts/LoadedSteps.h"

#include <QPainter>

#include <algorithm>

namespace nexrad::viewer
{

LoadedSteps::LoadedSteps(QWidget* parent)
  : QWidget(parent)
{
  this->setFixedHeight(4);
  this->setAccessibleName("Times that are loaded");
}

void LoadedSteps::Set(const std::vector<bool>& steps)
{
  if (steps != loaded)
  {
    loaded = steps;
    const auto count = std::count(loaded.begin(), loaded.end(), true);
    this->setToolTip(QString("%1 of %2 times are loaded").arg(count).arg(loaded.size()));
    this->update();
  }
}

void LoadedSteps::paintEvent(QPaintEvent*)
{
  QPainter painter(this);
  painter.fillRect(this->rect(), this->palette().color(QPalette::Mid));
  const double width = static_cast<double>(this->width()) / std::max<std::size_t>(1, loaded.size());
  for (std::size_t i = 0; i < loaded.size(); ++i)
  {
    if (loaded[i])
    {
      painter.fillRect(QRectF(static_cast<double>(i) * width, 0.0, width, this->height()),
        this->palette().color(QPalette::Highlight));
    }
  }
}

} // namespace nexrad::viewer
