// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file   vtkNexradNetCDFOutput.h
 * @brief  writes merged volumes into one NetCDF file that follows the CF conventions
 */
#ifndef vtkNexradNetCDFOutput_h
#define vtkNexradNetCDFOutput_h

#include "vtkNexradIOModule.h" // For export macro

#include <filesystem>
#include <memory>
#include <string>

namespace nexrad
{
struct GriddedVolume;
}

/**
 * One NetCDF-4 file of volumes at one or several times (Documentation/Formats/netcdf.md). It is
 * written under a temporary name and gets its name by Commit; without Commit nothing stays. Members
 * throw nexrad::Error, naming the file, when it cannot be written.
 */
class VTKNEXRADIO_EXPORT vtkNexradNetCDFOutput
{
public:
  /**
   * `history` says what made the volumes, as a command line does; the file's attribute of that name
   * is that text, without the time of writing: the same volumes make the same bytes.
   */
  vtkNexradNetCDFOutput(const std::filesystem::path& path, const std::string& history);
  ~vtkNexradNetCDFOutput();
  vtkNexradNetCDFOutput(const vtkNexradNetCDFOutput&) = delete;
  vtkNexradNetCDFOutput& operator=(const vtkNexradNetCDFOutput&) = delete;

  /**
   * Adds a time, later than those before, with its further moments. Also throws nexrad::Error for a
   * volume whose grid, moments, ancillary arrays or method are not those of the first, and for a
   * time that is not later.
   */
  void Add(const nexrad::GriddedVolume& volume);

  void Commit();

private:
  class Parts;
  std::unique_ptr<Parts> File;
};

/**
 * Writes a file of one volume.
 */
VTKNEXRADIO_EXPORT void vtkNexradWriteNetCDF(const std::filesystem::path& path,
  const nexrad::GriddedVolume& volume, const std::string& history);

#endif
// VTK-HeaderTest-Exclude: vtkNexradNetCDFOutput.h
