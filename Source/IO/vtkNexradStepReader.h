// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkNexradStepReader
 * @brief   base of the readers of merged radar volumes: one file, or the time steps of an index
 *
 * The output is a vtkImageData with the arrays and field data of vtkNexradImageConversion.h; its
 * points are the voxels' centres. A derived class lists the time steps that the file name stands
 * for, and reads each of them.
 *
 * A requested time shows the latest volume at or before it (before the first, the first). All
 * volumes must have the grid of the first. A pipeline may ask for any box of the voxels
 * (UPDATE_EXTENT); all are read for it, and the rest let go.
 *
 * Errors name the file; error codes are NoFileNameError, FileNotFoundError, CannotOpenFileError and
 * FileFormatError.
 */
#ifndef vtkNexradStepReader_h
#define vtkNexradStepReader_h

#include "vtkImageAlgorithm.h"
#include "vtkNew.h"            // For members
#include "vtkNexradIOModule.h" // For export macro

#include <memory> // For members
#include <string> // For members

class vtkDataArraySelection;
struct vtkNexradVolumeStep;
struct vtkNexradVolumeSteps;

class VTKNEXRADIO_EXPORT vtkNexradStepReader : public vtkImageAlgorithm
{
public:
  vtkTypeMacro(vtkNexradStepReader, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Path of the file, or of the index.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  ///@{
  /**
   * Names of the moments to read of a file that has several, as "VEL,REF": the first gives the
   * active scalars and the ghost flags. Empty, the default: all, in the order of the file.
   */
  vtkSetMacro(Moments, std::string);
  vtkGetMacro(Moments, std::string);
  ///@}

  /**
   * Which of the ancillary arrays (`REF_age`, `REF_radars`, `REF_weight`, `REF_site`; of a volume
   * of one radar alone also `azimuth`, `elevation`, `slant_range`, which are computed) are given.
   * It lists those of the file, of a series those of its first volume, once the information is up
   * to date; all are on by default.
   */
  vtkDataArraySelection* GetAncillaryArraySelection();

  vtkMTimeType GetMTime() override;

protected:
  vtkNexradStepReader();
  ~vtkNexradStepReader() override;

  int RequestInformation(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* output) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* output) override;

  ///@{
  /**
   * Of derived classes: lists what the file name stands for; and reads all voxels of one step into
   * an empty image. They throw nexrad::Error for what cannot be read.
   */
  virtual vtkNexradVolumeSteps ListSteps() = 0;
  virtual void ReadStep(const vtkNexradVolumeStep& step, vtkImageData* image) = 0;
  ///@}

  /**
   * For derived classes: what ListSteps gave for the file name.
   */
  const vtkNexradVolumeSteps& OpenedSteps() const;

  char* FileName = nullptr;
  std::string Moments;

private:
  vtkNexradStepReader(const vtkNexradStepReader&) = delete;
  void operator=(const vtkNexradStepReader&) = delete;

  int Fail(unsigned long code, const std::string& line);
  void Describe(vtkInformation* info) const;

  vtkNew<vtkDataArraySelection> AncillaryArraySelection;
  std::unique_ptr<vtkNexradVolumeSteps> Opened; ///< none: the information request failed
};

#endif
