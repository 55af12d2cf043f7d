// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkNexradLevel2Reader
 * @brief   reads one volume of a weather radar: a NEXRAD or TDWR Level II file
 *
 * A volume is a stack of cones: at each elevation angle the antenna turns once round and looks at
 * gates along each ray.
 *
 * ```
 *            up |      / sweep 2                north  ray 0
 *               |    /   . -                       |  / ray 1
 *               |  / . -    _ _ sweep 1            | /  .
 *               |/-_ _ - -                         |/ .  -> clockwise
 *   antenna     +------------- ground              +---o---o---o  gates along a ray
 * ```
 *
 * The output is a vtkPartitionedDataSetCollection: each sweep is a vtkPartitionedDataSet, named
 * like "Sweep 03 1.45 deg" (its index, from 0 in the order scanned, and the angle of its cut in the
 * coverage pattern, or the median of its rays where that is unknown; in the data assembly the same
 * name made valid). In it stands one vtkStructuredGrid (gates x rays
 * x 1) for each distinct gate geometry, because in most sweeps reflectivity and velocity differ in
 * it: partitions, since both are the same cone. Points are the centres of the gates; rays are in
 * the order scanned, the first repeated at the end when the sweep goes all the way round. Gates at
 * negative range are left out. vtkNexradSweepConversion.h lists arrays and field data.
 *
 * In: archive files (ARCHIVE2., AR2V0001 to AR2V0008; messages 1 and 31) in any container the
 * archive uses, plain, gzip, bzip2, compress, LDM records, also as a member of a tar archive
 * ("day.tar/KTLX20130520_200356_V06.gz"); and folders of real-time chunks. A file with several
 * volume cycles gives the sweeps of all of them.
 *
 * Damage gives a warning that names the file, the byte offset and what is wrong; what can be read
 * is read. A file without any ray is an error, with the vtkErrorCode FileFormatError (or
 * UnrecognizedFileTypeError when it is no Level II file at all). The time step is the time of the
 * first ray, in seconds since 1970-01-01T00:00:00Z. A run that was aborted leaves an empty output;
 * Modified() makes it run again.
 *
 * Not supported: Level III products, message 31 moments that are not in the list of
 * vtkNexradSweepReader::GetMomentSelection.
 *
 * Source: ICD for the RDA/RPG, 2620002; ICD for the archive II/user, 2620010.
 */
#ifndef vtkNexradLevel2Reader_h
#define vtkNexradLevel2Reader_h

#include "vtkNexradIOModule.h" // For export macro
#include "vtkNexradSweepReader.h"

#include <memory> // For members

class VTKNEXRADIO_EXPORT vtkNexradLevel2Reader : public vtkNexradSweepReader
{
public:
  static vtkNexradLevel2Reader* New();
  vtkTypeMacro(vtkNexradLevel2Reader, vtkNexradSweepReader);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Path of a Level II file, or of a folder of real-time chunks.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  /**
   * 1 when the path looks like a Level II file, one of its containers, or a chunk folder; else 0.
   * It looks at the first bytes (of a folder: at the names) alone.
   */
  static int CanReadFile(const char* path);

protected:
  vtkNexradLevel2Reader();
  ~vtkNexradLevel2Reader() override;

  int RequestInformation(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* output) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* output) override;

  char* FileName = nullptr;

private:
  vtkNexradLevel2Reader(const vtkNexradLevel2Reader&) = delete;
  void operator=(const vtkNexradLevel2Reader&) = delete;

  /**
   * Decodes the file unless it is in memory already. Returns 0, after an error, when there is
   * nothing to show.
   */
  int ReadFile();

  struct Decoded;
  std::unique_ptr<Decoded> File;
};

#endif
