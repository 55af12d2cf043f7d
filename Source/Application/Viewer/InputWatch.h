// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QFileSystemWatcher>
#include <QObject>
#include <QStringList>
#include <QTimer>

namespace nexrad::viewer
{

/// Watches inputs on disk for files that are added to them or grow.
class InputWatch : public QObject
{
  Q_OBJECT

public:
  explicit InputWatch(QObject* parent = nullptr);

  /// Watches these files and folders in place of those before.
  void Watch(const QStringList& inputs);

signals:
  /// Something changed, and then nothing for a second: a file that is being written changes often.
  void Changed();

private:
  void Renew();

  QStringList inputs;
  QFileSystemWatcher watcher;
  QTimer quiet;
};

} // namespace nexrad::viewer
