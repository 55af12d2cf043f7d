// SPDX-License-Identifier: BSD-3-Clause
// Convex polygons and planes that cut them.
#ifndef vtkTextureSlicePolygon_h
#define vtkTextureSlicePolygon_h

#include <array>
#include <cstddef>
#include <vector>

namespace vtkTextureSlice
{

using Vector = std::array<double, 3>;
/// a, b, c, d: a*x + b*y + c*z + d is not negative on the side that is kept.
using Plane = std::array<double, 4>;
using Polygon = std::vector<Vector>;

inline double Evaluate(const Plane& plane, const Vector& p)
{
  return plane[0] * p[0] + plane[1] * p[1] + plane[2] * p[2] + plane[3];
}

/// Sutherland and Hodgman: the part of a convex polygon on the positive side of a plane.
inline void ClipPolygon(const Polygon& polygon, const Plane& plane, Polygon& kept)
{
  kept.clear();
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const Vector& a = polygon[i];
    const Vector& b = polygon[(i + 1) % polygon.size()];
    const double valueA = Evaluate(plane, a);
    const double valueB = Evaluate(plane, b);
    if (valueA >= 0.0)
    {
      kept.push_back(a);
    }
    if ((valueA >= 0.0) != (valueB >= 0.0))
    {
      const double t = valueA / (valueA - valueB);
      kept.push_back(
        {a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2])});
    }
  }
}

} // namespace vtkTextureSlice

#endif
