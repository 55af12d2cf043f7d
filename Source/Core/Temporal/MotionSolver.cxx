// SPDX-License-Identifier: BSD-3-Clause
#include "Temporal/MotionSolver.h"

#include <algorithm>
#include <cmath>

namespace nexrad
{

namespace
{

// Gauss–Newton steps on each pair of images, and passes over the nodes in each step. The field is
// near its solution from the image before, so that few are needed.
constexpr int steps = 5;
constexpr int passes = 60;
// A difference of this many dBZ is as likely growth or decay as motion.
constexpr double tolerance = 10.0;
// What holds a node without echo near to the prevailing motion, as a part of the stiffness.
constexpr double anchor = 0.01;
constexpr double kilometre = 1000.0;

// Mean square difference of the pixels that both images have at one displacement.
struct Match
{
  double difference = 0.0; // dBZ²
  double pixels = 0.0;     // compared
};

Match MatchAt(const MotionImage& before, const MotionImage& after, int dx, int dy)
{
  double sum = 0.0;
  double compared = 0.0;
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
  return {compared > 0.0 ? sum / compared : 0.0, compared};
}

} // namespace

Displacement SearchDisplacement(const MotionImage& before, const MotionImage& after,
  const GridSpecification& grid, double farthest)
{
  const std::array<double, 2> voxel = VoxelExtent(grid, 0.5 * (grid.dimensions[1] - 1));
  const double width = voxel[0] * before.scale;
  const double depth = voxel[1] * before.scale;
  // Limited before it becomes a whole number: the farthest may be anything above 0.
  const auto most = [farthest](double pixel, int pixels)
  { return static_cast<int>(std::min(farthest / pixel, static_cast<double>(pixels - 1))); };
  const int mostX = most(width, before.columns);
  const int mostY = most(depth, before.rows);
  // No motion is the answer that any other must beat, so that two empty images stand still.
  const Match still = MatchAt(before, after, 0, 0);
  double least = still.difference;
  Displacement best = {0.0, 0.0};
  for (int dy = -mostY; dy <= mostY; ++dy)
  {
    for (int dx = -mostX; dx <= mostX; ++dx)
    {
      const Match match = MatchAt(before, after, dx, dy);
      if (match.difference < least && match.pixels >= 0.5 * still.pixels)
      {
        least = match.difference;
        best = {dx * width, dy * depth};
      }
    }
  }
  return best;
}

MotionSolver::MotionSolver(const GridSpecification& gridOfImages, const MotionOptions& options,
  const Displacement& prevailingDisplacement, double farthestDisplacement)
  : grid(gridOfImages)
  , lattice(MakeMotionLattice(gridOfImages, options.spacing))
  , stiffness(options.smoothness / (kilometre * kilometre))
  , farthest(farthestDisplacement)
  , prevailing(prevailingDisplacement)
  , displacements(lattice.NodeCount(), prevailingDisplacement)
{
}

void MotionSolver::Refine(const MotionImage& before, const MotionImage& after)
{
  for (int step = 0; step < steps; ++step)
  {
    const std::vector<Demand> demands = this->Demands(before, after);
    this->FindPrevailing(demands);
    this->Solve(demands);
  }
}

MotionField MotionSolver::Motion(double seconds) const
{
  MotionField field;
  field.lattice = lattice;
  field.velocities.clear();
  for (const Displacement& displacement : displacements)
  {
    field.velocities.push_back({displacement[0] / seconds, displacement[1] / seconds});
  }
  return field;
}

Displacement MotionSolver::At(const MotionLattice::Corners& corners) const
{
  Displacement sum = {0.0, 0.0};
  for (std::size_t i = 0; i < corners.node.size(); ++i)
  {
    sum[0] += corners.share[i] * displacements[corners.node[i]][0];
    sum[1] += corners.share[i] * displacements[corners.node[i]][1];
  }
  return sum;
}

// The two images are compared at the middle of the time between them, where the error of either
// end of the displacement weighs the same.
std::vector<MotionSolver::Demand> MotionSolver::Demands(
  const MotionImage& before, const MotionImage& after) const
{
  std::vector<Demand> demands(lattice.NodeCount());
  for (int row = 0; row < before.rows; ++row)
  {
    const std::array<double, 2> voxel = VoxelExtent(grid, before.ToVoxel(row));
    const double width = voxel[0] * before.scale;
    const double depth = voxel[1] * before.scale;
    for (int column = 0; column < before.columns; ++column)
    {
      const auto corners = lattice.Around(before.ToVoxel(column), before.ToVoxel(row));
      const Displacement moved = this->At(corners);
      const double dx = 0.5 * moved[0] / width;
      const double dy = 0.5 * moved[1] / depth;
      const auto first = SampleImage(before, column - dx, row - dy);
      const auto second = SampleImage(after, column + dx, row + dy);
      const bool known = first && second;
      const double difference = known ? second->value - first->value : 0.0;
      const double x = known ? 0.5 * (first->perColumn + second->perColumn) / width : 0.0;
      const double y = known ? 0.5 * (first->perRow + second->perRow) / depth : 0.0;
      const double excess = difference / tolerance;
      const double trust = 1.0 / ((1.0 + excess * excess) * (1.0 + excess * excess));
      for (std::size_t i = 0; i < corners.node.size(); ++i)
      {
        Demand& demand = demands[corners.node[i]];
        const double share = corners.share[i];
        demand.xx += share * trust * x * x;
        demand.xy += share * trust * x * y;
        demand.yy += share * trust * y * y;
        demand.x -= share * trust * x * difference;
        demand.y -= share * trust * y * difference;
        demand.pixels += share;
      }
    }
  }
  return demands;
}

// The mean over the nodes, each by how much the echo about it says. Without echo it stays.
void MotionSolver::FindPrevailing(const std::vector<Demand>& demands)
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

void MotionSolver::Solve(const std::vector<Demand>& demands)
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
void MotionSolver::Relax(const std::vector<Demand>& demands, int column, int row)
{
  const int width = lattice.nodes[0];
  const auto index = static_cast<std::size_t>(row * width + column);
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
  lean(column + 1 < width, index + 1);
  lean(row > 0, index - static_cast<std::size_t>(width));
  lean(row + 1 < lattice.nodes[1], index + static_cast<std::size_t>(width));

  // Positive: the pull is, and the demand's own determinant is no less than 0.
  const double determinant = (xx + pull) * (yy + pull) - xy * xy;
  const double east = ((yy + pull) * x - xy * y) / determinant;
  const double north = ((xx + pull) * y - xy * x) / determinant;
  const double length = std::hypot(east, north);
  const double limit = length > farthest ? farthest / length : 1.0;
  displacements[index] = {east * limit, north * limit};
}

} // namespace nexrad
