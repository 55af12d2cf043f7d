// SPDX-License-Identifier: BSD-3-Clause
// Finds out whether a card draws much faster by compute shaders than by fragments.
#ifndef vtkTextureSliceTrial_h
#define vtkTextureSliceTrial_h

#include <optional>

class vtkOpenGLRenderWindow;
class vtkTextureObject;

namespace vtkTextureSliceTrial
{

/// Whether compute was twice as fast for the renderer of the context that is current; none: there
/// was no trial yet.
std::optional<bool> Recall();

/**
 * Times both ways with the same short rays through a volume's texture, in a picture of 256 x 256
 * pixels, and remembers the result for all contexts of the same renderer. The number of samples
 * grows until the slower way takes a millisecond. The context, which must have compute shaders,
 * is current. @return whether compute is twice as fast
 */
bool Run(vtkOpenGLRenderWindow* window, vtkTextureObject* volume);

} // namespace vtkTextureSliceTrial

#endif
