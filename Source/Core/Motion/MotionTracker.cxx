// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Motion/MotionTracker.h"

#include "nexrad/Model/Site.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace nexrad
{

namespace
{

constexpr double imagePixel = 2'000.0;  // m, before halving
constexpr double finestPixel = 4'000.0; // m
constexpr double spacing = 40'000.0;    // m, between nodes of the motion
// Farther out beams are too wide, and too high, to show how storms move.
constexpr double imageReach = 240'000.0; // m
// Two volumes are compared as wholes when this part of the echo of each lies on tilts of the other.
constexpr double leastShared = 0.75;
constexpr float halfBeam = 0.5F; // degrees between tilts that see nearly the same
// Shortest time between two volumes of one radar that gives the motion of the echo in full: from a
// shorter one, a small error of the displacement is a large one of the speed.
constexpr double shortestInterval = 180.0; // s

// The box of a grid in pixels of at most imagePixel.
GridSpecification PixelsOf(const GridSpecification& grid)
{
  GridSpecification pixels = grid;
  const std::array<double, 2> voxel = VoxelExtent(grid, 0.5 * (grid.dimensions[1] - 1));
  for (std::size_t axis = 0; axis < 2; ++axis)
  {
    const double count = std::ceil(grid.dimensions[axis] * voxel[axis] / imagePixel);
    pixels.dimensions[axis] = std::max(1, static_cast<int>(count));
    pixels.spacing[axis] = grid.spacing[axis] * grid.dimensions[axis] / pixels.dimensions[axis];
    pixels.origin[axis] = grid.origin[axis] + 0.5 * (pixels.spacing[axis] - grid.spacing[axis]);
  }
  pixels.dimensions[2] = 1;
  return pixels;
}

// The composite of a volume in a direction: bilinear between the middles of its cells. Leaves value
// and mark as they are where it was not scanned.
void SampleComposite(const VolumeComposite& composite, double ringsPerTangent,
  const ColumnDirection& direction, float& value, std::uint8_t& scanned)
{
  const double t = static_cast<double>(direction.halfTangent);
  const auto ring =
    static_cast<float>(std::max(0.0, ringsPerTangent * t * (1.0 - t * t / 3.0) - 0.5));
  const auto inner = static_cast<int>(ring);
  if (inner + 1 >= composite.rings)
  {
    return;
  }
  const float turned = direction.azimuth + (static_cast<float>(VolumeComposite::Sectors) - 0.5F);
  const auto sector = static_cast<int>(turned);
  const float across = turned - static_cast<float>(sector);
  const float along = ring - static_cast<float>(inner);
  const std::size_t left = composite.Index(sector % VolumeComposite::Sectors, inner);
  const std::size_t right = composite.Index((sector + 1) % VolumeComposite::Sectors, inner);
  for (const std::size_t cell : {left, left + 1, right, right + 1})
  {
    if (composite.cells[cell] == VolumeComposite::Cell::NotScanned)
    {
      return;
    }
  }
  const auto mean = [&](std::size_t cell) {
    return composite.values[cell] + along * (composite.values[cell + 1] - composite.values[cell]);
  };
  value = mean(left) + across * (mean(right) - mean(left));
  scanned = 1;
}

// The composite on the pixels that the radar's geometry covers.
MotionImage MakeImage(const VolumeComposite& composite, const SiteGeometry& geometry,
  const std::array<double, 2>& voxelsPerPixel, double effectiveRadius)
{
  const double ringsPerTangent =
    2.0 * effectiveRadius / static_cast<double>(VolumeComposite::RingWidth);
  MotionImage image(geometry.EndX() - geometry.BeginX(), geometry.EndY() - geometry.BeginY());
  image.scale = voxelsPerPixel;
  image.first = {geometry.BeginX() * voxelsPerPixel[0], geometry.BeginY() * voxelsPerPixel[1]};
  for (int row = 0; row < image.rows; ++row)
  {
    const ColumnDirection* directions = geometry.Row(geometry.BeginY() + row);
    for (int column = 0; column < image.columns; ++column)
    {
      const std::size_t index = image.Index(column, row);
      SampleComposite(
        composite, ringsPerTangent, directions[column], image.values[index], image.scanned[index]);
    }
  }
  return image;
}

Time MiddleOf(const BeamVolume& volume)
{
  return volume.start + (volume.end - volume.start) / 2;
}

// The part of the echo of a composite that lies on tilts of another one, 0…1.
double SharedEcho(const VolumeComposite& composite, const VolumeComposite& other)
{
  double shared = 0.0;
  for (const VolumeComposite::Tilt& tilt : composite.tilts)
  {
    const auto isSame = [&tilt](const VolumeComposite::Tilt& each)
    { return std::abs(each.elevation - tilt.elevation) <= halfBeam; };
    shared += std::any_of(other.tilts.begin(), other.tilts.end(), isSame) ? tilt.echo : 0.0;
  }
  return composite.echo > 0.0 ? shared / composite.echo : 0.0;
}

// Whether two composites show nearly the same heights.
bool AreAlike(const VolumeComposite& a, const VolumeComposite& b)
{
  return std::min(SharedEcho(a, b), SharedEcho(b, a)) >= leastShared;
}

Velocity Slowed(const Velocity& velocity, double part)
{
  return {part * velocity.east, part * velocity.north};
}

// What makes one pair of volumes worse than another, the weightiest first: how much its time base
// is too short, its distance from the time of the merge, and how far its volumes are apart.
using PairRank = std::tuple<double, Duration, double>;

} // namespace

MotionTracker::MotionTracker(const GridSpecification& theGrid, const BeamModel& theBeam)
  : grid(theGrid)
  , pixels(PixelsOf(theGrid))
  , beam(theBeam)
{
  options.finestPixel = finestPixel;
  options.spacing = spacing;
}

std::vector<MotionTracker::Pair> MotionTracker::FindPairs(const BeamVolumes& volumes, Time time)
{
  std::map<SiteKey, BeamVolumes> sites;
  for (const Volume& volume : volumes)
  {
    if (volume->composite.echo > 0.0)
    {
      sites[KeyOf(volume->site)].push_back(volume);
    }
  }
  std::vector<Pair> found;
  for (const auto& site : sites)
  {
    if (const std::optional<Pair> pair = FindPair(site.second, time))
    {
      found.push_back(*pair);
    }
  }
  return found;
}

// Of the volumes of one radar, all with echo.
std::optional<MotionTracker::Pair> MotionTracker::FindPair(BeamVolumes own, Time time)
{
  std::sort(own.begin(), own.end(),
    [](const Volume& a, const Volume& b)
    { return std::make_pair(MiddleOf(*a), a->start) < std::make_pair(MiddleOf(*b), b->start); });
  std::optional<Pair> best;
  PairRank least;
  for (std::size_t i = 0; i < own.size(); ++i)
  {
    for (std::size_t j = i + 1; j < own.size(); ++j)
    {
      const std::optional<Pair> pair = Compare(own[i], own[j]);
      if (!pair)
      {
        continue;
      }
      const Duration away =
        std::max({MiddleOf(*own[i]) - time, time - MiddleOf(*own[j]), Duration::zero()});
      const double timeBase = pair->TimeBase();
      const PairRank rank = {std::max(0.0, shortestInterval - timeBase), away, timeBase};
      if (!best || rank <= least)
      {
        best = pair;
        least = rank;
      }
    }
  }
  return best;
}

// Empty where nothing can be compared, and where the time between is 0 or too long.
std::optional<MotionTracker::Pair> MotionTracker::Compare(const Volume& before, const Volume& after)
{
  const bool alike = AreAlike(before->composite, after->composite);
  const Pair pair = {{before, !alike}, {after, !alike}};
  if (!alike && !AreAlike(before->lowest, after->lowest))
  {
    return std::nullopt;
  }
  const double seconds = pair.Seconds();
  const double longest = std::chrono::duration<double>(LongestMotionInterval).count();
  const bool near = seconds > 0.0 && seconds <= longest;
  return near ? std::optional<Pair>(pair) : std::nullopt;
}

// How much of the motion that was found is kept, up to 1.
double MotionTracker::TrustIn(const std::vector<Pair>& pairs)
{
  double squares = 0.0; // s²
  for (const Pair& pair : pairs)
  {
    squares += pair.TimeBase() * pair.TimeBase();
  }
  return std::min(1.0, squares / (shortestInterval * shortestInterval));
}

void MotionTracker::MakeImages(const BeamVolumes& volumes, const RangeLoop& loop)
{
  std::vector<KeptPyramid> next;
  for (KeptPyramid& each : kept)
  {
    if (std::find(volumes.begin(), volumes.end(), each.picture.volume) != volumes.end())
    {
      next.push_back(std::move(each));
    }
  }
  const std::size_t known = next.size();
  for (const Pair& pair : pairs)
  {
    for (const Picture& picture : {pair.before, pair.after})
    {
      const auto same = [&picture](const KeptPyramid& each) { return each.picture == picture; };
      if (std::none_of(next.begin(), next.end(), same))
      {
        next.push_back({picture, MotionPyramid()});
        const Position& position = *picture.volume->site.position;
        geometries.try_emplace(
          {position.latitude, position.longitude}, pixels, position, imageReach, beam);
      }
    }
  }
  const std::array<double, 2> voxelsPerPixel = {
    pixels.spacing[0] / grid.spacing[0], pixels.spacing[1] / grid.spacing[1]};
  RunEach(loop, next.size() - known,
    [&](std::size_t i)
    {
      KeptPyramid& to = next[known + i];
      const Position& position = *to.picture.volume->site.position;
      const SiteGeometry& geometry = geometries.at({position.latitude, position.longitude});
      to.images = MakePyramid(
        MakeImage(to.picture.Composite(), geometry, voxelsPerPixel, beam.EffectiveRadius()), grid,
        options.finestPixel);
    });
  kept = std::move(next);
}

std::vector<MotionPair> MotionTracker::ImagesOfPairs() const
{
  const auto imagesOf = [this](const Picture& picture)
  {
    const auto same = [&picture](const KeptPyramid& each) { return each.picture == picture; };
    return &std::find_if(kept.begin(), kept.end(), same)->images;
  };
  std::vector<MotionPair> images;
  for (const Pair& pair : pairs)
  {
    images.push_back({imagesOf(pair.before), imagesOf(pair.after), pair.Seconds(),
      pair.before.Composite().echoTime});
  }
  return images;
}

std::shared_ptr<const MotionField> MotionTracker::Find(
  const BeamVolumes& volumes, Time time, const RangeLoop& loop)
{
  std::vector<Pair> wanted = FindPairs(volumes, time);
  if (wanted == pairs)
  {
    return motion;
  }
  pairs = std::move(wanted);
  this->MakeImages(volumes, loop);
  const std::vector<MotionPair> images = this->ImagesOfPairs();
  motion = nullptr;
  if (!images.empty())
  {
    MotionField found = EstimateMotion(images, grid, options);
    for (Velocity& velocity : found.velocities)
    {
      velocity = Slowed(velocity, TrustIn(pairs));
    }
    motion = std::make_shared<const MotionField>(std::move(found));
  }
  return motion;
}

std::optional<Velocity> MotionTracker::FindWithin(
  const GridArea& area, const BeamVolumes& volumes, Time time, const RangeLoop& loop)
{
  const std::shared_ptr<const MotionField> field = this->Find(volumes, time, loop);
  if (!field)
  {
    return std::nullopt;
  }
  const double column = (0.5 * (area[0] + area[1]) - grid.origin[0]) / grid.spacing[0];
  const double row = (0.5 * (area[2] + area[3]) - grid.origin[1]) / grid.spacing[1];
  const double trust = TrustIn(pairs);
  const Velocity first = Slowed(field->At(column, row), 1.0 / trust);
  const Velocity found =
    EstimateMotionWithin(area, ToSeconds(time), this->ImagesOfPairs(), grid, first, options);
  return Slowed(found, trust);
}

} // namespace nexrad
