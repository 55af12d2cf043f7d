// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkNexradBackgroundUpdate
 * @brief   updates an algorithm on a thread of its own
 *
 * For languages that run one thread at a time, as Python does: while files are decoded and volumes
 * merged, the caller asks IsDone and sleeps in between, and other threads go on. Until it is done,
 * nobody else may use the algorithm, and observers of it must not call back into such a language.
 */
#ifndef vtkNexradBackgroundUpdate_h
#define vtkNexradBackgroundUpdate_h

#include "vtkNexradIOModule.h" // For export macro
#include "vtkObject.h"

#include <memory>

class vtkAlgorithm;
class vtkStringArray;

class VTKNEXRADIO_EXPORT vtkNexradBackgroundUpdate : public vtkObject
{
public:
  static vtkNexradBackgroundUpdate* New();
  vtkTypeMacro(vtkNexradBackgroundUpdate, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Begins what the algorithm's UpdateInformation, Update, UpdateTimeStep or UpdateExtent does, and
   * waits first for what was begun before. `time` is in seconds since 1970, `extent` in points.
   */
  void StartInformation(vtkAlgorithm* algorithm);
  void StartUpdate(vtkAlgorithm* algorithm);
  void StartTimeStep(vtkAlgorithm* algorithm, double time);
  void StartExtent(vtkAlgorithm* algorithm, const int extent[6]);
  ///@}

  /**
   * Whether nothing runs (any more).
   */
  bool IsDone() const;

  /**
   * Asks the algorithm to give up, and waits until it has ended.
   */
  void Stop();

  ///@{
  /**
   * What the algorithm reported in the last run: one line each, without the class. Waits until it
   * is done.
   */
  vtkStringArray* GetErrors();
  vtkStringArray* GetWarnings();
  ///@}

protected:
  vtkNexradBackgroundUpdate();
  ~vtkNexradBackgroundUpdate() override; // waits until it is done

private:
  vtkNexradBackgroundUpdate(const vtkNexradBackgroundUpdate&) = delete;
  void operator=(const vtkNexradBackgroundUpdate&) = delete;

  struct Run;
  std::unique_ptr<Run> run;
};

#endif
