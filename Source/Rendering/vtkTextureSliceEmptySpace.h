// SPDX-License-Identifier: BSD-3-Clause
// What of a volume a request leaves invisible, and how far rays may go until there is something to
// see.
#ifndef vtkTextureSliceEmptySpace_h
#define vtkTextureSliceEmptySpace_h

#include "vtkNew.h"
#include "vtkNexradRenderingModule.h" // for the export macro
#include "vtkTextureObject.h"
#include "vtkType.h"

#include <array>
#include <string>
#include <tuple>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkShaderProgram;
struct vtkTextureSliceFrame;
struct vtkTextureSliceParts;

/// For each octant of directions, a brick has the edge, in bricks, of the largest cube without a
/// visible brick that begins with it and lies ahead of a ray of that octant; a visible one has 0.
class VTKNEXRADRENDERING_EXPORT vtkTextureSliceDistanceMap
{
public:
  /// Larger distances are stored as this one.
  static constexpr unsigned char MostDistance = 255;
  /// Bit 0 of an octant's number is set where rays go towards lower x, bit 1 lower y, bit 2 lower
  /// z.
  static constexpr int Octants = 8;

  /// @param count bricks along each axis.
  /// @param edge a brick's edges in box coordinates (0 to 1 along each axis); the last brick along
  /// an axis may reach beyond the box.
  /// @param visible not 0 for visible bricks, x fastest.
  void Build(const std::array<int, 3>& count, const std::array<double, 3>& edge,
    const std::vector<unsigned char>& visible);

  void Upload(vtkOpenGLRenderWindow* window);
  void SetUniforms(vtkShaderProgram* program, const vtkTextureSliceFrame& frame) const;

  std::array<int, 3> Count{1, 1, 1};
  std::array<double, 3> Edge{1.0, 1.0, 1.0};
  /// One octant after the other, each with one distance for each brick, x fastest.
  std::vector<unsigned char> Distances;
  double VisibleShare = 1.0; ///< part of the bricks, 0 to 1
  /// The part of the box about all visible bricks: lower x, upper x, lower y and so on.
  std::array<double, 6> Seen{0, 1, 0, 1, 0, 1};
  vtkNew<vtkTextureObject> Texture;

private:
  void Fill(unsigned int octant, const std::vector<unsigned char>& visible);
  void FindSeen(const std::vector<unsigned char>& visible);

  bool Uploaded = false;
};

/// Marks the bricks of a volume that can add to the picture, as the blend mode has it: see "Empty
/// space" in Documentation/Developer/rendering.md.
class vtkTextureSliceEmptySpace
{
public:
  /// Does nothing where nothing has changed of the scalars and the functions.
  void Update(const vtkTextureSliceParts& source);

  /// Whether so much is empty that looking for it costs less than it saves.
  bool IsSkippingWorthwhile() const
  {
    constexpr double mostVisible = 0.75;
    return this->Distances.VisibleShare < mostVisible;
  }
  /// Whether no sample can be seen.
  bool IsNothingVisible() const { return this->Distances.VisibleShare <= 0.0; }

  /// How far it is to the next visible brick.
  vtkTextureSliceDistanceMap Distances;

private:
  /// All that the answers depend on.
  using Key = std::tuple<vtkMTimeType, vtkMTimeType, vtkMTimeType, std::array<double, 2>,
    std::vector<double>, std::string>;

  Key Last;
  std::vector<unsigned char> Visible; ///< not 0 where a brick counts
};

#endif
