// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkNexradSeriesReader
 * @brief   reads many Level II files, of one radar or several, as a series in time
 *
 * ```
 *   KEAX  |--volume--||--volume--||--volume--|
 *   KLSX     |---volume---||---volume---|
 *   steps ^  ^         ^   ^      ^               the starts of all volumes
 * ```
 *
 * The files are grouped by the site named in each file, whatever their names. The time steps are
 * the times of the first rays of all volumes, in seconds since 1970-01-01T00:00:00Z; a file with
 * several cycles counts as several volumes. The output at a time holds, for each site, the sweeps
 * of its latest volume that starts at or before that time; a site that has not begun is absent. So
 * every scan stays in view until the radar's next one. Without a requested time, or for
 * one more than a day before the first time step, the output is that of the first time step.
 *
 * The output is that of vtkNexradLevel2Reader, with the site's name before each sweep's ("KEAX
 * Sweep 03 1.45 deg"); its field data are those of the last site. With several sites PROJECTED
 * coordinates, the default here, put each in its place: their centre is the centre of the box
 * that a merged volume of the same sites has by default. In LOCAL ones all lie about the origin.
 *
 * All files are decoded once to learn their times, and each again when it is shown. Damage gives
 * warnings; files that cannot be used are named and left out. No volume at all is an error. A run
 * that was aborted leaves an empty output; Modified() makes it run again.
 */
#ifndef vtkNexradSeriesReader_h
#define vtkNexradSeriesReader_h

#include "vtkNexradIOModule.h" // For export macro
#include "vtkNexradSweepReader.h"

#include <memory> // For members
#include <string> // For members
#include <vector> // For members

class VTKNEXRADIO_EXPORT vtkNexradSeriesReader : public vtkNexradSweepReader
{
public:
  static vtkNexradSeriesReader* New();
  vtkTypeMacro(vtkNexradSeriesReader, vtkNexradSweepReader);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The inputs: Level II files, chunk folders, and folders and tar archives of files (read with
   * those within).
   */
  virtual void AddFileName(const char* path);
  virtual void ClearFileNames();
  int GetNumberOfFileNames() const;
  const char* GetFileName(int index) const;
  ///@}

  /**
   * 1 when the path looks like a Level II file, one of its containers, a chunk folder, or a folder
   * that holds such files; else 0.
   */
  static int CanReadFile(const char* path);

protected:
  vtkNexradSeriesReader();
  ~vtkNexradSeriesReader() override;

  int RequestInformation(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* output) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* output) override;

  std::vector<std::string> FileNames;

private:
  vtkNexradSeriesReader(const vtkNexradSeriesReader&) = delete;
  void operator=(const vtkNexradSeriesReader&) = delete;

  /**
   * Learns the times of the inputs unless they are known. Returns 0 after an error; an abort leaves
   * nothing scanned.
   */
  int Scan();
  /**
   * Appends each site's latest sweeps. Returns 0 when it was aborted.
   */
  int ReadAt(
    double time, vtkInformation* outputInformation, class vtkPartitionedDataSetCollection* sweeps);

  struct Series;
  std::unique_ptr<Series> Scanned;
};

#endif
