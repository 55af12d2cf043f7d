// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Beams/BeamVolume.h"
#include "nexrad/Polar/PolarVolume.h"

#include <cstddef>
#include <vector>

namespace nexrad
{

/// A composite as far as the search for motion looks at it, in some thousand bytes.
struct PackedComposite
{
  int rings = 0;
  double echoTime = 0.0;
  double echo = 0.0;
  std::vector<VolumeComposite::Tilt> tilts;
  /// The cells in order. A value of 0 or more is a cell that was scanned, −1 one that was not; −n,
  /// n ≥ 2, says that the next stands for n cells.
  std::vector<float> picture;
};

/// What must be known of a volume where its rays are not needed: how far it sees, and for
/// reflectivity the pictures in which motion is looked for. Some ten thousand bytes.
struct VolumeSummary
{
  double reach = 0.0;        ///< m, slant range of the outer edge of the farthest gate of any sweep
  PackedComposite composite; ///< that of BeamVolume
  PackedComposite lowest;    ///< that of BeamVolume

  std::size_t MemoryBytes() const;
};

/// The summary of a volume; without pictures for other moments than REF.
VolumeSummary MakeSummary(const PolarVolume& volume);

/// The same of a volume made ready, whose sweeps tell how far it sees.
VolumeSummary MakeSummary(const BeamVolume& volume);

/// The composite again: which cells were scanned, their values exactly, and the echo. Throws Error
/// when the picture does not have its size.
VolumeComposite CompositeOf(const PackedComposite& packed);

} // namespace nexrad
