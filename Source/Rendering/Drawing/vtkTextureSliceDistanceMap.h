// SPDX-License-Identifier: BSD-3-Clause
// How far rays may go from each brick of a volume until there is something to see.
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

/**
 * For each octant of directions, a brick has the edge, in bricks, of the largest cube without a
 * visible brick that begins with it and lies ahead of a ray of that octant. A ray in the brick may
 * leave that cube without another look. A visible brick has 0.
 */
class VTKNEXRADRENDERING_EXPORT vtkTextureSliceDistanceMap
{
public:
  /// Larger distances are stored as this one.
  static constexpr unsigned char MostDistance = 255;
  /// Bit 0 of an octant's number is set where rays go towards lower x, bit 1 lower y, bit 2 lower
  /// z.
  static constexpr int Octants = 8;

  /**
   * @param count bricks along each axis.
   * @param edge a brick's edges in box coordinates (0 to 1 along each axis); the last brick along
   * an axis may reach beyond the box.
   * @param visible not 0 for visible bricks, x fastest.
   */
  void Build(const std::array<int, 3>& count, const std::array<double, 3>& edge,
    const std::vector<unsigned char>& visible);

  /// One octant after the other, each with one distance for each brick, x fastest.
  const std::vector<unsigned char>& GetDistances() const { return this->Distances; }
  /// Part of the bricks that are visible, 0 to 1.
  double GetVisibleShare() const { return this->VisibleShare; }

  /// The part of the box about all visible bricks: lower x, upper x, lower y and so on.
  std::array<double, 6> FindSeen() const;

  /// Brings the texture up to date.
  void Upload(vtkOpenGLRenderWindow* window);
  vtkTextureObject* GetTexture() const { return this->Texture; }
  /// Sets what TextureSliceSkippingFS reads.
  void SetUniforms(vtkShaderProgram* program, const vtkTextureSliceFrame& frame) const;

private:
  void Fill(unsigned int octant, const std::vector<unsigned char>& visible);

  std::array<int, 3> Count{1, 1, 1};
  std::array<double, 3> Edge{1.0, 1.0, 1.0};
  std::vector<unsigned char> Distances;
  double VisibleShare = 1.0;
  bool Uploaded = false;
  vtkNew<vtkTextureObject> Texture;
};

#endif
