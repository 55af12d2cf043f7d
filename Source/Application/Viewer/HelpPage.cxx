// SPDX-License-Identifier: BSD-3-Clause
#include "Viewer/HelpPage.h"

#include <QAction>
#include <QSet>
#include <QTextBrowser>
#include <QVBoxLayout>

namespace nexrad::viewer
{
namespace
{

constexpr char beginning[] =
  "<h3>How to begin</h3>"
  "<p>Drop radar files (NEXRAD Level II), a folder of them, or merged volumes (.nxv, .vti) on the "
  "window, or open them from the menu <i>File</i>. With nothing at hand, <i>Open the synthetic "
  "day</i> in that menu simulates an hour of storms over three radars.</p>"
  "<p>The line below the picture has one place for each time; Space plays them. The settings of "
  "the picture are on the right. Hold the pointer over a setting to read what it does and in which "
  "unit it is.</p>";

struct Gesture
{
  const char* mouse;
  const char* does;
};

constexpr Gesture gestures[] = {
  {"left button, drag", "turn and tilt"},
  {"middle button, or Shift and left button, drag", "move"},
  {"wheel", "zoom towards the place under the pointer"},
  {"right button, drag up or down", "zoom"},
  {"double click", "move what is there into the middle, and turn about it"},
  {"B, then left button, drag; or Ctrl and left button, drag",
    "a box on the ground, merged again in finer voxels; Escape: none"},
  {"X, then left button, drag", "the line of a vertical section on the ground"},
};

QString Row(const QString& first, const QString& second)
{
  return QString("<tr><td style='padding-right:16px'>%1</td><td>%2</td></tr>")
    .arg(first.toHtmlEscaped(), second.toHtmlEscaped());
}

QString MousePart()
{
  QString rows;
  for (const Gesture& gesture : gestures)
  {
    rows += Row(gesture.mouse, gesture.does);
  }
  return "<h3>Mouse on the picture</h3><table>" + rows + "</table>";
}

// "&Open files…" is the text of a menu.
QString Plain(QString text)
{
  return text.remove('&').remove(QString::fromUtf8("…"));
}

QString KeysPart(const QList<QAction*>& actions)
{
  QString rows;
  QSet<QString> listed;
  for (const QAction* action : actions)
  {
    const QString keys = action->shortcut().toString(QKeySequence::NativeText);
    if (!keys.isEmpty() && !listed.contains(keys))
    {
      listed << keys;
      rows += Row(keys, Plain(action->text()));
    }
  }
  return "<h3>Keys</h3><table>" + rows + "</table>";
}

} // namespace

HelpPage::HelpPage(const QList<QAction*>& actions, QWidget* parent)
  : QDialog(parent)
{
  this->setWindowTitle("Help");
  this->setAttribute(Qt::WA_DeleteOnClose);
  auto* page = new QTextBrowser(this);
  page->setObjectName("help");
  page->setAccessibleName("Help");
  page->setHtml(beginning + MousePart() + KeysPart(actions));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(page);
  this->resize(520, 560);
}

} // namespace nexrad::viewer
