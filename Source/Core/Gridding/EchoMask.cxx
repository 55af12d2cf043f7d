// SPDX-License-Identifier: BSD-3-Clause
#include "Gridding/EchoMask.h"

#include "Geometry/Angles.h"

#include <algorithm>
#include <cmath>

namespace nexrad
{

namespace
{

constexpr int sectors = VolumeComposite::Sectors;

// Marks what lies within `by` places of a mark, in a row that may close to a circle.
void WidenRow(
  const std::vector<std::uint8_t>& from, int by, bool circle, std::vector<std::uint8_t>& to)
{
  const int size = static_cast<int>(from.size());
  to.assign(from.size(), 0);
  int reach = -1; // last place that the marks so far reach
  const int start = circle ? -by : 0;
  for (int i = start; i < size + (circle ? by : 0); ++i)
  {
    const int place = circle ? (i + size) % size : i;
    if (from[static_cast<std::size_t>(place)] != 0)
    {
      for (int j = std::max({i - by, reach + 1, 0}); j <= std::min(i + by, size - 1); ++j)
      {
        to[static_cast<std::size_t>(j)] = 1;
      }
      reach = std::max(reach, i + by);
    }
  }
}

} // namespace

EchoMask::EchoMask(
  const std::vector<const VolumeComposite*>& composites, double effectiveRadius, double distance)
{
  float widestGap = 0.0F;
  for (const VolumeComposite* composite : composites)
  {
    rings = std::max(rings, static_cast<std::size_t>(composite->rings));
    widestGap = std::max(widestGap, composite->widestGap);
  }
  // Rings beyond the last gate, into which what is near its end is widened.
  const double ringWidth = static_cast<double>(VolumeComposite::RingWidth);
  rings += static_cast<std::size_t>(std::ceil(distance / ringWidth)) + 2;
  ringsPerTangent = static_cast<float>(2.0 * effectiveRadius / ringWidth);
  near.assign(rings * static_cast<std::size_t>(sectors), 0);
  for (const VolumeComposite* composite : composites)
  {
    for (int sector = 0; sector < sectors; ++sector)
    {
      for (int ring = 0; ring < composite->rings; ++ring)
      {
        const bool held =
          composite->cells[composite->Index(sector, ring)] == VolumeComposite::Cell::Held;
        near[static_cast<std::size_t>(sector) * rings + static_cast<std::size_t>(ring)] |=
          held ? 1 : 0;
      }
    }
  }
  this->Widen(distance, widestGap);
}

void EchoMask::Widen(double distance, float widestGap)
{
  // A ring for the gate beside, another for what the ground distance was rounded.
  const double ringWidth = static_cast<double>(VolumeComposite::RingWidth);
  this->WidenRings(static_cast<int>(std::ceil(distance / ringWidth)) + 2);
  const int raysBeside = static_cast<int>(std::ceil(widestGap)) + 1;
  for (std::size_t ring = 0; ring < rings; ++ring)
  {
    // From the ring's inner edge, where the distance takes the widest angle.
    const double range = static_cast<double>(ring) * ringWidth;
    const bool around = distance >= range;
    const double angle = around ? 180.0 : std::asin(distance / range) / RadiansPerDegree;
    const int by = static_cast<int>(std::ceil(angle)) + raysBeside;
    this->WidenSectors(ring, std::min(by, sectors / 2));
  }
}

void EchoMask::WidenRings(int by)
{
  std::vector<std::uint8_t> wide;
  for (std::size_t sector = 0; sector < static_cast<std::size_t>(sectors); ++sector)
  {
    const auto first = near.begin() + static_cast<std::ptrdiff_t>(sector * rings);
    WidenRow({first, first + static_cast<std::ptrdiff_t>(rings)}, by, false, wide);
    std::copy(wide.begin(), wide.end(), first);
  }
}

void EchoMask::WidenSectors(std::size_t ring, int by)
{
  std::vector<std::uint8_t> circle;
  std::vector<std::uint8_t> wide;
  for (std::size_t sector = 0; sector < static_cast<std::size_t>(sectors); ++sector)
  {
    circle.push_back(near[sector * rings + ring]);
  }
  WidenRow(circle, by, true, wide);
  for (std::size_t sector = 0; sector < static_cast<std::size_t>(sectors); ++sector)
  {
    near[sector * rings + ring] = wide[sector];
  }
}

} // namespace nexrad
