// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file   vtkNexradNetCDFRadars.h
 * @brief  the radars of merged volumes in a NetCDF file
 */
#ifndef vtkNexradNetCDFRadars_h
#define vtkNexradNetCDFRadars_h

#include "nexrad/Model/Site.h"

#include <cstddef>
#include <string>
#include <vector>

class vtkNexradNetCDFFile;

namespace nexrad
{
struct GriddedVolume;
}

/**
 * The radars that a file names while volumes are added to it: names, positions, and which of them
 * took part at each time.
 */
class vtkNexradNetCDFRadars
{
public:
  /**
   * Defines the variables. `time` is the number of the dimension.
   */
  vtkNexradNetCDFRadars(const vtkNexradNetCDFFile& file, int time);

  /**
   * Writes those of a volume, `index` being its place among the times. Returns the places of its
   * sites among the radars of the file.
   */
  std::vector<short> Add(const nexrad::GriddedVolume& volume, std::size_t index);

  /// Of all volumes so far.
  const std::vector<std::string>& Names() const { return this->Known; }

private:
  void WriteUse(std::size_t index, std::size_t radar, bool used);
  void AddRadar(const std::string& name, const nexrad::Position* position);

  const vtkNexradNetCDFFile& File;
  std::vector<std::string> Known;
  int NameVariable = -1;
  int PositionVariables[3] = {-1, -1, -1}; ///< latitude, longitude, altitude
  int UsedVariable = -1;
};

#endif
// VTK-HeaderTest-Exclude: vtkNexradNetCDFRadars.h
