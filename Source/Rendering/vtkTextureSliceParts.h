// SPDX-License-Identifier: BSD-3-Clause
// The parts of the texture-slice mapper, and a frame that they draw together.
#ifndef vtkTextureSliceParts_h
#define vtkTextureSliceParts_h

#include "vtkTextureSliceBlanks.h"
#include "vtkTextureSliceCoordinates.h"
#include "vtkTextureSliceEmptySpace.h"
#include "vtkTextureSliceFrame.h"
#include "vtkTextureSliceIntegralTable.h"
#include "vtkTextureSliceLights.h"
#include "vtkTextureSlicePeeling.h"
#include "vtkTextureSlicePlanes.h"
#include "vtkTextureSliceRequest.h"
#include "vtkTextureSliceResolution.h"
#include "vtkTextureSliceShadows.h"
#include "vtkTextureSliceTable.h"
#include "vtkTextureSliceTable2D.h"
#include "vtkTextureSliceTarget.h"
#include "vtkTextureSliceTexture.h"
#include "vtkTextureSliceUniforms.h"
#include "vtkTextureSliceWays.h"

#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <string>

class vtkImageData;
class vtkOpenGLRenderWindow;
class vtkShaderProgram;

/**
 * What vtkOpenGLTextureSliceVolumeMapper works with, one job each; every part decides for itself
 * what a change makes it do anew.
 */
class vtkTextureSliceParts
{
public:
  vtkTextureSliceTexture Texture;
  vtkTextureSliceTable Table;
  vtkTextureSliceTable2D Table2D;
  vtkTextureSliceTexture Mask;
  /// What two-dimensional functions have in place of the gradient magnitude.
  vtkTextureSliceTexture SecondArray;
  vtkTextureSliceBlanks Blanks;
  /// Used where the input is a rectilinear grid.
  vtkTextureSliceCoordinates Coordinates;
  vtkSmartPointer<vtkImageData> GridAsImage;
  vtkTextureSliceTable LabelTable;
  vtkTextureSliceIntegralTable Integrals;
  vtkTextureSliceIntegralTable LabelIntegrals;
  vtkTextureSliceFrame Frame;
  vtkTextureSliceEmptySpace EmptySpace;
  vtkTextureSlicePlanes Planes;
  vtkTextureSliceLights Lights;
  vtkTextureSliceShadows Shadows;
  vtkTextureSliceResolution Resolution;
  /// Image sample distance of this frame.
  double PixelSize = 1.0;
  vtkTextureSliceTarget Target;
  vtkTextureSliceWays Ways;
  vtkTextureSlicePeeling Peeling;
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

  /// Brings the tables of transfer functions up to date. @return false with one line in @a error
  bool UpdateTables(const vtkTextureSliceRequest& request, bool nearest, std::string& error);
  /// Adds the textures that the features need.
  void AddTextures(vtkTextureSliceUniforms& uniforms);
  /// Sets what the shaders read of the parts, beside their textures.
  void SetUniforms(const vtkTextureSliceFeatures& features, vtkShaderProgram* program);
  /// Draws the slices into the target. @return false with one line in @a error
  bool Draw(const vtkTextureSliceUniforms& uniforms, std::string& error);
  /// Hands the picture to the window. @a colorScale, @a colorBias: the final window and level
  void Composite(const vtkTextureSliceUniforms& uniforms, float colorScale, float colorBias);

private:
  /// Brings the integrals of the tables up to date, for slabs as thick as the planes are distant.
  void UpdateIntegrals(const vtkTextureSliceUniforms& uniforms);
};

#endif
