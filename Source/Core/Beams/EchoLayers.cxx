// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Beams/EchoLayers.h"

#include "nexrad/Beams/BeamSweep.h"
#include "nexrad/Beams/TiltEdges.h"
#include "nexrad/Beams/TiltMeans.h"
#include "nexrad/Model/Elevation.h"

#include <algorithm>
#include <cmath>

namespace nexrad
{

namespace
{

constexpr std::size_t sectors = TiltMeans::Sectors;
constexpr std::size_t rings = EchoLayers::Rings;
constexpr std::size_t ringsOfMeans = TiltMeans::Rings / rings;
constexpr double ringWidth = static_cast<double>(ringsOfMeans) * TiltMeans::RingWidth; // m
constexpr std::size_t ringsPerShare = rings / LayerShares::Rings;
constexpr std::size_t knots = 3;               // quarters of the way between two tilts
constexpr std::size_t codesOfCell = knots + 1; // of the changes, and of the most
constexpr std::size_t codesOfRow = rings * codesOfCell;

// One sweep of each tilt, the one with the most gates, ascending.
std::vector<const BeamSweep*> OneOfEachTilt(const std::vector<BeamSweep>& sweeps)
{
  std::vector<const BeamSweep*> sorted;
  for (const BeamSweep& sweep : sweeps)
  {
    sorted.push_back(&sweep);
  }
  std::stable_sort(sorted.begin(), sorted.end(),
    [](const BeamSweep* a, const BeamSweep* b) { return a->elevation < b->elevation; });
  const auto gatesOf = [](const BeamSweep& sweep)
  { return sweep.azimuths.size() * (static_cast<std::size_t>(sweep.gates) + 1); };
  std::vector<const BeamSweep*> tilts;
  for (const BeamSweep* sweep : sorted)
  {
    if (tilts.empty() || sweep->elevation - tilts.back()->elevation > static_cast<float>(SameTilt))
    {
      tilts.push_back(sweep);
    }
    else if (gatesOf(*sweep) > gatesOf(*tilts.back()))
    {
      tilts.back() = sweep;
    }
  }
  return tilts;
}

// Where a point between two tilts is seen at its own height, in rings of TiltMeans.
struct LevelPlaces
{
  float over = 0.0F;    // the point itself
  float nearer = 0.0F;  // the upper tilt
  float farther = 0.0F; // the lower one
  float way = 0.0F;     // from nearer to farther, 0…1
  float part = 0.0F;    // how much the two count, by their distance
};

LevelPlaces FindPlaces(
  double lower, double upper, double share, double distance, const BeamModel& beam)
{
  // Echo that far apart on either side says little of what lies between.
  constexpr double full = 50'000.0; // m
  const double height = beam.HeightOver(distance, lower + share * (upper - lower));
  LevelPlaces places;
  places.over = static_cast<float>(distance / TiltMeans::RingWidth);
  if (!(height > 0.0 && std::isfinite(height)))
  {
    return places;
  }
  const double nearer = beam.DistanceAt(height, upper);
  const double farther = beam.DistanceAt(height, lower);
  places.nearer = static_cast<float>(nearer / TiltMeans::RingWidth);
  places.farther = static_cast<float>(farther / TiltMeans::RingWidth);
  places.way = static_cast<float>((distance - nearer) / (farther - nearer));
  const double near = std::min(1.0, full / (farther - nearer));
  places.part = farther > nearer ? static_cast<float>(near * near) : 0.0F;
  return places;
}

std::int8_t CodeOf(float number)
{
  return static_cast<std::int8_t>(std::clamp(number, -127.0F, 127.0F));
}

// Works out the changes in one gap.
class GapWork
{
public:
  GapWork(const std::vector<TiltMeans>& theTilts, const std::vector<TiltEdges>& theEdges,
    std::size_t theGap, const BeamModel& theBeam, double theCeiling)
    : tilts(theTilts)
    , edges(theEdges)
    , gap(theGap)
    , beam(theBeam)
    , ceiling(theCeiling)
    , places(rings * knots)
  {
  }

  static double ShareOf(std::size_t knot)
  {
    return static_cast<double>(knot + 1) / static_cast<double>(knots + 1);
  }

