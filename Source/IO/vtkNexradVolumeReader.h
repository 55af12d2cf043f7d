// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkNexradVolumeReader
 * @brief   reads merged radar volumes: a .nxv file, or a series of them in time
 *
 * ```
 *   20060312T180000Z.nxv   "NXV1" | header length | JSON header | payloads
 *   storm.nxv.series       JSON: names of .nxv files beside it, and their times
 * ```
 *
 * The output is a vtkImageData, because a merged volume is a regular grid of voxels; its points are
 * the voxels' centres, in metres east and north of the projection's centre and above mean sea level
 * (or in degrees, when the volume was made so). vtkNexradImageConversion.h lists arrays and field
 * data.
 *
 * A .nxv file is one time step. An index gives the time steps of its files. FileName is the path of
 * either, or of a bare stream.
 *
 * With RawStream on, the file is the bare run-length stream of the codes, which knows nothing of
 * its grid: RawDimensions, RawOrigin and RawSpacing say it. Its values are whole dBZ.
 *
 * Errors name the file and the byte offset; error codes are NoFileNameError, FileNotFoundError,
 * CannotOpenFileError and FileFormatError. Source: Documentation/Formats/nxv.md.
 */
#ifndef vtkNexradVolumeReader_h
#define vtkNexradVolumeReader_h

#include "vtkNexradIOModule.h" // For export macro
#include "vtkNexradStepReader.h"

namespace nexrad
{
struct GriddedVolume;
}

class VTKNEXRADIO_EXPORT vtkNexradVolumeReader : public vtkNexradStepReader
{
public:
  static vtkNexradVolumeReader* New();
  vtkTypeMacro(vtkNexradVolumeReader, vtkNexradStepReader);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * 1 when the path is a .nxv file, or an index that names files; else 0.
   */
  static int CanReadFile(const char* path);

  ///@{
  /**
   * Give the scalars as the file's codes, one byte a voxel, with what they stand for in the field
   * data (vtkNexradImageConversion.h): vtkOpenGLTextureSliceVolumeMapper draws them as it draws
   * values, and they are read several times as fast and take a sixth of the memory. Files whose
   * codes take two bytes, files of floats and bare streams give values all the same. Off by
   * default.
   */
  vtkSetMacro(ScalarsAsCodes, bool);
  vtkGetMacro(ScalarsAsCodes, bool);
  vtkBooleanMacro(ScalarsAsCodes, bool);
  ///@}

  ///@{
  /**
   * Read a bare run-length stream. Off by default.
   */
  vtkSetMacro(RawStream, bool);
  vtkGetMacro(RawStream, bool);
  vtkBooleanMacro(RawStream, bool);
  ///@}

  ///@{
  /**
   * Grid of a bare stream: voxels along x, y, z (256, 256, 128 by default), centre of the first
   * voxel (0, 0, 0) and distance between centres (1, 1, 1) in metres.
   */
  vtkSetVector3Macro(RawDimensions, int);
  vtkGetVector3Macro(RawDimensions, int);
  vtkSetVector3Macro(RawOrigin, double);
  vtkGetVector3Macro(RawOrigin, double);
  vtkSetVector3Macro(RawSpacing, double);
  vtkGetVector3Macro(RawSpacing, double);
  ///@}

protected:
  vtkNexradVolumeReader();
  ~vtkNexradVolumeReader() override;

  vtkNexradVolumeSteps ListSteps() override;
  void ReadStep(const vtkNexradVolumeStep& step, vtkImageData* image) override;

  bool ScalarsAsCodes = false;
  bool RawStream = false;
  int RawDimensions[3] = {256, 256, 128};
  double RawOrigin[3] = {0.0, 0.0, 0.0};
  double RawSpacing[3] = {1.0, 1.0, 1.0};

private:
  vtkNexradVolumeReader(const vtkNexradVolumeReader&) = delete;
  void operator=(const vtkNexradVolumeReader&) = delete;

  nexrad::GriddedVolume BareVolume() const;
};

#endif
