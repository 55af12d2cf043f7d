// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkNexradSweepReader
 * @brief   what the readers of radar sweeps have in common
 *
 * Which moments to read, in which coordinates, and what to assume of a site whose file does not
 * say it. See vtkNexradLevel2Reader for the output.
 *
 * Several processes of a parallel pipeline share the sweeps out among them in turn
 * (UPDATE_PIECE_NUMBER): each has all data sets, and grids in those that are its own. Each decodes
 * the files whole.
 */
#ifndef vtkNexradSweepReader_h
#define vtkNexradSweepReader_h

#include "vtkNew.h"            // For members
#include "vtkNexradIOModule.h" // For export macro
#include "vtkPartitionedDataSetCollectionAlgorithm.h"

#include <string> // For members

class vtkDataArraySelection;
class vtkInformation;
class vtkStringArray;

namespace nexrad
{
struct Level2Options;
}
struct vtkNexradSweepOptions;

class VTKNEXRADIO_EXPORT vtkNexradSweepReader : public vtkPartitionedDataSetCollectionAlgorithm
{
public:
  vtkTypeMacro(vtkNexradSweepReader, vtkPartitionedDataSetCollectionAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * LOCAL: metres east, north and up of the antenna (azimuthal equidistant about the site).
   * GEOGRAPHIC: longitude and latitude in degrees, metres above mean sea level; longitudes count on
   * past 180 degrees where a sweep crosses the antimeridian.
   * PROJECTED: metres east and north of the projection's centre in the azimuthal equidistant
   * projection of WGS84, metres above mean sea level: the coordinates of a merged volume.
   */
  enum CoordinateSystem
  {
    LOCAL = 0,
    GEOGRAPHIC = 1,
    PROJECTED = 2
  };

  ///@{
  /**
   * The coordinates of the points. The last two need the site's position.
   */
  vtkSetClampMacro(Coordinates, int, LOCAL, PROJECTED);
  vtkGetMacro(Coordinates, int);
  void SetCoordinatesToLocal() { this->SetCoordinates(LOCAL); }
  void SetCoordinatesToGeographic() { this->SetCoordinates(GEOGRAPHIC); }
  void SetCoordinatesToProjected() { this->SetCoordinates(PROJECTED); }
  ///@}

  ///@{
  /**
   * Latitude and longitude in degrees of the centre of PROJECTED coordinates, when
   * UseProjectionCenter is on. Off by default: the reader chooses.
   */
  vtkSetVector2Macro(ProjectionCenter, double);
  vtkGetVector2Macro(ProjectionCenter, double);
  vtkSetMacro(UseProjectionCenter, bool);
  vtkGetMacro(UseProjectionCenter, bool);
  vtkBooleanMacro(UseProjectionCenter, bool);
  ///@}

  ///@{
  /**
   * The factor k of the effective earth radius (Formulas B1), 4/3 by default; the NEXRAD system
   * itself uses 1.21. At least 0.1.
   */
  vtkSetClampMacro(EffectiveRadiusFactor, double, 0.1, 1e6);
  vtkGetMacro(EffectiveRadiusFactor, double);
  ///@}

  ///@{
  /**
   * Name of the site (ICAO identifier) in place of the one in the file. Empty by default: the
   * file's.
   */
  vtkSetMacro(SiteName, std::string);
  vtkGetMacro(SiteName, std::string);
  ///@}

  ///@{
  /**
   * Latitude and longitude in degrees and height of the antenna in metres above mean sea level, in
   * place of the file's (or the site table's) when UseSitePosition is on. Off by default.
   */
  vtkSetVector3Macro(SitePosition, double);
  vtkGetVector3Macro(SitePosition, double);
  vtkSetMacro(UseSitePosition, bool);
  vtkGetMacro(UseSitePosition, bool);
  vtkBooleanMacro(UseSitePosition, bool);
  ///@}

  /**
   * The moments to read, by the names of their arrays: REF, VEL, SW, ZDR, PHI, RHO and CFP, all
   * enabled by default. It lists all seven, whatever the file holds.
   */
  vtkDataArraySelection* GetMomentSelection();

  /**
   * What was wrong in the inputs of the last run, one line each: "FILE: offset N: WHAT". The same
   * lines come as warnings.
   */
  vtkStringArray* GetDamage();

  vtkMTimeType GetMTime() override;

protected:
  vtkNexradSweepReader();
  ~vtkNexradSweepReader() override;

  nexrad::Level2Options MakeLevel2Options() const;
  vtkNexradSweepOptions MakeSweepOptions(vtkInformation* outputInformation);

  /**
   * Keeps the line and gives the warning.
   */
  void AddDamage(const std::string& line);

  /**
   * Sets the error code and gives the error. Returns 0, for a request that failed.
   */
  int Fail(unsigned long code, const std::string& line);

  int Coordinates = LOCAL;
  double ProjectionCenter[2] = {0.0, 0.0};
  bool UseProjectionCenter = false;
  double EffectiveRadiusFactor = 4.0 / 3.0;
  std::string SiteName;
  double SitePosition[3] = {0.0, 0.0, 0.0};
  bool UseSitePosition = false;
  vtkNew<vtkDataArraySelection> MomentSelection;
  vtkNew<vtkStringArray> Damage;

private:
  vtkNexradSweepReader(const vtkNexradSweepReader&) = delete;
  void operator=(const vtkNexradSweepReader&) = delete;
};

#endif
