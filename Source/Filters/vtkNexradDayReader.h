// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkNexradDayReader
 * @brief   a merged volume at any time of a day, from the radars' files
 *
 * ```
 *   KEAX  |--volume--||--volume--||--volume--|        files, grouped by the site in them
 *   KLSX     |---volume---||---volume---|
 *   steps      ^    ^    ^    ^    ^    ^             UTC multiples of TimeStep
 * ```
 *
 * Inputs: Level II files, chunk folders and folders of files, of any number of radars. At a time,
 * each radar takes part with its volumes that start just before (or at) and just after it, neither
 * farther than MaximumGap; with one alone where the other is missing. A time in a gap of all radars
 * gives a volume in which nothing is scanned.
 *
 * Output: the vtkImageData that vtkNexradImageConversion.h describes, about all radars of the
 * inputs.
 *
 * ```
 *      +----------------------+ HeightRange[1]      the box round the circles of Range
 *      |  .--.        .--.    |                     about all sites, or the bounds;
 *      | ( o  )      ( o  )   |                     Dimensions voxels in it, points at
 *      |  '--'        '--'    |                     their centres
 *      +----------------------+ HeightRange[0]
 * ```
 *
 * A pipeline may ask for any box of the voxels (UPDATE_EXTENT), as it does when several processes
 * share the volume: only that is made, and each voxel is what it is in the whole.
 *
 * The time steps are the multiples of TimeStep from the first ray to the last, or from BeginTime
 * to EndTime; where there is none from the first ray to the last, the middle between these. Any
 * other time can be asked for as well. Where nothing was scanned for more than a day between two
 * volumes, BeginTime or EndTime must say what is meant (UserError). Times are seconds since
 * 1970-01-01T00:00:00Z. Without a requested time, or for one more than a day before the
 * first time step, the output is that of the first time step.
 *
 * The headers of the files tell which of them lie about a time, so that only those are decoded for
 * an output; for the time steps one or two files of each radar are. Rays, and the outputs that were
 * made, stay in memory up to MemoryLimit each; what does not fit is decoded, or merged, again when
 * it is needed. Where the headers do not tell,
 * or a file turns out to hold another radar's rays or those of another time than its header says,
 * all files are decoded first.
 *
 * Several processes (SetController, UseGlobalController) scan a part of the files each, and
 * exchange once what the files hold: the times, how far each volume sees, and a summary of its echo
 * for the motion estimate. Then each makes the part of the volume that its pipeline asks for
 * (UPDATE_EXTENT), and decodes only the files of the radars that reach that part; no process waits
 * for another any more. The parts together are, bit by bit, the volume of one process.
 *
 * A damaged file gives warnings and still takes part with what can be read of it; a file that
 * cannot be used is named and left out (GetDamage, GetLeftOut). Errors: NoFileNameError,
 * FileNotFoundError (a path that does not exist, an empty folder), FileFormatError (no ray in any
 * input), UserError (settings that cannot be met). Progress counts from 0 to 1 while the files are
 * scanned, and again for each output. An aborted run leaves an empty output; Modified() makes it
 * run again.
 */
#ifndef vtkNexradDayReader_h
#define vtkNexradDayReader_h

#include "vtkImageAlgorithm.h"
#include "vtkNew.h"                 // For members
#include "vtkNexradFiltersModule.h" // For export macro
#include "vtkSmartPointer.h"        // For members

#include <array>  // For dimensions
#include <map>    // For members
#include <memory> // For members
#include <string> // For members
#include <vector> // For members

class vtkDoubleArray;
class vtkMultiProcessController;
class vtkStringArray;

namespace nexrad
{
struct MergeOptions;
struct MergerSetup;
} // namespace nexrad

