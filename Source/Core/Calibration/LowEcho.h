// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Polar/PolarVolume.h"

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace nexrad
{

/// The reflectivity that one volume has from 1 to 3 km above its radar, in coarse cells: what
/// radars that see the same places compare (Formulas Q6). Four bytes for each cell with a value; up
/// to some ten thousand bytes in all.
///
/// A cell is a sector of azimuth by a ring along the ground by a layer of height above mean sea
/// level. Its value is the mean of Z over the gates in it. Only cells in which each gate has a
/// value have one, and only from LeastValue on.
struct LowEcho
{
  static constexpr double Bottom = 1'000.0; ///< m above the antenna
  static constexpr double Top = 3'000.0;    ///< m above the antenna
  static constexpr int Sectors = 180;       ///< of 2 degrees
  static constexpr int Rings = 44;          ///< to 176 km, where the lowest tilts leave the layer
  static constexpr double RingWidth = 4'000.0;    ///< m along the ground
  static constexpr double LayerHeight = 500.0;    ///< m
  static constexpr double NearestGate = 20'000.0; ///< m along the ground; nearer ones do not count
  static constexpr double LeastValue = 5.0;       ///< dBZ

  Site site;          ///< the radar; it has a position
  Time start{};       ///< first ray of the volume
  Time time{};        ///< mean time of the gates that may count
  int firstLayer = 0; ///< lowest layer that some cell may be in; layer 0 begins at mean sea level
  int layers = 0;
  /// Index ((layer − firstLayer) · Sectors + sector) · Rings + ring and value, hundredths of dBZ,
  /// of the cells that have one, by index.
  std::vector<std::pair<std::uint16_t, std::int16_t>> cells;

  LowEcho() = default;

  /// The cells of a volume of REF at a site with a position. Rays that stray from their cut do not
  /// count, nor do the Doppler halves of split cuts. Throws Error for another moment, or without a
  /// position.
  explicit LowEcho(const PolarVolume& volume);

  /// Value of a cell, hundredths of dBZ; empty where it has none. The sector is 0…Sectors − 1, the
  /// ring 0…Rings − 1.
  std::optional<int> At(int layer, int sector, int ring) const;

  /// Whether a cell of some layer has a value.
  bool HasValue(int sector, int ring) const;
};

} // namespace nexrad
