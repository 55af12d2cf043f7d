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

// Of a table.
struct TableRow
{
  const char* first;
  const char* second;
};

constexpr TableRow tasks[] = {
  {"Read a value", "hold the pointer over an echo; the line at the bottom right says its value, "
                   "place and height"},
  {"See less, or more, of the storm", "Preset, in the panel Look"},
  {"Surfaces at values", "the preset iso-values; or write values into Iso-values, in the editor of "
                         "the transfer function (T)"},
  {"Velocity, or another moment", "Moment, in the panel Look"},
  {"Maps: composite, echo top, VIL, VIL density", "View, in the panel Look"},
  {"Cut the volume open", "the tab Cut beside the panel Look: Crop or Clip"},
  {"A vertical section", "X, then drag over the ground; Remove takes the line away"},
  {"The first view again", "R"},
  {"Give it to somebody else", "File: a picture, a movie, the volume, a session, or the command "
                               "that draws the picture"},
};

constexpr TableRow gestures[] = {
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

template <std::size_t Count>
QString Part(const QString& title, const TableRow (&table)[Count])
{
  QString rows;
  for (const TableRow& row : table)
  {
    rows += Row(row.first, row.second);
  }
  return "<h3>" + title + "</h3><table>" + rows + "</table>";
}

QString KeysPart(const QList<QAction*>& actions)
{
  QString rows;
  QSet<QString> listed;
  for (const QAction* action : actions)
  {
    QString keys = action->shortcut().toString(QKeySequence::NativeText);
    if (keys.isEmpty()) // a menu may name the key of a shortcut that is not the action's
    {
      keys = action->text().section('\t', 1);
    }
    if (!keys.isEmpty() && !listed.contains(keys))
    {
      listed << keys;
      const QString text = action->text().section('\t', 0, 0); // as "&Open files…"
      rows += Row(keys, QString(text).remove('&').remove(QString::fromUtf8("…")));
    }
  }
  return "<h3>Keys</h3><table>" + rows + "</table>";
}

} // namespace

HelpPage::HelpPage(const QList<QAction*>& actions, QWidget* parent)
  : QDialog(parent)
{
  this->setWindowTitle("Help: what to do, keys and mouse");
  this->setAttribute(Qt::WA_DeleteOnClose);
  auto* page = new QTextBrowser(this);
  page->setObjectName("help");
  page->setAccessibleName("Help");
  page->setHtml(beginning + Part("What to do for what", tasks) +
                Part("Mouse on the picture", gestures) + KeysPart(actions));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(page);
  this->resize(520, 560);
}

} // namespace nexrad::viewer
