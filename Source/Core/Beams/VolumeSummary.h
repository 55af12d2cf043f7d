// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Beams/VolumeComposite.h"
#include "nexrad/Polar/PolarVolume.h"

#include <cstddef>
#include <vector>

namespace nexrad
{

/// What must be known of a volume where its rays are not needed: how far it sees, and for
/// reflectivity the picture in which motion is looked for. Some ten thousand bytes.
struct VolumeSummary
{
  double reach = 0.0;    ///< m, slant range of the outer edge of the farthest gate of any sweep
  int rings = 0;         ///< of the composite
  double echoTime = 0.0; ///< of the composite
  double echo = 0.0;     ///< of the composite
  /// The composite's cells in order. A value of 0 or more is a cell that was scanned, −1 one that
  /// was not; −n, n ≥ 2, says that the next stands for n cells.
  std::vector<float> picture;

  std::size_t MemoryBytes() const { return sizeof(*this) + picture.size() * sizeof(float); }
};

/// The summary of a volume; without a picture for other moments than REF.
VolumeSummary MakeSummary(const PolarVolume& volume);

/// What a summary keeps of a composite; the reach is 0.
VolumeSummary MakeSummary(const VolumeComposite& composite);

/// The composite again, as far as the search for motion looks at it: which cells were scanned,
/// their values exactly, and the echo. Throws Error when the picture does not have its size.
VolumeComposite CompositeOf(const VolumeSummary& summary);

} // namespace nexrad
