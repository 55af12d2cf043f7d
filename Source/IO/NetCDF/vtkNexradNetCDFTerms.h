// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file   vtkNexradNetCDFTerms.h
 * @brief  the names of the CF conventions for what a merged volume has
 *
 * Source: NetCDF Climate and Forecast (CF) Metadata Conventions 1.8; its standard name table;
 * Documentation/Formats/netcdf.md.
 */
#ifndef vtkNexradNetCDFTerms_h
#define vtkNexradNetCDFTerms_h

#include <string>
#include <vector>

class vtkNexradNetCDFFile;

namespace nexrad
{
enum class MomentName : unsigned char;
struct GriddedVolume;
struct GridSpecification;
} // namespace nexrad

/// Version of this layout of NetCDF files, in the attribute of that name.
constexpr int vtkNexradNetCDFVersion = 1;
constexpr char vtkNexradNetCDFVersionName[] = "vtk_nexrad_netcdf_version";

/**
 * The standard name of a moment; empty: the table has none.
 */
std::string vtkNexradStandardName(nexrad::MomentName moment);

/**
 * The unit of a moment as UDUNITS writes it.
 */
std::string vtkNexradUnitsOf(nexrad::MomentName moment);

/**
 * Writes the parameters of the grid's projection into a grid mapping variable.
 */
void vtkNexradWriteProjection(
  const vtkNexradNetCDFFile& file, int variable, const nexrad::GridSpecification& grid);

/**
 * Writes the attributes of the file: conventions, title, where the data come from.
 */
void vtkNexradWriteProvenance(
  const vtkNexradNetCDFFile& file, const nexrad::GriddedVolume& volume, const std::string& history);

#endif
// VTK-HeaderTest-Exclude: vtkNexradNetCDFTerms.h
