// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Gridding/EchoMask.h"

#include "nexrad/Geometry/Angles.h"

#include <algorithm>
#include <cmath>

namespace nexrad
{

namespace
{

constexpr int sectors = VolumeComposite::Sectors;

// The largest within `by` places to either side, in a row that may close to a circle.
void WidenRow(
  const std::vector<std::uint8_t>& from, int by, bool circle, std::vector<std::uint8_t>& to)
{
  const int size = static_cast<int>(from.size());
  to.assign(from.size(), 0);
  const int start = circle ? -by : 0;
  const int end = circle ? size + by : size;
  const auto at = [&](int i) { return from[static_cast<std::size_t>((i + size) % size)]; };
  for (int i = start; i < end; ++i)
  {
    const std::uint8_t top = at(i);
    if (top > 0)
    {
      // Where the place before is as high, it has raised all but the last of them already.
      const bool raised = i > start && at(i - 1) >= top;
      const auto first = to.begin() + std::clamp(raised ? i + by : i - by, 0, size);
      const auto last = to.begin() + std::min(i + by + 1, size);
      std::transform(
        first, last, first, [top](std::uint8_t other) { return std::max(other, top); });
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
  tops.assign(rings * static_cast<std::size_t>(sectors), 0);
  for (const VolumeComposite* composite : composites)
  {
    for (int sector = 0; sector < sectors; ++sector)
    {
      for (int ring = 0; ring < composite->rings; ++ring)
      {
        const std::size_t at =
          static_cast<std::size_t>(sector) * rings + static_cast<std::size_t>(ring);
        tops[at] = std::max(tops[at], composite->tops[composite->Index(sector, ring)]);
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
    const auto first = tops.begin() + static_cast<std::ptrdiff_t>(sector * rings);
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
    circle.push_back(tops[sector * rings + ring]);
  }
  WidenRow(circle, by, true, wide);
  for (std::size_t sector = 0; sector < static_cast<std::size_t>(sectors); ++sector)
  {
    tops[sector * rings + ring] = wide[sector];
  }
}

} // namespace nexrad
