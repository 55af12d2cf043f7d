// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file   vtkNexradNetCDFFile.h
 * @brief  a NetCDF file that is being written, its errors as nexrad::Error
 */
#ifndef vtkNexradNetCDFFile_h
#define vtkNexradNetCDFFile_h

#include "vtk_netcdf.h"

#include <filesystem>
#include <mutex>
#include <string>
#include <type_traits>
#include <vector>

/**
 * What holds it uses the NetCDF library alone: the library may run on one thread at a time only.
 */
std::unique_lock<std::recursive_mutex> vtkNexradLockNetCDF();

/**
 * A NetCDF file that is being written. Whoever calls a member, the constructor and the destructor
 * among them, holds what vtkNexradLockNetCDF gives. All members throw nexrad::Error, naming the
 * file, what could not be done, and what the library reports.
 */
class vtkNexradNetCDFFile
{
public:
  /**
   * Makes a new NetCDF-4 file; the path must not exist. `shown` is the name of the file in
   * messages.
   */
  vtkNexradNetCDFFile(const std::filesystem::path& path, std::string shown);
  ~vtkNexradNetCDFFile();
  vtkNexradNetCDFFile(const vtkNexradNetCDFFile&) = delete;
  vtkNexradNetCDFFile& operator=(const vtkNexradNetCDFFile&) = delete;

  int Id() const { return this->Identifier; }

  /**
   * Throws nexrad::Error when `status`, which a function of the library returned, is an error.
   */
  void Check(int status, const std::string& what) const;
  [[noreturn]] void Fail(const std::string& problem) const;

  /**
   * Writes what the library still holds.
   */
  void Close();

  ///@{
  /**
   * Writes an attribute of a variable, or of the file (NC_GLOBAL): a text, or numbers of type
   * double, float, short or signed char, which the file has of the same type.
   */
  void SetText(int variable, const std::string& name, const std::string& text) const;
  template <class Number = double>
  void SetNumbers(int variable, const std::string& name, const std::vector<Number>& numbers) const
  {
    constexpr nc_type type = std::is_same_v<Number, double>  ? NC_DOUBLE
                             : std::is_same_v<Number, float> ? NC_FLOAT
                             : std::is_same_v<Number, short> ? NC_SHORT
                                                             : NC_BYTE;
    this->Check(
      nc_put_att(this->Identifier, variable, name.c_str(), type, numbers.size(), numbers.data()),
      name);
  }
  ///@}

private:
  std::string Shown;
  int Identifier = -1;
};

#endif
// VTK-HeaderTest-Exclude: vtkNexradNetCDFFile.h
