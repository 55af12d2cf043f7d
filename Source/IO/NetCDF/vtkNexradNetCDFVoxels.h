// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file   vtkNexradNetCDFVoxels.h
 * @brief  the voxels of merged volumes in a NetCDF file: values, states and ancillary arrays
 *
 * Source of the names: NetCDF Climate and Forecast (CF) Metadata Conventions 1.8; its standard name
 * table; Documentation/Formats/netcdf.md.
 */
#ifndef vtkNexradNetCDFVoxels_h
#define vtkNexradNetCDFVoxels_h

#include "vtkNexradNetCDFGrid.h" // For members

#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

class vtkNexradNetCDFFile;

namespace nexrad
{
struct GriddedVolume;
}

/**
 * The variables of a file's moments, while volumes are added to it.
 */
class vtkNexradNetCDFVoxels
{
public:
  /**
   * Defines the variables for the moments and ancillary arrays of a volume.
   */
  vtkNexradNetCDFVoxels(const vtkNexradNetCDFFile& file,
    const vtkNexradNetCDFDimensions& dimensions, const nexrad::GriddedVolume& volume);

  /**
   * Writes the voxels of a volume, `index` being its place among the times and `places` those of
   * its sites among the radars of the file. Throws nexrad::Error also for a volume that has other
   * arrays.
   */
  void Write(
    const nexrad::GriddedVolume& volume, std::size_t index, const std::vector<short>& places);

  /**
   * Says in the variables of nearest radars what their numbers mean.
   */
  void NameRadars(const std::vector<std::string>& names) const;

private:
  void Define(const nexrad::GriddedVolume& moment);
  int DefineVariable(const std::string& name, int type, const std::array<std::size_t, 4>& chunk);
  void DefineAncillary(const nexrad::GriddedVolume& moment, std::string& names);
  int VariableOf(const std::string& name) const;
  void DefineView(const nexrad::GriddedVolume& volume);
  void WriteView(std::size_t index);
  void WriteMoment(
    const nexrad::GriddedVolume& moment, std::size_t index, const std::vector<short>& places);

  const vtkNexradNetCDFFile& File;
  const vtkNexradNetCDFDimensions Dimensions;
  std::vector<std::size_t> Shape; ///< of one time: 1, z, y, x
  bool Placed;                    ///< columns have latitude and longitude
  std::map<std::string, int> Variables;
  std::map<int, std::vector<short>> View; ///< codes of the radar's view, by variable
};

#endif
// VTK-HeaderTest-Exclude: vtkNexradNetCDFVoxels.h
