// SPDX-License-Identifier: BSD-3-Clause
#include "Viewer/Parts/ArrayChoice.h"

#include <vtkPointData.h>

#include <QComboBox>
#include <QStandardItemModel>

#include <algorithm>

namespace nexrad::viewer
{
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

void OfferArrays(const OfferedArrays& offered, const QString& chosen, QComboBox* box)
{
  box->clear();
  box->addItem("Itself", QString());
  for (const QString& moment : offered.moments)
  {
    box->addItem(moment, moment);
  }
  auto* entries = qobject_cast<QStandardItemModel*>(box->model());
  for (const Ancillary& ancillary : ancillaryArrays)
  {
    const QString array = offered.shown + ancillary.ending;
    const bool has =
      offered.arrays != nullptr && offered.arrays->HasArray(array.toUtf8().constData()) != 0;
    const bool on = has || (offered.arrays != nullptr && offered.makesAncillary);
    box->addItem(ancillary.name, array);
    entries->item(box->count() - 1)->setEnabled(on);
    const QString tip = array + ": " + ancillary.tip;
    box->setItemData(box->count() - 1, on ? tip : tip + missing, Qt::ToolTipRole);
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

} // namespace nexrad::viewer
