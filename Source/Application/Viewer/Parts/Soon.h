// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>

#include <functional>

namespace nexrad::viewer
{

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

} // namespace nexrad::viewer
