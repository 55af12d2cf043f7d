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

#include <map>    // For members
#include <string> // For members

namespace nexrad
{
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
   * Interpolation between two observations of a radar. LINEAR: without a shift (Formulas A1).
   * MOTION: along the motion of the echo (A2a).
   */
  enum TimeInterpolationType
  {
    LINEAR = 0,
    MOTION = 1
  };

  ///@{
  /**
   * Sets an option of the merge, and says what it is. The keys and texts are those of `nexrad3d
   * grid` (user guide, chapter 3): "overlap-length" and "80km". A flag is "on" or "off", and its
   * key has no "no-" before it: "sharpening". An empty text is the default. A number is metres,
   * seconds, 0 or 1 of a flag, or the place of a name among those of a choice, from 0. An unknown
   * key gives an error, and changes nothing; a wrong text is an error of the next update
   * (UserError). GetOption gives a text in its normal form: "230km" for 230000.
   */
  void SetOption(const char* key, const char* text);
  void SetOption(const char* key, double number);
  std::string GetOption(const char* key) const;
  ///@}

  /**
   * What the options are, as a JSON array with an object for each: key, kind, choices, default, and
   * a sentence ("says").
   */
  static std::string GetOptionTable();

  /**
   * Voxels along x, y and z. 256, 256, 128 by default; each at least 1.
   */
  void SetDimensions(int x, int y, int z);
  void SetDimensions(const int dimensions[3]);

  /**
   * Radius in metres of the circle about each site that the grid must hold. 230 000 by default.
   */
  void SetRange(double metres);

  /**
   * Lower and upper face of the grid in metres above mean sea level. 0 and 20 000 by default.
   */
  void SetHeightRange(double lower, double upper);

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
   * What x and y mean. Projected by default: metres east and north of the domain's centre in the
   * azimuthal equidistant projection of WGS84. Geographic: degrees of longitude and latitude, as
   * the thesis has them.
   */
  void SetAxesToProjected() { this->SetOption("axes", "projected"); }
  void SetAxesToGeographic() { this->SetOption("axes", "geographic"); }
  ///@}

  ///@{
  /**
   * Name of the moment: "REF" (the default), "VEL", "SW", "ZDR", "PHI", "RHO" or "CFP", or one that
   * is derived of them: "SRV" (radial velocity relative to the storm, m/s), "AZSHEAR" (azimuthal
   * shear, 1/s), "DIV" (radial divergence, 1/s) or "KDP" (specific differential phase, degrees/km;
   * nexrad::MomentMaker). THESIS knows REF alone. Several, as "REF,VEL", are merged in one run:
   * each file is decoded once for all of them, and the first gives the active scalars and the ghost
   * flags (vtkNexradImageConversion.h).
   */
  void SetMoment(const std::string& names) { this->SetOption("moment", names.c_str()); }
  std::string GetMoment() const { return this->GetOption("moment"); }
  ///@}

  ///@{
  /**
   * The method, BEAM by default. An unknown one is refused with an error, and the method stays.
   */
  void SetMethod(int method);
  int GetMethod() const { return this->GetOption("method") == "thesis" ? THESIS : BEAM; }
  void SetMethodToThesis() { this->SetMethod(THESIS); }
  void SetMethodToBeam() { this->SetMethod(BEAM); }
  ///@}

  ///@{
  /**
   * What quality control takes out of REF before it is merged (Formulas Q1 to Q5). Standard (the
   * default): ground clutter and anomalous propagation, spikes of the sun and of other
   * transmitters, receiver faults and speckle. Strict: birds and insects too. Off: nothing. Gates
   * that are taken out carry no weight; a voxel that no other radar saw has the state 4, filtered.
   * For BEAM; THESIS takes out nothing.
   */
  void SetQualityToOff() { this->SetOption("quality", "off"); }
  void SetQualityToStandard() { this->SetOption("quality", "standard"); }
  void SetQualityToStrict() { this->SetOption("quality", "strict"); }
  ///@}

  ///@{
  /**
   * Unfold the velocities of VEL before they are merged (Formulas V1 to V4). Gates whose fold
   * nothing decides then count as not sampled. Off leaves them as the radars measured them, each
   * within the Nyquist velocity of its ray. SRV, AZSHEAR and DIV are made of unfolded velocities
   * either way. On by default.
   */
  void SetDealiasing(bool on) { this->SetOption("dealiasing", on ? "on" : "off"); }
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
  void SetSharpening(bool on) { this->SetOption("sharpening", on ? "on" : "off"); }
  vtkBooleanMacro(Sharpening, bool);
  ///@}

  ///@{
  /**
   * For BEAM: add the ancillary arrays `REF_age`, `REF_radars`,
   * `REF_weight` and `REF_site` (vtkNexradImageConversion.h). Off by default.
   */
  void SetAncillaryArrays(bool on) { this->SetOption("ancillary", on ? "on" : "off"); }
  vtkBooleanMacro(AncillaryArrays, bool);
  ///@}

protected:
  vtkNexradGridAlgorithm();
  ~vtkNexradGridAlgorithm() override;

  /**
   * What the options ask of merged volumes. Throws nexrad::Error for a text that is wrong, and for
   * a moment that the method does not know.
   */
  nexrad::MergeOptions MakeMergeOptions() const;

  /**
   * Sets the error code and gives the error. Returns 0, for a request that failed.
   */
  int Fail(unsigned long code, const std::string& line);

  double GeographicBounds[4] = {0.0, 0.0, 0.0, 0.0};
  bool UseGeographicBounds = false;
  double StormMotion[2] = {0.0, 0.0};
  bool UseStormMotion = false;
  int TimeInterpolation = MOTION;
  double GivenMotion[2] = {0.0, 0.0};
  bool UseGivenMotion = false;

private:
  vtkNexradGridAlgorithm(const vtkNexradGridAlgorithm&) = delete;
  void operator=(const vtkNexradGridAlgorithm&) = delete;

  std::map<std::string, std::string> Texts; // of the options that were set
};

#endif
