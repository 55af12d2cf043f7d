// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkNexradVolumeResampler
 * @brief   grids one volume of one radar
 *
 * Input: the sweeps of one volume, as vtkNexradLevel2Reader gives them. Output: a vtkImageData, the
 * grid of vtkNexradGridAlgorithm filled from this volume alone, whose time it carries. The radar's
 * position must be known.
 *
 * The error code of an input that holds no volume or several, or lacks what the reader adds, is
 * UserError. An aborted run leaves an empty output; Modified() makes it run again.
 *
 * @sa vtkNexradSiteMerge vtkNexradDayReader
 */
#ifndef vtkNexradVolumeResampler_h
#define vtkNexradVolumeResampler_h

#include "vtkNexradFiltersModule.h" // For export macro
#include "vtkNexradGridAlgorithm.h"

class VTKNEXRADFILTERS_EXPORT vtkNexradVolumeResampler : public vtkNexradGridAlgorithm
{
public:
  static vtkNexradVolumeResampler* New();
  vtkTypeMacro(vtkNexradVolumeResampler, vtkNexradGridAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkNexradVolumeResampler();
  ~vtkNexradVolumeResampler() override;

  int RequestData(
    vtkInformation*, vtkInformationVector** input, vtkInformationVector* output) override;

private:
  vtkNexradVolumeResampler(const vtkNexradVolumeResampler&) = delete;
  void operator=(const vtkNexradVolumeResampler&) = delete;
};

#endif
