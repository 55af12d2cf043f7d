// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Velocity/VelocityDerivatives.h"

#include "nexrad/Geometry/Angles.h"
#include "nexrad/Velocity/VelocityVolume.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace nexrad
{

namespace
{

constexpr double cressmanRadius = 2'500.0; // m

struct Slopes
{
  double alongAzimuth;
  double alongRay;
};

// The sums of a weighted least-squares plane c0 + c1·x + c2·y.
class PlaneFit
{
public:
  void Add(double x, double y, double value)
  {
    const double squares = x * x + y * y;
    constexpr double limit = cressmanRadius * cressmanRadius;
    const double weight = std::max(0.0, (limit - squares) / (limit + squares));
    s += weight;
    sx += weight * x;
    sy += weight * y;
    sxx += weight * x * x;
    sxy += weight * x * y;
    syy += weight * y * y;
    sv += weight * value;
    sxv += weight * x * value;
    syv += weight * y * value;
  }

  Slopes Solve() const
  {
    const double xx = sxx - sx * sx / s;
    const double xy = sxy - sx * sy / s;
    const double yy = syy - sy * sy / s;
    const double xv = sxv - sx * sv / s;
    const double yv = syv - sy * sv / s;
    const double determinant = xx * yy - xy * xy;
    return {(xv * yy - yv * xy) / determinant, (yv * xx - xv * xy) / determinant};
  }

private:
  double s = 0.0, sx = 0.0, sy = 0.0, sxx = 0.0, sxy = 0.0, syy = 0.0;
  double sv = 0.0, sxv = 0.0, syv = 0.0;
};

class DerivativeField
{
public:
  // Half the size of the window along the azimuth and along the ray, m.
  DerivativeField(const VelocitySweep& theSweep, double theHalfWidth, double halfLength)
    : sweep(theSweep)
    , halfWidth(theHalfWidth)
    , ring(MakeSweepRing(theSweep))
    , turn(2.0 * Pi / static_cast<double>(std::max<std::size_t>(ring.rows, 1)))
    , reach(std::max(std::ptrdiff_t(1), std::ptrdiff_t(halfLength / ring.gateSpacing)))
  {
  }

  std::vector<float> Make(double Slopes::*slope) const
  {
    std::vector<float> field(sweep.values.size(), std::numeric_limits<float>::quiet_NaN());
    for (std::size_t row = 0; row < ring.rows; ++row)
    {
      for (std::size_t gate = 0; gate < ring.gates; ++gate)
      {
        const std::size_t index = sweep.Index(ring.ray[row], gate);
        if (!std::isnan(sweep.values[index]) && ring.RangeOf(gate) > nearest)
        {
          field[index] = this->At(row, gate, slope);
        }
      }
    }
    return field;
  }

private:
  // Closer in the window holds a quarter of all rays and more, and no plane fits.
  static constexpr double nearest = 2'000.0; // m

  float At(std::size_t row, std::size_t gate, double Slopes::*slope) const
  {
    PlaneFit fit;
    int found = this->AddRow(row, row, gate, fit);
    int wanted = int(2 * reach + 1);
    const auto rows = std::max(1, int(halfWidth / (turn * ring.RangeOf(gate))));
    std::size_t before = row;
    std::size_t after = row;
    bool hasBefore = true;
    bool hasAfter = true;
    for (int step = 0; step < rows; ++step)
    {
      before = ring.PreviousRow(before);
      hasBefore = hasBefore && ring.beside[before] != 0;
      found += hasBefore ? this->AddRow(row, before, gate, fit) : 0;
      hasAfter = hasAfter && ring.beside[after] != 0;
      after = ring.NextRow(after);
      found += hasAfter ? this->AddRow(row, after, gate, fit) : 0;
      wanted += 2 * int(2 * reach + 1);
    }
    return 3 * found <= 2 * wanted ? std::numeric_limits<float>::quiet_NaN()
                                   : static_cast<float>(fit.Solve().*slope);
  }

  // Adds the gates of one row of the window; returns how many have a velocity.
  int AddRow(std::size_t centre, std::size_t row, std::size_t gate, PlaneFit& fit) const
  {
    const double angle = AngleDifference(static_cast<double>(ring.azimuth[centre]),
                           static_cast<double>(ring.azimuth[row])) *
                         RadiansPerDegree;
    int found = 0;
    for (std::ptrdiff_t step = -reach; step <= reach; ++step)
    {
      const std::ptrdiff_t place = std::ptrdiff_t(gate) + step;
      if (place < 0 || place >= std::ptrdiff_t(ring.gates))
      {
        continue;
      }
      const float value = sweep.values[sweep.Index(ring.ray[row], std::size_t(place))];
      if (!std::isnan(value))
      {
        const double range = ring.RangeOf(std::size_t(place));
        fit.Add(angle * range, double(step) * ring.gateSpacing, double(value));
        ++found;
      }
    }
    return found;
  }

  const VelocitySweep& sweep;
  double halfWidth;
  SweepRing ring;
  double turn; // radians from one ray to the next
  std::ptrdiff_t reach;
};

} // namespace

void SubtractMotion(VelocitySweep& sweep, const Wind& motion)
{
  for (std::size_t ray = 0; ray < sweep.rays.size(); ++ray)
  {
    const double azimuth = static_cast<double>(sweep.rays[ray].azimuth) * RadiansPerDegree;
    const double elevation = static_cast<double>(sweep.rays[ray].elevation) * RadiansPerDegree;
    const auto radial = static_cast<float>(
      (motion.east * std::sin(azimuth) + motion.north * std::cos(azimuth)) * std::cos(elevation));
    for (std::size_t gate = 0; gate < sweep.gates; ++gate)
    {
      sweep.values[sweep.Index(ray, gate)] -= radial; // NaN stays NaN
    }
  }
}

std::vector<float> AzimuthalShear(const VelocitySweep& sweep)
{
  return DerivativeField(sweep, 1'250.0, 375.0).Make(&Slopes::alongAzimuth);
}

std::vector<float> RadialDivergence(const VelocitySweep& sweep)
{
  return DerivativeField(sweep, 375.0, 750.0).Make(&Slopes::alongRay);
}

} // namespace nexrad
