// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file   vtkNexradFirstView.h
 * @brief  how a view of ParaView, and the words in it, show radar data where nobody chose
 */
#ifndef vtkNexradFirstView_h
#define vtkNexradFirstView_h

#include <array>
#include <initializer_list>

class vtkSMProxy;
class vtkSMViewProxy;

/**
 * Whether any data are visible in a view; legends and texts are none.
 */
bool vtkNexradShowsData(vtkSMViewProxy* view);

/**
 * Gives a view the sky of the scene's theme, and a camera that looks at a box of the view (from, to
 * of x, y and z): from the scene's usual direction, or straight from above.
 */
void vtkNexradDressView(vtkSMViewProxy* view, const std::array<double, 6>& box, bool fromAbove);

/**
 * The height of letters that can be read where the camera of a view looks, in the coordinates of
 * the view.
 */
double vtkNexradLetterHeight(vtkSMViewProxy* view);

/**
 * Gives properties of a proxy the theme's colour of letters where a view has the theme's sky:
 * ParaView's own letters are white.
 */
void vtkNexradDressWords(
  vtkSMProxy* proxy, std::initializer_list<const char*> properties, vtkSMProxy* view);

#endif
