// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkNexradEchoOnly
 * @brief   the part of a merged volume that holds echo, as cells that any filter of VTK understands
 *
 * A merged volume has a number at every voxel, also where no echo is and where no beam passed.
 * Filters that do not look at states or at hidden points take these numbers for measured ones. This
 * filter leaves them out.
 *
 * Input: a vtkImageData with a moment and its states (as REF and REF_state). Output: a
 * vtkUnstructuredGrid, in one of two forms:
 *
 * - BETWEEN_VOXELS (default): cells whose eight corners are voxels that count; all point arrays
 * stay point arrays. For what interpolates: contours, gradients, slices, probes.
 * - VOXELS: a cell for each voxel that counts, as large as the voxel; all point arrays become cell
 *   arrays. For what counts or sums: statistics, histograms, thresholds, integrals.
 *
 * A voxel counts when its state is echo; with NoEchoCounts also when it was scanned and held no
 * echo, which has the volume's fill value: then a contour closes round an echo, and no wall of it
 * stands beside what was not scanned. Errors (UserError): the array is no moment of the input.
 */
#ifndef vtkNexradEchoOnly_h
#define vtkNexradEchoOnly_h

#include "vtkNexradFiltersModule.h" // For export macro
#include "vtkUnstructuredGridAlgorithm.h"

#include <string> // For members

class VTKNEXRADFILTERS_EXPORT vtkNexradEchoOnly : public vtkUnstructuredGridAlgorithm
{
public:
  static vtkNexradEchoOnly* New();
  vtkTypeMacro(vtkNexradEchoOnly, vtkUnstructuredGridAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Name of the moment whose states decide, as "REF". By default (empty) that of the active
   * scalars.
   */
  vtkSetMacro(Moment, std::string);
  vtkGetMacro(Moment, std::string);
  ///@}

  enum CellType
  {
    BETWEEN_VOXELS = 0,
    VOXELS = 1
  };

  ///@{
  /**
   * What the cells of the output are. BETWEEN_VOXELS by default.
   */
  vtkSetClampMacro(Cells, int, BETWEEN_VOXELS, VOXELS);
  vtkGetMacro(Cells, int);
  void SetCellsToBetweenVoxels() { this->SetCells(BETWEEN_VOXELS); }
  void SetCellsToVoxels() { this->SetCells(VOXELS); }
  ///@}

  ///@{
  /**
   * Whether voxels that were scanned and held no echo count too. Off by default.
   */
  vtkSetMacro(NoEchoCounts, bool);
  vtkGetMacro(NoEchoCounts, bool);
  vtkBooleanMacro(NoEchoCounts, bool);
  ///@}

protected:
  vtkNexradEchoOnly() = default;
  ~vtkNexradEchoOnly() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(
    vtkInformation*, vtkInformationVector** input, vtkInformationVector* output) override;

  std::string Moment;
  int Cells = BETWEEN_VOXELS;
  bool NoEchoCounts = false;

private:
  vtkNexradEchoOnly(const vtkNexradEchoOnly&) = delete;
  void operator=(const vtkNexradEchoOnly&) = delete;
};

#endif
