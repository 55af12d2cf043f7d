// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkNexradGridAlgorithm
 * @brief   what the algorithms that make a merged volume have in common
 *
 * Which grid, which moment, by which method. The output is the vtkImageData that
 * vtkNexradImageConversion.h describes.
 *
 * ```
 *      +----------------------+ HeightRange[1]      the box round the circles of Range
 *      |  .--.        .--.    |                     about all sites, or GeographicBounds;
 *      | ( o  )      ( o  )   |                     Dimensions voxels in it, points at
 *      |  '--'        '--'    |                     their centres
 *      +----------------------+ HeightRange[0]
 * ```
 *
 * A pipeline may ask for any box of the voxels (UPDATE_EXTENT), as it does when several processes
 * share the volume: only that is made, and each voxel is what it is in the whole.
 */
#ifndef vtkNexradGridAlgorithm_h
#define vtkNexradGridAlgorithm_h

#include "vtkImageAlgorithm.h"
#include "vtkNexradFiltersModule.h" // For export macro

#include <string> // For members
#include <vector> // For moments and volumes

namespace nexrad
{
enum class MomentName : unsigned char;
struct GridRequest;
struct MergeOptions;
} // namespace nexrad

class VTKNEXRADFILTERS_EXPORT vtkNexradGridAlgorithm : public vtkImageAlgorithm
{
public:
  vtkTypeMacro(vtkNexradGridAlgorithm, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * THESIS: the bin average of Formulas T1 to T7, on reflectivity limited to 0 to 80 dBZ. BEAM:
   * interpolation between the beams, each ray at its own time, with what was not scanned, what
   * holds no echo and what is range folded kept apart (Formulas G, W and A).
   */
  enum MergeMethod
  {
    THESIS = 0,
    BEAM = 1
  };

  /**
   * What becomes of a voxel that several radars scanned (Formulas W1 to W4). MEAN: all count alike.
   * NEAREST: the nearest radar alone. MAXIMUM: the largest value. DISTANCE: weights that fall with
   * the distance.
   */
  enum OverlapStrategyType
  {
    MEAN = 0,
    NEAREST = 1,
    MAXIMUM = 2,
    DISTANCE = 3
  };

  /**
   * Interpolation between two observations of a radar. LINEAR: without a shift (Formulas A1).
   * MOTION: along the motion of the echo (A2a).
   */
  enum TimeInterpolationType
  {
    LINEAR = 0,
    MOTION = 1
  };

  /**
   * What quality control takes out of REF, see SetQuality.
   */
  enum QualityLevelType
  {
    QUALITY_OFF = 0,
    QUALITY_STANDARD = 1,
    QUALITY_STRICT = 2
  };

  /**
   * PROJECTED: metres east and north of the domain's centre in the azimuthal equidistant
   * projection of WGS84. GEOGRAPHIC: degrees of longitude and latitude, as the thesis has them.
   */
  enum AxesType
  {
    PROJECTED = 0,
    GEOGRAPHIC = 1
  };

  ///@{
  /**
   * Voxels along x, y and z. 256, 256, 128 by default; each at least 1.
   */
  vtkSetVector3Macro(Dimensions, int);
  vtkGetVector3Macro(Dimensions, int);
  ///@}

  ///@{
  /**
   * Radius in metres of the circle about each site that the grid must hold. 230 000 by default.
   */
  vtkSetMacro(Range, double);
  vtkGetMacro(Range, double);
  ///@}

  ///@{
  /**
   * Lower and upper face of the grid in metres above mean sea level. 0 and 20 000 by default.
   */
  vtkSetVector2Macro(HeightRange, double);
  vtkGetVector2Macro(HeightRange, double);
  ///@}

  ///@{
  /**
   * West, south, east and north outer faces in degrees, in place of the box about the sites when
   * UseGeographicBounds is on. Off by default.
   */
  vtkSetVector4Macro(GeographicBounds, double);
  vtkGetVector4Macro(GeographicBounds, double);
  vtkSetMacro(UseGeographicBounds, bool);
  vtkGetMacro(UseGeographicBounds, bool);
  vtkBooleanMacro(UseGeographicBounds, bool);
  ///@}

  ///@{
  /**
   * What x and y mean. PROJECTED by default.
   */
  vtkSetClampMacro(Axes, int, PROJECTED, GEOGRAPHIC);
  vtkGetMacro(Axes, int);
  void SetAxesToProjected() { this->SetAxes(PROJECTED); }
  void SetAxesToGeographic() { this->SetAxes(GEOGRAPHIC); }
  ///@}

  ///@{
  /**
   * Name of the moment: "REF" (the default), "VEL", "SW", "ZDR", "PHI", "RHO" or "CFP", or one that
   * is derived of them: "SRV" (radial velocity relative to the storm, m/s), "AZSHEAR" (azimuthal
   * shear, 1/s), "DIV" (radial divergence, 1/s) or "KDP" (specific differential phase, degrees/km;
   * nexrad::MomentMaker). THESIS knows REF alone. vtkNexradDayReader also takes several, as
   * "REF,VEL": each file is decoded once for all of them, and the first gives the active scalars
   * and the ghost flags (vtkNexradImageConversion.h).
   */
  vtkSetMacro(Moment, std::string);
  vtkGetMacro(Moment, std::string);
  ///@}

  ///@{
  /**
   * The method, BEAM by default. An unknown one is refused with an error, and the method stays.
   */
  void SetMethod(int method);
  vtkGetMacro(Method, int);
  void SetMethodToThesis() { this->SetMethod(THESIS); }
  void SetMethodToBeam() { this->SetMethod(BEAM); }
  ///@}

  ///@{
  /**
   * Takes out gates whose value stands nearly alone, before anything is merged: those of which
   * fewer than this many of the 26 neighbours in ray, gate and tilt have a value. Such a gate
   * carries no weight, and does not say that there is no echo. 0…26; 0, which takes out none, by
   * default.
   */
  vtkSetClampMacro(FewestNeighbours, int, 0, 26);
  vtkGetMacro(FewestNeighbours, int);
  ///@}

  ///@{
  /**
   * What quality control takes out of REF before it is merged (Formulas Q1 to Q5).
   * QUALITY_STANDARD: ground clutter and anomalous propagation, spikes of the sun and of other
   * transmitters, receiver faults and speckle. QUALITY_STRICT: birds and insects too. QUALITY_OFF:
   * nothing. Gates that are taken out carry no weight; a voxel that no other radar saw has the
   * state 4, filtered. For BEAM; THESIS takes out nothing. QUALITY_STANDARD by default.
   */
  vtkSetClampMacro(Quality, int, QUALITY_OFF, QUALITY_STRICT);
  vtkGetMacro(Quality, int);
  void SetQualityToOff() { this->SetQuality(QUALITY_OFF); }
  void SetQualityToStandard() { this->SetQuality(QUALITY_STANDARD); }
  void SetQualityToStrict() { this->SetQuality(QUALITY_STRICT); }
  ///@}

  ///@{
  /**
   * Unfold the velocities of VEL before they are merged (Formulas V1 to V4). Gates whose fold
   * nothing decides then count as not sampled. Off leaves them as the radars measured them, each
   * within the Nyquist velocity of its ray. SRV, AZSHEAR and DIV are made of unfolded velocities
   * either way. On by default.
   */
  vtkSetMacro(Dealiasing, bool);
  vtkGetMacro(Dealiasing, bool);
  vtkBooleanMacro(Dealiasing, bool);
  ///@}

  ///@{
  /**
   * The motion of the storm in metres a second towards east and north that SRV is relative to, when
   * UseStormMotion is on. 0, 0 and off by default: then it is the mean wind of the lowest 6 km over
   * each radar, of the wind profile of each volume (nexrad::EstimateStormMotion).
   */
  vtkSetVector2Macro(StormMotion, double);
  vtkGetVector2Macro(StormMotion, double);
  vtkSetMacro(UseStormMotion, bool);
  vtkGetMacro(UseStormMotion, bool);
  vtkBooleanMacro(UseStormMotion, bool);
  ///@}

  ///@{
  /**
   * For BEAM and reflectivity: the biases of radars that are taken off before anything is merged
   * (Formulas Q6). "off" (the default): none. "auto": those that the comparison of the radars finds
   * where two of them see the same places; vtkNexradDayReader then decodes all files first. Else
   * names of radars, and how many dB they measure too high, -20 to 20: "KLSX:2,KILX:-1.5". A
   * radar that is none of the inputs' is an error.
   */
  vtkSetMacro(Bias, std::string);
  vtkGetMacro(Bias, std::string);
  ///@}

  ///@{
  /**
   * For BEAM: how radars that scanned the same voxel are put together. DISTANCE by default.
   * Velocity, divergence, spectrum width and differential phase always take the nearest, azimuthal
   * shear always the largest value.
   */
  vtkSetClampMacro(OverlapStrategy, int, MEAN, DISTANCE);
  vtkGetMacro(OverlapStrategy, int);
  ///@}

  ///@{
  /**
   * For BEAM and DISTANCE: the distance in metres at which a radar's weight has fallen to 1/e of
   * that at the radar. 100 000 by default; must be above 0.
   */
  vtkSetMacro(OverlapLength, double);
  vtkGetMacro(OverlapLength, double);
  ///@}

  ///@{
  /**
   * For BEAM: interpolation in time. MOTION by default: along the motion that is found from the
   * reflectivity of the volumes about the time, or along GivenMotion. Other moments than REF are
   * interpolated linearly unless a motion is given.
   */
  vtkSetClampMacro(TimeInterpolation, int, LINEAR, MOTION);
  vtkGetMacro(TimeInterpolation, int);
  void SetTimeInterpolationToLinear() { this->SetTimeInterpolation(LINEAR); }
  void SetTimeInterpolationToMotion() { this->SetTimeInterpolation(MOTION); }
  ///@}

  ///@{
  /**
   * For BEAM and MOTION: the motion of all echo in metres a second towards east and north, in place
   * of the one that is found, when UseGivenMotion is on. 0, 0 and off by default. Its speed must be
   * at most 150.
   */
  vtkSetVector2Macro(GivenMotion, double);
  vtkGetVector2Macro(GivenMotion, double);
  vtkSetMacro(UseGivenMotion, bool);
  vtkGetMacro(UseGivenMotion, bool);
  vtkBooleanMacro(UseGivenMotion, bool);
  ///@}

  ///@{
  /**
   * For BEAM: take back from reflectivity in dBZ what the width of the beam did to it (Formulas
   * G9). Off leaves the values as the radars measured them. On by default.
   */
  vtkSetMacro(Sharpening, bool);
  vtkGetMacro(Sharpening, bool);
  vtkBooleanMacro(Sharpening, bool);
  ///@}

  ///@{
  /**
   * For BEAM: interpolate and average reflectivity as Z in place of dBZ. Off by default.
   */
  vtkSetMacro(LinearReflectivity, bool);
  vtkGetMacro(LinearReflectivity, bool);
  vtkBooleanMacro(LinearReflectivity, bool);
  ///@}

  ///@{
  /**
   * For BEAM: fill each column between and below what was scanned, as THESIS always does. Off by
   * default.
   */
  vtkSetMacro(ColumnFilling, bool);
  vtkGetMacro(ColumnFilling, bool);
  vtkBooleanMacro(ColumnFilling, bool);
  ///@}

  ///@{
  /**
   * For BEAM: add the ancillary arrays `REF_age`, `REF_radars`,
   * `REF_weight` and `REF_site` (vtkNexradImageConversion.h). Off by default.
   */
  vtkSetMacro(AncillaryArrays, bool);
  vtkGetMacro(AncillaryArrays, bool);
  vtkBooleanMacro(AncillaryArrays, bool);
  ///@}

protected:
  vtkNexradGridAlgorithm();
  ~vtkNexradGridAlgorithm() override;

  /**
   * The moments. Throws nexrad::Error for one that the method does not know.
   */
  std::vector<nexrad::MomentName> CheckMoments() const;

  nexrad::GridRequest MakeGridRequest() const;

  /**
   * What the properties ask of merged volumes. Throws nexrad::Error as CheckMoments does, and for
   * a Bias that is none.
   */
  nexrad::MergeOptions MakeMergeOptions() const;

  /**
   * Sets the error code and gives the error. Returns 0, for a request that failed.
   */
  int Fail(unsigned long code, const std::string& line);

  int Dimensions[3] = {256, 256, 128};
  double Range = 230000.0;
  double HeightRange[2] = {0.0, 20000.0};
  double GeographicBounds[4] = {0.0, 0.0, 0.0, 0.0};
  bool UseGeographicBounds = false;
  int Axes = PROJECTED;
  std::string Moment = "REF";
  int Method = BEAM;
  int FewestNeighbours = 0;
  int Quality = QUALITY_STANDARD;
  bool Dealiasing = true;
  double StormMotion[2] = {0.0, 0.0};
  bool UseStormMotion = false;
  std::string Bias = "off";
  int OverlapStrategy = DISTANCE;
  double OverlapLength = 100000.0;
  int TimeInterpolation = MOTION;
  double GivenMotion[2] = {0.0, 0.0};
  bool UseGivenMotion = false;
  bool LinearReflectivity = false;
  bool Sharpening = true;
  bool ColumnFilling = false;
  bool AncillaryArrays = false;

private:
  vtkNexradGridAlgorithm(const vtkNexradGridAlgorithm&) = delete;
  void operator=(const vtkNexradGridAlgorithm&) = delete;
};

#endif
