// SPDX-License-Identifier: BSD-3-Clause
#include "Viewer/Widgets.h"

#include "Scene/Frame/VolumeInformation.h"
#include "nexrad/Geometry/Angles.h"

#include <vtkPointData.h>

#include <QAbstractSpinBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QDoubleSpinBox>
#include <QEvent>
#include <QScrollBar>
#include <QStandardItemModel>
#include <QTimer>

#include <algorithm>
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

HorizontalUnit HorizontalUnitOf(vtkImageData* volume)
{
  const bool geographic = volume != nullptr && scene::IsGeographic(volume);
  return geographic ? HorizontalUnit{1.0, MetresPerDegree, "°", 3} : HorizontalUnit{};
}

QDoubleSpinBox* MakeCoordinate(const QString& tip, QWidget* parent)
{
  auto* box = Named(new QDoubleSpinBox(parent), tip, tip);
  box->setRange(-2000.0, 2000.0);
  box->setDecimals(1);
  box->setKeyboardTracking(false);
  return box;
}

namespace
{

struct Ancillary
{
  const char* ending; // of the name of the array
  const char* name;
  const char* tip;
};
constexpr Ancillary ancillaryArrays[] = {
  {"_radars", "Number of radars", "how many radars scanned each place"},
  {"_age", "Age of the data", "time between the volume and the nearest ray, in minutes"},
  {"_site", "Nearest radar", "which radar that scanned the place is nearest to it"},
  {"_weight", "Weight", "sum of the weights of the radars that scanned the place"}};

constexpr char missing[] =
  ". Off: these volumes were made without ancillary arrays. Merge the radar files with nexrad3d "
  "grid --ancillary (method beam), or open the radar files themselves.";

} // namespace

void SetEntries(QComboBox* box, const QStringList& entries)
{
  QStringList before;
  for (int i = 0; i < box->count(); ++i)
  {
    before << box->itemText(i);
  }
  if (entries != before)
  {
    box->clear();
    box->addItems(entries);
  }
}

void OfferArrays(const OfferedArrays& offered, const QString& chosen, QComboBox* box)
{
  QStringList names = QStringList("Same moment") + offered.moments;
  for (const Ancillary& ancillary : ancillaryArrays)
  {
    names << ancillary.name;
  }
  SetEntries(box, names);
  int place = 0;
  box->setItemData(place++, QString());
  for (const QString& moment : offered.moments)
  {
    box->setItemData(place++, moment);
  }
  auto* entries = qobject_cast<QStandardItemModel*>(box->model());
  for (const Ancillary& ancillary : ancillaryArrays)
  {
    const QString array = offered.shown + ancillary.ending;
    const bool has =
      offered.arrays != nullptr && offered.arrays->HasArray(array.toUtf8().constData()) != 0;
    const bool on = has || (offered.arrays != nullptr && offered.makesAncillary);
    box->setItemData(place, array);
    entries->item(place)->setEnabled(on);
    const QString tip = array + ": " + ancillary.tip;
    box->setItemData(place++, on ? tip : tip + missing, Qt::ToolTipRole);
  }
  box->setCurrentIndex(std::max(0, box->findData(chosen)));
}

QString ChosenArray(const QComboBox* box)
{
  return box->currentData().toString();
}

void KeepNarrow(QComboBox* box)
{
  constexpr int letters = 8;
  box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  box->setMinimumContentsLength(letters);
}

namespace
{

bool IsSetting(const QWidget* widget)
{
  return qobject_cast<const QComboBox*>(widget) != nullptr ||
         qobject_cast<const QAbstractSpinBox*>(widget) != nullptr;
}

} // namespace

SettingsScroll::SettingsScroll(QWidget* panel, QWidget* parent)
  : QScrollArea(parent)
{
  this->setWidget(panel);
  this->setWidgetResizable(true);
  for (QWidget* setting : panel->findChildren<QWidget*>())
  {
    if (IsSetting(setting))
    {
      setting->setFocusPolicy(Qt::StrongFocus); // the wheel does not give it the focus
      setting->installEventFilter(this);
    }
  }
}

bool SettingsScroll::eventFilter(QObject* watched, QEvent* event)
{
  const auto* setting = qobject_cast<QWidget*>(watched);
  if (event->type() == QEvent::Wheel && IsSetting(setting) && !setting->hasFocus())
  {
    return QCoreApplication::sendEvent(this->verticalScrollBar(), event);
  }
  return QScrollArea::eventFilter(watched, event);
}

} // namespace nexrad::viewer
