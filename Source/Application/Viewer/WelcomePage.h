// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QScrollArea>
#include <QString>
#include <QStringList>

class QCommandLinkButton;
class QLabel;
class QVBoxLayout;

namespace nexrad::viewer
{

/// The page that covers the picture as long as no volume is shown: it says what can be opened, and
/// opens it, or what is being opened.
class WelcomePage : public QScrollArea
{
  Q_OBJECT

public:
  /// Covers `picture`, of which it becomes a part.
  explicit WelcomePage(QWidget* picture);

  /// Shows what can be opened, and why nothing is open where something could not be opened.
  void OfferToOpen(const QString& problem);
  /// Shows what is being opened, in a sentence, in place of what can be opened.
  void TellOpening(const QString& what);
  /// Uncovers the picture, which takes the keys.
  void Leave();
  /// Paths that were opened before, the last one first.
  void SetRecent(const QStringList& paths);

signals:
  void FilesWanted();
  void FolderWanted();
  void SyntheticDayWanted();
  /// A path that was opened before.
  void PathWanted(const QString& path);

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  QCommandLinkButton* AddChoice(QVBoxLayout* column, const QString& name, const QString& text,
    const QString& description, void (WelcomePage::*wanted)());
  QWidget* MakeChoices();

  QLabel* said;           ///< what went wrong, or what is being opened
  QWidget* choices;       ///< hidden while something is being opened
  QWidget* recent;        ///< hidden where nothing was opened before
  QVBoxLayout* recentRow; ///< the button of each path
  QCommandLinkButton* firstChoice = nullptr;
};

} // namespace nexrad::viewer
