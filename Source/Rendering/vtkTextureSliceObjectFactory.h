// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTextureSliceObjectFactory
 * @brief   Makes vtkGPUVolumeRayCastMapper::New give slices
 *
 * While an object of this class is registered, vtkGPUVolumeRayCastMapper::New makes a
 * vtkOpenGLTextureSliceVolumeMapper, and so does everything that calls it, such as
 * vtkSmartVolumeMapper. vtkOpenGLGPUVolumeRayCastMapper::New asks no factory and is left as it is.
 *
 * @code
 * vtkTextureSliceObjectFactory::Activate();
 * vtkNew<vtkSmartVolumeMapper> mapper; // draws slices
 * @endcode
 */
#ifndef vtkTextureSliceObjectFactory_h
#define vtkTextureSliceObjectFactory_h

#include "vtkNexradRenderingModule.h" // for the export macro
#include "vtkObjectFactory.h"

class VTKNEXRADRENDERING_EXPORT vtkTextureSliceObjectFactory : public vtkObjectFactory
{
public:
  static vtkTextureSliceObjectFactory* New();
  vtkTypeMacro(vtkTextureSliceObjectFactory, vtkObjectFactory);

  ///@{
  /**
   * Registers a factory of this class, and takes it away again. The first factory wins in VTK, so
   * Activate switches vtkGPUVolumeRayCastMapper off in those that are there, and Deactivate on
   * again. Activate is to be called when VTK's modules are loaded; twice is as once.
   */
  static void Activate();
  static void Deactivate();
  ///@}

  /**
   * The first half of Activate: switches vtkGPUVolumeRayCastMapper off in the factories that are
   * registered. For those who let VTK register one of this class (VTK_AUTOLOAD_PATH).
   */
  static void DisableOthers();

  const char* GetVTKSourceVersion() override;
  const char* GetDescription() override;

protected:
  vtkTextureSliceObjectFactory();
  ~vtkTextureSliceObjectFactory() override = default;

private:
  vtkTextureSliceObjectFactory(const vtkTextureSliceObjectFactory&) = delete;
  void operator=(const vtkTextureSliceObjectFactory&) = delete;
};

#endif
