// SPDX-License-Identifier: BSD-3-Clause
#include "Viewer/InputWatch.h"

#include <QDir>
#include <QFileInfo>

namespace nexrad::viewer
{

InputWatch::InputWatch(QObject* parent)
  : QObject(parent)
{
  constexpr int quietTime = 1000; // ms
  quiet.setSingleShot(true);
  quiet.setInterval(quietTime);
  const auto wait = [this] { quiet.start(); };
  connect(&watcher, &QFileSystemWatcher::fileChanged, this, wait);
  connect(&watcher, &QFileSystemWatcher::directoryChanged, this, wait);
  connect(&quiet, &QTimer::timeout, this,
    [this]
    {
      this->Renew();
      emit Changed();
    });
}

void InputWatch::Watch(const QStringList& paths)
{
  inputs = paths;
  quiet.stop();
  this->Renew();
}

// A folder tells of files that come and go, but not of a file that grows, so the newest files are
// watched themselves. A file that was replaced has to be watched anew.
void InputWatch::Renew()
{
  constexpr int newest = 16;
  QStringList paths;
  for (const QString& input : inputs)
  {
    const QFileInfo info(input);
    if (info.exists())
    {
      paths << info.absoluteFilePath();
    }
    if (info.isDir())
    {
      const QFileInfoList files = QDir(input).entryInfoList(QDir::Files, QDir::Time);
      for (const QFileInfo& file : files.mid(0, newest))
      {
        paths << file.absoluteFilePath();
      }
    }
  }
  const QStringList old = watcher.files() + watcher.directories();
  if (!old.isEmpty())
  {
    watcher.removePaths(old);
  }
  if (!paths.isEmpty())
  {
    watcher.addPaths(paths);
  }
}

} // namespace nexrad::viewer
