// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Beams/VolumeComposite.h"

#include "nexrad/Beams/BeamSweep.h"
#include "nexrad/Geometry/Beam.h"
#include "nexrad/Model/Elevation.h"

#include <algorithm>
#include <cmath>

namespace nexrad
{

namespace
{

// None for a sweep that ends at or behind the antenna; else at least one, also straight up.
int RingsOf(const BeamSweep& sweep)
{
  const auto reach = static_cast<double>(sweep.Reach());
  if (!(reach > 0.0))
  {
    return 0;
  }
  const BeamModel beam;
  const double ground = beam.Locate(reach, static_cast<double>(sweep.elevation)).groundDistance;
  return std::max(
    1, static_cast<int>(std::ceil(ground / static_cast<double>(VolumeComposite::RingWidth))));
}

// Adds the rays of one sweep to a composite.
class SweepAdder
{
public:
  SweepAdder(const BeamSweep& source, VolumeComposite& target)
    : sweep(source)
    , composite(target)
  {
    const int rings = RingsOf(sweep);
    const auto last = static_cast<std::size_t>(sweep.gates);
    gates.push_back(0);
    for (int ring = 1; ring < rings; ++ring)
    {
      // In the standard atmosphere: rings are wider than the difference that another one makes.
      const auto range = static_cast<float>(
        RangeOver(sweep, ring * static_cast<double>(VolumeComposite::RingWidth), BeamModel()));
      const float gate = std::max(0.0F, (range - sweep.firstGate) * sweep.gatesPerMetre);
      gates.push_back(std::min(static_cast<std::size_t>(std::ceil(gate)), last));
    }
    gates.push_back(last);
    composite.widestGap = std::max(composite.widestGap, sweep.halfWidth);
  }

  void AddAll()
  {
    const double begin = ToSeconds(sweep.begin);
    composite.tilts.push_back({sweep.elevation, 0.0});
    for (std::size_t entry = 1; entry + 1 < sweep.azimuths.size(); ++entry)
    {
      this->FindStrongest(entry);
      const float azimuth = sweep.azimuths[entry];
      const int own = static_cast<int>(azimuth) % VolumeComposite::Sectors;
      this->AddTo(own);
      // A sector without a ray of its own takes the nearest, unless the gap there is too wide.
      this->Spread(entry - 1, own, -1, 0.5F * (azimuth - sweep.azimuths[entry - 1]), azimuth);
      this->Spread(entry, own, 1, 0.5F * (sweep.azimuths[entry + 1] - azimuth), azimuth);
      composite.echoTime += rayEcho * (begin + static_cast<double>(sweep.times[entry]));
      composite.echo += rayEcho;
      composite.tilts.back().echo += rayEcho;
    }
  }

private:
  void FindStrongest(std::size_t entry)
  {
    const std::uint16_t* codes = sweep.Row(entry);
    const GateRange& held = sweep.held[entry];
    rayEcho = 0.0;
    strongest.assign(gates.size() - 1, GateCode::NoEcho);
    for (std::size_t ring = 0; ring + 1 < gates.size() && gates[ring] < held.end; ++ring)
    {
      std::uint16_t most = 0;
      const std::size_t end = std::min(gates[ring + 1], held.end);
      for (std::size_t gate = std::max(gates[ring], held.begin); gate < end; ++gate)
      {
        most = std::max(most, codes[gate]);
      }
      strongest[ring] = most;
      rayEcho += static_cast<double>(this->ValueOf(most));
    }
  }

  float ValueOf(std::uint16_t code) const
  {
    return code < GateCode::FirstValue ? 0.0F : std::max(0.0F, sweep.scale.ValueOf(code));
  }

  // Adds the ray to the sectors on one side of its own whose middle lies within `halfGap` of it.
  void Spread(std::size_t gap, int own, int side, float halfGap, float azimuth)
  {
    if (sweep.inverseGaps[gap] <= 0.0F)
    {
      return;
    }
    composite.widestGap = std::max(composite.widestGap, 2.0F * halfGap);
    for (int sector = own + side;; sector += side)
    {
      const float middle = static_cast<float>(sector) + 0.5F;
      if (std::abs(middle - azimuth) > halfGap)
      {
        return;
      }
      this->AddTo((sector + VolumeComposite::Sectors) % VolumeComposite::Sectors);
    }
  }

  void AddTo(int sector)
  {
    const std::size_t first = composite.Index(sector, 0);
    for (std::size_t ring = 0; ring < strongest.size(); ++ring)
    {
      if (gates[ring] == gates[ring + 1])
      {
        continue;
      }
      const std::uint16_t code = strongest[ring];
      const auto cell =
        code == GateCode::NoEcho ? VolumeComposite::Cell::NoEcho : VolumeComposite::Cell::Held;
      composite.cells[first + ring] = std::max(composite.cells[first + ring], cell);
      if (cell == VolumeComposite::Cell::Held)
      {
        composite.tops[first + ring] =
          std::max(composite.tops[first + ring], ElevationCode(sweep.elevation));
      }
      composite.values[first + ring] =
        std::max(composite.values[first + ring], this->ValueOf(code));
    }
  }

  const BeamSweep& sweep;
  VolumeComposite& composite;
  std::vector<std::size_t> gates;       // first of each ring, and the end of the last
  std::vector<std::uint16_t> strongest; // of the ray, by ring
  double rayEcho = 0.0;
};

using SweepIterator = std::vector<BeamSweep>::const_iterator;

VolumeComposite CompositeOf(SweepIterator begin, SweepIterator end)
{
  VolumeComposite composite;
  for (SweepIterator sweep = begin; sweep != end; ++sweep)
  {
    composite.rings = std::max(composite.rings, RingsOf(*sweep));
  }
  const std::size_t size = composite.Index(VolumeComposite::Sectors, 0);
  composite.cells.assign(size, VolumeComposite::Cell::NotScanned);
  composite.tops.assign(size, 0);
  composite.values.assign(size, 0.0F);
  for (SweepIterator sweep = begin; sweep != end; ++sweep)
  {
    if (RingsOf(*sweep) > 0)
    {
      SweepAdder(*sweep, composite).AddAll();
    }
  }
  if (composite.echo > 0.0)
  {
    composite.echoTime /= composite.echo;
  }
  return composite;
}

} // namespace

VolumeComposite MakeComposite(const std::vector<BeamSweep>& sweeps)
{
  return CompositeOf(sweeps.begin(), sweeps.end());
}

VolumeComposite MakeLowestComposite(const std::vector<BeamSweep>& sweeps)
{
  const auto lower = [](const BeamSweep& a, const BeamSweep& b)
  { return a.elevation < b.elevation; };
  const auto lowest = std::min_element(sweeps.begin(), sweeps.end(), lower);
  const auto isLowest = [&lowest](const BeamSweep& sweep)
  { return sweep.elevation - lowest->elevation <= static_cast<float>(SameTilt); };
  const auto first = std::find_if(sweeps.begin(), sweeps.end(), isLowest);
  return CompositeOf(first, first == sweeps.end() ? first : first + 1);
}

} // namespace nexrad
