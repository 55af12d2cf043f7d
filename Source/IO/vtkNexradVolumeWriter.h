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
 * A file is written under a temporary name and renamed when it is whole. An error (a full disk, an
 * input without the arrays or that cannot be made) stops the run: Write returns 0, the error code
 * is set, and no index is written; volumes of earlier steps stay. So it is after an abort, without
 * an error code. Error codes are NoFileNameError, OutOfDiskSpaceError, CannotOpenFileError, and
 * UserError for an input that cannot be written.
 *
 * Source: Documentation/Formats/nxv.md.
 */
#ifndef vtkNexradVolumeWriter_h
#define vtkNexradVolumeWriter_h

#include "vtkNexradIOModule.h" // For export macro
#include "vtkWriter.h"

#include <string>  // For members
#include <utility> // For members
#include <vector>  // For members

class vtkImageData;
namespace nexrad
{
struct GriddedVolume;
struct NxvWriteOptions;
} // namespace nexrad

class VTKNEXRADIO_EXPORT vtkNexradVolumeWriter : public vtkWriter
{
public:
  static vtkNexradVolumeWriter* New();
  vtkTypeMacro(vtkNexradVolumeWriter, vtkWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * AUTOMATIC: RUN_LENGTH for volumes of the method "thesis", else RADAR_STEPS. RADAR_STEPS: codes
   * of 8 or 16 bits in the steps in which the radar sends the moment (half dBZ from -32 to 94.5 for
   * reflectivity), deflated. RUN_LENGTH: 7-bit codes in the thesis's stream as it stands.
   * RUN_LENGTH_DEFLATED: the same, deflated. FLOAT: exact values and states, deflated.
   */
  enum EncodingType
  {
    AUTOMATIC = 0,
    RUN_LENGTH = 1,
    RUN_LENGTH_DEFLATED = 2,
    FLOAT = 3,
    RADAR_STEPS = 4
  };

  ///@{
  /**
   * Path of the file, or of the index.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  ///@{
  /**
   * How the values are stored. AUTOMATIC by default.
   */
  vtkSetClampMacro(Encoding, int, AUTOMATIC, RADAR_STEPS);
  vtkGetMacro(Encoding, int);
  ///@}

  ///@{
  /**
   * Of the two RUN_LENGTH encodings: width of a 7-bit code in the moment's unit (1 dBZ by default)
   * and the value of code 0 (0).
   */
  vtkSetMacro(CodeScale, double);
  vtkGetMacro(CodeScale, double);
  vtkSetMacro(CodeOffset, double);
  vtkGetMacro(CodeOffset, double);
  ///@}

  ///@{
  /**
   * Write the bare run-length stream without a header. Off by default; not for an index.
   */
  vtkSetMacro(RawStream, bool);
  vtkGetMacro(RawStream, bool);
  vtkBooleanMacro(RawStream, bool);
  ///@}

  /**
   * Writes. Returns 1 when all is written, else 0.
   */
  int Write() override;

  /**
   * Paths of the files of the last run, the index last.
   */
  int GetNumberOfWrittenFiles() const;
  const char* GetWrittenFile(int index) const;

protected:
  vtkNexradVolumeWriter();
  ~vtkNexradVolumeWriter() override;

  vtkTypeBool ProcessRequest(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;
  int FillInputPortInformation(int port, vtkInformation* info) override;
  void WriteData() override;

  char* FileName = nullptr;
  int Encoding = AUTOMATIC;
  double CodeScale = 1.0;
  double CodeOffset = 0.0;
  bool RawStream = false;

private:
  vtkNexradVolumeWriter(const vtkNexradVolumeWriter&) = delete;
  void operator=(const vtkNexradVolumeWriter&) = delete;

  bool IsSeries() const;
  void Begin();
  void ReadTimeSteps(vtkInformation* inputInformation);
  int WriteStep(vtkInformation* request);
  void WriteVolume(const nexrad::GriddedVolume& volume);
  void WriteIndex();
  nexrad::NxvWriteOptions MakeOptions() const;
  void Fail(unsigned long code, const std::string& line);

  std::vector<double> TimeSteps; ///< of the input
  std::size_t CurrentStep = 0;
  std::vector<std::pair<std::string, double>> Index; ///< volumes written so far
  std::vector<std::string> Written;
  bool Complete = false; ///< the last run wrote all that it had to
};

#endif
