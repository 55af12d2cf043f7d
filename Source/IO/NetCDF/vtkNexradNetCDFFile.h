// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file   vtkNexradNetCDFFile.h
 * @brief  an open NetCDF file, its errors as nexrad::Error
 */
#ifndef vtkNexradNetCDFFile_h
#define vtkNexradNetCDFFile_h

#include <cstddef>
#include <filesystem>
#include <mutex>
#include <optional>
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
 * An open NetCDF file. Whoever calls a member, the constructor and the destructor among them, holds
 * a vtkNexradNetCDFLock. All members throw nexrad::Error, naming the file, what could not be done,
 * and what the library reports.
 */
class vtkNexradNetCDFFile
{
public:
  enum class Mode
  {
    Read,
    Create, ///< a new NetCDF-4 file; the path must not exist
  };

  /**
   * `shown` is the name of the file in messages.
   */
  vtkNexradNetCDFFile(const std::filesystem::path& path, Mode mode, std::string shown);
  ~vtkNexradNetCDFFile();
  vtkNexradNetCDFFile(const vtkNexradNetCDFFile&) = delete;
  vtkNexradNetCDFFile& operator=(const vtkNexradNetCDFFile&) = delete;

  int Id() const { return this->Identifier; }
  const std::string& Name() const { return this->Shown; }

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

  ///@{
  /**
   * Reads an attribute; empty when there is none of that name and kind.
   */
  std::optional<std::string> Text(int variable, const std::string& name) const;
  std::optional<double> Number(int variable, const std::string& name) const;
  ///@}

  /**
   * The number of a variable; empty when the file has none of that name.
   */
  std::optional<int> FindVariable(const std::string& name) const;

  /**
   * The lengths of a variable's dimensions.
   */
  std::vector<std::size_t> ShapeOf(int variable) const;

  /**
   * Reads texts (NC_STRING) of a variable with one dimension.
   */
  std::vector<std::string> Texts(int variable) const;

private:
  std::string Shown;
  int Identifier = -1;
};

#endif
// VTK-HeaderTest-Exclude: vtkNexradNetCDFFile.h
