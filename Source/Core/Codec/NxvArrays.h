// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Codec/NxvHeader.h"
#include "nexrad/Compression/Deflate.h"
#include "nexrad/Grid/GriddedVolume.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace nexrad
{

/// What takes an array of a volume, of which `source` gives `size` bytes, to be deflated. The
/// source lives as long as the call.
using NxvAddArray = std::function<void(
  NxvArray array, std::size_t size, DeflateSearch search, const ByteSource& source)>;
/// What takes an array of a volume with its payload.
using NxvAddPayload = std::function<void(NxvArray array, std::vector<std::uint8_t> payload)>;

/// Adds the arrays of a volume's own moment and states, as NxvEncoding names them; those of states
/// and of filtered voxels where codes do not tell them.
void AddFloatArrays(const NxvAddArray& add, const GriddedVolume& volume);
void AddThesisArrays(
  const NxvAddPayload& addPayload, const NxvAddArray& add, const GriddedVolume& volume);
void AddRadarStepArrays(const NxvAddArray& add, const GriddedVolume& volume);

/// Adds those of the ancillary arrays that the volume has: ages and weights as codes, or exact.
/// Throws Error for one of the wrong length, or with a value that it cannot have.
void AddAncillaryArrays(const NxvAddArray& add, const GriddedVolume& volume, bool exact);

/// Adds all arrays of one moment of a part of a volume in bricks: as floats, or as codes, the same
/// ones in all parts. Ancillary arrays are exact. Throws Error also unless there is a value and a
/// state for each voxel.
void AddBandArrays(const NxvAddArray& add, const GriddedVolume& volume, bool exact);

} // namespace nexrad
