// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Gridding/BeamRows.h"

#include "nexrad/Geometry/Angles.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace nexrad
{

namespace
{

// Columns are merged in strips, so that whole cache lines of each level are written at a time, of
// states, too, and so that neighbouring columns look the same sweep up one after the other.
constexpr int stripWidth = 64;

// One strip's columns, level by level within a column.
template <class Value>
class Strip
{
public:
  // Columns do not begin a power of two apart, where a cache would keep only a few of them.
  explicit Strip(std::size_t levelCount)
    : stride(levelCount + 64 / sizeof(Value))
    , values(stride * stripWidth)
  {
  }

  void Set(int column, const std::vector<Value>& from)
  {
    std::copy(
      from.begin(), from.end(), values.begin() + static_cast<std::ptrdiff_t>(stride) * column);
  }

  // Writes a level of the first `count` columns to where the first of them stands.
  void Write(std::size_t level, int count, Value* to) const
  {
    const Value* from = values.data() + level;
    for (int column = 0; column < count; ++column)
    {
      to[column] = from[static_cast<std::size_t>(column) * stride];
    }
  }

private:
  std::size_t stride;
  std::vector<Value> values;
};

// A motion in the grid's directions as a radar sees it over a column.
ColumnMotion MotionSeenBy(
  const MergeSite& site, const ColumnDirection& column, const Velocity& velocity)
{
  const float azimuth = column.azimuth * static_cast<float>(RadiansPerDegree);
  const float sine = std::sin(azimuth);
  const float cosine = std::cos(azimuth);
  const double diameter = 2.0 * static_cast<double>(site.context.effectiveRadius);
  const auto north =
    static_cast<float>((site.north[0] * velocity.east + site.north[1] * velocity.north) / diameter);
  const auto east =
    static_cast<float>((site.north[1] * velocity.east - site.north[0] * velocity.north) / diameter);
  return {north * cosine + east * sine, east * cosine - north * sine};
}

class StripMerger
{
public:
  StripMerger(
    const std::vector<MergeSite>& theSites, const RowOptions& theOptions, GriddedVolume& theVolume)
    : sites(theSites)
    , options(theOptions)
    , volume(theVolume)
    , levels(static_cast<std::size_t>(theOptions.levels))
    , ancillary(!theVolume.ancillary.age.empty())
    , column(theOptions.levels, theOptions.strategy,
        theSites.empty() ? ValueRule() : theSites.front().context.rule, ancillary, theOptions.trend)
    , values(levels)
    , states(levels)
    , ages(ancillary ? levels : 0)
    , weights(ancillary ? levels : 0)
    , radars(ancillary ? levels : 0)
    , nearestSites(ancillary ? levels : 0)
    , samples(theSites.size())
    , surroundings(theSites.size())
  {
  }

  // Merges the columns x to x + count − 1 of a row.
  void Merge(int x, int y, int count)
  {
    present.clear();
    for (std::size_t i = 0; i < sites.size(); ++i)
    {
      this->Sample(i, x, y, count);
    }
    anyEcho = false;
    for (int i = 0; i < count && !present.empty(); ++i)
    {
      this->MergeColumn(x + i, y, i);
    }
    this->Write(x, y, count);
  }

private:
  // What a radar has about a column: the highest sweep that holds something, whether layers change
  // anything, how both move; and the tilts from the first to the last that scanned it, where all of
  // these found nothing.
  struct Surroundings
  {
    std::uint8_t top = 0;
    bool layers = false;
    const QuietZones::Tilt* known = nullptr; // of each tilt where none has an echo; or nullptr
    ColumnMotion motion;
    bool quiet = false;
    std::size_t firstTilt = 0;
    std::size_t endTilt = 0; // firstTilt where no tilt scanned it
  };

  // A radar that sees columns of the strip.
  struct Present
  {
    std::size_t site;
    int begin; // first of its columns in the strip
    int end;
  };

  void Sample(std::size_t number, int x, int y, int count)
  {
    const MergeSite& site = sites[number];
    const SiteGeometry& geometry = *site.geometry;
    int begin = std::max(x, geometry.BeginX()) - x;
    int end = std::min(x + count, geometry.EndX()) - x;
    if (y < geometry.BeginY() || y >= geometry.EndY() || begin >= end)
    {
      return;
    }
    const ColumnDirection* directions = geometry.Row(y) + (x - geometry.BeginX());
    while (begin < end && directions[begin].halfTangent > site.reach)
    {
      ++begin;
    }
    while (begin < end && directions[end - 1].halfTangent > site.reach)
    {
      --end;
    }
    if (begin == end)
    {
      return;
    }
    present.push_back({number, begin, end});
    samples[number].resize(site.tilts.size() * stripWidth); // of few radars, on a large grid
    this->SurveyColumns(number, directions, x, y, begin, end);
    const std::array<Surroundings, stripWidth>& about = surroundings[number];
    const std::size_t tilts = site.tilts.size();
    for (std::size_t tilt = 0; tilt < tilts; ++tilt)
    {
      TiltSample* to = samples[number].data() + tilt;
      for (int i = begin; i < end; ++i)
      {
        if (!about[static_cast<std::size_t>(i)].quiet)
        {
          to[static_cast<std::size_t>(i) * tilts] =
            this->SampleColumn(site, tilt, directions[i], about[static_cast<std::size_t>(i)]);
        }
      }
    }
  }

  // What is known of the columns before their tilts are looked up.
  void SurveyColumns(
    std::size_t number, const ColumnDirection* directions, int x, int y, int begin, int end)
  {
    const MergeSite& site = sites[number];
    for (int i = begin; i < end; ++i)
    {
      Surroundings& about = surroundings[number][static_cast<std::size_t>(i)];
      about.top = site.mask.TopOver(directions[i]);
      about.layers = site.layers.AnyAt(directions[i]);
      about.known = site.zones.At(directions[i]);
      if ((about.top > 0 || about.layers) && options.motion != nullptr)
      {
        about.motion = MotionSeenBy(site, directions[i], options.motion->At(x + i, y));
      }
      TiltSample* to = samples[number].data() + static_cast<std::size_t>(i) * site.tilts.size();
      this->FindQuietTilts(site, directions[i], about, to);
    }
  }

  // Finds out whether a radar has no echo over a column, and the tilts that say so. Of these the
  // first and the last alone are sampled, with whose beams ends what was scanned, and the last only
  // where it is not above the grid.
  void FindQuietTilts(const MergeSite& site, const ColumnDirection& direction, Surroundings& about,
    TiltSample* to) const
  {
    const QuietZones::Tilt* known = about.known;
    about.quiet = false;
    if (known == nullptr || about.top >= site.lowestQuiet || about.layers)
    {
      return;
    }
    about.firstTilt = about.endTilt = 0;
    for (std::size_t tilt = 0; tilt < site.tilts.size(); ++tilt)
    {
      bool none = known[tilt] == QuietZones::Tilt::NoEcho;
      if (known[tilt] == QuietZones::Tilt::Unknown)
      {
        to[tilt] = this->SampleColumn(site, tilt, direction, about);
        none = to[tilt].state == VoxelState::NoEcho && to[tilt].fade == 1.0F;
        if (!none && to[tilt].state != VoxelState::NotScanned)
        {
          return;
        }
      }
      if (none && about.endTilt > about.firstTilt && about.endTilt != tilt)
      {
        return; // above a tilt that did not scan it
      }
      about.firstTilt = none && about.endTilt == about.firstTilt ? tilt : about.firstTilt;
      about.endTilt = none ? tilt + 1 : about.endTilt;
    }
    about.quiet = true;
    const auto sample = [&](std::size_t tilt)
    {
      if (known[tilt] == QuietZones::Tilt::NoEcho)
      {
        to[tilt] = this->SampleColumn(site, tilt, direction, about);
      }
    };
    if (about.firstTilt < about.endTilt)
    {
      const std::size_t last = about.endTilt - 1;
      sample(about.firstTilt);
      site.levels.AreBelow(site.edges[last].tangent, direction.halfTangent) ? void() : sample(last);
    }
  }

  TiltSample SampleColumn(const MergeSite& site, std::size_t tilt, const ColumnDirection& direction,
    const Surroundings& about) const
  {
    if (about.known != nullptr && about.known[tilt] == QuietZones::Tilt::NotScanned)
    {
      return {};
    }
    const QuietTilt& quiet = site.quiet[tilt];
    const ColumnMotion* motion =
      about.top > 0 && options.motion != nullptr ? &about.motion : nullptr;
    if (about.top >= quiet.elevation)
    {
      return SampleTilt(site.tilts, tilt, direction, site.context, motion);
    }
    // What lower tilts hold may come to a look alone, which moves at its height.
    const bool asked = quiet.alone && about.top >= site.lowestQuiet;
    const std::optional<TiltSample> known =
      asked ? std::nullopt : SampleQuiet(quiet, direction, site.context);
    return known ? *known : SampleTilt(site.tilts, tilt, direction, site.context, motion, true);
  }

  void MergeColumn(int x, int y, int place)
  {
    column.Clear();
    order.clear();
    bool echo = false;
    for (const Present& each : present)
    {
      if (place >= each.begin && place < each.end)
      {
        const MergeSite& site = sites[each.site];
        const SiteGeometry& geometry = *site.geometry;
        const float halfTangent = geometry.Row(y)[x - geometry.BeginX()].halfTangent;
        if (halfTangent <= site.reach)
        {
          order.push_back({halfTangent, each.site});
          echo = echo || !surroundings[each.site][static_cast<std::size_t>(place)].quiet;
        }
      }
    }
    if (echo) // else it decides nothing in what order and how much they count
    {
      std::sort(order.begin(), order.end());
    }
    for (const auto& [halfTangent, number] : order)
    {
      const MergeSite& site = sites[number];
      const Surroundings& about = surroundings[number][static_cast<std::size_t>(place)];
      SiteColumn seen;
      seen.site = site.number;
      seen.halfTangent = halfTangent;
      seen.weight = echo ? this->WeightAt(site, halfTangent) : 1.0F;
      seen.levels = &site.levels;
      seen.edges = &site.edges;
      seen.samples = samples[number].data() + static_cast<std::size_t>(place) * site.tilts.size();
      // Formulas G12: what layers of echo change over the column.
      const ColumnMotion* motion = options.motion != nullptr ? &about.motion : nullptr;
      const bool layered =
        about.layers &&
        site.layers.Find(site.geometry->Row(y)[x - site.geometry->BeginX()], motion, layers);
      seen.layers = layered ? layers.data() : nullptr;
      if (about.quiet)
      {
        column.AddQuiet(seen, about.firstTilt, about.endTilt);
      }
      else
      {
        column.Add(seen);
      }
    }
    anyEcho = anyEcho || echo;
    column.Finish(volume.fill);
    if (options.fillColumns)
    {
      column.FillColumn();
    }
    this->Keep(place);
  }

  // Formulas W4, the part of the distance along the ground; the heights' part is in the levels.
  float WeightAt(const MergeSite& site, float halfTangent) const
  {
    if (options.strategy != OverlapStrategy::Distance)
    {
      return 1.0F;
    }
    const float chord = 2.0F * site.levels.radius * halfTangent /
                        std::sqrt(1.0F + halfTangent * halfTangent) / options.overlapLength;
    return std::exp(-chord * chord);
  }

  void Keep(int place)
  {
    values.Set(place, column.Values());
    states.Set(place, column.States());
    if (ancillary)
    {
      ages.Set(place, column.Ages());
      weights.Set(place, column.Weights());
      radars.Set(place, column.Radars());
      nearestSites.Set(place, column.NearestSites());
    }
  }

  void Write(int x, int y, int count) const
  {
    const VoxelBlock& block = options.block;
    const auto width = static_cast<std::size_t>(block.Size(0));
    const auto plane = width * static_cast<std::size_t>(block.Size(1));
    std::size_t at = static_cast<std::size_t>(y - block.begin[1]) * width +
                     static_cast<std::size_t>(x - block.begin[0]);
    for (auto level = static_cast<std::size_t>(block.begin[2]);
         level < static_cast<std::size_t>(block.end[2]); ++level, at += plane)
    {
      const auto write = [&](bool any, const auto& strip, auto& array, auto nothing)
      {
        auto* to = array.data() + at;
        any ? strip.Write(level, count, to) : std::fill(to, to + count, nothing);
      };
      const bool seen = !present.empty();
      write(anyEcho, values, volume.values, volume.fill);
      write(seen, states, volume.states, VoxelState::NotScanned);
      if (ancillary)
      {
        write(seen, ages, volume.ancillary.age, 0.0F);
        write(seen, weights, volume.ancillary.weight, 0.0F);
        write(seen, radars, volume.ancillary.radars, std::uint8_t(0));
        write(seen, nearestSites, volume.ancillary.nearestSite, BeamColumn::NoSite);
      }
    }
  }

  const std::vector<MergeSite>& sites;
  const RowOptions& options;
  GriddedVolume& volume;
  const std::size_t levels;
  const bool ancillary;
  BeamColumn column;
  Strip<float> values;
  Strip<VoxelState> states;
  Strip<float> ages;
  Strip<float> weights;
  Strip<std::uint8_t> radars;
  Strip<std::uint8_t> nearestSites;
  std::vector<std::vector<TiltSample>> samples; // of each site seen: tilts within columns
  std::vector<std::array<Surroundings, stripWidth>> surroundings; // of each site
  std::vector<Present> present;
  bool anyEcho = false;                             // there may be some in the strip
  std::vector<std::pair<float, std::size_t>> order; // distance and site
  std::vector<EchoLayers::Changes> layers;          // of the site that is added, by gap
};

} // namespace

void MergeRows(const std::vector<MergeSite>& sites, const RowOptions& options, int beginRow,
  int endRow, GriddedVolume& volume)
{
  StripMerger merger(sites, options, volume);
  const int end = options.block.end[0];
  // Rows within strips: what the sweeps have about a strip is still in the cache for the next row.
  for (int x = options.block.begin[0]; x < end; x += stripWidth)
  {
    for (int y = beginRow; y < endRow; ++y)
    {
      merger.Merge(x, y, std::min(stripWidth, end - x));
    }
  }
}

} // namespace nexrad
