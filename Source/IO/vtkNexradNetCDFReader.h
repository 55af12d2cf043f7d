// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkNexradNetCDFReader
 * @brief   reads merged radar volumes from NetCDF files that vtkNexradNetCDFWriter wrote
 *
 * Values, states and ancillary arrays are those that were written. A file gives the time steps that
 * it has; an index of files (`volumes.nc.series`), those of all of them.
 *
 * NetCDF files of other programs are not read: vtkNetCDFCFReader is for those.
 *
 * Source: Documentation/Formats/netcdf.md.
 */
#ifndef vtkNexradNetCDFReader_h
#define vtkNexradNetCDFReader_h

#include "vtkNexradIOModule.h" // For export macro
#include "vtkNexradStepReader.h"

class VTKNEXRADIO_EXPORT vtkNexradNetCDFReader : public vtkNexradStepReader
{
public:
  static vtkNexradNetCDFReader* New();
  vtkTypeMacro(vtkNexradNetCDFReader, vtkNexradStepReader);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * 1 when the path is a NetCDF file of merged volumes, or an index that names some; else 0.
   */
  static int CanReadFile(const char* path);

protected:
  vtkNexradNetCDFReader();
  ~vtkNexradNetCDFReader() override;

  vtkNexradVolumeSteps ListSteps() override;
  void ReadStep(const vtkNexradVolumeStep& step, vtkImageData* image) override;

private:
  vtkNexradNetCDFReader(const vtkNexradNetCDFReader&) = delete;
  void operator=(const vtkNexradNetCDFReader&) = delete;
};

#endif
