// SPDX-License-Identifier: BSD-3-Clause
#include "Viewer/WelcomePage.h"

#include <QApplication>
#include <QCommandLinkButton>
#include <QEvent>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace nexrad::viewer
{
namespace
{

constexpr int mostOffered = 5;
constexpr int widest = 360; // pixels of a column

QLabel* Text(const QString& text, QWidget* parent)
{
  auto* label = new QLabel(text, parent);
  label->setWordWrap(true);
  return label;
}

QLabel* Heading(const QString& text, double times, QWidget* parent)
{
  auto* label = new QLabel(text, parent);
  QFont font = label->font();
  font.setPointSizeF(times * font.pointSizeF());
  font.setBold(true);
  label->setFont(font);
  return label;
}

} // namespace

WelcomePage::WelcomePage(QWidget* picture)
  : QScrollArea(picture)
  , said(Text("", this))
{
  this->setObjectName("welcome");
  this->setAccessibleName("Welcome");
  this->setFrameShape(QFrame::NoFrame);
  this->setAutoFillBackground(true);
  this->setAttribute(Qt::WA_NoMousePropagation); // the camera does not turn below it
  this->setFocusPolicy(Qt::NoFocus);
  this->setWidgetResizable(true);
  auto* page = new QWidget(this);
  auto* column = new QVBoxLayout(page);
  column->setContentsMargins(32, 24, 32, 24);
  column->setSpacing(10);
  column->addStretch(1);
  column->addWidget(Heading("nexrad3d", 2.2, page));
  column->addWidget(Text("Weather radar in three dimensions: files of one or more radars (NEXRAD "
                         "Level II) are merged into a volume for each time.",
    page));
  said->setObjectName("welcome text");
  said->setAccessibleName("What is being opened, or why nothing is open");
  said->setTextInteractionFlags(Qt::TextSelectableByMouse);
  column->addWidget(said);
  choices = this->MakeChoices();
  column->addWidget(choices);
  column->addStretch(2);
  this->setWidget(page);
  picture->installEventFilter(this);
  this->setGeometry(picture->rect());
  this->hide();
}

QCommandLinkButton* WelcomePage::AddChoice(QVBoxLayout* column, const QString& name,
  const QString& text, const QString& description, void (WelcomePage::*wanted)())
{
  auto* button = new QCommandLinkButton(text, description, this);
  button->setObjectName(name);
  button->setAccessibleName(QString(text).remove('&'));
  button->setAccessibleDescription(description);
  button->setAutoDefault(true);  // Enter presses it, as Space does
  const QWidget* sized = button; // whose own height is that of a narrower one
  button->setFixedSize(widest, sized->heightForWidth(widest));
  connect(button, &QAbstractButton::clicked, this, wanted);
  column->addWidget(button);
  return button;
}

QWidget* WelcomePage::MakeChoices()
{
  auto* both = new QWidget(this);
  auto* column = new QVBoxLayout(both);
  column->setContentsMargins(0, 0, 0, 0);
  auto* row = new QHBoxLayout;
  row->setSpacing(32);
  auto* buttons = new QVBoxLayout;
  firstChoice = this->AddChoice(buttons, "welcome files", "Open files…",
    "Radar files, merged volumes (.nxv, .vti), or a session that was saved (Ctrl+O)",
    &WelcomePage::FilesWanted);
  this->AddChoice(buttons, "welcome folder", "Open folder…",
    "All radar files in it, merged into one series of times (Ctrl+Shift+O)",
    &WelcomePage::FolderWanted);
  this->AddChoice(buttons, "welcome synthetic day", "Synthetic day",
    "An hour of SYNTHETIC storms over three radars, without any files; the radars are simulated "
    "first, which takes about half a minute",
    &WelcomePage::SyntheticDayWanted);
  buttons->addStretch(1);
  recent = new QWidget(both);
  recentRow = new QVBoxLayout(recent);
  recentRow->setContentsMargins(0, 6, 0, 0);
  recentRow->setSpacing(2);
  recentRow->addWidget(Heading("Opened before", 1.0, recent));
  row->addLayout(buttons);
  row->addWidget(recent, 1, Qt::AlignTop);
  row->addStretch(0);
  column->addLayout(row);
  column->addWidget(Text("Files and folders can also be dropped on this window. F1 shows what the "
                         "mouse and the keys do.",
    both));
  return both;
}

void WelcomePage::SetRecent(const QStringList& paths)
{
  while (QLayoutItem* item = recentRow->takeAt(1)) // after the heading
  {
    item->widget()->deleteLater(); // its click may have led here
    delete item;
  }
  for (const QString& path : paths.mid(0, mostOffered))
  {
    auto* button = new QPushButton(recent);
    button->setText(button->fontMetrics().elidedText(
      QFileInfo(path).fileName().replace('&', "&&"), Qt::ElideMiddle, widest - 100));
    button->setObjectName("welcome recent");
    button->setAccessibleName("Open " + path);
    button->setToolTip(path);
    button->setFlat(true);
    button->setStyleSheet("text-align: left; padding: 4px");
    button->setAutoDefault(true);
    button->setMaximumWidth(widest);
    connect(button, &QAbstractButton::clicked, this, [this, path] { emit PathWanted(path); });
    recentRow->addWidget(button);
  }
  recent->setVisible(!paths.isEmpty());
}

void WelcomePage::OfferToOpen(const QString& problem)
{
  const bool before = !this->isHidden() && !choices->isHidden();
  said->setText(problem);
  said->setVisible(!problem.isEmpty());
  choices->show();
  this->show();
  this->raise();
  if (!before)
  {
    firstChoice->setFocus();
  }
}

void WelcomePage::TellOpening(const QString& what)
{
  said->setText(what);
  said->show();
  choices->hide();
  this->show();
  this->raise();
}

void WelcomePage::Leave()
{
  if (this->isHidden())
  {
    return;
  }
  const QWidget* focus = QApplication::focusWidget();
  const bool hadFocus = focus == nullptr || this->isAncestorOf(focus);
  this->hide();
  if (hadFocus)
  {
    this->parentWidget()->setFocus();
  }
}

bool WelcomePage::eventFilter(QObject* watched, QEvent* event)
{
  if (watched == this->parentWidget() && event->type() == QEvent::Resize)
  {
    this->setGeometry(this->parentWidget()->rect());
  }
  return QScrollArea::eventFilter(watched, event);
}

} // namespace nexrad::viewer
