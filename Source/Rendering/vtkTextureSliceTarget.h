// SPDX-License-Identifier: BSD-3-Clause
// The picture of the volume before the window sees it, its resolution, images of it, and which part
// of the volume it is.
#ifndef vtkTextureSliceTarget_h
#define vtkTextureSliceTarget_h

#include "vtkNew.h"
#include "vtkNexradRenderingModule.h" // for the export macro
#include "vtkOpenGLFramebufferObject.h"
#include "vtkTextureObject.h"
#include "vtkTextureSliceWays.h"

#include <array>
#include <string>
#include <vector>

class vtkAbstractMapper;
class vtkImageData;
class vtkOpenGLRenderPass;
class vtkOpenGLRenderWindow;
class vtkRenderer;
class vtkShaderProgram;
class vtkVolume;
struct vtkTextureSliceParts;

/// The image sample distance, pixels of the window for each pixel of the volume's picture along an
/// axis: 1, 2, 5 or 10, as in VTK's ray caster. A frame's time is taken to grow with its pixels.
class VTKNEXRADRENDERING_EXPORT vtkTextureSliceResolution
{
public:
  /// Whether a frame that may take that long, seconds, is one of an interaction, as in VTK's ray
  /// caster.
  static bool IsInteractive(double allowedTime) { return allowedTime < 1.0; }

  /// The finest of the distances whose frame is expected to take no longer, clamped.
  /// @param allowedTime seconds.
  double Choose(double allowedTime, double minimum, double maximum);
  /// Reports how many seconds the frame of the last choice took.
  void Report(double seconds);

private:
  double LastDistance = 1.0;
  double FullTime = 0.0; ///< expected at a distance of 1; 0: not known yet
};

/// VTK's dual depth peeling draws a volume several times a frame, each time by two pictures: of
/// what is in front of the geometry that is not peeled yet, and of what is behind it. Its textures
/// tell between which depths a pixel's part of the volume lies (TextureSliceRayFS).
class vtkTextureSlicePeeling
{
public:
  enum Stage
  {
    None,    ///< the volume is not peeled
    Outside, ///< in front of all translucent geometry, and behind it
    Between, ///< between two peels
    Rest     ///< all that is left when there are no peels any more
  };

  /// Asks the render passes that draw the volume what they want.
  /// @return one line that says why they cannot have it; nullptr if they can
  const char* Update(vtkRenderer* renderer, vtkAbstractMapper* mapper, vtkVolume* volume);
  Stage GetStage() const { return this->Asked; }

  /// The pictures to be drawn one after the other; picture 0 is in front if there are two.
  int CountPictures() const { return this->Asked == Outside || this->Asked == Between ? 2 : 1; }
  /// Chooses the picture that is drawn next.
  void SetPicture(int picture) { this->Picture = picture; }

  void SetUniforms(vtkShaderProgram* program) const;

private:
  Stage Asked = None;
  int Picture = 0;
  vtkOpenGLRenderPass* Pass = nullptr;
  vtkAbstractMapper* Mapper = nullptr;
  vtkVolume* Volume = nullptr;
};

/// RGBA of associated colour (Formulas R3), and a copy of the depth of the opaque geometry.
class vtkTextureSliceTarget
{
public:
  /// Width and height of the picture for the viewport that OpenGL draws into now; see Begin.
  static std::array<int, 2> GetSize(vtkOpenGLRenderWindow* window, double pixelSize);

  /// Copies the depth of the framebuffer that is bound, if the shader reads it, clears the picture
  /// and directs drawing here. End must follow.
  /// @return in one line why it cannot be made, and then End must not follow; or nothing
  std::string Begin(const vtkTextureSliceParts& parts);
  /// The depth of what is drawn already, of the viewport's size.
  vtkTextureObject* GetGeometryDepth() { return this->Depth; }
  vtkTextureObject* GetPicture() const { return this->Color; }
  /// Directs drawing back to where it went before Begin.
  void End();

  /// Blends the picture over the viewport of the last Begin.
  void Composite(vtkTextureSliceParts& parts);

  void ReleaseGraphicsResources(vtkOpenGLRenderWindow* window);

private:
  bool MakePicture(int width, int height, bool fullPrecision);
  bool CopyDepth();

  vtkNew<vtkOpenGLFramebufferObject> Framebuffer;
  vtkNew<vtkOpenGLFramebufferObject> DepthFramebuffer;
  vtkNew<vtkTextureObject> Color;
  vtkNew<vtkTextureObject> Depth;
  vtkTextureSliceBox Box;
  vtkOpenGLRenderWindow* Window = nullptr;
  std::array<int, 4> Viewport{}; ///< left, bottom, width, height
  bool FullPrecision = false;    ///< of Color
  /// Of Depth, which must be the window's: bits, whether they are floats, whether with a stencil.
  std::array<int, 3> DepthFormat{-1, 0, 0};
};

/// What a mapper draws with RenderToImage: see its GetColorImage.
struct vtkTextureSliceImages
{
  vtkNew<vtkImageData> Color;
  vtkNew<vtkImageData> Depth;

  static std::vector<float> Download(vtkTextureObject* picture);
  /// @param colors pixels of the picture.
  /// @param places of the picture of places (vtkTextureSliceFeatures::Places).
  void Fill(const vtkTextureSliceParts& parts, const std::vector<float>& colors,
    const std::vector<float>& places);
};

#endif
