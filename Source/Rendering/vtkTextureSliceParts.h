// SPDX-License-Identifier: BSD-3-Clause
// The parts of the texture-slice mapper, and a frame that they draw together.
#ifndef vtkTextureSliceParts_h
#define vtkTextureSliceParts_h

#include "vtkSmartPointer.h"
#include "vtkTextureSliceEmptySpace.h"
#include "vtkTextureSliceFrame.h"
#include "vtkTextureSliceRequest.h"
#include "vtkTextureSliceShadows.h"
#include "vtkTextureSliceTables.h"
#include "vtkTextureSliceTarget.h"
#include "vtkTextureSliceTexture.h"
#include "vtkTextureSliceWays.h"
#include "vtkWeakPointer.h"

#include <array>
#include <functional>
#include <string>
#include <vector>

class vtkDataArray;
class vtkImageData;
class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkTextureObject;

/// What the mapper works with, one job each. Each part decides what a change makes it do anew.
struct vtkTextureSliceParts
{
  /// The volume of this frame; of a rectilinear grid, an image of its points or cells.
  vtkSmartPointer<vtkImageData> Image;
  vtkDataArray* Scalars = nullptr;
  vtkDataArray* MaskValues = nullptr; ///< nullptr: there is no mask
  vtkTextureSliceRequest Request;
  vtkTextureSliceFrame Frame;
  vtkTextureSlicePlanes Planes;
  vtkTextureSliceTexture Texture;
  vtkTextureSliceTable Table;
  vtkTextureSliceCoordinates Coordinates; ///< used if Features.Rectilinear
  vtkTextureSliceTexture SecondArray;     ///< used if Features.SecondArray is above 0
  vtkTextureSliceTable2D Table2D;         ///< used if Features.Table2D
  /// Flags of cells (or, beside scalars of cells, of points) that hide what is in them (or nearest
  /// to them); used if Features.Blanked.
  vtkTextureSliceTexture Blanks;
  bool HasBlanks = false;
  vtkTextureSliceTexture Mask;            ///< used if Features.HasMask()
  vtkTextureSliceIntegralTable Integrals; ///< used if Features.Slabs
  vtkTextureSliceLights Lights;
  vtkTextureSliceShadows Shadows; ///< used if Features.Shadows
  vtkTextureSlicePeeling Peeling; ///< used if Features.Peel is above 0
  vtkTextureSliceEmptySpace EmptySpace;
  vtkTextureSliceResolution Resolution;
  vtkTextureSliceTarget Target;
  vtkTextureSliceImages Images;
  vtkTextureSliceWays Ways;

  vtkTextureSliceFeatures Features;
  /// The part of the box with something to see: lower x, upper x, lower y and so on.
  std::array<double, 6> Seen{0, 1, 0, 1, 0, 1};
  double PixelSize = 1.0;                ///< pixels of the viewport for one of the picture
  std::array<float, 3> SelectionColor{}; ///< used if Features.Selection

  /// The window whose context owns the graphics resources.
  vtkWeakPointer<vtkOpenGLRenderWindow> Window;
  /// What was said of the last frame, and is not said again: what it refused, what it ignored, and
  /// why it was drawn in another way.
  std::array<std::string, 3> Said;

  /// Deletes the graphics resources in the context of the window that owns them; the current
  /// context stays the same.
  void Release(vtkOpenGLRenderWindow* window);
  /// Makes that window the owner; another one gives its resources up first.
  void Use(vtkOpenGLRenderWindow* window);

  /// Brings the textures of the volume and of the functions up to date.
  /// @return in one line why they cannot be, or nothing
  std::string UpdateVolume();
  /// Draws the slices into the target. @return in one line why it cannot, or nothing
  std::string Draw();
  /// Draws with a shader that is ready, which gets everything that it reads.
  void DrawWith(vtkShaderProgram* program, const std::function<void()>& draw);

private:
  /// Brings the integrals of the table up to date, for slabs as thick as the planes are distant.
  void UpdateIntegrals();
  /// A texture, the name of its sampler, and whether the features need it.
  struct Sampler
  {
    bool Needed;
    const char* Name;
    vtkTextureObject* Texture;
  };
  std::vector<Sampler> FindSamplers();
  void SetUniforms(vtkShaderProgram* program);
};

#endif