class VTKNEXRADFILTERS_EXPORT vtkNexradDayReader : public vtkImageAlgorithm
{
public:
  static vtkNexradDayReader* New();
  vtkTypeMacro(vtkNexradDayReader, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The inputs: Level II files, chunk folders, and folders and tar archives of files (read with
   * those within).
   */
  virtual void AddFileName(const char* path);
  virtual void ClearFileNames();
  int GetNumberOfFileNames() const { return static_cast<int>(this->FileNames.size()); }
  const char* GetFileName(int index) const;
  ///@}

  /**
   * 1 when the path looks like a Level II file, one of its containers, a chunk folder, or a folder
   * that holds such files; else 0.
   */
  static int CanReadFile(const char* path);

  ///@{
  /**
   * Sets an option of the merge, and says what it is. The keys and texts are those of `nexrad3d
   * grid` (user guide, chapter 3): "overlap-length" and "80km". A flag is "on" or "off", and its
   * key has no "no-" before it: "sharpening". An empty text is the default. A number is metres,
   * seconds, 0 or 1 of a flag, or the place of a name among those of a choice, from 0. An unknown
   * key gives an error, and changes nothing; a wrong text is an error of the next update
   * (UserError). GetOption gives a text in its normal form: "230km" for 230000. The options have
   * the program's defaults, but that a terminal radar has the range of the others.
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
   * Name of the moment: "REF" (the default), "VEL", "SW", "ZDR", "PHI", "RHO" or "CFP", or one that
   * is derived of them: "SRV" (radial velocity relative to the storm, m/s), "AZSHEAR" (azimuthal
   * shear, 1/s), "DIV" (radial divergence, 1/s) or "KDP" (specific differential phase, degrees/km;
   * nexrad::MomentMaker). The method "thesis" knows REF alone. Several, as "REF,VEL", are merged in
   * one run: each file is decoded once for all of them, and the first gives the active scalars and
   * the ghost flags (vtkNexradImageConversion.h).
   */
  void SetMoment(const std::string& names) { this->SetOption("moment", names.c_str()); }
  std::string GetMoment() const { return this->GetOption("moment"); }
  ///@}

  ///@{
  /**
   * Distance between time steps in seconds, to the millisecond. 300 by default; more than 0.
   */
  vtkSetMacro(TimeStep, double);
  vtkGetMacro(TimeStep, double);
  ///@}

  ///@{
  /**
   * First and last time that may be a time step, both inclusive. By default (VTK_DOUBLE_MIN and
   * VTK_DOUBLE_MAX) those of the first and of the last ray.
   */
  vtkSetMacro(BeginTime, double);
  vtkGetMacro(BeginTime, double);
  vtkSetMacro(EndTime, double);
  vtkGetMacro(EndTime, double);
  ///@}

  ///@{
  /**
   * BeginTime and EndTime as text for a panel: UTC like "2010-09-11T20:05" (ISO 8601, without
   * seconds or with them, a space in place of T), or seconds since 1970-01-01T00:00:00Z. Empty
   * where they are those of the data. A text that is no time is an error, and changes nothing.
   */
  virtual void SetBeginTimeText(const std::string& text);
  std::string GetBeginTimeText() const;
  virtual void SetEndTimeText(const std::string& text);
  std::string GetEndTimeText() const;
  ///@}

  ///@{
  /**
   * A volume that starts farther from the time takes no part, in seconds. 900 by default.
   */
  vtkSetClampMacro(MaximumGap, double, 0.0, 1e9);
  vtkGetMacro(MaximumGap, double);
  ///@}

  ///@{
  /**
   * Memory in bytes for the rays of volumes that were read, and as much again for the outputs that
   * were made, which are kept packed. 1 GiB by default. The volumes about the time that is being
   * made live beside it.
   */
  vtkSetClampMacro(MemoryLimit, vtkTypeInt64, 0, VTK_TYPE_INT64_MAX);
  vtkGetMacro(MemoryLimit, vtkTypeInt64);
  ///@}

  ///@{
  /**
   * Name of the site in place of the one in the files, which then all count as that site's. Empty
   * by default.
   */
  vtkSetMacro(SiteName, std::string);
  vtkGetMacro(SiteName, std::string);
  ///@}

  ///@{
  /**
   * Processes that read the same inputs together: each scans a part of them, and all know all. They
   * must have the same settings, and update their information at the same time. None by default:
   * this process reads everything.
   */
  virtual void SetController(vtkMultiProcessController* controller);
  vtkMultiProcessController* GetController() const;
  ///@}

  ///@{
  /**
   * Where no controller is set, take vtkMultiProcessController::GetGlobalController() when the
   * inputs are scanned. Off by default; the ParaView plugin switches it on.
   */
  vtkSetMacro(UseGlobalController, bool);
  vtkGetMacro(UseGlobalController, bool);
  vtkBooleanMacro(UseGlobalController, bool);
  ///@}

  /**
   * Merges a box of the domain again at a time, in voxels of 250 m (larger where the box is wider
   * than 60 km: it has at most 240 x 240 columns), from the rays that are in memory. `faces`: west,
   * east, south and north of the box in the units of x and y. Fills `box` as the output is filled.
   * False after an error: no file was opened, the box does not lie over the domain, the method
   * "thesis".
   */
  bool MergeBox(double time, const double faces[4], vtkImageData* box);

  /**
   * How many times this process decoded a file for its outputs. A file whose rays are still in
   * memory is not decoded again. Of several processes, the files that they scan together do not
   * count.
   */
  int GetNumberOfDecodedFiles() const;

  /**
   * How many outputs this process merged. An output that is still in memory is not merged again
   * when its time is asked for again with the same settings.
   */
  int GetNumberOfMerges() const;

  /**
   * What was wrong in the inputs that were decoded so far, one line each ("FILE: offset N: WHAT").
   * The same lines come as warnings, those of a file as one.
   */
  vtkStringArray* GetDamage() { return this->Damage.Get(); }

  /**
   * The paths of inputs that were left out so far, a part of those of GetDamage.
   */
  vtkStringArray* GetLeftOut() { return this->LeftOut.Get(); }

  /**
   * What the comparison of the radars finds in the reflectivity that was decoded so far (Formulas
   * Q6), one line for each pair of radars and for each radar. Empty with one radar.
   */
  vtkStringArray* GetRadarComparison();

  /**
   * After UpdateInformation: the time steps, and the names of the radars.
   */
  vtkDoubleArray* GetTimeSteps() { return this->TimeSteps.Get(); }
  vtkStringArray* GetSites() { return this->Sites.Get(); }

  ///@{
  /**
   * After UpdateInformation: the times of the first and the last ray of all inputs, as
   * "2010-09-11T20:05:12.345Z", whatever BeginTime and EndTime are. Empty before, and after an
   * error.
   */
  vtkGetMacro(FirstRay, std::string);
  vtkGetMacro(LastRay, std::string);
  ///@}

#ifndef __VTK_WRAP__
  /// The settings as Core has them. Throws nexrad::Error for a text that is wrong, and for a moment
  /// that the method does not know.
  nexrad::MergeOptions MakeDayOptions() const;
#endif

protected:
  vtkNexradDayReader();
  ~vtkNexradDayReader() override;

  int RequestInformation(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* output) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* output) override;

