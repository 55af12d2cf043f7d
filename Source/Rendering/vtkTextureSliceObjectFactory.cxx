// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTextureSliceObjectFactory.h"

#include "vtkNew.h"
#include "vtkOpenGLTextureSliceVolumeMapper.h"
#include "vtkVersion.h"
#include "vtkWeakPointer.h"

vtkStandardNewMacro(vtkTextureSliceObjectFactory);

namespace
{

constexpr const char* Overridden = "vtkGPUVolumeRayCastMapper";

VTK_CREATE_CREATE_FUNCTION(vtkOpenGLTextureSliceVolumeMapper);

/// The factory that Activate registered; VTK's list keeps it.
vtkWeakPointer<vtkObjectFactory> Registered;

} // namespace

vtkTextureSliceObjectFactory::vtkTextureSliceObjectFactory()
{
  this->RegisterOverride(Overridden, "vtkOpenGLTextureSliceVolumeMapper", "Slices of a 3-D texture",
    1, vtkObjectFactoryCreatevtkOpenGLTextureSliceVolumeMapper);
}

void vtkTextureSliceObjectFactory::DisableOthers()
{
  vtkObjectFactory::SetAllEnableFlags(0, Overridden);
}

void vtkTextureSliceObjectFactory::Activate()
{
  if (Registered == nullptr)
  {
    DisableOthers();
    vtkNew<vtkTextureSliceObjectFactory> factory;
    vtkObjectFactory::RegisterFactory(factory);
    Registered = factory;
  }
}

void vtkTextureSliceObjectFactory::Deactivate()
{
  if (Registered != nullptr)
  {
    vtkObjectFactory::UnRegisterFactory(Registered);
    vtkObjectFactory::SetAllEnableFlags(1, Overridden);
  }
}

const char* vtkTextureSliceObjectFactory::GetVTKSourceVersion()
{
  return VTK_SOURCE_VERSION;
}

const char* vtkTextureSliceObjectFactory::GetDescription()
{
  return "Slices of a 3-D texture in place of ray casting";
}
