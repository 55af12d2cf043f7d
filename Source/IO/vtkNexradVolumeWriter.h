// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkNexradVolumeWriter
 * @brief   writes merged radar volumes: a .nxv file, or a series of them in time
 *
 * The input is a vtkImageData with the arrays of vtkNexradImageConversion.h. What the file name
 * ends in decides:
 *
 * - `.nxv.series`: every time step of the input is asked for and written beside the index, named by
 *   its time (`20060312T180000Z.nxv`); then the index that names them.
 * - anything else: the input as it is goes into that file.
 *
 * A file is written under a temporary name and renamed when it is whole. When a run stops early
 * (vtkNexradStepWriter), no index is written; volumes of earlier steps stay.
 *
 * Source: Documentation/Formats/nxv.md.
 */
#ifndef vtkNexradVolumeWriter_h
#define vtkNexradVolumeWriter_h

#include "vtkNexradIOModule.h" // For export macro
#include "vtkNexradStepWriter.h"

class VTKNEXRADIO_EXPORT vtkNexradVolumeWriter : public vtkNexradStepWriter
{
public:
  static vtkNexradVolumeWriter* New();
  vtkTypeMacro(vtkNexradVolumeWriter, vtkNexradStepWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * AUTOMATIC: for reflectivity of the method "thesis" the thesis's code (whole dBZ from 1 to 80),
   * else RADAR_STEPS. RADAR_STEPS: codes of 8 or 16 bits in the steps in which the radar sends the
   * moment (half dBZ from -32 to 94.5 for reflectivity), deflated. FLOAT: exact values and states,
   * deflated.
   */
  enum EncodingType
  {
    AUTOMATIC = 0,
    RADAR_STEPS = 1,
    FLOAT = 2
  };

  ///@{
  /**
   * How the values are stored. AUTOMATIC by default.
   */
  vtkSetClampMacro(Encoding, int, AUTOMATIC, FLOAT);
  vtkGetMacro(Encoding, int);
  ///@}

protected:
  vtkNexradVolumeWriter() = default;
  ~vtkNexradVolumeWriter() override = default;

  bool WritesAllSteps() const override { return this->IsSeries(); }
  void WriteVolume(const nexrad::GriddedVolume& volume) override;

  int Encoding = AUTOMATIC;

private:
  vtkNexradVolumeWriter(const vtkNexradVolumeWriter&) = delete;
  void operator=(const vtkNexradVolumeWriter&) = delete;
};

#endif