  double TimeStep = 300.0;
  double BeginTime = VTK_DOUBLE_MIN;
  double EndTime = VTK_DOUBLE_MAX;
  double MaximumGap = 900.0;
  vtkTypeInt64 MemoryLimit = vtkTypeInt64(1) << 30;
  std::string SiteName;
  bool UseGlobalController = false;
  std::vector<std::string> FileNames;

private:
  vtkNexradDayReader(const vtkNexradDayReader&) = delete;
  void operator=(const vtkNexradDayReader&) = delete;

  // Sets the error code and gives the error. Returns 0, for a request that failed.
  int Fail(unsigned long code, const std::string& line);
  nexrad::MergerSetup MakeSetup(const std::array<int, 3>& dimensions) const;
  /**
   * Finds the files, or sets the options of those that are known. False after an abort. Throws
   * nexrad::Error.
   */
  bool Open();
  void ReportProblems();

  std::map<std::string, std::string> Texts; // of the options that were set
  vtkSmartPointer<vtkMultiProcessController> Controller;
  vtkNew<vtkStringArray> Damage;
  vtkNew<vtkStringArray> LeftOut;
  vtkNew<vtkStringArray> RadarComparison;
  vtkNew<vtkStringArray> Sites;
  vtkNew<vtkDoubleArray> TimeSteps;
  std::string FirstRay;
  std::string LastRay;
  struct Day;
  std::unique_ptr<Day> Opened;
};

#endif
