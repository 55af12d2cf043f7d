// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Model/RadarVolume.h"
#include "nexrad/Simulation/ScanStrategy.h"

#include <cstddef>
#include <cstdint>

namespace nexrad
{

/// Where the words of a ray's moments stand, one after another: those of REF, VEL, SW, then ZDR,
/// PHI (two bytes each) and RHO.
struct RayBlocks
{
  /// `words` holds Bytes of the same layout.
  RayBlocks(const CutLayout& layout, int polarimetricGates, std::uint8_t* words);

  static std::size_t Bytes(const CutLayout& layout, int polarimetricGates);

  /// Sets the rows of a ray that have gates: they point to the words.
  void Describe(Ray& ray) const;
  /// Puts one value into all gates of a moment, as a receiver's test pattern does.
  void FillWithPattern() const;

  GateLayout reflectivityGates;
  GateLayout dopplerGates;
  GateLayout polarimetricGates;
  std::uint8_t* reflectivity;
  std::uint8_t* velocity;
  std::uint8_t* width;
  std::uint8_t* polarimetric;
};

} // namespace nexrad
