// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Beams/SweepMeans.h"

#include "nexrad/Geometry/Angles.h"
#include "nexrad/Model/Elevation.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace nexrad
{

namespace
{

constexpr double fullCircle = 360.0;    // degrees
constexpr double fewestSectors = 12.0;  // of the rings about the radar itself
constexpr float angleCodes = 65'000.0F; // in a period
constexpr double turn = 2.0 * Pi;

// Width of the cells between which is interpolated, for a mean over `side` of samples that are
// means over `spacing` themselves (Formulas G10).
double CellWidth(double side, double spacing)
{
  return side > 2.0 * spacing ? std::sqrt((side * side - spacing * spacing) / 3.0) : spacing;
}

// Degrees between neighbouring rays, as most of them stand.
double RaySpacing(const BeamSweep& sweep)
{
  std::vector<double> gaps;
  for (std::size_t entry = 0; entry + 1 < sweep.azimuths.size(); ++entry)
  {
    gaps.push_back(static_cast<double>(sweep.azimuths[entry + 1] - sweep.azimuths[entry]));
  }
  return std::min(MedianOf(std::move(gaps)), 2.0); // a single ray has no spacing of its own
}

// Places rings to the last gate where gates are put together; else as far as rays are, and one more
// ring, which leads over to the gates beyond.
class RingPlan
{
public:
  RingPlan(const BeamSweep& theSweep, double theSide)
    : sweep(theSweep)
    , side(theSide)
    , raySpacing(RaySpacing(theSweep) * RadiansPerDegree)
  {
    const double spacing = 1.0 / static_cast<double>(sweep.gatesPerMetre);
    const double length = sweep.gates * spacing;
    count = std::max(1, static_cast<int>(std::lround(length / CellWidth(side, spacing))));
    longer = count < sweep.gates;
    width = length / count;
    start = static_cast<double>(sweep.firstGate) - 0.5 * spacing;
  }

  double GatesPerRing() const { return static_cast<double>(sweep.gates) / count; }

  void PlaceIn(SweepMeans& means)
  {
    means.firstRing = static_cast<float>(start + 0.5 * width);
    means.ringsPerMetre = static_cast<float>(1.0 / width);
    means.reach = std::numeric_limits<float>::infinity();
    std::size_t cells = 0;
    for (int ring = 0; ring < count; ++ring)
    {
      const double range = start + (ring + 0.5) * width;
      const int sectors = this->SectorsAt(range);
      means.rings.push_back(
        {static_cast<std::uint32_t>(cells), sectors, static_cast<float>(sectors / fullCircle)});
      cells += sectors > 0 ? static_cast<std::size_t>(sectors) + 2 : sweep.azimuths.size();
      if (sectors == 0 && !longer)
      {
        means.reach = static_cast<float>(range);
        break;
      }
    }
    means.cells.resize(cells);
    means.spread = static_cast<float>(1.5 * std::hypot(width, widestArc)); // from cell to cell
  }

private:
  // Of the ring about a slant range, m; 0: as many as rays.
  int SectorsAt(double range)
  {
    const double ground = std::max(range * static_cast<double>(sweep.cosine), 0.0);
    if (!(side > 2.0 * ground * raySpacing))
    {
      return 0;
    }
    const double round = turn * ground;
    const double sectors =
      std::max(fewestSectors, std::floor(round / CellWidth(side, ground * raySpacing)));
    widestArc = std::max(widestArc, round / sectors);
    return static_cast<int>(sectors);
  }

  const BeamSweep& sweep;
  const double side;
  const double raySpacing; // radians
  bool longer;             // rings than gates
  int count;               // of rings to the last gate
  double width;            // m, of a ring
  double start;            // m, slant range at which the first gate begins
  double widestArc = 0.0;  // m, of a sector
};

// Parts of a cell by what its gates hold.
struct Tally : StateWeights
{
  float sum = 0.0F;  // over the echo: of codes, of Z, or of angles' cosines
  float sine = 0.0F; // over the echo, of angles

  void Add(const Tally& other, float weight)
  {
    echo += weight * other.echo;
    none += weight * other.none;
    folded += weight * other.folded;
    filtered += weight * other.filtered;
    missing += weight * other.missing;
    sum += weight * other.sum;
    sine += weight * other.sine;
  }

  float Unmeasured() const { return folded + missing + filtered; }
};

const Tally noEcho = {{0.0F, 1.0F}};

// Less of a cell is none of it: what rounding leaves.
constexpr float smallestPart = 1e-6F;

// Adds up gates, and makes the cell's value and shares of the sums.
class GateAdder
{
public:
  GateAdder(const BeamSweep& theSweep, const ValueRule& theRule)
    : sweep(theSweep)
    , rule(theRule)
  {
  }

  void Add(std::uint16_t code, float weight, Tally& to) const
  {
    if (code < GateCode::FirstValue)
    {
      to.AddNothing(code, weight);
      return;
    }
    to.echo += weight;
    if (rule.period > 0.0F)
    {
      const float angle = sweep.scale.ValueOf(code) * static_cast<float>(turn) / rule.period;
      to.sum += weight * std::cos(angle);
      to.sine += weight * std::sin(angle);
    }
    else if (rule.linear)
    {
      to.sum += weight * std::pow(10.0F, 0.1F * sweep.scale.ValueOf(code));
    }
    else
    {
      to.sum += weight * static_cast<float>(code - 1); // its number
    }
  }

  // Of a tally whose parts sum to 1.
  SweepMeans::Cell CellOf(const Tally& tally, const SweepMeans& means) const
  {
    SweepMeans::Cell cell;
    if (tally.echo + tally.Unmeasured() <= 0.0F)
    {
      return cell;
    }
    if (!(tally.echo + tally.none > 0.0F))
    {
      cell.code = tally.CodeOfNothing();
      cell.missing = 255;
      return cell;
    }
    // What was measured, and an echo, however small a part it is of the cell, is not lost.
    const auto partOf = [](float share) { return static_cast<int>(255.0F * share + 0.5F); };
    const int least = tally.echo > 0.0F ? 1 : 0;
    cell.echo = static_cast<std::uint8_t>(std::clamp(partOf(tally.echo), least, 255));
    cell.missing =
      static_cast<std::uint8_t>(std::min({partOf(tally.Unmeasured()), 254, 255 - cell.echo}));
    if (cell.echo > 0)
    {
      const float number = this->MeanNumber(tally, means) + 0.5F;
      constexpr auto first = static_cast<float>(GateScale::FirstNumber);
      cell.code = static_cast<std::uint16_t>(std::clamp(number, first, 65'535.0F));
    }
    return cell;
  }

private:
  float MeanNumber(const Tally& tally, const SweepMeans& means) const
  {
    if (rule.period > 0.0F)
    {
      const float angle = std::atan2(tally.sine, tally.sum) / static_cast<float>(turn);
      const float part = angle < 0.0F ? angle + 1.0F : angle;
      return (part * rule.period - means.scale.base) / means.scale.step;
    }
    const float mean = tally.sum / tally.echo;
    const float value = rule.linear ? 10.0F * std::log10(mean) : sweep.scale.ValueOfNumber(mean);
    return (value - means.scale.base) / means.scale.step;
  }

  const BeamSweep& sweep;
  const ValueRule& rule;
};

// The directions for which a ray stands, degrees; they may reach across north.
struct RayWidth
{
  double begin;
  double end;
};

std::vector<RayWidth> FindRayWidths(const BeamSweep& sweep)
{
  const auto end = [&sweep](std::size_t entry, double side)
  {
    return static_cast<double>(sweep.azimuths[entry]) + side * static_cast<double>(sweep.halfWidth);
  };
  const auto middle = [&sweep](std::size_t entry)
  {
    return 0.5 * (static_cast<double>(sweep.azimuths[entry]) +
                   static_cast<double>(sweep.azimuths[entry + 1]));
  };
  std::vector<RayWidth> widths;
  for (std::size_t entry = 1; entry + 1 < sweep.azimuths.size(); ++entry)
  {
    const bool gapBefore = sweep.inverseGaps[entry - 1] <= 0.0F;
    const bool gapAfter = sweep.inverseGaps[entry] <= 0.0F;
    widths.push_back({gapBefore ? end(entry, -1.0) : middle(entry - 1),
      gapAfter ? end(entry, 1.0) : middle(entry)});
  }
  return widths;
}

// Fills the cells of rings that are placed.
class SweepReducer
{
public:
  SweepReducer(const BeamSweep& theSweep, const ValueRule& theRule, SweepMeans& theMeans)
    : sweep(theSweep)
    , adder(theSweep, theRule)
    , means(theMeans)
    , rays(theSweep.azimuths.size() - 2)
  {
    tallies.resize(rays);
    closed = sweep.IsClosed();
  }

  void Reduce(double gatesPerRing)
  {
    this->WeighGates(gatesPerRing);
    const auto first = std::find_if(means.rings.begin(), means.rings.end(),
      [](const SweepMeans::Ring& ring) { return ring.sectors == 0; });
    const auto sectorRings = static_cast<std::size_t>(first - means.rings.begin());
    const std::vector<RayWidth> widths = FindRayWidths(sweep);
    for (std::size_t number = 0; number < sectorRings; ++number)
    {
      bool any = !closed;
      for (std::size_t ray = 0; ray < rays; ++ray)
      {
        this->SumUp(ray, number, tallies[ray]);
        any = any || tallies[ray].none < 1.0F;
      }
      if (any) // else the cells are made as no echo
      {
        const SweepMeans::Ring& ring = means.rings[number];
        this->SetSectors(
          static_cast<std::size_t>(ring.sectors), widths, means.cells.data() + ring.first);
      }
    }
    for (std::size_t ray = 0; ray < rays; ++ray)
    {
      const std::size_t end = sweep.held[ray + 1].end; // beyond, the cells are made as no echo
      for (std::size_t ring = sectorRings; ring < means.rings.size() && ringGates[ring].begin < end;
           ++ring)
      {
        Tally tally;
        this->SumUp(ray, ring, tally);
        if (tally.none < 1.0F)
        {
          means.cells[means.rings[ring].first + ray + 1] = adder.CellOf(tally, means);
        }
      }
    }
    for (std::size_t number = sectorRings; number < means.rings.size(); ++number)
    {
      SweepMeans::Cell* cells = means.cells.data() + means.rings[number].first;
      cells[0] = cells[rays];
      cells[rays + 1] = cells[1];
    }
  }

private:
  // The gates of a ring, the same of all rays; the weights are their parts of the ring.
  struct RingGates
  {
    std::size_t begin;
    std::size_t end;
    std::size_t firstWeight;
  };

  void WeighGates(double gatesPerRing)
  {
    const auto last = static_cast<double>(sweep.gates);
    for (std::size_t ring = 0; ring < means.rings.size(); ++ring)
    {
      const double begin = static_cast<double>(ring) * gatesPerRing;
      const double end = std::min(begin + gatesPerRing, last);
      const auto first = static_cast<std::size_t>(begin);
      RingGates gates{first, first, weights.size()};
      for (; static_cast<double>(gates.end) < end; ++gates.end)
      {
        const auto place = static_cast<double>(gates.end);
        const double part = std::min(place + 1.0, end) - std::max(place, begin);
        weights.push_back(part > static_cast<double>(smallestPart)
                            ? static_cast<float>(part / (end - begin))
                            : 0.0F);
      }
      ringGates.push_back(gates);
    }
  }

  // The part of a ray in a ring.
  void SumUp(std::size_t ray, std::size_t ring, Tally& tally) const
  {
    const RingGates& gates = ringGates[ring];
    const std::uint16_t* codes = sweep.Row(ray + 1);
    const GateRange held = Common({gates.begin, gates.end}, sweep.held[ray + 1]);
    if (held.IsEmpty() || std::all_of(codes + held.begin, codes + held.end,
                            [](std::uint16_t code) { return code == GateCode::NoEcho; }))
    {
      tally = noEcho;
      return;
    }
    tally = Tally();
    for (std::size_t gate = gates.begin; gate < gates.end; ++gate)
    {
      const float weight = weights[gates.firstWeight + gate - gates.begin];
      if (weight > 0.0F)
      {
        adder.Add(held.Holds(gate) ? codes[gate] : GateCode::NoEcho, weight, tally);
      }
    }
  }

  void SetSectors(std::size_t count, const std::vector<RayWidth>& widths, SweepMeans::Cell* cells)
  {
    sectors.assign(count, Tally());
    covered.assign(count, 0.0F);
    const double perDegree = static_cast<double>(count) / fullCircle;
    for (std::size_t ray = 0; ray < rays; ++ray)
    {
      if (closed && tallies[ray].none >= 1.0F)
      {
        continue; // where there are rays everywhere, what nothing else fills is no echo
      }
      // In sectors, from one turn before north on: never below 0.
      const double begin = (widths[ray].begin + fullCircle) * perDegree;
      const double end = (widths[ray].end + fullCircle) * perDegree;
      for (auto sector = static_cast<std::size_t>(begin); static_cast<double>(sector) < end;
           ++sector)
      {
        const auto place = static_cast<double>(sector);
        const double part = std::min(place + 1.0, end) - std::max(place, begin);
        if (part > static_cast<double>(smallestPart))
        {
          const std::size_t turned = sector < count ? sector : sector - count;
          const std::size_t at = turned < count ? turned : turned - count;
          sectors[at].Add(tallies[ray], static_cast<float>(part));
          covered[at] += static_cast<float>(part);
        }
      }
    }
    for (std::size_t sector = 0; sector < count; ++sector)
    {
      Tally& tally = sectors[sector];
      const float rest = 1.0F - covered[sector];
      (closed ? tally.none : tally.missing) += rest > smallestPart ? rest : 0.0F;
      cells[sector + 1] = adder.CellOf(sectors[sector], means);
    }
    cells[0] = cells[count];
    cells[count + 1] = cells[1];
  }

  const BeamSweep& sweep;
  const GateAdder adder;
  SweepMeans& means;
  const std::size_t rays;
  std::vector<float> weights; // of the gates of each ring, one ring after the other
  std::vector<RingGates> ringGates;
  bool closed;                // no gap between rays is too wide
  std::vector<Tally> tallies; // of one ring: its parts along the rays
  std::vector<Tally> sectors; // and its sectors
  std::vector<float> covered; // parts of the sectors in which rays stand
};

// A scale for means of the gates' values; of angles one of the whole circle.
GateScale ScaleOf(const BeamSweep& sweep, const ValueRule& rule)
{
  if (rule.period > 0.0F)
  {
    const float step = rule.period / angleCodes;
    return {-step * static_cast<float>(GateScale::FirstNumber), step};
  }
  const CodeRange codes = FindValueCodes(sweep);
  return codes.IsEmpty()
           ? GateScale()
           : GateScale::Between(sweep.scale.ValueOf(codes.least), sweep.scale.ValueOf(codes.most));
}

} // namespace

SweepMeans MakeSweepMeans(const BeamSweep& sweep, const ValueRule& rule, double side)
{
  SweepMeans means;
  constexpr double asLong = 1.0 + 1e-6; // as a gate, but for rounding
  const double gatesPerSide = side * static_cast<double>(sweep.gatesPerMetre);
  if (rule.nearest || sweep.gates < 1 || !(gatesPerSide > asLong))
  {
    return means;
  }
  RingPlan plan(sweep, side);
  plan.PlaceIn(means);
  if (means.rings.size() == 1 && means.reach < std::numeric_limits<float>::infinity())
  {
    return {}; // the gates serve everywhere
  }
  means.scale = ScaleOf(sweep, rule);
  SweepReducer(sweep, rule, means).Reduce(plan.GatesPerRing());
  return means;
}

} // namespace nexrad
