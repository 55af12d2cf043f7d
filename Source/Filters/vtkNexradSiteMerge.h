// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkNexradSiteMerge
 * @brief   merges already chosen volumes of several radars at one time
 *
 * Inputs, on the repeatable port 0: sweeps as vtkNexradLevel2Reader gives them, any number of
 * volumes of any number of radars, in any order. Volumes are told apart by site and start time. At
 * the time that is set, each radar takes part with the volumes that start just before (or at) and
 * just after it; with one alone where the other is missing or too far.
 *
 * Output: one vtkImageData, the grid of vtkNexradGridAlgorithm about all the input's radars, at
 * that time. A radar without a position is an error. vtkNexradDayReader does the same from files,
 * for any time that the pipeline asks for.
 *
 * The error code of inputs that cannot be merged is UserError, also of two radars of one name that
 * stand more than 2 km from each other. An aborted run leaves an empty output; Modified() makes it
 * run again.
 */
#ifndef vtkNexradSiteMerge_h
#define vtkNexradSiteMerge_h

#include "vtkNexradFiltersModule.h" // For export macro
#include "vtkNexradGridAlgorithm.h"

class VTKNEXRADFILTERS_EXPORT vtkNexradSiteMerge : public vtkNexradGridAlgorithm
{
public:
  static vtkNexradSiteMerge* New();
  vtkTypeMacro(vtkNexradSiteMerge, vtkNexradGridAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The time of the output in seconds since 1970-01-01T00:00:00Z. 0 by default.
   */
  vtkSetMacro(Time, double);
  vtkGetMacro(Time, double);
  ///@}

  ///@{
  /**
   * A volume that starts farther from the time takes no part, in seconds. 900 by default.
   */
  vtkSetClampMacro(MaximumGap, double, 0.0, 1e9);
  vtkGetMacro(MaximumGap, double);
  ///@}

protected:
  vtkNexradSiteMerge();
  ~vtkNexradSiteMerge() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* output) override;
  int RequestData(
    vtkInformation*, vtkInformationVector** input, vtkInformationVector* output) override;

  double Time = 0.0;
  double MaximumGap = 900.0;

private:
  vtkNexradSiteMerge(const vtkNexradSiteMerge&) = delete;
  void operator=(const vtkNexradSiteMerge&) = delete;
};

#endif
