// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Gridding/EchoMask.h"

#include "nexrad/Geometry/Angles.h"

#include <algorithm>
#include <cmath>

namespace nexrad
{

namespace
{

constexpr auto sectors = static_cast<std::size_t>(VolumeComposite::Sectors);

// The largest within `by` places to either side, in a row that may close to a circle.
std::vector<std::uint8_t> WidenRow(const std::vector<std::uint8_t>& from, int by, bool circle)
{
  const int size = static_cast<int>(from.size());
  std::vector<std::uint8_t> to(from.size(), 0);
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
  return to;
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
  tops.assign(rings * sectors, 0);
  for (const VolumeComposite* composite : composites)
  {
    for (int sector = 0; sector < VolumeComposite::Sectors; ++sector)
    {
      for (int ring = 0; ring < composite->rings; ++ring)
      {
        const std::size_t at =
          static_cast<std::size_t>(sector) * rings + static_cast<std::size_t>(ring);
        tops[at] = std::max(tops[at], composite->tops[composite->Index(sector, ring)]);
      }
    }
  }
  // A ring for the gate beside, another for what the ground distance was rounded.
  const int ringsBeside = static_cast<int>(std::ceil(distance / ringWidth)) + 2;
  for (std::size_t sector = 0; sector < sectors; ++sector)
  {
    this->WidenLine(sector * rings, 1, rings, ringsBeside, false);
  }
  const int raysBeside = static_cast<int>(std::ceil(widestGap)) + 1;
  for (std::size_t ring = 0; ring < rings; ++ring)
  {
    // From the ring's inner edge, where the distance takes the widest angle.
    const double range = static_cast<double>(ring) * ringWidth;
    const bool around = distance >= range;
    const double angle = around ? 180.0 : std::asin(distance / range) / RadiansPerDegree;
    const int by = static_cast<int>(std::ceil(angle)) + raysBeside;
    this->WidenLine(ring, rings, sectors, std::min(by, VolumeComposite::Sectors / 2), true);
  }
}

void EchoMask::WidenLine(
  std::size_t first, std::size_t stride, std::size_t count, int by, bool circle)
{
  std::vector<std::uint8_t> line;
  for (std::size_t i = 0; i < count; ++i)
  {
    line.push_back(tops[first + i * stride]);
  }
  line = WidenRow(line, by, circle);
  for (std::size_t i = 0; i < count; ++i)
  {
    tops[first + i * stride] = line[i];
  }
}

} // namespace nexrad
