// SPDX-License-Identifier: BSD-3-Clause
// The ways to draw the same picture of the volume, and which of them draws it.
#ifndef vtkTextureSliceWays_h
#define vtkTextureSliceWays_h

#include "vtkNew.h"
#include "vtkOpenGLTextureSliceVolumeMapper.h"
#include "vtkOpenGLVertexArrayObject.h"
#include "vtkSmartPointer.h"
#include "vtkTextureSliceLightVolume.h"

#include <array>
#include <functional>
#include <map>
#include <string>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkShaderProgram;
struct vtkTextureSliceParts;

/// Shaders that run for each pixel of the volume's box, or instead of it.
class vtkTextureSliceBox
{
public:
  /// Makes a shader the current one.
  /// @param key what the shader depends on
  /// @param makeSource gives its source if it is not known yet
  /// @return nullptr if it does not compile: then it is not made again
  vtkShaderProgram* Ready(vtkOpenGLRenderWindow* window, const std::string& key,
    const std::function<std::string()>& makeSource, bool isCompute = false);
  /// Draws by a fragment shader of which TextureSliceBoxVS is the vertex shader, after Ready.
  /// @param times how often, one after the other: the shader gets the number as "slice".
  void Draw(const vtkTextureSliceParts& parts, vtkShaderProgram* program, int times = 1);
  void ReleaseGraphicsResources(vtkOpenGLRenderWindow* window);

private:
  vtkNew<vtkOpenGLVertexArrayObject> VertexArray; ///< OpenGL draws with one, although it is empty
  std::map<std::string, vtkSmartPointer<vtkShaderProgram>> Programs;
};

/// Pixels of a picture: lower left column and row, then the column and the row where they end.
using vtkTextureSlicePixels = std::array<int, 4>;

/// For each pixel, one fragment or one invocation of a compute shader goes along the pixel's ray.
/// Polygons are the outline of the volume's box once a plane, the nearest plane first, each blended
/// behind those before. They draw composite blending of samples on planes alone, to compare the
/// other ways with, and where no other shader compiles.
class vtkTextureSliceWays
{
public:
  using Mapper = vtkOpenGLTextureSliceVolumeMapper;
  using Way = Mapper::Ways;

  /// Chooses the way of the next picture and makes its shader ready.
  /// @return false if there is none whose shaders compile
  bool Choose(const vtkTextureSliceParts& parts);
  /// That of the last picture; AUTOMATIC: there was none.
  Way GetDrawn() const { return this->Drawn; }
  /// Why the last picture was not drawn as asked for, in one line; or an empty text.
  const std::string& GetFallback() const { return this->Fallback; }
  /// After Choose: draws the picture, which is bound.
  void Draw(vtkTextureSliceParts& parts);

  /// The vtkTextureSliceLightVolume::Sweep of the card, where compute draws the volume.
  bool SweepLight(const vtkTextureSliceParts& parts, const vtkTextureSliceLightCells& cells,
    const vtkTextureSliceLightVolume::Courses& courses, std::vector<float>& sums);

  void ReleaseGraphicsResources(vtkOpenGLRenderWindow* window);

private:
  /// What the environment variable VTK_TEXTURE_SLICE_WAY names takes precedence over @a asked.
  Way FindAsked(Way asked);
  /// What draws volume and light, unless its shader does not compile.
  Way FindWay(const vtkTextureSliceParts& parts, bool canBePolygons);
  /// What AUTOMATIC stands for. The first picture is drawn by fragments where there was no trial
  /// yet, because a trial takes longer than a program with one picture can gain by it. In software
  /// the same processor runs both ways: fragments, unless the environment variable asks for a
  /// trial, so that pictures do not depend on what else the machine does.
  Way ChooseByTrial();
  /// @param instead says what draws the volume where the shader of that way does not compile.
  bool Ready(Way way, const vtkTextureSliceParts& parts, const char* instead);
  /// Draws those pixels by the shader that is ready.
  void DrawPixels(Way way, vtkTextureSliceParts& parts, const vtkTextureSlicePixels& pixels);
  /// Times fragments and compute with a part of the picture that is drawn next.
  void RunTrial(vtkTextureSliceParts& parts, const vtkTextureSlicePixels& pixels);

  vtkTextureSliceBox Box;
  vtkShaderProgram* Program = nullptr; ///< that is ready
  Way Drawn = Mapper::AUTOMATIC;
  bool IsTrialDue = false; ///< with the next picture
  std::string Fallback;
};

#endif
