// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Motion/MotionEstimate.h"

#include <algorithm>
#include <cmath>

namespace nexrad
{

namespace
{

// Gauss–Newton steps on each pair of images, and passes over the nodes in each step. The field is
// near its solution from the image before, so that few are needed.
constexpr int steps = 3;
constexpr int passes = 60;
// A difference of this many dBZ is as likely growth or decay as motion.
constexpr double tolerance = 10.0;
// What holds a node without echo near to the prevailing motion, as a part of the stiffness.
constexpr double anchor = 0.01;
constexpr double stiffness = 0.2 / (1000.0 * 1000.0); // (dBZ/m)²

// m towards east and north, in the mean time between the images of the pairs.
using Displacement = std::array<double, 2>;

// Two images of the same size. Not owned.
struct ImagePair
{
  const MotionImage* before = nullptr;
  const MotionImage* after = nullptr;
  double part = 1.0; // time between them, as a part of the mean over the pairs
};

// Mean square difference of the pixels that both images have at one displacement.
struct Match
{
  double difference = 0.0; // dBZ²
  double pixels = 0.0;     // compared
};

Match MatchAt(const std::vector<ImagePair>& pairs, int columns, int rows)
{
  double sum = 0.0;
  double compared = 0.0;
  for (const ImagePair& pair : pairs)
  {
    const MotionImage& before = *pair.before;
    const MotionImage& after = *pair.after;
    const int dx = static_cast<int>(std::lround(pair.part * columns));
    const int dy = static_cast<int>(std::lround(pair.part * rows));
    for (int row = std::max(0, -dy); row < before.rows - std::max(0, dy); ++row)
    {
      for (int column = std::max(0, -dx); column < before.columns - std::max(0, dx); ++column)
      {
        const std::size_t from = before.Index(column, row);
        const std::size_t to = after.Index(column + dx, row + dy);
        if (before.scanned[from] != 0 && after.scanned[to] != 0)
        {
          const double difference =
            static_cast<double>(after.values[to]) - static_cast<double>(before.values[from]);
          sum += difference * difference;
          compared += 1.0;
        }
      }
    }
  }
  return {compared > 0.0 ? sum / compared : 0.0, compared};
}

// Marks what lies within `by` places of a mark along one axis: `count` places, `stride` apart.
void Widen(
  std::vector<std::uint8_t>& marks, std::size_t first, std::size_t stride, int count, int by)
{
  std::vector<int> marked;
  for (int i = 0; i < count; ++i)
  {
    if (marks[first + static_cast<std::size_t>(i) * stride] != 0)
    {
      marked.push_back(i);
    }
  }
  for (const int place : marked)
  {
    for (int i = std::max(place - by, 0); i <= std::min(place + by, count - 1); ++i)
    {
      marks[first + static_cast<std::size_t>(i) * stride] = 1;
    }
  }
}

// The displacement that, the same for all pixels of all pairs, brings the second images closest to
// the first: the least mean square difference over the pixels that both have, of all whole pixels
// up to `farthest` m. Displacements that leave less than half of what no displacement has to
// compare do not count.
Displacement SearchDisplacement(
  const std::vector<ImagePair>& pairs, const GridSpecification& grid, double farthest)
{
  const std::array<double, 2> voxel = VoxelExtent(grid, 0.5 * (grid.dimensions[1] - 1));
  const double width = voxel[0] * pairs.front().before->scale[0];
  const double depth = voxel[1] * pairs.front().before->scale[1];
  int columns = 0;
  int rows = 0;
  for (const ImagePair& pair : pairs)
  {
    columns = std::max(columns, pair.before->columns);
    rows = std::max(rows, pair.before->rows);
  }
  // Limited before it becomes a whole number: the farthest may be anything above 0.
  const auto most = [farthest](double pixel, int pixels)
  { return static_cast<int>(std::min(farthest / pixel, static_cast<double>(pixels - 1))); };
  const int mostX = most(width, columns);
  const int mostY = most(depth, rows);
  // No motion is the answer that any other must beat, so that empty images stand still.
  const Match still = MatchAt(pairs, 0, 0);
  double least = still.difference;
  Displacement best = {0.0, 0.0};
  for (int dy = -mostY; dy <= mostY; ++dy)
  {
    for (int dx = -mostX; dx <= mostX; ++dx)
    {
      const Match match = MatchAt(pairs, dx, dy);
      if (match.difference < least && match.pixels >= 0.5 * still.pixels)
      {
        least = match.difference;
        best = {dx * width, dy * depth};
      }
    }
  }
  return best;
}

// Displacements at the nodes of a lattice, improved image by image from coarse to fine.
class MotionSolver
{
public:
  // Starts from one displacement everywhere; none will be longer than `farthestDisplacement` m.
  MotionSolver(const GridSpecification& gridOfImages, const MotionOptions& options,
    const Displacement& prevailingDisplacement, double farthestDisplacement)
    : grid(gridOfImages)
    , lattice(MakeMotionLattice(gridOfImages, options.spacing))
    , farthest(farthestDisplacement)
    , prevailing(prevailingDisplacement)
    , displacements(lattice.NodeCount(), prevailingDisplacement)
  {
  }