  // Writes the codes of one cell; false when nothing is changed there.
  bool Change(std::size_t sector, std::size_t ring, float share, std::int8_t* to)
  {
    this->PlaceRing(ring);
    const TiltMeans::Span below = tilts[gap].EchoIn(sector);
    const TiltMeans::Span above = tilts[gap + 1].EchoIn(sector);
    if (places[ring * knots + knots - 1].farther < std::min(below.begin, above.begin) ||
        places[ring * knots].nearer > std::max(below.end, above.end))
    {
      return false; // without echo at any of the places
    }
    const float over = places[ring * knots].over;
    TiltGapValues column;
    column.lower = tilts[gap].At(sector, over);
    column.upper = this->UpperAt(sector, over);
    if (std::isnan(column.lower + column.upper))
    {
      return false;
    }
    column.lowerEcho = column.lower != 0.0F;
    column.upperEcho = column.upper != 0.0F;
    if (gap > 0)
    {
      column.below = tilts[gap - 1].At(sector, over);
    }
    if (gap + 2 < tilts.size())
    {
      column.above = tilts[gap + 2].At(sector, over);
    }
    const TiltInterpolation upwards(column, edges[gap]);
    bool any = false;
    float most = 0.0F;
    for (std::size_t knot = 0; knot < knots; ++knot)
    {
      const LevelPlaces& at = places[ring * knots + knot];
      const float upper = tilts[gap + 1].At(sector, at.nearer);
      const float level = upper + at.way * (tilts[gap].At(sector, at.farther) - upper);
      const float straight = upwards.At(static_cast<float>(ShareOf(knot)));
      const float change = share * at.part * (level - straight);
      const bool known = at.part > 0.0F && !std::isnan(change);
      to[knot] = known ? CodeOf(std::round(change / EchoLayers::Precision)) : std::int8_t(0);
      any = any || to[knot] != 0;
      most = std::fmax(most, known ? level : 0.0F);
    }
    constexpr float gatesVary = 1.0F; // dB, about the means of the cells
    to[knots] = CodeOf(std::ceil(most + gatesVary));
    return any;
  }

private:
  // No echo beyond the last gate where the tilt is above the weather (Formulas G4).
  float UpperAt(std::size_t sector, float place) const
  {
    const TiltMeans& upper = tilts[gap + 1];
    const float mean = upper.At(sector, place);
    const bool above = std::isnan(mean) && upper.Ends(place) &&
                       beam.HeightOver(static_cast<double>(place) * TiltMeans::RingWidth,
                         static_cast<double>(upper.Elevation())) > ceiling;
    return above ? 0.0F : mean;
  }

  // Most rings have no cell that needs it.
  void PlaceRing(std::size_t ring)
  {
    if (placed[ring])
    {
      return;
    }
    placed[ring] = true;
    const auto lower = static_cast<double>(tilts[gap].Elevation());
    const auto upper = static_cast<double>(tilts[gap + 1].Elevation());
    const double distance = (static_cast<double>(ring) + 0.5) * ringWidth;
    for (std::size_t knot = 0; knot < knots; ++knot)
    {
      places[ring * knots + knot] = FindPlaces(lower, upper, ShareOf(knot), distance, beam);
    }
  }

