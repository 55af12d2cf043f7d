// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkNexradGeographicCoordinates
 * @brief   longitudes and latitudes of points of a merged volume, and the points of those
 *
 * The grid of a volume and its projection are taken from its origin, spacing and field data
 * (vtkNexradImageConversion.h). Longitudes and latitudes are geodetic, on WGS84, in degrees east
 * and north; longitudes lie from -180 to 180.
 *
 * Nothing is set up: the functions are static.
 */
#ifndef vtkNexradGeographicCoordinates_h
#define vtkNexradGeographicCoordinates_h

#include "vtkNexradIOModule.h" // For export macro
#include "vtkObject.h"

class vtkDoubleArray;
class vtkImageData;

class VTKNEXRADIO_EXPORT vtkNexradGeographicCoordinates : public vtkObject
{
public:
  static vtkNexradGeographicCoordinates* New();
  vtkTypeMacro(vtkNexradGeographicCoordinates, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Turns pairs x, y of the volume's coordinates into pairs longitude, latitude, and back. Both
   * arrays have two components; `to` gets the length of `from`. False, and `to` is empty, for an
   * image whose axes are turned and for arrays that have another number of components.
   */
  static bool ToGeographic(vtkImageData* volume, vtkDoubleArray* from, vtkDoubleArray* to);
  static bool FromGeographic(vtkImageData* volume, vtkDoubleArray* from, vtkDoubleArray* to);
  ///@}

protected:
  vtkNexradGeographicCoordinates() = default;
  ~vtkNexradGeographicCoordinates() override = default;

private:
  vtkNexradGeographicCoordinates(const vtkNexradGeographicCoordinates&) = delete;
  void operator=(const vtkNexradGeographicCoordinates&) = delete;
};

#endif
