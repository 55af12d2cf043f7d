// SPDX-License-Identifier: BSD-3-Clause
// The functions by which VTK gets a factory out of a library of VTK_AUTOLOAD_PATH (see
// vtkObjectFactory).
#include "vtkTextureSliceObjectFactory.h"

#include "vtkVersion.h"

extern "C" VTK_ABI_EXPORT const char* vtkGetFactoryVersion()
{
  return VTK_SOURCE_VERSION;
}

// VTK registers what this gives, behind the factories of the modules that the program has linked.
extern "C" VTK_ABI_EXPORT vtkObjectFactory* vtkLoad()
{
  vtkTextureSliceObjectFactory::DisableOthers();
  return vtkTextureSliceObjectFactory::New();
}
