// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file   vtkNexradGatePlacement.h
 * @brief  where the gates of a ray lie, in the coordinates that a reader was asked for
 */
#ifndef vtkNexradGatePlacement_h
#define vtkNexradGatePlacement_h

#include "nexrad/Geometry/Beam.h"
#include "nexrad/Geometry/SiteGeoreference.h"
#include "nexrad/Grid/GridSpecification.h"
#include "nexrad/Model/RadarVolume.h"

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

enum class vtkNexradCoordinates
{
  Local,      ///< m east, north and up of the antenna
  Geographic, ///< degrees east and north, m above mean sea level
  Projected   ///< m east and north of a centre, m above mean sea level, as in a merged volume
};

/**
 * Turns slant ranges into points: the beam by Formulas B1, the ground by B3. Local coordinates are
 * those of the azimuthal equidistant projection about the site: at the azimuth and the distance
 * along the ground. A ray's line on the ground is smooth, so that geodesics are solved at nodes 20
 * km apart only, with cubics between them (to better than a millimetre up to 460 km).
 */
class vtkNexradGatePlacement
{
public:
  /**
   * `center` is the latitude and longitude in degrees about which Projected coordinates count.
   * Throws nexrad::Error when the coordinates need a position and the site has none.
   */
  vtkNexradGatePlacement(const nexrad::Site& site, vtkNexradCoordinates coordinates,
    const std::optional<std::array<double, 2>>& center, double effectiveRadiusFactor);

  /**
   * Writes x, y, z of `gates` gates, the first at `firstGate` m of slant range, `spacing` m apart.
   */
  void PlaceRay(const nexrad::Ray& ray, double firstGate, double spacing, std::size_t gates,
    double* points) const;

private:
  using Nodes = std::vector<std::array<double, 2>>;
  Nodes MakeNodes(double azimuth, double farthest) const;

  nexrad::BeamModel beam;
  vtkNexradCoordinates coordinates;
  nexrad::Position site;
  nexrad::GridSpecification projection;
};

#endif
// VTK-HeaderTest-Exclude: vtkNexradGatePlacement.h
