// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Beams/EchoLayers.h"
#include "nexrad/Gridding/BeamSampling.h"
#include "nexrad/Gridding/BeamTilts.h"

#include <vector>

namespace nexrad
{

/// The corrections for layered echo (EchoLayers) of one radar's volumes about the time of a merge.
/// Volumes nearer in time count more; each is taken where the echo over a column was at the
/// volume's time.
class SiteLayers
{
public:
  SiteLayers() = default;
  /// `tilts` are those of the merge. The volumes must outlive the object.
  SiteLayers(
    const std::vector<const BeamVolume*>& volumes, const std::vector<BeamTilt>& tilts, Time time);

  /// False when no change lies over a column or within the distance that echo moves.
  bool AnyAt(const ColumnDirection& column) const
  {
    const std::size_t cell = parts.empty() ? anyIn.size() : parts.front().layers->CellAt(column);
    return cell < anyIn.size() && anyIn[cell] != 0;
  }

  /// Finds the changes in the gap above each tilt but the last (EchoLayers); false when there are
  /// none over the column. `motion` may be nullptr.
  bool Find(const ColumnDirection& column, const ColumnMotion* motion,
    std::vector<EchoLayers::Changes>& changes) const;

private:
  struct Part
  {
    const EchoLayers* layers;
    float seconds;             // from the time of the merge to the middle of the volume
    std::vector<int> gaps;     // of the volume, for each of the merge; −1 for none
    std::vector<float> shares; // how much it counts in each
  };
  std::vector<Part> parts;
  std::vector<std::uint8_t> anyIn; // cells of EchoLayers in which any part changes something
  std::size_t gapCount = 0;
};

} // namespace nexrad
