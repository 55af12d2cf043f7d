// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Motion/MotionField.h"
#include "nexrad/Motion/MotionImage.h"

#include <array>
#include <vector>

namespace nexrad
{

struct MotionOptions
{
  double spacing = 20'000.0;    ///< m between nodes of the motion field, at most; above 0
  double finestPixel = 2'000.0; ///< m, no image is halved beyond; above 0
  double maximumSpeed = 50.0;   ///< m/s, no motion is faster; above 0
  double smoothness = 0.2; ///< (dBZ/km)², how much a difference between neighbouring nodes costs
                           ///< beside the slopes of the echo; above 0
};

/// Two images of one radar, or of one merge, at two times. Not owned.
struct MotionPair
{
  const MotionPyramid* before = nullptr;
  const MotionPyramid* after = nullptr; ///< of the same sizes
  double seconds = 0.0;                 ///< between them, above 0
};

/// Finds the one motion of the echo (Formulas A3) that fits pairs of images of column maxima over
/// one grid, which may be of several radars and of several times, coarse to fine. First the one
/// displacement that fits all; then, from pixels of about 8 km to pixels of about 2 km, the
/// displacement at each node that makes half of it forwards from the first image and half of it
/// backwards from the second meet, least squares with little weight for echo that grew or decayed,
/// and as smooth as `smoothness` asks. Where there is no echo the field continues that of the
/// neighbours; without any echo, and without pairs, nothing moves. Throws Error when an option is
/// not above 0.
MotionField EstimateMotion(const std::vector<MotionPair>& pairs, const GridSpecification& grid,
  const MotionOptions& options = {});

/// m towards east and north, in the mean time between the images of the pairs.
using Displacement = std::array<double, 2>;

/// Two images of the same size. Not owned.
struct ImagePair
{
  const MotionImage* before = nullptr;
  const MotionImage* after = nullptr;
  double part = 1.0; ///< time between them, as a part of the mean over the pairs
};

/// The displacement that, the same for all pixels of all pairs, brings the second images closest to
/// the first: the least mean square difference over the pixels that both have, of all whole pixels
/// up to `farthest` m. Displacements that leave less than half of what no displacement has to
/// compare do not count.
Displacement SearchDisplacement(
  const std::vector<ImagePair>& pairs, const GridSpecification& grid, double farthest);

/// Displacements at the nodes of a lattice, improved image by image from coarse to fine.
class MotionSolver
{
public:
  /// Starts from `prevailing` everywhere; no displacement will be longer than `farthest` m.
  MotionSolver(const GridSpecification& grid, const MotionOptions& options,
    const Displacement& prevailing, double farthest);

  /// Improves the displacements by what the images say (Gauss–Newton).
  void Refine(const std::vector<ImagePair>& pairs);

  /// The displacements as motion; `seconds` is the mean time.
  MotionField Motion(double seconds) const;

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

  std::vector<EchoPixel> FindEcho(const ImagePair& pair) const;
  void CountPixels(const MotionImage& image, std::vector<Demand>& demands) const;
  void AddDemands(const ImagePair& pair, const std::vector<EchoPixel>& pixels,
    std::vector<Demand>& demands) const;
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
