// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkNexradHistogram
 * @brief   how many voxels of a merged volume have which values
 *
 * Input: a vtkImageData with a point array of one component, as vtkNexradDayReader and
 * vtkNexradVolumeReader give it, of values or of codes (vtkNexradImageConversion.h). Output: a
 * vtkTable with one row for each bin and two columns of float64: "value", the middle of the bin in
 * the unit of the array, and "voxels".
 *
 * Counted are the voxels that have a value: those with echo where the array has states (NAME_state,
 * or the states of the codes), else those that are not HIDDENPOINT; of these the finite ones. The
 * bins are BinWidth wide, begin at multiples of it, and reach from the bin of the least to that of
 * the greatest value; there are at most 4096. Where that would be more, and where no value was
 * counted, the table has no rows and the former is an error (UserError).
 *
 * A code stands for all values that were rounded to it: its voxels are spread evenly over the bins
 * between the middles to its neighbours. So the counts have no gaps where bins and codes do not
 * coincide, and may have fractions.
 *
 * Errors (UserError): an array that the image does not have, or that has several components.
 */
#ifndef vtkNexradHistogram_h
#define vtkNexradHistogram_h

#include "vtkNexradFiltersModule.h" // For export macro
#include "vtkTableAlgorithm.h"

#include <string> // For members

class VTKNEXRADFILTERS_EXPORT vtkNexradHistogram : public vtkTableAlgorithm
{
public:
  static vtkNexradHistogram* New();
  vtkTypeMacro(vtkNexradHistogram, vtkTableAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Name of the array, as "REF". Empty, the default: the active scalars.
   */
  vtkSetMacro(ArrayName, std::string);
  vtkGetMacro(ArrayName, std::string);
  ///@}

  ///@{
  /**
   * Width of the bins in the unit of the array. 0, the default: a hundredth of the usual range
   * (vtkNexradTwoFields::GetUsualRange) of the array, or of the range of its values where it has no
   * usual one, rounded up to 1, 2 or 5 times a power of ten. 1e-12 at least otherwise.
   */
  vtkSetMacro(BinWidth, double);
  vtkGetMacro(BinWidth, double);
  ///@}

  ///@{
  /**
   * How many voxels are looked at, at most: of a larger volume every second, third, … one, and the
   * counts are multiplied accordingly. 0, the default: all.
   */
  vtkSetMacro(MaximumNumberOfVoxels, vtkIdType);
  vtkGetMacro(MaximumNumberOfVoxels, vtkIdType);
  ///@}

protected:
  vtkNexradHistogram() = default;
  ~vtkNexradHistogram() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(
    vtkInformation*, vtkInformationVector** input, vtkInformationVector* output) override;

  std::string ArrayName;
  double BinWidth = 0.0;
  vtkIdType MaximumNumberOfVoxels = 0;

private:
  vtkNexradHistogram(const vtkNexradHistogram&) = delete;
  void operator=(const vtkNexradHistogram&) = delete;
};

#endif
