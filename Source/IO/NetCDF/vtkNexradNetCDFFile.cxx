// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNexradNetCDFFile.h"

#include "nexrad/System/MessageText.h"

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

} // namespace

std::unique_lock<std::recursive_mutex> vtkNexradLockNetCDF()
{
  // The library keeps state that all its files share.
  static std::recursive_mutex mutex;
  std::unique_lock<std::recursive_mutex> lock(mutex);
  SilenceThread();
  return lock;
}

vtkNexradNetCDFFile::vtkNexradNetCDFFile(const std::filesystem::path& path, std::string shown)
  : Shown(std::move(shown))
{
  const int status = nc_create(path.c_str(), NC_NETCDF4 | NC_NOCLOBBER, &this->Identifier);
  if (status != NC_NOERR)
  {
    this->Identifier = -1;
  }
  this->Check(status, "cannot be written");
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
