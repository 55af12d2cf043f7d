// SPDX-License-Identifier: BSD-3-Clause
// The parts of the texture-slice mapper, and a frame that they draw together.
#ifndef vtkTextureSliceParts_h
#define vtkTextureSliceParts_h

#include "vtkTextureSliceEmptySpace.h"
#include "vtkTextureSliceTarget.h"
#include "vtkTextureSliceUniforms.h"
#include "vtkTextureSliceWays.h"

#include "vtkWeakPointer.h"

#include <string>

class vtkDataArray;
class vtkOpenGLRenderWindow;

/**
 * What vtkOpenGLTextureSliceVolumeMapper works with, one job each: what the shaders read, and what
 * finds and draws it.
 */
class vtkTextureSliceParts : public vtkTextureSliceUniforms
{
public:
  vtkTextureSliceEmptySpace EmptySpace;
  vtkTextureSliceResolution Resolution;
  vtkTextureSliceTarget Target;
  vtkTextureSliceImages Images;
  vtkTextureSliceWays Ways;
  /// The window whose context owns the graphics resources.
  vtkWeakPointer<vtkOpenGLRenderWindow> Window;
  /// What the last frame refused, and what it ignored: the same is not said again.
  std::string Refused;
  std::string Ignored;
  /// Why it was drawn in another way than asked for.
  std::string Fallback;

  /// Whether a message that is repeated each frame is another one than in the last frame.
  static bool IsNews(std::string& last, const std::string& message);

  /// Deletes the graphics resources in the context of the window that owns them; the current
  /// context stays the same.
  void Release(vtkOpenGLRenderWindow* window);
  /// Makes that window the owner; another one gives its resources up first.
  void Use(vtkOpenGLRenderWindow* window);

  /// Brings the textures of the volume and of the functions up to date.
  /// @param second of two-dimensional functions; or nullptr
  /// @return false with one line in @a error
  bool UpdateVolume(bool cellData, vtkDataArray* second, std::string& error);
  /// Draws the slices into the target. @return false with one line in @a error
  bool Draw(std::string& error);
  /// Hands the picture to the window. @a colorScale, @a colorBias: the final window and level
  void Composite(float colorScale, float colorBias);

private:
  bool UpdateTables(bool nearest, std::string& error);
  /// Brings the integrals of the tables up to date, for slabs as thick as the planes are distant.
  void UpdateIntegrals();
};

#endif
