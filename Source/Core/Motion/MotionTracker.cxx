// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Motion/MotionTracker.h"

#include "nexrad/Model/SiteKey.h"
#include "nexrad/Motion/MotionInterval.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace nexrad
{

namespace
{

constexpr double imagePixel = 2'000.0;  // m, before halving
constexpr double finestPixel = 4'000.0; // m
constexpr double spacing = 40'000.0;    // m, between nodes of the motion
// Farther out beams are too wide, and too high, to show how storms move.
constexpr double imageReach = 240'000.0; // m

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

// The composite of a volume at one place: bilinear between the middles of its cells.
class CompositeSampler
{
public:
  CompositeSampler(const VolumeComposite& source, double effectiveRadius)
    : composite(source)
    , ringsPerTangent(2.0 * effectiveRadius / static_cast<double>(VolumeComposite::RingWidth))
  {
  }

  void Sample(const ColumnDirection& direction, float& value, std::uint8_t& scanned) const
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
    const auto missing = [this](std::size_t cell)
    { return composite.cells[cell] == VolumeComposite::Cell::NotScanned; };
    if (missing(left) || missing(left + 1) || missing(right) || missing(right + 1))
    {
      return;
    }
    const auto mean = [&](std::size_t cell) {
      return composite.values[cell] + along * (composite.values[cell + 1] - composite.values[cell]);
    };
    value = mean(left) + across * (mean(right) - mean(left));
    scanned = 1;
  }

private:
  const VolumeComposite& composite;
  const double ringsPerTangent;
};

// The composite on the pixels that the radar's geometry covers.
MotionImage MakeImage(const VolumeComposite& composite, const SiteGeometry& geometry,
  const std::array<double, 2>& voxelsPerPixel, double effectiveRadius)
{
  MotionImage image;
  image.columns = geometry.EndX() - geometry.BeginX();
  image.rows = geometry.EndY() - geometry.BeginY();
  image.scale = voxelsPerPixel;
  image.first = {geometry.BeginX() * voxelsPerPixel[0], geometry.BeginY() * voxelsPerPixel[1]};
  const auto size = static_cast<std::size_t>(image.columns) * static_cast<std::size_t>(image.rows);
  image.values.assign(size, 0.0F);
  image.scanned.assign(size, 0);
  const CompositeSampler sampler(composite, effectiveRadius);
  for (int row = 0; row < image.rows; ++row)
  {
    const ColumnDirection* directions = geometry.Row(geometry.BeginY() + row);
    for (int column = 0; column < image.columns; ++column)
    {
      const std::size_t index = image.Index(column, row);
      sampler.Sample(directions[column], image.values[index], image.scanned[index]);
    }
  }
  return image;
}

Time MiddleOf(const BeamVolume& volume)
{
  return volume.start + (volume.end - volume.start) / 2;
}

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
  std::optional<Pair> nearest;
  Duration least = Duration::max();
  for (std::size_t i = 1; i < own.size(); ++i)
  {
    const Pair pair = {own[i - 1], own[i]};
    const double seconds = pair.after->composite.echoTime - pair.before->composite.echoTime;
    if (seconds <= 0.0 || seconds > std::chrono::duration<double>(LongestMotionInterval).count())
    {
      continue;
    }
    // At the middle of a volume the later pair's motion begins.
    const Duration away =
      std::max({MiddleOf(*pair.before) - time, time - MiddleOf(*pair.after), Duration::zero()});
    if (away <= least)
    {
      nearest = pair;
      least = away;
    }
  }
  return nearest;
}

const SiteGeometry& MotionTracker::GeometryOf(const Position& position)
{
  for (const KeptGeometry& each : geometries)
  {
    if (each.position.latitude == position.latitude &&
        each.position.longitude == position.longitude)
    {
      return each.geometry;
    }
  }
  geometries.push_back({position, SiteGeometry(pixels, position, imageReach, beam)});
  return geometries.back().geometry;
}

void MotionTracker::MakeImages(const BeamVolumes& volumes, const RangeLoop& loop)
{
  std::vector<KeptPyramid> next;
  std::vector<std::size_t> missing;
  for (const Volume& volume : volumes)
  {
    const auto same = [&volume](const KeptPyramid& each) { return each.volume == volume; };
    const auto found = std::find_if(kept.begin(), kept.end(), same);
    if (found == kept.end())
    {
      missing.push_back(next.size());
      this->GeometryOf(*volume->site.position); // made here, before several threads ask
    }
    next.push_back({volume, found != kept.end() ? std::move(found->images) : MotionPyramid()});
  }
  const std::array<double, 2> voxelsPerPixel = {
    pixels.spacing[0] / grid.spacing[0], pixels.spacing[1] / grid.spacing[1]};
  const auto make = [&](int begin, int end)
  {
    for (int i = begin; i < end; ++i)
    {
      KeptPyramid& to = next[missing[static_cast<std::size_t>(i)]];
      const SiteGeometry& geometry = this->GeometryOf(*to.volume->site.position);
      to.images = MakePyramid(
        MakeImage(to.volume->composite, geometry, voxelsPerPixel, beam.EffectiveRadius()), grid,
        options.finestPixel);
    }
  };
  RunLoop(loop, static_cast<int>(missing.size()), make);
  kept = std::move(next);
}

const MotionPyramid& MotionTracker::ImagesOf(const Volume& volume) const
{
  const auto same = [&volume](const KeptPyramid& each) { return each.volume == volume; };
  return std::find_if(kept.begin(), kept.end(), same)->images;
}

std::shared_ptr<const MotionField> MotionTracker::Find(
  const BeamVolumes& volumes, Time time, const RangeLoop& loop)
{
  const std::vector<Pair> wanted = FindPairs(volumes, time);
  const auto same = [](const Pair& a, const Pair& b)
  { return a.before == b.before && a.after == b.after; };
  if (std::equal(wanted.begin(), wanted.end(), pairs.begin(), pairs.end(), same))
  {
    return motion;
  }
  this->MakeImages(volumes, loop);
  std::vector<MotionPair> images;
  for (const Pair& pair : wanted)
  {
    images.push_back({&this->ImagesOf(pair.before), &this->ImagesOf(pair.after),
      pair.after->composite.echoTime - pair.before->composite.echoTime});
  }
  pairs = wanted;
  motion = images.empty()
             ? nullptr
             : std::make_shared<const MotionField>(EstimateMotion(images, grid, options));
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
  std::vector<AreaPair> images;
  for (const Pair& pair : pairs)
  {
    const VolumeComposite& before = pair.before->composite;
    const double seconds = pair.after->composite.echoTime - before.echoTime;
    images.push_back({{&this->ImagesOf(pair.before), &this->ImagesOf(pair.after), seconds},
      ToSeconds(time) - before.echoTime});
  }
  const double column = (0.5 * (area[0] + area[1]) - grid.origin[0]) / grid.spacing[0];
  const double row = (0.5 * (area[2] + area[3]) - grid.origin[1]) / grid.spacing[1];
  return EstimateMotionWithin(area, images, grid, field->At(column, row), options);
}

} // namespace nexrad