  // Improves them by what the pairs of images say (Gauss–Newton).
  void Refine(const std::vector<ImagePair>& pairs)
  {
    std::vector<Demand> counts(lattice.NodeCount());
    std::vector<std::vector<EchoPixel>> pixels;
    for (const ImagePair& pair : pairs)
    {
      pixels.push_back(this->FindEcho(pair, counts));
    }
    for (int step = 0; step < steps; ++step)
    {
      std::vector<Demand> demands = counts;
      for (std::size_t i = 0; i < pairs.size(); ++i)
      {
        this->AddDemands(pairs[i], pixels[i], demands);
      }
      this->FindPrevailing(demands);
      this->Solve(demands);
    }
  }

  // The displacements as motion; `seconds` is the mean time.
  MotionField Motion(double seconds) const
  {
    MotionField field{lattice, {}};
    for (const Displacement& displacement : displacements)
    {
      field.velocities.push_back({displacement[0] / seconds, displacement[1] / seconds});
    }
    return field;
  }

private:
  // What the pixels about a node ask of its displacement: the sums of least squares, per pixel.
  struct Demand
  {
    double xx = 0.0, xy = 0.0, yy = 0.0; // (dBZ/m)²
    double x = 0.0, y = 0.0;             // dBZ²/m
    double pixels = 0.0;
  };

  // A pixel about which one of two images has echo, or may have within the farthest way.
  struct EchoPixel
  {
    int column;
    int row;
    MotionLattice::Corners corners;
  };

  Displacement At(const MotionLattice::Corners& corners) const
  {
    Displacement sum = {0.0, 0.0};
    for (std::size_t i = 0; i < corners.node.size(); ++i)
    {
      sum[0] += corners.share[i] * displacements[corners.node[i]][0];
      sum[1] += corners.share[i] * displacements[corners.node[i]][1];
    }
    return sum;
  }

  // The pixels with echo nearby; counts how many pixels each node answers for, with echo or
  // without.
  std::vector<EchoPixel> FindEcho(const ImagePair& pair, std::vector<Demand>& counts) const
  {
    const MotionImage& image = *pair.before;
    std::vector<std::uint8_t> near(image.values.size());
    for (std::size_t i = 0; i < near.size(); ++i)
    {
      near[i] = image.values[i] > 0.0F || pair.after->values[i] > 0.0F ? 1 : 0;
    }
    // Half of the way, and a pixel beside it.
    const auto reach = [&](double pixel, int pixels)
    {
      const double most = std::ceil(0.5 * pair.part * farthest / pixel) + 1.0;
      return static_cast<int>(std::min(most, static_cast<double>(pixels)));
    };
    const std::array<double, 2> voxel = VoxelExtent(grid, 0.5 * (grid.dimensions[1] - 1));
    const int columns = reach(voxel[0] * image.scale[0], image.columns);
    const int rows = reach(voxel[1] * image.scale[1], image.rows);
    const auto width = static_cast<std::size_t>(image.columns);
    for (int row = 0; row < image.rows; ++row)
    {
      Widen(near, image.Index(0, row), 1, image.columns, columns);
    }
    for (int column = 0; column < image.columns; ++column)
    {
      Widen(near, image.Index(column, 0), width, image.rows, rows);
    }
    std::vector<EchoPixel> pixels;
    for (int row = 0; row < image.rows; ++row)
    {
      for (int column = 0; column < image.columns; ++column)
      {
        const auto corners = lattice.Around(image.ToVoxel(0, column), image.ToVoxel(1, row));
        for (std::size_t i = 0; i < corners.node.size(); ++i)
        {
          counts[corners.node[i]].pixels += corners.share[i];
        }
        if (near[image.Index(column, row)] != 0)
        {
          pixels.push_back({column, row, corners});
        }
      }
    }
    return pixels;
  }

