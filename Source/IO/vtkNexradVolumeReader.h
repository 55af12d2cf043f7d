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
 * A pipeline may ask for any box of the voxels (UPDATE_EXTENT). The file is decoded as a whole for
 * it, since its runs cross rows, and the rest let go.
 *
 * A .nxv file is one time step. An index gives the time steps of its files; a requested time shows
 * the latest volume at or before it (before the first, the first). All volumes of a series must
 * have the extent, origin and spacing of its first.
 *
 * With RawStream on, the file is the bare run-length stream of the codes, which knows nothing of
 * its grid: RawDimensions, RawOrigin and RawSpacing say it. Its values are whole dBZ.
 *
 * Errors name the file and the byte offset; error codes are NoFileNameError, FileNotFoundError,
 * CannotOpenFileError and FileFormatError. Source: Documentation/Formats/nxv.md.
 */
#ifndef vtkNexradVolumeReader_h
#define vtkNexradVolumeReader_h

#include "vtkImageAlgorithm.h"
#include "vtkNew.h"            // For members
#include "vtkNexradIOModule.h" // For export macro

#include <filesystem> // For file names
#include <memory>     // For members
#include <string>     // For members

class vtkDataArraySelection;

namespace nexrad
{
struct VoxelBlock;
}

class VTKNEXRADIO_EXPORT vtkNexradVolumeReader : public vtkImageAlgorithm
{
public:
  static vtkNexradVolumeReader* New();
  vtkTypeMacro(vtkNexradVolumeReader, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Path of a .nxv file, a .nxv.series index, or (with RawStream) a bare stream.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

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

  int RequestInformation(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* output) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* output) override;

  char* FileName = nullptr;
  bool ScalarsAsCodes = false;
  bool RawStream = false;
  std::string Moments;
  int RawDimensions[3] = {256, 256, 128};
  double RawOrigin[3] = {0.0, 0.0, 0.0};
  double RawSpacing[3] = {1.0, 1.0, 1.0};

private:
  vtkNexradVolumeReader(const vtkNexradVolumeReader&) = delete;
  void operator=(const vtkNexradVolumeReader&) = delete;

  int Fail(unsigned long code, const std::string& line);
  void ReadHeader();
  void ListAncillaryArrays();
  void ReadImage(
    const std::filesystem::path& path, const nexrad::VoxelBlock& block, vtkImageData* image);

  vtkNew<vtkDataArraySelection> AncillaryArraySelection;
  struct Files;
  std::unique_ptr<Files> Opened;
};

#endif
