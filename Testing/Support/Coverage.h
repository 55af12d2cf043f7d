// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Geometry/Beam.h"
#include "nexrad/Grid/GridSpecification.h"
#include "nexrad/Polar/PolarVolume.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace nexrad
{

/// How beams are told from what they passed by.
struct CoverageOptions
{
  std::optional<double> beamWidth; ///< degrees; unless said, each radar's own (Formulas B4)
  BeamModel beam = BeamModel();    ///< path of the beams
};

/// Which voxels some beam saw: 1 where the centre of the voxel lies in a beam of some sweep of some
/// volume, else 0. It does when, from the site, the ray with the nearest azimuth is within a beam
/// width, the elevation of the centre is within half a beam width of that ray's, and its slant
/// range lies in a gate that was sampled (gates reach half a spacing to both sides of their
/// centre). Exact geometry (Formulas B1 to B3), a geodesic for each column of each site. The order
/// is that of GriddedVolume's values. Throws Error for a volume without a position.
std::vector<std::uint8_t> BeamCoverage(const std::vector<const PolarVolume*>& volumes,
  const GridSpecification& grid, const CoverageOptions& options = {});

} // namespace nexrad
