// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Temporal/MotionEstimate.h"
#include "Temporal/MotionImage.h"

#include <array>
#include <vector>

namespace nexrad
{

/// m towards east and north, between the times of two volumes.
using Displacement = std::array<double, 2>;

/// The displacement that, the same for all pixels, brings the second image closest to the first:
/// the least mean square difference over the pixels that both have, of all whole pixels up to
/// `farthest` m. Displacements that leave less than half of what no displacement has to compare do
/// not count.
Displacement SearchDisplacement(const MotionImage& before, const MotionImage& after,
  const GridSpecification& grid, double farthest);

/// Displacements at the nodes of a lattice, improved image by image from coarse to fine.
class MotionSolver
{
public:
  /// Starts from `prevailing` everywhere; no displacement will be longer than `farthest` m.
  MotionSolver(const GridSpecification& grid, const MotionOptions& options,
    const Displacement& prevailing, double farthest);

  /// Improves the displacements by what two images of the same size say (Gauss–Newton).
  void Refine(const MotionImage& before, const MotionImage& after);

  /// The displacements as motion.
  MotionField Motion(double seconds) const;

private:
  // What the pixels about a node ask of its displacement: the sums of least squares, per pixel.
  struct Demand
  {
    double xx = 0.0, xy = 0.0, yy = 0.0; // (dBZ/m)²
    double x = 0.0, y = 0.0;             // dBZ²/m
    double pixels = 0.0;
  };

  std::vector<Demand> Demands(const MotionImage& before, const MotionImage& after) const;
  void FindPrevailing(const std::vector<Demand>& demands);
  void Solve(const std::vector<Demand>& demands);
  void Relax(const std::vector<Demand>& demands, int column, int row);
  Displacement At(const MotionLattice::Corners& corners) const;

  const GridSpecification grid;
  const MotionLattice lattice;
  const double stiffness; // (dBZ/m)²
  const double farthest;
  Displacement prevailing;                 // that nodes without echo are held near to
  std::vector<Displacement> displacements; // at the nodes
  std::vector<Displacement> previous;      // about which the images were compared
};

} // namespace nexrad
