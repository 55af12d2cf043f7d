// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkNexradShowController
 * @brief   shows merged volumes and sweeps in ParaView as a person wants to see them
 *
 * ParaView makes one of these for each time that it shows something, in place of its own class.
 * When the output of a source whose hints have the element NexradShow is shown in a view for the
 * first time:
 *
 * - kind="volume": it is coloured by its first moment, and lit over the ground; stretch of heights,
 * opacities and slices suit its echo, as in the scene (vtkNexradFraming).
 * - kind="sweeps": coloured by its first moment, heights stretched by the scene's rule; the first
 * sweep of each radar alone is visible, without lighting.
 * - kind="map": drawn in its own colours, with the heights of its input.
 *
 * In a render view in which nothing else is visible, volumes and sweeps get the sky of the scene's
 * light theme, with dark letters, and a camera: at the echo of a volume from the scene's direction,
 * at sweeps straight from above.
 *
 * A new opacity function of a moment's array gets the opacities of the moment's preset; ParaView
 * itself takes only the colours of a preset. The legend of a moment has numbers without exponents.
 *
 * What is shown by ParaView's button Apply gets a map and its time beside it, as filters in the
 * pipeline, when the view has neither yet. Scripts, which call Show, do not.
 *
 * Loading a state does not show anything in this sense, so that a state comes back as it was saved.
 */
#ifndef vtkNexradShowController_h
#define vtkNexradShowController_h

#include "vtkSMParaViewPipelineControllerWithRendering.h"

class vtkNexradShowController : public vtkSMParaViewPipelineControllerWithRendering
{
public:
  static vtkNexradShowController* New();
  // Its name at run time is ParaView's: scripts of ParaView find the methods of the class by it.
  using Superclass = vtkSMParaViewPipelineControllerWithRendering;

  using Superclass::Show;
  vtkSMProxy* Show(vtkSMSourceProxy* producer, int outputPort, vtkSMViewProxy* view,
    const char* representationType) override;
  vtkSMViewProxy* ShowInPreferredView(
    vtkSMSourceProxy* producer, int outputPort, vtkSMViewProxy* view) override;

  using Superclass::RegisterOpacityTransferFunction;
  bool RegisterOpacityTransferFunction(vtkSMProxy* proxy, const char* name) override;
  bool PostInitializeProxy(vtkSMProxy* proxy) override;

protected:
  vtkNexradShowController() = default;
  ~vtkNexradShowController() override = default;

private:
  vtkNexradShowController(const vtkNexradShowController&) = delete;
  void operator=(const vtkNexradShowController&) = delete;

  /**
   * Shows a filter of the plugin with a name in the pipeline browser beside its input.
   */
  void ShowCompanion(
    vtkSMSourceProxy* producer, vtkSMViewProxy* view, const char* filter, const char* name);
};

/**
 * Lets ParaView use vtkNexradShowController. Servers show nothing, so nothing happens there.
 */
void vtkNexradStartShowController();

#endif
