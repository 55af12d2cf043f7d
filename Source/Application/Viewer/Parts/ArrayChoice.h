// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QString>
#include <QStringList>

class QComboBox;
class vtkPointData;

namespace nexrad::viewer
{

/// What may stand in place of the moment that is shown.
struct OfferedArrays
{
  QString shown;                  ///< the moment
  QStringList moments;            ///< others that the inputs hold
  vtkPointData* arrays = nullptr; ///< of the volume; nullptr: there is none
  bool makesAncillary = false; ///< volumes without ancillary arrays can be merged again with them
};

/// Sets the entries of a box. A list that a user has open, to choose from, stays where its entries
/// are the same.
void SetEntries(QComboBox* box, const QStringList& entries);

/// Fills a box with the moment itself, other moments, and the ancillary arrays of the moment, and
/// shows the array that is chosen (empty: the moment itself). An array that the volume does not
/// have and that cannot be made is off; its tool tip says why.
void OfferArrays(const OfferedArrays& offered, const QString& chosen, QComboBox* box);

/// The array that the entry of such a box stands for, as "REF_age"; empty: the moment itself.
QString ChosenArray(const QComboBox* box);

/// The box keeps its width, and the picture beside the panel its size, when other entries come.
void KeepNarrow(QComboBox* box);

} // namespace nexrad::viewer
