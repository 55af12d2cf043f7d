// SPDX-License-Identifier: BSD-3-Clause
#include "Viewer/Parts/Soon.h"

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

} // namespace nexrad::viewer
