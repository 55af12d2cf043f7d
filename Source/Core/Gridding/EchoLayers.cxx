// SPDX-License-Identifier: BSD-3-Clause
#include "Gridding/EchoLayers.h"

#include "Geometry/Angles.h"
#include "Gridding/BeamVolume.h"
#include "Gridding/LayerShares.h"
#include "Gridding/TiltEdges.h"
#include "Gridding/TiltGap.h"
#include "Gridding/TiltMeans.h"
#include "Model/Elevation.h"

#include <algorithm>
#include <cmath>

namespace nexrad
{

namespace
{

constexpr std::size_t sectors = TiltMeans::Sectors;
constexpr std::size_t rings = TiltMeans::Rings / 2;
constexpr double ringWidth = 2.0 * TiltMeans::RingWidth;
constexpr std::size_t knots = std::tuple_size_v<EchoLayers::Changes>;
constexpr float perDecibel = 2.0F; // units of a stored change

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
  std::vector<const BeamSweep*> tilts;
  for (const BeamSweep* sweep : sorted)
  {
    if (tilts.empty() || sweep->elevation - tilts.back()->elevation > static_cast<float>(SameTilt))
    {
      tilts.push_back(sweep);
    }
    else if (sweep->codes.size() > tilts.back()->codes.size())
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

  // Writes the changes of one cell; false when there are none.
  bool Change(std::size_t sector, std::size_t ring, float share, std::int8_t* to)
  {
    this->PlaceRing(ring);
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
    for (std::size_t knot = 0; knot < knots; ++knot)
    {
      const LevelPlaces& at = places[ring * knots + knot];
      const float upper = tilts[gap + 1].At(sector, at.nearer);
      const float level = upper + at.way * (tilts[gap].At(sector, at.farther) - upper);
      const float straight = upwards.At(static_cast<float>(ShareOf(knot)));
      const float change = share * at.part * (level - straight);
      const bool known = at.part > 0.0F && !std::isnan(change);
      to[knot] = known ? static_cast<std::int8_t>(
                           std::clamp(std::round(perDecibel * change), -127.0F, 127.0F))
                       : std::int8_t(0);
      any = any || to[knot] != 0;
    }
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

std::vector<TiltEdges> EdgesOf(const std::vector<TiltMeans>& tilts, double beamWidth)
{
  std::vector<BeamTilt> angles(tilts.size());
  for (std::size_t i = 0; i < tilts.size(); ++i)
  {
    angles[i].elevation = tilts[i].Elevation();
    angles[i].tangent =
      static_cast<float>(std::tan(static_cast<double>(tilts[i].Elevation()) * RadiansPerDegree));
  }
  return FindEdges(angles, beamWidth);
}

} // namespace

EchoLayers::EchoLayers(
  const std::vector<BeamSweep>& sweeps, double beamWidth, const BeamModel& beam, double ceiling)
  : ringsPerTangent(static_cast<float>(2.0 * beam.EffectiveRadius() / ringWidth))
{
  constexpr float least = 0.15F; // smaller shares are noise: echo without any order has 0.12
  std::vector<TiltMeans> tilts;
  for (const BeamSweep* sweep : OneOfEachTilt(sweeps))
  {
    tilts.emplace_back(*sweep, beam);
  }
  const std::vector<TiltEdges> edges = EdgesOf(tilts, beamWidth);
  const LayerShares shares(tilts, beam);
  for (std::size_t i = 0; i + 1 < tilts.size() && i < MostGaps; ++i)
  {
    Gap gap{tilts[i].Elevation(), tilts[i + 1].Elevation(), {}};
    GapWork work(tilts, edges, i, beam, ceiling);
    for (std::size_t sector = 0; sector < sectors; ++sector)
    {
      const bool echo = tilts[i].HasEcho(sector) || tilts[i + 1].HasEcho(sector);
      for (std::size_t ring = 0; echo && ring < rings; ++ring)
      {
        const float share = shares.At(i, sector, (static_cast<double>(ring) + 0.5) * ringWidth);
        std::array<std::int8_t, knots> changes{};
        if (share >= least && work.Change(sector, ring, share, changes.data()))
        {
          gap.changes.resize(sectors * rings * knots);
          std::copy(changes.begin(), changes.end(),
            gap.changes.begin() + static_cast<std::ptrdiff_t>((sector * rings + ring) * knots));
        }
      }
    }
    gaps.push_back(std::move(gap));
  }
  this->MarkGaps();
}

// A cell is marked when something is changed within as far as echo moves in some minutes.
void EchoLayers::MarkGaps()
{
  constexpr std::size_t sectorsBeside = 3;
  constexpr std::size_t ringsBeside = 3;
  for (std::size_t number = 0; number < gaps.size(); ++number)
  {
    const std::vector<std::int8_t>& changes = gaps[number].changes;
    if (changes.empty())
    {
      continue;
    }
    const std::uint32_t mark = std::uint32_t(1) << number;
    marks.resize(sectors * rings);
    for (std::size_t cell = 0; cell < sectors * rings; ++cell)
    {
      const std::int8_t* of = changes.data() + cell * knots;
      if (std::all_of(of, of + knots, [](std::int8_t change) { return change == 0; }))
      {
        continue;
      }
      const std::size_t ring = cell % rings;
      const std::size_t end = std::min(ring + ringsBeside + 1, rings);
      for (std::size_t turn = sectors - sectorsBeside; turn <= sectors + sectorsBeside; ++turn)
      {
        std::uint32_t* row = marks.data() + (cell / rings + turn) % sectors * rings;
        for (std::size_t each = std::max(ring, ringsBeside) - ringsBeside; each < end; ++each)
        {
          row[each] |= mark;
        }
      }
    }
  }
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

std::uint32_t EchoLayers::GapsAt(const ColumnDirection& direction) const
{
  const auto ring = static_cast<std::size_t>(direction.halfTangent * ringsPerTangent);
  return marks.empty() || ring >= rings
           ? 0
           : marks[static_cast<std::size_t>(direction.azimuth) * rings + ring];
}

void EchoLayers::Add(int gap, const ColumnDirection& direction, float weight, Changes& to) const
{
  const float ringPlace = std::clamp(
    direction.halfTangent * ringsPerTangent - 0.5F, 0.0F, static_cast<float>(rings) - 1.001F);
  const float sectorPlace = direction.azimuth + static_cast<float>(sectors) - 0.5F;
  const auto ring = static_cast<std::size_t>(ringPlace);
  const auto sector = static_cast<std::size_t>(sectorPlace);
  const float along = ringPlace - static_cast<float>(ring);
  const float across = sectorPlace - static_cast<float>(sector);
  const std::int8_t* changes = gaps[static_cast<std::size_t>(gap)].changes.data();
  const std::int8_t* first = changes + (sector % sectors * rings + ring) * knots;
  const std::int8_t* second = changes + ((sector + 1) % sectors * rings + ring) * knots;
  for (std::size_t knot = 0; knot < knots; ++knot)
  {
    const auto on = [along, knot](const std::int8_t* ray)
    {
      const auto near = static_cast<float>(ray[knot]);
      return near + along * (static_cast<float>(ray[knots + knot]) - near);
    };
    to[knot] += weight / perDecibel * (on(first) + across * (on(second) - on(first)));
  }
}

std::size_t EchoLayers::MemoryBytes() const
{
  std::size_t bytes = marks.size() * sizeof(std::uint32_t);
  for (const Gap& gap : gaps)
  {
    bytes += sizeof(Gap) + gap.changes.size();
  }
  return bytes;
}

} // namespace nexrad
