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
 * A .nxv file is one time step. An index gives the time steps of its files, which must all have the
 * grid of the first. A requested time shows the latest volume at or before it (before the first,
 * the first). A pipeline may ask for any box of the voxels (UPDATE_EXTENT); all are read for it,
 * and the rest let go.
 *
 * Errors name the file and the byte offset; error codes are NoFileNameError, FileNotFoundError,
 * CannotOpenFileError and FileFormatError. Source: Documentation/Formats/nxv.md.
 */
#ifndef vtkNexradVolumeReader_h
#define vtkNexradVolumeReader_h

#include "vtkImageAlgorithm.h"
#include "vtkNew.h"            // For members
#include "vtkNexradIOModule.h" // For export macro

#include <memory> // For members
#include <string> // For members

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

  /**
   * 1 when the path is a .nxv file, or an index that names files; else 0.
   */
  static int CanReadFile(const char* path);

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

  ///@{
  /**
   * The size of the voxels, of a file that has the volume in several: 0, the default, stands for
   * the smallest, 1 for those of the next coarser level, and so on; a number that the file does not
   * have, for the largest. Coarser levels have no ancillary arrays.
   */
  vtkSetClampMacro(Level, int, 0, VTK_INT_MAX);
  vtkGetMacro(Level, int);
  ///@}

  ///@{
  /**
   * Give the scalars as the file's codes, one byte a voxel, with what they stand for in the field
   * data (vtkNexradImageConversion.h): vtkOpenGLTextureSliceVolumeMapper draws them as it draws
   * values, and they are read several times as fast and take a sixth of the memory. Files whose
   * codes take two bytes, and files of floats, give values all the same. Off by default.
   */
  vtkSetMacro(ScalarsAsCodes, bool);
  vtkGetMacro(ScalarsAsCodes, bool);
  vtkBooleanMacro(ScalarsAsCodes, bool);
  ///@}

  vtkMTimeType GetMTime() override;

protected:
  vtkNexradVolumeReader();
  ~vtkNexradVolumeReader() override;

  int RequestInformation(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* output) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* output) override;

  char* FileName = nullptr;
  std::string Moments;
  int Level = 0;
  bool ScalarsAsCodes = false;

private:
  vtkNexradVolumeReader(const vtkNexradVolumeReader&) = delete;
  void operator=(const vtkNexradVolumeReader&) = delete;

  struct Step;
  struct Contents;
  Contents ReadContents() const;
  void ReadStep(const Step& step, const nexrad::VoxelBlock& block, vtkImageData* image);
  int Fail(unsigned long code, const std::string& line);
  void Describe(vtkInformation* info) const;

  vtkNew<vtkDataArraySelection> AncillaryArraySelection;
  std::unique_ptr<Contents> Opened; ///< none: the information request failed
};

#endif
