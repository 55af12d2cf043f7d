// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Beams/BeamVolume.h"
#include "nexrad/Motion/MotionEstimate.h"
#include "nexrad/System/RangeLoop.h"

#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace nexrad
{

/// Longest time between two volumes of one radar from which the motion of the echo is estimated
/// (Formulas A3a).
constexpr Duration LongestMotionInterval = std::chrono::minutes(20);

/// Finds the motion of the echo for the merges of one run (Formulas A3a): at a time, the one motion
/// that fits two volumes of each radar with echo: of those far enough apart in time the nearest to
/// each other between whose middles the time lies, else those whose middles are nearest to it. Two
/// volumes of which one lacks most of the tilts of the other are compared by their lowest tilts.
/// Each volume's images are made once, and kept as long as the volume takes part; where the volumes
/// are those of the call before, so is the motion. What is found depends on the volumes and the
/// time alone.
class MotionTracker
{
public:
  /// `beam` is the path of the beams. Throws Error for a grid without voxels.
  explicit MotionTracker(const GridSpecification& grid, const BeamModel& beam = BeamModel());

  /// The motion on the grid, from volumes of reflectivity about the time in any order; nullptr
  /// where nothing is known: no radar has two volumes with echo near enough to each other.
  std::shared_ptr<const MotionField> Find(
    const BeamVolumes& volumes, Time time, const RangeLoop& loop = {});

  /// The one motion of the echo that is in an area of the grid at the time, m/s: that of Find in
  /// the middle of the area, improved by the echo in the area alone (EstimateMotionWithin). Empty
  /// where Find knows nothing.
  std::optional<Velocity> FindWithin(
    const GridArea& area, const BeamVolumes& volumes, Time time, const RangeLoop& loop = {});

private:
  using Volume = std::shared_ptr<const BeamVolume>;
  // What is compared of a volume: the strongest echo of all its tilts, or of its lowest one.
  struct Picture
  {
    Volume volume;
    bool lowest = false;

    const VolumeComposite& Composite() const { return lowest ? volume->lowest : volume->composite; }
    bool operator==(const Picture& other) const
    {
      return volume == other.volume && lowest == other.lowest;
    }
  };
  struct Pair
  {
    Picture before;
    Picture after;

    // Between their echo.
    double Seconds() const { return after.Composite().echoTime - before.Composite().echoTime; }
    // s, less where one tilt alone is compared.
    double TimeBase() const { return before.lowest ? 0.5 * this->Seconds() : this->Seconds(); }
    bool operator==(const Pair& other) const
    {
      return before == other.before && after == other.after;
    }
  };
  struct KeptPyramid
  {
    Picture picture;
    MotionPyramid images;
  };

  static std::vector<Pair> FindPairs(const BeamVolumes& volumes, Time time);
  static std::optional<Pair> FindPair(BeamVolumes own, Time time);
  static std::optional<Pair> Compare(const Volume& before, const Volume& after);
  static double TrustIn(const std::vector<Pair>& pairs);
  void MakeImages(const BeamVolumes& volumes, const RangeLoop& loop);
  std::vector<MotionPair> ImagesOfPairs() const;

  const GridSpecification grid;
  const GridSpecification pixels; // the same box in pixels of the images
  const BeamModel beam;
  MotionOptions options;
  std::map<std::array<double, 2>, SiteGeometry> geometries; // by latitude and longitude
  std::vector<KeptPyramid> kept;
  std::vector<Pair> pairs; // of the call before
  std::shared_ptr<const MotionField> motion;
};

} // namespace nexrad