  // The two images are compared at the middle of the time between them, where the error of either
  // end of the displacement weighs the same.
  void AddDemands(
    const ImagePair& pair, const std::vector<EchoPixel>& pixels, std::vector<Demand>& demands) const
  {
    const MotionImage& before = *pair.before;
    for (const EchoPixel& pixel : pixels)
    {
      const std::array<double, 2> voxel = VoxelExtent(grid, before.ToVoxel(1, pixel.row));
      const double width = voxel[0] * before.scale[0];
      const double depth = voxel[1] * before.scale[1];
      const Displacement moved = this->At(pixel.corners);
      const double dx = 0.5 * pair.part * moved[0] / width;
      const double dy = 0.5 * pair.part * moved[1] / depth;
      const auto first = SampleImage(before, pixel.column - dx, pixel.row - dy);
      const auto second = SampleImage(*pair.after, pixel.column + dx, pixel.row + dy);
      if (!first || !second)
      {
        continue;
      }
      const double difference = second->value - first->value;
      const double x = 0.5 * pair.part * (first->perColumn + second->perColumn) / width;
      const double y = 0.5 * pair.part * (first->perRow + second->perRow) / depth;
      const double excess = difference / tolerance;
      const double trust = 1.0 / ((1.0 + excess * excess) * (1.0 + excess * excess));
      for (std::size_t i = 0; i < pixel.corners.node.size(); ++i)
      {
        Demand& demand = demands[pixel.corners.node[i]];
        const double weight = pixel.corners.share[i] * trust;
        demand.xx += weight * x * x;
        demand.xy += weight * x * y;
        demand.yy += weight * y * y;
        demand.x -= weight * x * difference;
        demand.y -= weight * y * difference;
      }
    }
  }

  // The mean over the nodes, each by how much the echo about it says. Without echo it stays.
  void FindPrevailing(const std::vector<Demand>& demands)
  {
    Displacement sum = {0.0, 0.0};
    double weights = 0.0;
    for (std::size_t i = 0; i < demands.size(); ++i)
    {
      const double weight = demands[i].xx + demands[i].yy;
      sum[0] += weight * displacements[i][0];
      sum[1] += weight * displacements[i][1];
      weights += weight;
    }
    if (weights > 0.0)
    {
      prevailing = {sum[0] / weights, sum[1] / weights};
    }
  }

  void Solve(const std::vector<Demand>& demands)
  {
    previous = displacements;
    for (int pass = 0; pass < passes; ++pass)
    {
      for (int row = 0; row < lattice.nodes[1]; ++row)
      {
        for (int column = 0; column < lattice.nodes[0]; ++column)
        {
          this->Relax(demands, column, row);
        }
      }
    }
  }

