// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkNexradNetCDFWriter
 * @brief   writes merged radar volumes as NetCDF that follows the CF conventions
 *
 * The input is a vtkImageData with the arrays of vtkNexradImageConversion.h. The file has their
 * values, states and ancillary arrays, the coordinates with latitudes and longitudes, the
 * projection, the times and the radars, so that other programs place and decode it without this
 * project. What the file name ends in decides:
 *
 * - `.series`: every time step of the input is asked for and written to a file beside the index,
 *   named by its time (`20060312T180000Z.nc`); then the index that names them.
 * - anything else: one file, of all time steps of the input (AllTimeSteps), or of the input as it
 *   is.
 *
 * A file is written under a temporary name and renamed when it is whole. When a run stops early
 * (vtkNexradStepWriter), a file of several times is not written at all; files of one time stay.
 *
 * Source: Documentation/Formats/netcdf.md; NetCDF Climate and Forecast (CF) Metadata
 * Conventions 1.8.
 */
#ifndef vtkNexradNetCDFWriter_h
#define vtkNexradNetCDFWriter_h

#include "vtkNexradIOModule.h" // For export macro
#include "vtkNexradStepWriter.h"

#include <memory> // For members
#include <string> // For members

class vtkNexradNetCDFOutput;

class VTKNEXRADIO_EXPORT vtkNexradNetCDFWriter : public vtkNexradStepWriter
{
public:
  static vtkNexradNetCDFWriter* New();
  vtkTypeMacro(vtkNexradNetCDFWriter, vtkNexradStepWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Write all time steps of the input into the file, not only the one that the input has. On by
   * default; an index always names all.
   */
  vtkSetMacro(AllTimeSteps, bool);
  vtkGetMacro(AllTimeSteps, bool);
  vtkBooleanMacro(AllTimeSteps, bool);
  ///@}

  ///@{
  /**
   * What the file's attribute `history` says. "vtkNexradNetCDFWriter" by default.
   */
  vtkSetMacro(History, std::string);
  vtkGetMacro(History, std::string);
  ///@}

protected:
  vtkNexradNetCDFWriter();
  ~vtkNexradNetCDFWriter() override;

  bool WritesAllSteps() const override { return this->AllTimeSteps || this->IsSeries(); }
  void WriteVolume(const nexrad::GriddedVolume& volume) override;
  void CompleteFile() override;
  void GiveUp() override;

  bool AllTimeSteps = true;
  std::string History = "vtkNexradNetCDFWriter";

private:
  vtkNexradNetCDFWriter(const vtkNexradNetCDFWriter&) = delete;
  void operator=(const vtkNexradNetCDFWriter&) = delete;

  std::unique_ptr<vtkNexradNetCDFOutput> Output; ///< one file of several times
};

#endif
