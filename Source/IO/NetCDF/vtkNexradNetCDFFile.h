// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file   vtkNexradNetCDFFile.h
 * @brief  a NetCDF file that is being written, its errors as nexrad::Error
 */
#ifndef vtkNexradNetCDFFile_h
#define vtkNexradNetCDFFile_h

#include <filesystem>
#include <mutex>
#include <string>
#include <vector>

/**
 * What holds it uses the NetCDF library alone: the library may run on one thread at a time only.
 */
class vtkNexradNetCDFLock
{
public:
  vtkNexradNetCDFLock();

private:
  std::unique_lock<std::recursive_mutex> Lock;
};

/**
 * A NetCDF file that is being written. Whoever calls a member, the constructor and the destructor
 * among them, holds a vtkNexradNetCDFLock. All members throw nexrad::Error, naming the file, what
 * could not be done, and what the library reports.
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
   * Writes an attribute of a variable, or of the file (NC_GLOBAL).
   */
  void SetText(int variable, const std::string& name, const std::string& text) const;
  void SetNumbers(int variable, const std::string& name, const std::vector<double>& numbers) const;
  void SetBytes(
    int variable, const std::string& name, const std::vector<signed char>& numbers) const;
  void SetFloat(int variable, const std::string& name, float number) const;
  void SetShort(int variable, const std::string& name, short number) const;
  ///@}

private:
  std::string Shown;
  int Identifier = -1;
};

#endif
// VTK-HeaderTest-Exclude: vtkNexradNetCDFFile.h
