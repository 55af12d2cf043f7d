// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkNexradVerticalSection
 * @brief   what stands above a line on the ground, as a vtkImageData of distance and height
 *
 * ```
 *   m above mean sea level
 *   ^  +--------------------+
 *   |  |     section        |
 *   |  |                    |
 *   |  A--------------------B
 *   +----> m from A
 * ```
 *
 * Input: a merged volume, of values or of codes (vtkImageData as vtkNexradDayReader and
 * vtkNexradVolumeReader give it). Output: a vtkImageData of one layer. x is the distance from A in
 * m, y the height above mean sea level in m; the points are the centres of rectangles that fill the
 * section from A to B and from the lower to the upper face of the volume. Point data, here of REF:
 *
 * - `REF`, float32, the active scalars: NaN where there is no echo.
 * - `REF_state`, uint8: 0 echo, 1 no echo, 2 range folded, 3 not scanned, 4 filtered.
 *
 * The field data are those of the volume. Values are interpolated linearly among voxels with an
 * echo; whether a point has an echo is decided by the weights of the voxels about it
 * (nexrad::MakeVerticalSection). Velocities and phases are those of the nearest voxel, because a
 * mean of folded values is none.
 *
 * Errors (UserError): a line of no length; an input without the arrays of a moment, or whose axes
 * are turned.
 */
#ifndef vtkNexradVerticalSection_h
#define vtkNexradVerticalSection_h

#include "vtkImageAlgorithm.h"
#include "vtkNexradFiltersModule.h" // For export macro

class VTKNEXRADFILTERS_EXPORT vtkNexradVerticalSection : public vtkImageAlgorithm
{
public:
  static vtkNexradVerticalSection* New();
  vtkTypeMacro(vtkNexradVerticalSection, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The ends of the line in x and y of the volume, m, or degrees of longitude and latitude for a
   * volume on geographic axes. Both (0, 0) by default: they must be set.
   */
  vtkSetVector2Macro(A, double);
  vtkGetVector2Macro(A, double);
  vtkSetVector2Macro(B, double);
  vtkGetVector2Macro(B, double);
  ///@}

  ///@{
  /**
   * Number of samples along the line and upwards, 1 to 16384. 512 and 256 by default.
   */
  vtkSetClampMacro(SamplesAlong, int, 1, 16384);
  vtkGetMacro(SamplesAlong, int);
  vtkSetClampMacro(SamplesUpward, int, 1, 16384);
  vtkGetMacro(SamplesUpward, int);
  ///@}

protected:
  vtkNexradVerticalSection() = default;
  ~vtkNexradVerticalSection() override = default;

  int RequestInformation(
    vtkInformation*, vtkInformationVector** input, vtkInformationVector* output) override;
  int RequestUpdateExtent(
    vtkInformation*, vtkInformationVector** input, vtkInformationVector* output) override;
  int RequestData(
    vtkInformation*, vtkInformationVector** input, vtkInformationVector* output) override;

  double A[2] = {0.0, 0.0};
  double B[2] = {0.0, 0.0};
  int SamplesAlong = 512;
  int SamplesUpward = 256;

private:
  vtkNexradVerticalSection(const vtkNexradVerticalSection&) = delete;
  void operator=(const vtkNexradVerticalSection&) = delete;

  void Cut(vtkImageData* volume, vtkImageData* section);
};

#endif
