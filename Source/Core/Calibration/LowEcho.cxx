// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Calibration/LowEcho.h"

#include "nexrad/Geometry/Angles.h"
#include "nexrad/Geometry/Beam.h"
#include "nexrad/Model/SiteTable.h"
#include "nexrad/Polar/SweepPairing.h"
#include "nexrad/System/Error.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace nexrad
{

namespace
{

constexpr double hundredths = 100.0; // a dB in the values of cells
constexpr int noCell = -1;

// The cells while gates are added.
struct CellSum
{
  double sum = 0.0; // of Z, mm^6/m^3
  int gates = 0;
  int values = 0; // gates with a value
};

// Adds the sweeps of a volume one after the other.
class CellSums
{
public:
  CellSums(double antennaHeight, int theFirstLayer, int layers)
    : antenna(antennaHeight)
    , firstLayer(theFirstLayer)
    , sums(static_cast<std::size_t>(layers * LowEcho::Rings * LowEcho::Sectors))
  {
  }

  void Add(const PolarSweep& sweep, const std::vector<std::size_t>& rays)
  {
    this->FindRows(sweep);
    if (begin == end || rays.empty())
    {
      return;
    }
    this->FindPowers(sweep);
    codes.resize(sweep.gates);
    for (const std::size_t ray : rays)
    {
      sweep.Read(ray, codes.data());
      this->AddRay(sweep.rays[ray]);
    }
  }

  // Mean time of the gates that were looked at; 0 without any.
  Time MeanTime() const
  {
    const double mean = looked > 0 ? timeSum / static_cast<double>(looked) : 0.0;
    return Time(Duration(std::llround(mean)));
  }

  const std::vector<CellSum>& Sums() const { return sums; }

private:
  // Which gates lie in the layer, and in which cell of the first sector.
  void FindRows(const PolarSweep& sweep)
  {
    const double elevation = MedianElevation(sweep);
    places.assign(sweep.gates, noCell);
    begin = sweep.gates;
    end = 0;
    for (std::size_t gate = 0; gate < sweep.gates; ++gate)
    {
      const double range = sweep.firstGate + sweep.gateSpacing * static_cast<double>(gate);
      const BeamPoint point = beam.Locate(std::max(range, 0.0), elevation);
      const int ring = static_cast<int>(point.groundDistance / LowEcho::RingWidth);
      if (point.groundDistance >= LowEcho::NearestGate && ring < LowEcho::Rings &&
          point.height >= LowEcho::Bottom && point.height < LowEcho::Top)
      {
        const int layer =
          static_cast<int>(std::floor((antenna + point.height) / LowEcho::LayerHeight)) -
          firstLayer;
        places[gate] = layer * LowEcho::Sectors * LowEcho::Rings + ring;
        begin = std::min(begin, gate);
        end = gate + 1;
      }
    }
    begin = std::min(begin, end);
  }

  // Z of each code of the sweep that has a value of some strength: weaker ones add next to nothing.
  void FindPowers(const PolarSweep& sweep)
  {
    powers.assign(static_cast<std::size_t>(sweep.rows.LargestCode()) + 1, 0.0F);
    for (std::size_t code = GateCode::FirstValue; code < powers.size(); ++code)
    {
      const float value = sweep.scale.ValueOf(static_cast<std::uint16_t>(code));
      powers[code] = std::pow(10.0F, 0.1F * std::clamp(value, -40.0F, 100.0F));
    }
  }

  void AddRay(const PolarRay& ray)
  {
    const double azimuth = ToFullTurn(static_cast<double>(ray.azimuth));
    const int sector =
      std::clamp(static_cast<int>(azimuth * LowEcho::Sectors / 360.0), 0, LowEcho::Sectors - 1);
    const std::size_t firstRing = static_cast<std::size_t>(sector) * LowEcho::Rings;
    for (std::size_t gate = begin; gate < end; ++gate)
    {
      if (places[gate] == noCell)
      {
        continue;
      }
      const std::uint16_t code = codes[gate];
      CellSum& cell = sums[firstRing + static_cast<std::size_t>(places[gate])];
      ++cell.gates;
      if (code >= GateCode::FirstValue)
      {
        ++cell.values;
        cell.sum += static_cast<double>(powers[code]);
      }
    }
    const auto count = static_cast<std::int64_t>(end - begin);
    looked += count;
    timeSum +=
      static_cast<double>(count) * static_cast<double>(ray.time.time_since_epoch().count());
  }

  const double antenna; // m above mean sea level
  const int firstLayer;
  const BeamModel beam;
  std::vector<CellSum> sums;
  std::vector<int> places; // of each gate, in sector 0
  std::size_t begin = 0;   // the gates with a place
  std::size_t end = 0;
  std::vector<float> powers; // by code
  std::vector<std::uint16_t> codes;
  std::int64_t looked = 0;
  double timeSum = 0.0; // ms
};

} // namespace

LowEcho::LowEcho(const PolarVolume& volume)
  : site(volume.site)
  , start(volume.start)
{
  if (volume.moment != MomentName::REF || !site.position)
  {
    throw Error("site \"" + site.name +
                "\": radars are compared by reflectivity (REF), and where " +
                "they stand must be known");
  }
  const double antenna = site.position->altitude;
  firstLayer = static_cast<int>(std::floor((antenna + Bottom) / LayerHeight));
  layers = static_cast<int>(std::ceil((antenna + Top) / LayerHeight)) - firstLayer;
  const double beamWidth = BeamWidthOf(site);
  CellSums sums(antenna, firstLayer, layers);
  for (std::size_t i = 0; i < volume.sweeps.size(); ++i)
  {
    std::vector<std::size_t> rays = FindRaysOfCut(volume.sweeps[i], beamWidth);
    LeaveOutSeenTwice(volume, i, beamWidth, rays);
    sums.Add(volume.sweeps[i], rays);
  }
  time = sums.MeanTime();
  const std::vector<CellSum>& all = sums.Sums();
  for (std::size_t index = 0; index < all.size(); ++index)
  {
    const CellSum& cell = all[index];
    const double value =
      cell.values > 0 && cell.values == cell.gates ? 10.0 * std::log10(cell.sum / cell.gates) : 0.0;
    if (value >= LeastValue)
    {
      cells.emplace_back(static_cast<std::uint16_t>(index),
        static_cast<std::int16_t>(std::lround(hundredths * value)));
    }
  }
  cells.shrink_to_fit();
}

std::optional<int> LowEcho::At(int layer, int sector, int ring) const
{
  if (layer < firstLayer || layer >= firstLayer + layers)
  {
    return std::nullopt;
  }
  const auto index =
    static_cast<std::uint16_t>(((layer - firstLayer) * Sectors + sector) * Rings + ring);
  const auto cell = std::lower_bound(cells.begin(), cells.end(), index,
    [](const auto& each, std::uint16_t wanted) { return each.first < wanted; });
  return cell != cells.end() && cell->first == index ? std::optional<int>(cell->second)
                                                     : std::nullopt;
}

bool LowEcho::HasValue(int sector, int ring) const
{
  bool found = false;
  for (int layer = firstLayer; layer < firstLayer + layers && !found; ++layer)
  {
    found = this->At(layer, sector, ring).has_value();
  }
  return found;
}

} // namespace nexrad
