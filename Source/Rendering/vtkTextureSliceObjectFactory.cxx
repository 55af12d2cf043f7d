// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTextureSliceObjectFactory.h"

#include "vtkNew.h"
#include "vtkObjectFactoryCollection.h"
#include "vtkOpenGLTextureSliceVolumeMapper.h"
#include "vtkVersion.h"

vtkStandardNewMacro(vtkTextureSliceObjectFactory);

namespace
{

constexpr const char* Overridden = "vtkGPUVolumeRayCastMapper";

vtkObject* MakeSlices()
{
  return vtkOpenGLTextureSliceVolumeMapper::New();
}

/// The one that Activate left, nullptr if there is none.
vtkObjectFactory* FindRegistered()
{
  vtkObjectFactoryCollection* registered = vtkObjectFactory::GetRegisteredFactories();
  vtkCollectionSimpleIterator iterator;
  registered->InitTraversal(iterator);
  vtkObjectFactory* factory = registered->GetNextObjectFactory(iterator);
  while (factory != nullptr && vtkTextureSliceObjectFactory::SafeDownCast(factory) == nullptr)
  {
    factory = registered->GetNextObjectFactory(iterator);
  }
  return factory;
}

} // namespace

vtkTextureSliceObjectFactory::vtkTextureSliceObjectFactory()
{
  this->RegisterOverride(
    Overridden, "vtkOpenGLTextureSliceVolumeMapper", "Slices of a 3-D texture", 1, MakeSlices);
}

void vtkTextureSliceObjectFactory::DisableOthers()
{
  vtkObjectFactory::SetAllEnableFlags(0, Overridden);
}

void vtkTextureSliceObjectFactory::Activate()
{
  if (FindRegistered() == nullptr)
  {
    DisableOthers();
    vtkNew<vtkTextureSliceObjectFactory> factory;
    vtkObjectFactory::RegisterFactory(factory);
  }
}

void vtkTextureSliceObjectFactory::Deactivate()
{
  if (vtkObjectFactory* factory = FindRegistered())
  {
    vtkObjectFactory::UnRegisterFactory(factory);
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

void vtkTextureSliceObjectFactory::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