  // One Gauss–Seidel update: the best displacement of a node while its neighbours keep theirs.
  void Relax(const std::vector<Demand>& demands, int column, int row)
  {
    const auto width = static_cast<std::size_t>(lattice.nodes[0]);
    const std::size_t index =
      static_cast<std::size_t>(row) * width + static_cast<std::size_t>(column);
    const Demand& demand = demands[index];
    const double perPixel = demand.pixels > 0.0 ? 1.0 / demand.pixels : 0.0;
    const double xx = demand.xx * perPixel;
    const double xy = demand.xy * perPixel;
    const double yy = demand.yy * perPixel;
    const Displacement& about = previous[index];
    double x = demand.x * perPixel + xx * about[0] + xy * about[1];
    double y = demand.y * perPixel + xy * about[0] + yy * about[1];

    double pull = anchor * stiffness;
    x += pull * prevailing[0];
    y += pull * prevailing[1];
    const auto lean = [&](bool exists, std::size_t neighbour)
    {
      if (exists)
      {
        pull += stiffness;
        x += stiffness * displacements[neighbour][0];
        y += stiffness * displacements[neighbour][1];
      }
    };
    lean(column > 0, index - 1);
    lean(column + 1 < lattice.nodes[0], index + 1);
    lean(row > 0, index - width);
    lean(row + 1 < lattice.nodes[1], index + width);

    // Positive: the pull is, and the demand's own determinant is no less than 0.
    const double determinant = (xx + pull) * (yy + pull) - xy * xy;
    const double east = ((yy + pull) * x - xy * y) / determinant;
    const double north = ((xx + pull) * y - xy * x) / determinant;
    const double length = std::hypot(east, north);
    const double limit = length > farthest ? farthest / length : 1.0;
    displacements[index] = {east * limit, north * limit};
  }

