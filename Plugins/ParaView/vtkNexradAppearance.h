// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file   vtkNexradAppearance.h
 * @brief  how ParaView's representations and views show radar data where nobody chose
 */
#ifndef vtkNexradAppearance_h
#define vtkNexradAppearance_h

class vtkSMProxy;
class vtkSMViewProxy;

/**
 * Whether any data are visible in a view; legends and texts are none.
 */
bool vtkNexradShowsData(vtkSMViewProxy* view);

/**
 * Colours a representation by the first moment of its input and stretches its heights. A volume is
 * lit, with opacities for 5 km; of sweeps the first of each radar is shown, in the colours of the
 * legend.
 */
void vtkNexradDressData(vtkSMProxy* representation, bool isVolume);

/**
 * Gives a map its own colours, and the heights of its input's representation in the view.
 */
void vtkNexradDressMap(vtkSMProxy* representation, vtkSMViewProxy* view);

/**
 * Gives a view a dark background, and a camera that looks at what the representation shows: at a
 * volume from the south and from above, at sweeps straight from above.
 */
void vtkNexradDressView(vtkSMViewProxy* view, vtkSMProxy* representation, bool isVolume);

#endif
