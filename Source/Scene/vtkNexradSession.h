// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkNexradSession
 * @brief   a series of merged volumes, one of which a vtkNexradVolumeScene shows
 *
 * Inputs: merged volumes (.nxv, .nxv.series, .vti, folders of them), or radar files and folders of
 * them, which are merged with the settings of GetDayReader. Volumes and radar files cannot be
 * mixed.
 *
 * ```
 *   session = vtknexrad.vtkNexradSession()
 *   session.AddFileName("folder")
 *   window.AddRenderer(session.GetScene().GetRenderer())
 *   session.ShowTimeStep(0)
 *   window.Render()
 * ```
 *
 * The volumes that follow the one shown are read, or merged, ahead on another thread, so that a
 * series plays on without waiting. The frame of the scene holds the echo of all time steps, of many
 * that of eight. It is measured when a time step is shown for the first time, and with each other
 * preset.
 *
 * A volume of a file that has it in voxels of several sizes is shown in the smallest ones that fit
 * in the scene's texture memory (option "texture-memory"); ShowTimeStep reads what the camera sees
 * of it in voxels as fine as the pixels, as far as these fit as well, and shows them in its place.
 *
 * Errors: an input that does not exist or cannot be used, volumes mixed with radar files, a volume
 * that cannot be read or merged, and those of vtkNexradVolumeScene. After an error the scene shows
 * what it showed before.
 */
#ifndef vtkNexradSession_h
#define vtkNexradSession_h

#include "vtkNew.h"               // For members
#include "vtkNexradSceneModule.h" // For export macro
#include "vtkObject.h"

#include <functional> // For arguments
#include <memory>     // For members
#include <optional>   // For arguments
#include <string>     // For arguments
#include <vector>     // For arguments

class vtkDoubleArray;
class vtkNexradDayReader;
class vtkNexradVolumeScene;
class vtkStringArray;

namespace nexrad
{
class VolumeSeries;
struct BoxRequest;
} // namespace nexrad

class VTKNEXRADSCENE_EXPORT vtkNexradSession : public vtkObject
{
public:
  static vtkNexradSession* New();
  vtkTypeMacro(vtkNexradSession, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The inputs: files and folders.
   */
  void AddFileName(const char* path);
  void ClearFileNames();
  int GetNumberOfFileNames() const;
  const char* GetFileName(int index) const;
  ///@}

  /**
   * Says how radar files are merged: set the grid, the method, the moment and the time steps there.
   * Its file names are those of the session. Not used for merged volumes.
   */
  vtkNexradDayReader* GetDayReader() const;

  /**
   * What shows the volume: camera, colours, mapper, and the renderer to put into a window.
   */
  vtkNexradVolumeScene* GetScene() const;

  ///@{
  /**
   * Whether volumes are read as the codes of the files where the scene can draw these: faster, and
   * a sixth of the memory. The volume of the scene then has codes for scalars
   * (vtkNexradVolumeReader::ScalarsAsCodes). On by default.
   */
  vtkSetMacro(ScalarsAsCodes, bool);
  vtkGetMacro(ScalarsAsCodes, bool);
  vtkBooleanMacro(ScalarsAsCodes, bool);
  ///@}

  /**
   * Opens the inputs, unless they are open already and neither they nor the reader's settings have
   * changed since. The other functions do so themselves. False after an error.
   */
  bool UpdateInformation();

  /**
   * Times of the volumes, ascending, in seconds since 1970-01-01T00:00:00Z. Empty after an error.
   */
  vtkDoubleArray* GetTimeSteps();

  /**
   * Loads the volume of a time step, counted from 0, and shows it. False after an error.
   */
  bool ShowTimeStep(int index);

  /**
   * Loads and shows the volume of the time step nearest to a time, in seconds since
   * 1970-01-01T00:00:00Z; of two that are equally near, the earlier one. False after an error.
   */
  bool ShowTime(double time);

  /**
   * Index of the time step that is shown; -1 before the first.
   */
  vtkGetMacro(TimeStepIndex, int);

  /**
   * What was wrong in the inputs so far, one line each.
   */
  vtkStringArray* GetDamage();

#ifndef __VTK_WRAP__
  /// Shows volumes of a series that is open, in place of files: the indices of those that take
  /// part, in the order in which they are shown. `box`: is merged in finer voxels with each of
  /// them.
  void SetSeries(std::unique_ptr<nexrad::VolumeSeries> series, std::vector<std::size_t> steps,
    const std::optional<nexrad::BoxRequest>& box);
  /// As ShowTimeStep, for a series that is open, but throws Error where ShowTimeStep reports one.
  /// False when `progress` asked to stop; then the scene stays as it is.
  bool Show(int step, const std::function<bool(double)>& progress = {});
  /// The lines of GetDamage.
  std::vector<std::string> Problems() const;
#endif

protected:
  vtkNexradSession();
  ~vtkNexradSession() override;

  bool ScalarsAsCodes = true;
  int TimeStepIndex = -1;

private:
  vtkNexradSession(const vtkNexradSession&) = delete;
  void operator=(const vtkNexradSession&) = delete;

  void Open();
  void Forget();
  void ListTimes();
  void MeasureFrame();
  void LoadAhead();
  bool Load(int index, const std::function<bool(double)>& progress);
  bool LoadSeen(const std::function<bool(double)>& progress);

  vtkNew<vtkNexradDayReader> DayReader;
  vtkNew<vtkNexradVolumeScene> Scene;
  vtkNew<vtkDoubleArray> TimeSteps;
  vtkNew<vtkStringArray> Damage;
  struct Opened;
  std::unique_ptr<Opened> Series;
};

#endif
