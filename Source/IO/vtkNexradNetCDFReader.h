// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkNexradNetCDFReader
 * @brief   reads merged radar volumes from NetCDF files that vtkNexradNetCDFWriter wrote
 *
 * The output is a vtkImageData, as that of vtkNexradVolumeReader: its points are the voxels'
 * centres; vtkNexradImageConversion.h lists arrays and field data. Values, states and ancillary
 * arrays are those that were written.
 *
 * A file gives the time steps that it has; an index of files (`volumes.nc.series`), those of all of
 * them. A requested time shows the latest volume at or before it (before the first, the first). All
 * volumes must have the grid of the first. A pipeline may ask for any box of the voxels
 * (UPDATE_EXTENT); all are read for it, and the rest let go.
 *
 * NetCDF files of other programs are not read: vtkNetCDFCFReader is for those. Errors name the
 * file; error codes are NoFileNameError, FileNotFoundError, CannotOpenFileError and
 * FileFormatError.
 *
 * Source: Documentation/Formats/netcdf.md.
 */
#ifndef vtkNexradNetCDFReader_h
#define vtkNexradNetCDFReader_h

#include "vtkImageAlgorithm.h"
#include "vtkNew.h"            // For members
#include "vtkNexradIOModule.h" // For export macro

#include <memory> // For members
#include <string> // For members

class vtkDataArraySelection;

class VTKNEXRADIO_EXPORT vtkNexradNetCDFReader : public vtkImageAlgorithm
{
public:
  static vtkNexradNetCDFReader* New();
  vtkTypeMacro(vtkNexradNetCDFReader, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Path of a NetCDF file, or of an index of several.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  /**
   * 1 when the path is a NetCDF file of merged volumes, or an index that names some; else 0.
   */
  static int CanReadFile(const char* path);

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
   * It lists those of the first file once the information is up to date; all are on by default.
   */
  vtkDataArraySelection* GetAncillaryArraySelection();

  vtkMTimeType GetMTime() override;

protected:
  vtkNexradNetCDFReader();
  ~vtkNexradNetCDFReader() override;

  int RequestInformation(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* output) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* output) override;

  char* FileName = nullptr;
  std::string Moments;

private:
  vtkNexradNetCDFReader(const vtkNexradNetCDFReader&) = delete;
  void operator=(const vtkNexradNetCDFReader&) = delete;

  struct Files;
  int Fail(unsigned long code, const std::string& line);
  void ListFiles();
  void ListAncillaryArrays();

  vtkNew<vtkDataArraySelection> AncillaryArraySelection;
  std::unique_ptr<Files> Opened;
};

#endif
