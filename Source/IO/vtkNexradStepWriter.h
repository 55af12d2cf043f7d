// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkNexradStepWriter
 * @brief   base of the writers of merged radar volumes: one time step after the other
 *
 * The input is a vtkImageData with the arrays of vtkNexradImageConversion.h. A derived class says
 * whether all time steps of the input are written, and writes each of them. When the file name ends
 * in `.series`, each goes into a file beside the index, named by its time, and then the index that
 * names them is written.
 *
 * An error (a full disk, an input without the arrays or that cannot be made) stops the run: Write
 * returns 0 and the error code is set. So it is after an abort, without an error code. Error codes
 * are NoFileNameError, OutOfDiskSpaceError, CannotOpenFileError, and UserError for an input that
 * cannot be written.
 */
#ifndef vtkNexradStepWriter_h
#define vtkNexradStepWriter_h

#include "vtkNexradIOModule.h" // For export macro
#include "vtkWriter.h"

#include <functional> // For writing
#include <string>     // For members
#include <utility>    // For members
#include <vector>     // For members

namespace nexrad
{
struct GriddedVolume;
}

class VTKNEXRADIO_EXPORT vtkNexradStepWriter : public vtkWriter
{
public:
  vtkTypeMacro(vtkNexradStepWriter, vtkWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Path of the file, or of the index.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
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
  vtkNexradStepWriter();
  ~vtkNexradStepWriter() override;

  vtkTypeBool ProcessRequest(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;
  int FillInputPortInformation(int port, vtkInformation* info) override;
  void WriteData() override;

  ///@{
  /**
   * Of derived classes: whether every time step of the input is asked for and written; what writes
   * a volume; what completes the one file of all of them; and what drops what a run has begun and
   * not completed. They may throw nexrad::Error for an input that cannot be written.
   */
  virtual bool WritesAllSteps() const = 0;
  virtual void WriteVolume(const nexrad::GriddedVolume& volume) = 0;
  virtual void CompleteFile() {}
  virtual void GiveUp() {}
  ///@}

  /**
   * For derived classes: calls what writes to the disk, whose nexrad::Error sets the error code of
   * its cause.
   */
  static void Attempt(const std::function<void()>& write);
  /**
   * Whether the file name is that of an index of a series.
   */
  bool IsSeries() const;
  /**
   * The file that a volume goes into, which the index of a series then names.
   */
  std::string FileOf(const nexrad::GriddedVolume& volume, const char* extension);

  char* FileName = nullptr;
  std::vector<std::string> Written;

private:
  vtkNexradStepWriter(const vtkNexradStepWriter&) = delete;
  void operator=(const vtkNexradStepWriter&) = delete;

  void Begin();
  void End();
  void ReadTimeSteps(vtkInformation* inputInformation);
  int WriteStep(vtkInformation* request);
  void Guarded(const std::function<void()>& work);
  void Fail(unsigned long code, const std::string& line);

  std::vector<double> TimeSteps;                     ///< of the input
  std::vector<std::pair<std::string, double>> Index; ///< files of the series so far
  std::size_t CurrentStep = 0;
  bool Complete = false; ///< the last run wrote all that it had to
};

#endif
