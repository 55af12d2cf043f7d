// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Gridding/BeamRows.h"

#include "nexrad/Geometry/Angles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace nexrad
{

namespace
{

// Columns are merged in strips, so that whole cache lines of each level are written at a time, of
// states, too, and so that neighbouring columns look the same sweep up one after the other.
constexpr int stripWidth = 64;

// One strip's columns, column by column within a level.
template <class Value>
class Strip
{
public:
  explicit Strip(std::size_t levelCount)
    : values(levelCount * stripWidth)
  {
  }

  void Set(int column, const std::vector<Value>& from)
  {
    Value* to = values.data() + column;
    for (const Value value : from)
    {
      *to = value;
      to += stripWidth;
    }
  }

  void Fill(Value value) { std::fill(values.begin(), values.end(), value); }

  // A level of all columns.
  const Value* Row(std::size_t level) const { return values.data() + level * stripWidth; }
  // Writes a level of the first `count` columns to where the first of them stands.
  void Write(std::size_t level, int count, Value* to) const
  {
    std::copy_n(this->Row(level), count, to);
  }

private:
  std::vector<Value> values;
};

bool HasNoEcho(QuietZones::Tilt tilt)
{
  return tilt == QuietZones::Tilt::NoEcho || tilt == QuietZones::Tilt::AgingNoEcho;
}

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
  StripMerger(const std::vector<SiteOnBlock>& theSites, const RowOptions& theOptions,
    bool withAncillaryArrays)
    : sites(theSites)
    , options(theOptions)
    , levels(static_cast<std::size_t>(theOptions.levels))
    , ancillary(withAncillaryArrays)
    , column(theOptions.levels, theOptions.strategy,
        theSites.empty() ? ValueRule() : theSites.front().site->context.rule, ancillary,
        theOptions.trend)
    , values(options.code ? 0 : levels)
    , codes(options.code ? levels : 0)
    , codesOfColumn(options.code ? levels : 0)
    , states(levels)
    , ages(ancillary ? levels : 0)
    , weights(ancillary ? levels : 0)
    , radars(ancillary ? levels : 0)
    , nearestSites(ancillary ? levels : 0)
    , samples(theSites.size())
    , surroundings(theSites.size())
  {
    states.Fill(VoxelState::NotScanned);
  }

  // Merges the columns x to x + count − 1 of a row.
  void Merge(int x, int y, int count, GriddedVolume& volume)
  {
    this->Sample(x, y, count);
    anyEcho = false;
    if (options.echoes != nullptr)
    {
      std::fill_n(this->EchoesOf(x, y), count, std::uint8_t(0));
    }
    for (int i = 0; i < count && !present.empty(); ++i)
    {
      this->MergeColumn(x + i, y, i, volume.fill);
    }
    this->Write(x, y, count, volume);
  }

  // Gives the states away that codes do not tell.
  std::vector<StateRun> TakeRuns() { return std::move(runs); }

  // From now on, what radars see is compared alone, however much they count beside each other.
  void BeginToCompare() { compares = true; }

  // Marks those of these columns to which others give something else.
  void Compare(StripMerger& others, int x, int y, int count, std::uint8_t* marks)
  {
    this->Sample(x, y, count);
    others.Sample(x, y, count);
    for (int i = 0; i < count; ++i)
    {
      marks[i] = this->IsSame(others, x + i, y, i) ? 0 : 1;
    }
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
    float way = 0.0F;          // of tan(γ/2), that the echo moves at most
    std::uint8_t topAlong = 0; // as top, along that way
    std::size_t tilts = 0;     // that matter
    bool quiet = false;
    bool inFull = false; // where it is quiet: near enough in time to count so
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

  // Looks all radars up about columns of a row.
  void Sample(int x, int y, int count)
  {
    present.clear();
    echoes.fill(false);
    for (std::size_t i = 0; i < sites.size(); ++i)
    {
      this->SurveySite(i, x, y, count);
    }
    for (const Present& each : present)
    {
      this->SampleSite(each, x, y);
    }
  }

  void SurveySite(std::size_t number, int x, int y, int count)
  {
    const MergeSite& site = *sites[number].site;
    const SiteGeometry& geometry = *sites[number].geometry;
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
  }

  // Looks up the tilts of a radar that is not quiet. Where another one is not, how much it counts
  // matters, too.
  void SampleSite(const Present& seen, int x, int y)
  {
    const MergeSite& site = *sites[seen.site].site;
    std::array<Surroundings, stripWidth>& about = surroundings[seen.site];
    for (auto i = static_cast<std::size_t>(seen.begin); i < static_cast<std::size_t>(seen.end); ++i)
    {
      about[i].quiet = about[i].quiet && (about[i].inFull || !echoes[i]);
    }
    const ColumnDirection* directions = &this->DirectionAt(seen.site, x + seen.begin, y);
    const std::size_t tilts = site.tilts.size();
    for (std::size_t tilt = 0; tilt < tilts; ++tilt)
    {
      TiltSample* to = samples[seen.site].data() + tilt;
      for (int i = seen.begin; i < seen.end; ++i)
      {
        const Surroundings& here = about[static_cast<std::size_t>(i)];
        if (!here.quiet && tilt < here.tilts)
        {
          this->SampleColumn(
            site, tilt, directions[i - seen.begin], here, to[static_cast<std::size_t>(i) * tilts]);
        }
      }
    }
  }

  // Whether others give the same to a column.
  bool IsSame(StripMerger& others, int x, int y, int place)
  {
    const bool echo = this->FindOrder(x, y, place);
    const bool othersEcho = others.FindOrder(x, y, place);
    if (echo || othersEcho || order.size() > 1 || others.order.size() > 1)
    {
      this->AddRadars(x, y, place);
      others.AddRadars(x, y, place);
      return column.HasSameSums(others.column);
    }
    // Echo of a further radar feels how much those count that have none.
    return this->QuietLevels(x, y, place) == others.QuietLevels(x, y, place) &&
           ((this->CountInFull(place) && others.CountInFull(place)) || !this->HadEcho(x, y));
  }

  // The levels that the one radar scanned that sees a column, and has no echo there.
  std::pair<int, int> QuietLevels(int x, int y, int place)
  {
    if (order.empty())
    {
      return {0, 0};
    }
    const auto& [halfTangent, number] = order.front();
    const Surroundings& about = surroundings[number][static_cast<std::size_t>(place)];
    return column.QuietLevels(
      this->SeenBy(number, halfTangent, x, y, place, false), about.firstTilt, about.endTilt);
  }

  // What the radar has where the echo over the column stood or will stand at the time of any ray.
  static void LookAlong(const MergeSite& site, const ColumnDirection& column, Surroundings& about)
  {
    const float apart = 0.95F * static_cast<float>(MergeSite::NearDistance) /
                        site.context.effectiveRadius; // of the places looked at
    const float speed = std::hypot(about.motion.away, about.motion.clockwise);
    const float seconds = site.since + site.until;
    const int places = 1 + static_cast<int>(seconds * speed / apart);
    const float step = seconds / static_cast<float>(places);
    about.way = speed * std::max(site.since, site.until);
    about.topAlong = 0;
    for (int i = 0; i < places && about.topAlong < about.top; ++i)
    {
      const float time = (static_cast<float>(i) + 0.5F) * step - site.since;
      const ColumnDirection place = nexrad::DirectionAt(column, about.motion, time);
      about.topAlong = std::max(about.topAlong, site.nearMask.TopOver(place));
    }
    about.topAlong = std::min(about.topAlong, about.top);
  }

  // Of the tilts that surely pass above the grid two matter: echo falls towards the first one, and
  // follows the second one (Formulas G8, G11).
  static std::size_t CountTilts(const MergeSite& site, const ColumnDirection& direction)
  {
    std::size_t count = site.edges.size();
    while (count > 2 && site.levels.AreBelow(site.edges[count - 3].tangent, direction.halfTangent))
    {
      --count;
    }
    return count;
  }

  // Whether gates of a radar hold anything about a column but no echo.
  static bool Holds(const MergeSite& site, const Surroundings& about)
  {
    return about.top >= site.lowestQuiet || about.layers;
  }

  // Whether a radar gave an echo when the column was merged; true where that is not known.
  bool HadEcho(int x, int y) const
  {
    return options.echoes == nullptr || *this->EchoesOf(x, y) != 0;
  }

  std::uint8_t* EchoesOf(int x, int y) const
  {
    return options.echoes + static_cast<std::size_t>(y) * static_cast<std::size_t>(options.width) +
           static_cast<std::size_t>(x);
  }

  // Whether the radars that see a column, none of which has an echo there, count in full.
  bool CountInFull(int place) const
  {
    return std::all_of(order.begin(), order.end(),
      [&](const auto& each)
      { return surroundings[each.second][static_cast<std::size_t>(place)].inFull; });
  }

  // What is known of the columns before their tilts are looked up.
  void SurveyColumns(
    std::size_t number, const ColumnDirection* directions, int x, int y, int begin, int end)
  {
    const MergeSite& site = *sites[number].site;
    for (int i = begin; i < end; ++i)
    {
      Surroundings& about = surroundings[number][static_cast<std::size_t>(i)];
      about.top = site.mask.TopOver(directions[i]);
      about.layers = site.layers.AnyAt(directions[i]);
      about.known = site.zones.At(directions[i]);
      about.tilts = CountTilts(site, directions[i]);
      if ((about.top > 0 || about.layers) && options.motion != nullptr)
      {
        about.motion = MotionSeenBy(site, directions[i], options.motion->At(x + i, y));
        this->LookAlong(site, directions[i], about);
      }
      TiltSample* to = samples[number].data() + static_cast<std::size_t>(i) * site.tilts.size();
      this->FindQuietTilts(site, directions[i], about, to);
      echoes[static_cast<std::size_t>(i)] = echoes[static_cast<std::size_t>(i)] || !about.quiet;
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
    if (known == nullptr || Holds(site, about))
    {
      return;
    }
    about.firstTilt = about.endTilt = 0;
    about.inFull = true;
    for (std::size_t tilt = 0; tilt < about.tilts; ++tilt)
    {
      bool none = HasNoEcho(known[tilt]);
      about.inFull = about.inFull && known[tilt] != QuietZones::Tilt::AgingNoEcho;
      if (known[tilt] == QuietZones::Tilt::Unknown)
      {
        this->SampleColumn(site, tilt, direction, about, to[tilt]);
        none = to[tilt].state == VoxelState::NoEcho && to[tilt].fade >= LeastFade;
        about.inFull = about.inFull && (!none || to[tilt].fade == 1.0F);
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
      if (HasNoEcho(known[tilt]))
      {
        this->SampleColumn(site, tilt, direction, about, to[tilt]);
      }
    };
    if (about.firstTilt < about.endTilt)
    {
      const std::size_t last = about.endTilt - 1;
      sample(about.firstTilt);
      site.levels.AreBelow(site.edges[last].tangent, direction.halfTangent) ? void() : sample(last);
    }
  }

  void SampleColumn(const MergeSite& site, std::size_t tilt, const ColumnDirection& direction,
    const Surroundings& about, TiltSample& sample) const
  {
    sample = {};
    if (about.known != nullptr && about.known[tilt] == QuietZones::Tilt::NotScanned)
    {
      return;
    }
    const QuietTilt& quiet = site.quiet[tilt];
    const bool moves = about.top > 0 && options.motion != nullptr;
    const ColumnMotion* motion = moves ? &about.motion : nullptr;
    // Where both observations have gates all along the way, what lies beside it does not matter.
    const bool along = moves && !quiet.alone && quiet.before != nullptr &&
                       direction.halfTangent - about.way > quiet.nearest &&
                       direction.halfTangent + about.way < quiet.farthest;
    if ((along ? about.topAlong : about.top) >= quiet.elevation)
    {
      SampleTilt(site.tilts, tilt, direction, site.context, motion, false, sample);
      return;
    }
    // What lower tilts hold may come to a look alone, which moves at its height.
    const bool asked = quiet.alone && about.top >= site.lowestQuiet;
    if (asked || !SampleQuiet(quiet, direction, site.context, sample))
    {
      SampleTilt(site.tilts, tilt, direction, site.context, motion, true, sample);
    }
  }

  void MergeColumn(int x, int y, int place, float fill)
  {
    const bool echo = this->AddRadars(x, y, place);
    anyEcho = anyEcho || echo;
    if (options.echoes != nullptr && echo)
    {
      *this->EchoesOf(x, y) = column.HasEcho() ? 1 : 0;
    }
    column.Finish(fill);
    if (options.fillColumns)
    {
      column.FillColumn();
    }
    this->Keep(place);
  }

  // Finds the radars that see a column. False when all of them know that it has no echo.
  bool FindOrder(int x, int y, int place)
  {
    order.clear();
    bool echo = false;
    for (const Present& each : present)
    {
      if (place >= each.begin && place < each.end)
      {
        const float halfTangent = this->DirectionAt(each.site, x, y).halfTangent;
        if (halfTangent <= sites[each.site].site->reach)
        {
          order.push_back({halfTangent, each.site});
          echo = echo || !surroundings[each.site][static_cast<std::size_t>(place)].quiet;
        }
      }
    }
    return echo;
  }

  const ColumnDirection& DirectionAt(std::size_t number, int x, int y) const
  {
    const SiteGeometry& geometry = *sites[number].geometry;
    return geometry.Row(y)[x - geometry.BeginX()];
  }

  // A radar over a column; `weighs`: as much as it counts beside others.
  SiteColumn SeenBy(std::size_t number, float halfTangent, int x, int y, int place, bool weighs)
  {
    const MergeSite& site = *sites[number].site;
    const Surroundings& about = surroundings[number][static_cast<std::size_t>(place)];
    SiteColumn seen;
    seen.site = site.number;
    seen.halfTangent = halfTangent;
    seen.weight = weighs && !compares ? this->WeightAt(site, halfTangent) : 1.0F;
    seen.levels = &site.levels;
    seen.edges = &site.edges;
    seen.samples = samples[number].data() + static_cast<std::size_t>(place) * site.tilts.size();
    // Formulas G12: what layers of echo change over the column.
    const ColumnMotion* motion = options.motion != nullptr ? &about.motion : nullptr;
    const bool layered =
      about.layers && site.layers.Find(this->DirectionAt(number, x, y), motion, layers);
    seen.layers = layered ? layers.data() : nullptr;
    return seen;
  }

  // Adds what the radars say of a column. False when all of them know that it has no echo.
  bool AddRadars(int x, int y, int place)
  {
    column.Clear();
    const bool echo = this->FindOrder(x, y, place);
    if (echo) // else it decides nothing in what order and how much they count
    {
      std::sort(order.begin(), order.end());
    }
    for (const auto& [halfTangent, number] : order)
    {
      const Surroundings& about = surroundings[number][static_cast<std::size_t>(place)];
      const SiteColumn seen = this->SeenBy(number, halfTangent, x, y, place, echo);
      if (about.quiet)
      {
        column.AddQuiet(seen, about.firstTilt, about.endTilt);
      }
      else
      {
        column.Add(seen);
      }
    }
    return echo;
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
    if (options.code)
    {
      this->KeepCodes(place);
    }
    else
    {
      values.Set(place, column.Values());
      states.Set(place, column.States());
    }
    if (ancillary)
    {
      ages.Set(place, column.Ages());
      weights.Set(place, column.Weights());
      radars.Set(place, column.Radars());
      nearestSites.Set(place, column.NearestSites());
    }
  }

  void KeepCodes(int place)
  {
    options.code->WriteBytes(
      column.Values().data(), column.States().data(), levels, 0, codesOfColumn.data());
    codes.Set(place, codesOfColumn);
    if (column.HasUnknown())
    {
      states.Set(place, column.States());
      anyUnknown = true;
    }
  }

  void Write(int x, int y, int count, GriddedVolume& volume)
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
      if (options.code)
      {
        write(seen, codes, volume.codes, std::uint8_t(MomentCode::NotScannedCode));
        anyUnknown ? this->NoteUnknown(states.Row(level), count, at) : void();
      }
      else
      {
        write(anyEcho, values, volume.values, volume.fill);
        write(seen, states, volume.states, VoxelState::NotScanned);
      }
      if (ancillary)
      {
        write(seen, ages, volume.ancillary.age, 0.0F);
        write(seen, weights, volume.ancillary.weight, 0.0F);
        write(seen, radars, volume.ancillary.radars, std::uint8_t(0));
        write(seen, nearestSites, volume.ancillary.nearestSite, BeamColumn::NoSite);
      }
    }
    if (std::exchange(anyUnknown, false))
    {
      states.Fill(VoxelState::NotScanned);
    }
  }

  // Adds the states of a row of the strip that codes do not tell; `at` is its first voxel.
  void NoteUnknown(const VoxelState* row, int count, std::size_t at)
  {
    for (int begin = 0, end = 1; begin < count; begin = end++)
    {
      while (end < count && row[end] == row[begin])
      {
        ++end;
      }
      if (row[begin] == VoxelState::Filtered || row[begin] == VoxelState::RangeFolded)
      {
        runs.push_back({at + static_cast<std::size_t>(begin), static_cast<std::size_t>(end - begin),
          row[begin]});
      }
    }
  }

  const std::vector<SiteOnBlock>& sites;
  const RowOptions& options;
  const std::size_t levels;
  const bool ancillary;
  BeamColumn column;
  Strip<float> values;
  Strip<std::uint8_t> codes;
  std::vector<std::uint8_t> codesOfColumn;
  Strip<VoxelState> states; // with codes, of columns that have one which these do not tell
  Strip<float> ages;
  Strip<float> weights;
  Strip<std::uint8_t> radars;
  Strip<std::uint8_t> nearestSites;
  std::vector<std::vector<TiltSample>> samples; // of each site seen: tilts within columns
  std::vector<std::array<Surroundings, stripWidth>> surroundings; // of each site
  std::vector<Present> present;
  bool compares = false;
  std::array<bool, stripWidth> echoes{}; // columns of which a radar does not know that it has none
  bool anyEcho = false;                  // there may be some in the strip
  bool anyUnknown = false;               // a column of the strip has a state that codes do not tell
  std::vector<StateRun> runs;
  std::vector<std::pair<float, std::size_t>> order; // distance and site
  std::vector<EchoLayers::Changes> layers;          // of the site that is added, by gap
};

} // namespace

std::vector<StateRun> MergeRows(const std::vector<SiteOnBlock>& sites, const RowOptions& options,
  int beginRow, int endRow, GriddedVolume& volume)
{
  StripMerger merger(sites, options, !volume.ancillary.age.empty());
  const int end = options.block.end[0];
  // Rows within strips: what the sweeps have about a strip is still in the cache for the next row.
  for (int x = options.block.begin[0]; x < end; x += stripWidth)
  {
    for (int y = beginRow; y < endRow; ++y)
    {
      merger.Merge(x, y, std::min(stripWidth, end - x), volume);
    }
  }
  return merger.TakeRuns();
}

void MergeColumns(const std::vector<SiteOnBlock>& sites, const RowOptions& options,
  const std::vector<std::uint8_t>& wanted, GriddedVolume& volume)
{
  StripMerger merger(sites, options, !volume.ancillary.age.empty());
  const VoxelBlock& block = options.block;
  const std::uint8_t* row = wanted.data();
  for (int y = block.begin[1]; y < block.end[1]; ++y, row += block.Size(0))
  {
    for (int begin = 0; begin < block.Size(0);)
    {
      const std::uint8_t* const last = row + std::min(begin + stripWidth, block.Size(0));
      const auto end = static_cast<int>(std::find(row + begin, last, std::uint8_t(0)) - row);
      if (begin < end)
      {
        merger.Merge(block.begin[0] + begin, y, end - begin, volume);
      }
      begin = std::max(end, begin + 1);
    }
  }
}

std::vector<std::uint8_t> FindDifferences(const std::vector<SiteOnBlock>& before,
  const std::vector<SiteOnBlock>& after, const RowOptions& options, bool ancillary)
{
  StripMerger merger(before, options, ancillary);
  StripMerger others(after, options, ancillary);
  merger.BeginToCompare();
  others.BeginToCompare();
  const VoxelBlock& block = options.block;
  const auto width = static_cast<std::size_t>(block.Size(0));
  std::vector<std::uint8_t> marks(width * static_cast<std::size_t>(block.Size(1)));
  std::uint8_t* row = marks.data();
  for (int y = block.begin[1]; y < block.end[1]; ++y, row += width)
  {
    for (int x = 0; x < block.Size(0); x += stripWidth)
    {
      const int count = std::min(stripWidth, block.Size(0) - x);
      merger.Compare(others, block.begin[0] + x, y, count, row + x);
    }
  }
  return marks;
}

} // namespace nexrad