  const std::vector<TiltMeans>& tilts;
  const std::vector<TiltEdges>& edges;
  const std::size_t gap;
  const BeamModel beam;
  const double ceiling;            // m above the antenna, above which there is no weather
  std::vector<LevelPlaces> places; // rings × knots, of the rings that are placed
  std::array<bool, rings> placed{};
};

// Marks of cells, by sector and ring, together with those as far as echo moves in some minutes.
std::vector<std::uint32_t> Widen(const std::vector<std::uint32_t>& marks)
{
  constexpr std::size_t beside = 3; // sectors and rings, to either side
  std::vector<std::uint32_t> widened(marks.size());
  for (std::size_t cell = 0; cell < marks.size(); ++cell)
  {
    if (marks[cell] == 0)
    {
      continue;
    }
    const std::size_t ring = cell % rings;
    const std::size_t end = std::min(ring + beside + 1, rings);
    for (std::size_t turn = sectors - beside; turn <= sectors + beside; ++turn)
    {
      const std::size_t row = (cell / rings + turn) % sectors * rings;
      for (std::size_t each = std::max(ring, beside) - beside; each < end; ++each)
      {
        widened[row + each] |= marks[cell];
      }
    }
  }
  return widened;
}

} // namespace

EchoLayers::EchoLayers(
  const std::vector<BeamSweep>& sweeps, double beamWidth, const BeamModel& beam, double ceiling)
  : ringsPerTangent(static_cast<float>(2.0 * beam.EffectiveRadius() / ringWidth))
{
  constexpr float least = 0.15F; // smaller shares are noise: echo without any order has 0.12
  std::vector<TiltMeans> tilts;
  std::vector<float> elevations;
  for (const BeamSweep* sweep : OneOfEachTilt(sweeps))
  {
    tilts.emplace_back(*sweep, beam);
    elevations.push_back(sweep->elevation);
  }
  const std::vector<TiltEdges> edges = FindEdges(elevations, beamWidth);
  const LayerShares shares(tilts, beam);
  std::vector<std::uint32_t> changed; // bits of gaps, by cell
  Gap gap;                            // its memory grows for one gap after the other
  for (std::size_t i = 0; i + 1 < tilts.size() && i < MostGaps; ++i)
  {
    gap.lower = tilts[i].Elevation();
    gap.upper = tilts[i + 1].Elevation();
    gap.rows.clear();
    gap.changes.clear();
    GapWork work(tilts, edges, i, beam, ceiling);
    for (std::size_t sector = 0; sector < sectors; ++sector)
    {
      if (!tilts[i].HasEcho(sector) && !tilts[i + 1].HasEcho(sector))
      {
        continue;
      }
      const float* row = shares.Row(i, sector);
      for (std::size_t ring = 0; ring < rings; ++ring)
      {
        const float share = row[ring / ringsPerShare];
        std::array<std::int8_t, codesOfCell> changes{};
        if (share >= least && work.Change(sector, ring, share, changes.data()))
        {
          changed.resize(sectors * rings);
          changed[sector * rings + ring] |= std::uint32_t(1) << i;
          std::copy(changes.begin(), changes.end(), gap.RowOf(sector) + ring * codesOfCell);
        }
      }
    }
    gaps.push_back(gap);
  }
  marks = Widen(changed);
}

std::int8_t* EchoLayers::Gap::RowOf(std::size_t sector)
{
  if (changes.empty())
  {
    rows.resize(sectors);
    changes.resize(codesOfRow);
  }
  if (rows[sector] == 0)
  {
    rows[sector] = static_cast<std::uint32_t>(changes.size());
    changes.resize(changes.size() + codesOfRow);
  }
  return changes.data() + rows[sector];
}

int EchoLayers::FindGap(float lower, float upper) const
{
  constexpr auto same = static_cast<float>(SameTilt);
  const auto found = std::find_if(gaps.begin(), gaps.end(),
    [lower, upper](const Gap& gap)
    { return std::abs(gap.lower - lower) <= same && std::abs(gap.upper - upper) <= same; });
  return found != gaps.end() && !found->changes.empty() ? static_cast<int>(found - gaps.begin())
                                                        : -1;
}

EchoLayers::Place EchoLayers::FindPlace(const ColumnDirection& direction) const
{
  const float ringPlace = std::clamp(
    direction.halfTangent * ringsPerTangent - 0.5F, 0.0F, static_cast<float>(rings) - 1.001F);
  const float sectorPlace = direction.azimuth + static_cast<float>(sectors) - 0.5F;
  const auto ring = static_cast<std::size_t>(ringPlace);
  const auto sector = static_cast<std::size_t>(sectorPlace);
  return {sector % sectors, (sector + 1) % sectors, ring * codesOfCell,
    ringPlace - static_cast<float>(ring), sectorPlace - static_cast<float>(sector)};
}

void EchoLayers::Add(int gap, const Place& place, float weight, Changes& to) const
{
  const Gap& in = gaps[static_cast<std::size_t>(gap)];
  const std::int8_t* first = in.changes.data() + in.rows[place.first] + place.cell;
  const std::int8_t* second = in.changes.data() + in.rows[place.second] + place.cell;
  for (std::size_t knot = 0; knot < knots; ++knot)
  {
    const auto on = [&place, knot](const std::int8_t* ray)
    {
      const auto near = static_cast<float>(ray[knot]);
      return near + place.along * (static_cast<float>(ray[codesOfCell + knot]) - near);
    };
    to.atQuarters[knot + 1] +=
      Precision * weight * (on(first) + place.across * (on(second) - on(first)));
  }
  for (const std::int8_t* ray : {first, second})
  {
    to.most = std::max(to.most, static_cast<float>(std::max(ray[knots], ray[codesOfCell + knots])));
  }
}

std::size_t EchoLayers::MemoryBytes() const
{
  std::size_t bytes = marks.size() * sizeof(std::uint32_t);
  for (const Gap& gap : gaps)
  {
    bytes += sizeof(Gap) + gap.rows.size() * sizeof(std::uint32_t) + gap.changes.size();
  }
  return bytes;
}

} // namespace nexrad
