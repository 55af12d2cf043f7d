// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file   vtkNexradAppearance.h
 * @brief  how ParaView's representations show radar data where nobody chose: as the scene does
 */
#ifndef vtkNexradAppearance_h
#define vtkNexradAppearance_h

#include <array>
#include <optional>

class vtkSMProxy;
class vtkSMViewProxy;

/**
 * A box of a view: from, to of x, y and z.
 */
using vtkNexradBox = std::array<double, 6>;

/**
 * Colours the representation of a volume by its first moment, lights it over the ground, and gives
 * it the stretch of heights, the distance of opacities and the number of slices that suit its echo
 * at the time of the view (vtkNexradFraming), and the size of pixels that suits its voxels there.
 * What the view is to look at; nothing where there is no volume.
 */
std::optional<vtkNexradBox> vtkNexradDressVolume(vtkSMProxy* representation, vtkSMViewProxy* view);

/**
 * Shows the first sweep of each radar, in the colours of the legend, with stretched heights. What a
 * view is to look at; nothing where there are no sweeps.
 */
std::optional<vtkNexradBox> vtkNexradDressSweeps(vtkSMProxy* representation);

/**
 * Gives a map its own colours, and the heights of its input's representation in the view.
 */
void vtkNexradDressMap(vtkSMProxy* representation, vtkSMViewProxy* view);

/**
 * Gives the filter of a map, whose input a view shows, letters that can be read there.
 */
void vtkNexradSizeLetters(vtkSMProxy* map, vtkSMViewProxy* view);

#endif
