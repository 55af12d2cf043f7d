// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>

#include <filesystem>

class QMenu;

namespace nexrad::viewer
{

class MainWindow;

/// What the menu File does with what is shown, beside pictures: the command that draws it, and
/// sessions.
class FileActions : public QObject
{
  Q_OBJECT

public:
  /// A child of the window.
  explicit FileActions(MainWindow& window);

  /// Appends its entries.
  void AddTo(QMenu* menu);

  /// Opens a session in place of what is open; reports what is wrong with the file.
  void OpenSession(const std::filesystem::path& path);

private:
  void CopyCommand();
  void AskToSaveSession();
  void AskForSession();

  MainWindow& window;
};

} // namespace nexrad::viewer
