// SPDX-License-Identifier: BSD-3-Clause
// How far it is from each brick of a volume to the nearest one with something to see.
#ifndef vtkTextureSliceDistanceMap_h
#define vtkTextureSliceDistanceMap_h

#include "vtkNew.h"
#include "vtkNexradRenderingModule.h" // for the export macro
#include "vtkTextureObject.h"

#include <array>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkTextureSliceFrame;
class vtkWindow;

/**
 * A ray that enters a brick of distance d passes d - 1 bricks in any direction without a look at
 * them (the chessboard distance). A visible brick has the distance 0.
 */
class VTKNEXRADRENDERING_EXPORT vtkTextureSliceDistanceMap
{
public:
  /// Larger distances are stored as this one.
  static constexpr unsigned char MostDistance = 31;

  /**
   * @param count bricks along each axis.
   * @param edge a brick's edges in box coordinates (0 to 1 along each axis); the last brick along
   * an axis may reach beyond the box.
   * @param visible not 0 for visible bricks, x fastest.
   */
  void Build(const std::array<int, 3>& count, const std::array<double, 3>& edge,
    const std::vector<unsigned char>& visible);

  /// One for each brick, x fastest.
  const std::vector<unsigned char>& GetDistances() const { return this->Distances; }
  /// Part of the bricks that are visible, 0 to 1.
  double GetVisibleShare() const { return this->VisibleShare; }

  /// The part of the box about all visible bricks: lower x, upper x, lower y and so on.
  std::array<double, 6> FindSeen() const;

  /// Brings the texture up to date.
  void Upload(vtkOpenGLRenderWindow* window);
  void ReleaseGraphicsResources(vtkWindow* window);
  vtkTextureObject* GetTexture() const { return this->Texture; }
  /// Sets what TextureSliceSkippingFS reads.
  void SetUniforms(vtkShaderProgram* program, const vtkTextureSliceFrame& frame) const;

private:
  std::array<int, 3> Count{1, 1, 1};
  std::array<double, 3> Edge{1.0, 1.0, 1.0};
  std::vector<unsigned char> Distances;
  double VisibleShare = 1.0;
  bool Uploaded = false;
  vtkNew<vtkTextureObject> Texture;
};

#endif