  const GridSpecification grid;
  const MotionLattice lattice;
  const double farthest;
  Displacement prevailing;                 // that nodes without echo are held near to
  std::vector<Displacement> displacements; // at the nodes
  std::vector<Displacement> previous;      // about which the images were compared
};

double MeanSeconds(const std::vector<MotionPair>& pairs)
{
  double mean = 0.0;
  for (const MotionPair& pair : pairs)
  {
    mean += pair.seconds / static_cast<double>(pairs.size());
  }
  return mean;
}

// The images of a level, counted from the finest. What has fewer levels takes part in the coarser
// ones with its coarsest.
std::vector<ImagePair> ImagesOf(
  const std::vector<MotionPair>& pairs, std::size_t level, double mean)
{
  std::vector<ImagePair> images;
  for (const MotionPair& pair : pairs)
  {
    const std::size_t own = std::min(level, pair.before->size() - 1);
    images.push_back({&pair.before->at(own), &pair.after->at(own), pair.seconds / mean});
  }
  return images;
}

// Pixels of an image along one axis, fractions count.
struct PixelSpan
{
  double begin;
  double end;
};

// The area as it lay `metres` before, in pixels of the image.
PixelSpan PixelsOf(const GridArea& area, const GridSpecification& grid, const MotionImage& image,
  std::size_t axis, double metres)
{
  const double middleRow = (0.5 * (area[2] + area[3]) - grid.origin[1]) / grid.spacing[1];
  const double back = metres / VoxelExtent(grid, middleRow)[axis]; // voxels
  const auto pixelOf = [&](double place)
  {
    const double voxel = (place - grid.origin[axis]) / grid.spacing[axis] - back;
    return (voxel + 0.5 - image.first[axis]) / image.scale[axis] - 0.5;
  };
  return {pixelOf(area[2 * axis]), pixelOf(area[2 * axis + 1])};
}

// The pixels from `begin` up to `end` along both axes, as far as there are.
MotionImage CutOut(
  const MotionImage& image, const std::array<int, 2>& begin, const std::array<int, 2>& end)
{
  MotionImage part(end[0] - begin[0], end[1] - begin[1]);
  part.scale = image.scale;
  part.first = {
    image.first[0] + begin[0] * image.scale[0], image.first[1] + begin[1] * image.scale[1]};
  for (int row = 0; row < part.rows; ++row)
  {
    const std::size_t from = image.Index(begin[0], begin[1] + row);
    const std::size_t to = part.Index(0, row);
    std::copy_n(image.values.data() + from, part.columns, part.values.data() + to);
    std::copy_n(image.scanned.data() + from, part.columns, part.scanned.data() + to);
  }
  return part;
}

// The two images about the area, of which the first knows the area alone.
struct AreaImages
{
  MotionImage before;
  MotionImage after;
};

AreaImages ImagesAbout(const GridArea& area, double time, const MotionPair& pair,
  const GridSpecification& grid, const Velocity& first, double farthest)
{
  const MotionImage& before = pair.before->front();
  const MotionImage& after = pair.after->front();
  const double early = time - pair.start; // s
  const std::array<int, 2> size = {
    std::min(before.columns, after.columns), std::min(before.rows, after.rows)};
  const std::array<double, 2> voxel = VoxelExtent(grid, 0.5 * (grid.dimensions[1] - 1));
  const std::array<double, 2> back = {first.east * early, first.north * early};
  std::array<PixelSpan, 2> inside{};
  std::array<int, 2> begin{};
  std::array<int, 2> end{};
  for (const std::size_t axis : {0U, 1U})
  {
    inside[axis] = PixelsOf(area, grid, before, axis, back[axis]);
    const double margin = farthest / (voxel[axis] * before.scale[axis]) + 2.0;
    const auto limit = [&](double pixel)
    { return static_cast<int>(std::clamp(pixel, 0.0, static_cast<double>(size[axis]))); };
    begin[axis] = limit(std::floor(inside[axis].begin - margin));
    end[axis] = limit(std::ceil(inside[axis].end + margin) + 1.0);
  }
  AreaImages images = {CutOut(before, begin, end), CutOut(after, begin, end)};
  const auto isIn = [&](std::size_t axis, int pixel)
  {
    // A pixel more: what lies between the last one and the face is found from both.
    const double place = begin[axis] + pixel;
    return place > inside[axis].begin - 1.0 && place < inside[axis].end + 1.0;
  };
  for (int row = 0; row < images.before.rows; ++row)
  {
    for (int column = 0; column < images.before.columns; ++column)
    {
      if (!isIn(0, column) || !isIn(1, row))
      {
        images.before.scanned[images.before.Index(column, row)] = 0;
      }
    }
  }
  return images;
}

} // namespace

MotionField EstimateMotion(
  const std::vector<MotionPair>& pairs, const GridSpecification& grid, const MotionOptions& options)
{
  if (pairs.empty())
  {
    return MotionField{};
  }
  std::size_t levels = 0;
  for (const MotionPair& pair : pairs)
  {
    levels = std::max(levels, pair.before->size());
  }
  const double mean = MeanSeconds(pairs);
  const double farthest = options.maximumSpeed * mean;
  MotionSolver solver(
    grid, options, SearchDisplacement(ImagesOf(pairs, levels - 1, mean), grid, farthest), farthest);
  for (std::size_t level = levels; level-- > 0;)
  {
    solver.Refine(ImagesOf(pairs, level, mean));
  }
  return solver.Motion(mean);
}

Velocity EstimateMotionWithin(const GridArea& area, double time,
  const std::vector<MotionPair>& pairs, const GridSpecification& grid, const Velocity& first,
  const MotionOptions& options)
{
  const double mean = MeanSeconds(pairs);
  const double farthest = options.maximumSpeed * mean;
  std::vector<AreaImages> images(pairs.size());
  std::vector<ImagePair> compared;
  for (std::size_t i = 0; i < pairs.size(); ++i)
  {
    images[i] = ImagesAbout(area, time, pairs[i], grid, first, farthest);
    compared.push_back({&images[i].before, &images[i].after, pairs[i].seconds / mean});
  }
  GridSpecification oneNode = grid; // whose one displacement is that of all pixels
  oneNode.dimensions = {1, 1, 1};
  MotionSolver solver(oneNode, options, {first.east * mean, first.north * mean}, farthest);
  for (int i = 0; i < 2; ++i) // each of them is some steps of Gauss and Newton
  {
    solver.Refine(compared);
  }
  return solver.Motion(mean).velocities.front();
}

} // namespace nexrad
