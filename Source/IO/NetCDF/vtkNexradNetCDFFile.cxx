// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNexradNetCDFFile.h"

#include "nexrad/System/MessageText.h"
#include "nexrad/System/OrdinaryFile.h"

#include "vtk_netcdf.h"

#include <dlfcn.h>

#include <cstdint>
#include <utility>

namespace
{

// HDF5 prints every attribute that NetCDF looks for in vain on standard error, on each thread anew
// until that thread asks it not to; NetCDF does so for the first thread alone. HDF5 is found
// through the NetCDF library: a process may have another HDF5 beside it (ParaView's, built for
// MPI).
void SilenceThread()
{
  using SetAutomaticPrinting = int (*)(std::int64_t, void*, void*);
  static const SetAutomaticPrinting set = []() -> SetAutomaticPrinting
  {
    Dl_info library{};
    if (dladdr(reinterpret_cast<void*>(&nc_open), &library) == 0)
    {
      return nullptr;
    }
    void* const handle = dlopen(library.dli_fname, RTLD_LAZY | RTLD_NOLOAD);
    void* found = handle != nullptr ? dlsym(handle, "H5Eset_auto2") : nullptr;
    if (handle != nullptr && found == nullptr)
    {
      found = dlsym(handle, "vtkhdf5_H5Eset_auto2"); // VTK's own copy
    }
    return reinterpret_cast<SetAutomaticPrinting>(found);
  }();
  thread_local bool silent = false;
  if (!silent && set != nullptr)
  {
    set(0, nullptr, nullptr); // of the thread's default list of errors
    silent = true;
  }
}

// Of the library, which keeps state that all its files share.
std::recursive_mutex& LibraryMutex()
{
  static std::recursive_mutex mutex;
  return mutex;
}

// Longest text of an attribute that is read, bytes.
constexpr std::size_t LongestText = std::size_t(1) << 20;

} // namespace

vtkNexradNetCDFLock::vtkNexradNetCDFLock()
  : Lock(LibraryMutex())
{
  SilenceThread();
}

vtkNexradNetCDFFile::vtkNexradNetCDFFile(
  const std::filesystem::path& path, Mode mode, std::string shown)
  : Shown(std::move(shown))
{
  const bool create = mode == Mode::Create;
  if (!create)
  {
    nexrad::RequireOrdinaryFile(path);
  }
  const int status = create ? nc_create(path.c_str(), NC_NETCDF4 | NC_NOCLOBBER, &this->Identifier)
                            : nc_open(path.c_str(), NC_NOWRITE, &this->Identifier);
  if (status != NC_NOERR)
  {
    this->Identifier = -1;
  }
  this->Check(status, create ? "cannot be written" : "cannot be read as NetCDF");
}

vtkNexradNetCDFFile::~vtkNexradNetCDFFile()
{
  if (this->Identifier >= 0)
  {
    nc_close(this->Identifier);
  }
}

void vtkNexradNetCDFFile::Check(int status, const std::string& what) const
{
  if (status != NC_NOERR)
  {
    this->Fail(what + ": " + nc_strerror(status));
  }
}

void vtkNexradNetCDFFile::Fail(const std::string& problem) const
{
  throw nexrad::FileError(this->Shown, problem);
}

void vtkNexradNetCDFFile::Close()
{
  const int status = nc_close(this->Identifier);
  this->Identifier = -1;
  this->Check(status, "cannot be written");
}

void vtkNexradNetCDFFile::SetText(
  int variable, const std::string& name, const std::string& text) const
{
  this->Check(
    nc_put_att_text(this->Identifier, variable, name.c_str(), text.size(), text.c_str()), name);
}

void vtkNexradNetCDFFile::SetNumbers(
  int variable, const std::string& name, const std::vector<double>& numbers) const
{
  this->Check(nc_put_att_double(this->Identifier, variable, name.c_str(), NC_DOUBLE, numbers.size(),
                numbers.data()),
    name);
}

void vtkNexradNetCDFFile::SetBytes(
  int variable, const std::string& name, const std::vector<signed char>& numbers) const
{
  this->Check(nc_put_att_schar(
                this->Identifier, variable, name.c_str(), NC_BYTE, numbers.size(), numbers.data()),
    name);
}

void vtkNexradNetCDFFile::SetFloat(int variable, const std::string& name, float number) const
{
  this->Check(
    nc_put_att_float(this->Identifier, variable, name.c_str(), NC_FLOAT, 1, &number), name);
}

void vtkNexradNetCDFFile::SetShort(int variable, const std::string& name, short number) const
{
  this->Check(
    nc_put_att_short(this->Identifier, variable, name.c_str(), NC_SHORT, 1, &number), name);
}

std::optional<std::string> vtkNexradNetCDFFile::Text(int variable, const std::string& name) const
{
  nc_type type = NC_NAT;
  std::size_t length = 0;
  if (nc_inq_att(this->Identifier, variable, name.c_str(), &type, &length) != NC_NOERR ||
      type != NC_CHAR || length > LongestText)
  {
    return std::nullopt;
  }
  std::string text(length, '\0');
  this->Check(nc_get_att_text(this->Identifier, variable, name.c_str(), text.data()), name);
  return text;
}

std::optional<double> vtkNexradNetCDFFile::Number(int variable, const std::string& name) const
{
  nc_type type = NC_NAT;
  std::size_t length = 0;
  double number = 0.0;
  if (nc_inq_att(this->Identifier, variable, name.c_str(), &type, &length) != NC_NOERR ||
      type == NC_CHAR || type == NC_STRING || length != 1 ||
      nc_get_att_double(this->Identifier, variable, name.c_str(), &number) != NC_NOERR)
  {
    return std::nullopt;
  }
  return number;
}

std::optional<int> vtkNexradNetCDFFile::FindVariable(const std::string& name) const
{
  int variable = -1;
  return nc_inq_varid(this->Identifier, name.c_str(), &variable) == NC_NOERR
           ? std::optional(variable)
           : std::nullopt;
}

std::vector<std::size_t> vtkNexradNetCDFFile::ShapeOf(int variable) const
{
  int count = 0;
  this->Check(nc_inq_varndims(this->Identifier, variable, &count), "dimensions");
  std::vector<int> dimensions(static_cast<std::size_t>(count));
  this->Check(nc_inq_vardimid(this->Identifier, variable, dimensions.data()), "dimensions");
  std::vector<std::size_t> shape;
  for (const int dimension : dimensions)
  {
    std::size_t length = 0;
    this->Check(nc_inq_dimlen(this->Identifier, dimension, &length), "dimensions");
    shape.push_back(length);
  }
  return shape;
}

std::vector<std::string> vtkNexradNetCDFFile::Texts(int variable) const
{
  nc_type type = NC_NAT;
  this->Check(nc_inq_vartype(this->Identifier, variable, &type), "type");
  const std::vector<std::size_t> shape = this->ShapeOf(variable);
  if (type != NC_STRING || shape.size() != 1)
  {
    this->Fail("a list of names has another type than string");
  }
  std::vector<char*> texts(shape[0], nullptr);
  if (texts.empty())
  {
    return {};
  }
  this->Check(nc_get_var_string(this->Identifier, variable, texts.data()), "names");
  std::vector<std::string> names;
  for (const char* text : texts)
  {
    names.emplace_back(text != nullptr ? text : "");
  }
  nc_free_string(texts.size(), texts.data());
  return names;
}
