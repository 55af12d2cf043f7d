// SPDX-License-Identifier: BSD-3-Clause
// The shader program of the slices and the buffer of their vertices.
#ifndef vtkTextureSliceProgram_h
#define vtkTextureSliceProgram_h

#include "vtkNew.h"
#include "vtkTextureSliceFeatures.h"

#include <array>
#include <functional>
#include <vector>

class vtkOpenGLBufferObject;
class vtkOpenGLRenderWindow;
class vtkOpenGLVertexArrayObject;
class vtkShaderProgram;
class vtkTextureObject;
class vtkTextureSliceBlanks;
class vtkTextureSliceCoordinates;
class vtkTextureSliceFrame;
class vtkTextureSliceGeometry;
class vtkTextureSliceIntegralTable;
class vtkTextureSliceLights;
class vtkTextureSlicePeeling;
class vtkTextureSliceShadows;
class vtkTextureSliceTable;
class vtkTextureSliceTable2D;

/// How much of a light a component returns: vtkVolumeProperty's ambient, diffuse, specular and
/// specular power.
using vtkTextureSliceMaterial = std::array<float, 4>;

/// How one component is coloured.
struct vtkTextureSliceSurface
{
  float InverseUnitDistance = 1.0f; ///< one over the data length that its opacity stands for
  float Weight = 1.0f;
  vtkTextureSliceMaterial Material{};
};

/// Everything the shaders read in one frame.
struct vtkTextureSliceUniforms
{
  vtkTextureSliceFeatures Features;
  const vtkTextureSliceFrame* Frame = nullptr;
  vtkTextureObject* Volume = nullptr;
  /// Texel to 0 to 1 over the range of each component.
  std::array<float, 4> ScalarScale{1, 1, 1, 1};
  std::array<float, 4> ScalarBias{0, 0, 0, 0};
  vtkTextureSliceTable* Table = nullptr;
  const vtkTextureSliceCoordinates* Coordinates = nullptr; ///< used if Features.Rectilinear
  vtkTextureObject* SecondArray = nullptr; ///< used if Features.SecondArray is above 0
  std::array<float, 4> SecondScale{1, 1, 1, 1};
  std::array<float, 4> SecondBias{0, 0, 0, 0};
  vtkTextureSliceTable2D* Table2D = nullptr;              ///< used if Features.Table2D
  vtkTextureSliceBlanks* Blanks = nullptr;                ///< used if Features.Blanked
  vtkTextureObject* Mask = nullptr;                       ///< used if Features.HasMask()
  vtkTextureSliceTable* LabelTable = nullptr;             ///< used if Features.Labels is above 0
  float LabelWeight = 1.0f;                               ///< how much the label's functions count
  vtkTextureSliceIntegralTable* Integrals = nullptr;      ///< used if Features.Slabs is above 0
  vtkTextureSliceIntegralTable* LabelIntegrals = nullptr; ///< the same, with labels
  vtkTextureObject* GeometryDepth = nullptr;              ///< used if Features.NeedsDepth()
  const vtkTextureSlicePeeling* Peeling = nullptr;        ///< used if Features.Peel is above 0
  double PixelSize = 1.0;                       ///< pixels of the viewport for one of the picture
  std::vector<vtkTextureSliceSurface> Surfaces; ///< one for each component
  const vtkTextureSliceLights* Lights = nullptr;
  const vtkTextureSliceShadows* Shadows = nullptr; ///< used if Features.Shadows
  int CropFlags = 0;
  std::array<float, 2> AverageRange{0, 1}; ///< 0 to 1 as the scalars are
  std::vector<float> IsoValues;            ///< ascending, 0 to 1 as the scalars are

  std::array<float, 3> SelectionColor{}; ///< used if Features.Selection

  /// The textures that the features need.
  std::vector<vtkTextureObject*> GetTextures() const;
  /// The table and the weights, which the last step of the extremes reads as well. The table must
  /// be active.
  void SetTable(vtkShaderProgram* program) const;
};

class vtkTextureSliceProgram
{
public:
  vtkTextureSliceProgram();
  ~vtkTextureSliceProgram();

  /// Called after a group of slices with the vertices of the last one: the buffer, the first and
  /// their number.
  using AfterGroup = std::function<void(vtkOpenGLBufferObject*, int, int)>;

  /// Slices are drawn in groups.
  struct Groups
  {
    int First = 0;  ///< slices in the first one; 0: all slices are one group
    int Growth = 1; ///< each further one has so many times the slices of the one before
  };

  /**
   * Draws all slices, the nearest first, and calls @a afterGroup between two groups.
   * @return false if the shaders do not compile
   */
  bool Draw(vtkOpenGLRenderWindow* window, const vtkTextureSliceGeometry& geometry,
    const vtkTextureSliceUniforms& uniforms, const Groups& groups, const AfterGroup& afterGroup);
  /// The window that owns the resources must be current.
  void ReleaseGraphicsResources();

  /// Those of the last Draw.
  vtkOpenGLBufferObject* GetVertices() { return this->Vertices; }

private:
  vtkShaderProgram* Ready(
    vtkOpenGLRenderWindow* window, const vtkTextureSliceFeatures& features) const;
  bool Upload(vtkShaderProgram* program, const vtkTextureSliceGeometry& geometry);
  void DrawGroups(vtkOpenGLRenderWindow* window, const std::vector<int>& firstVertices,
    const Groups& groups, const AfterGroup& afterGroup);

  vtkNew<vtkOpenGLVertexArrayObject> VertexArray;
  vtkNew<vtkOpenGLBufferObject> Vertices;
  vtkShaderProgram* Program = nullptr; ///< of the last Draw; the shader cache owns it
};

#endif
