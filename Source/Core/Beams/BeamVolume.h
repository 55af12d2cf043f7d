// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Beams/BeamSweep.h"
#include "nexrad/Beams/EchoLayers.h"
#include "nexrad/Beams/VolumeComposite.h"
#include "nexrad/Polar/PolarVolume.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

namespace nexrad
{

/// One moment of one volume, made ready for the merge by beams once a run.
struct BeamVolume
{
  Site site;
  MomentName moment = MomentName::REF;
  Time start{}; ///< first ray
  Time end{};   ///< last ray
  bool synthetic = false;
  EchoGates echo;                              ///< of reflectivity
  std::optional<double> endsAt = std::nullopt; ///< PolarVolume::endsAt
  std::vector<BeamSweep> sweeps;               ///< in the order scanned
  VolumeComposite composite;                   ///< of the sweeps
  VolumeComposite lowest; ///< of reflectivity: of the first sweep of the lowest tilt
  std::shared_ptr<const EchoLayers> layers = ///< of reflectivity, when PrepareForGrid was asked for
    std::make_shared<const EchoLayers>();    ///< them; shared by copies of the volume
  double voxelSide = 0.0; ///< m, of the voxels for which the sweeps' means were made; 0: for none

  std::size_t MemoryBytes() const;
};

/// Volumes made ready, which several may share.
using BeamVolumes = std::vector<std::shared_ptr<const BeamVolume>>;

/// Makes a volume ready. Gates keep their codes. A gap between rays wider than one and a half times
/// `beamWidth` (degrees; unless said, the radar's own, BeamWidthOf) or the sweep's own spacing,
/// whichever is larger, is not interpolated across.
///
/// Left out are sweeps without rays or gates or that end at or behind the antenna, rays that stray
/// from their cut (Formulas Q7), rays at the azimuth of a later one, and of REF the Doppler half of
/// a split cut in the directions in which its surveillance half has rays. The Doppler half is a
/// contiguous Doppler cut after a surveillance or batch cut at the same tilt, with nothing but
/// other cuts at that tilt between them. A terminal radar's cuts without ambiguity resolution are
/// none: it repeats the lowest one each minute for its reflectivity.
BeamVolume PrepareBeamVolume(
  const PolarVolume& volume, std::optional<double> beamWidth = std::nullopt);

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
