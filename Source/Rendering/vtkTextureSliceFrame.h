// SPDX-License-Identifier: BSD-3-Clause
// Where the volume is, where it is seen from, where the slices lie, and the lights.
#ifndef vtkTextureSliceFrame_h
#define vtkTextureSliceFrame_h

#include "vtkNexradRenderingModule.h" // for the export macro
#include "vtkTextureSliceLightVolume.h"

#include <array>
#include <map>
#include <optional>
#include <vector>

class vtkImageData;
class vtkLight;
class vtkPlane;
class vtkRenderer;
class vtkShaderProgram;
class vtkVolume;
class vtkVolumeMapper;

/// What decides where the slices lie. Box coordinates run from 0 to 1 along each axis of the
/// volume; data lengths, which VTK's ray caster measures too, are those before its actor's matrix.
struct vtkTextureSliceView
{
  /// Box to camera coordinates (x right, y up, the camera looks along -z), row by row.
  std::array<double, 16> BoxToCamera{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  /// Box to clip coordinates, row by row.
  std::array<double, 16> BoxToClip{};
  /// Signed data length of the box's edges.
  std::array<double, 3> EdgeLength{1, 1, 1};
  /// Depth of the near plane: no slice is nearer.
  double NearDepth = 0.0;
  /// The part of the box to draw: lower x, upper x, lower y and so on.
  std::array<double, 6> Part{0, 1, 0, 1, 0, 1};
  /// The one plane to draw, in box coordinates; none: slices parallel to the image plane.
  std::optional<std::array<double, 4>> Plane;
  /// Slices between the nearest and the farthest point of the part; 0: from SampleDistance.
  int NumberOfSlices = 256;
  /// Data length between two slices along the axis of the view, used if NumberOfSlices is 0.
  double SampleDistance = 1.0;
  /// Along each axis, the place in the box of a face between two voxels and the faces in the box,
  /// where samples jump at faces; 0 faces: samples are interpolated.
  std::array<double, 3> FirstFace{0, 0, 0};
  std::array<double, 3> Faces{0, 0, 0};
  /// Width and height of the picture in pixels.
  std::array<int, 2> Viewport{1, 1};
};

/// A vector that depends on a pixel: the first one times x, plus the second one times y, plus the
/// third one; pixels' centres lie at one half.
using vtkTextureSlicePixelMap = std::array<std::array<double, 3>, 3>;

/// Planes of equal depth, in the middle of equal intervals between the nearest and the farthest
/// point of what is drawn. Where many would lie on faces between voxels, all are nearer by a
/// quarter of a voxel, or of an interval. Places on a ray are counted in slices: 0 is the nearest
/// plane.
struct VTKNEXRADRENDERING_EXPORT vtkTextureSlicePlanes
{
  /// More slices than this are not drawn, however small the sample distance.
  static constexpr int MaximumNumberOfSlices = 16384;

  /// There are no slices where the part is behind the near plane.
  void Place(const vtkTextureSliceView& view);

  int NumberOfSlices = 0;
  /// Depth of the nearest slice, and between two of them, in the camera's (world) units.
  double NearestDepth = 0.0;
  double DepthStep = 0.0;
  /// The distance of two slices along the axis of the view as a data length.
  double DataStep = 0.0;
  /// Where a pixel's ray meets the nearest slice, and its way to the next one, in box coordinates.
  vtkTextureSlicePixelMap Places;
  vtkTextureSlicePixelMap Steps;
  /// a, b, c, d that give the place on a ray at a depth of the window (0 to 1). With m the double
  /// of what the depth lacks to 1, it is (a - m * b) / (c + m * d).
  std::array<float, 4> DepthToSlice{};
};

/// Every coordinate system of one frame; world coordinates are those after the actor's matrix.
struct vtkTextureSliceFrame
{
  void SetVolume(vtkImageData* image, bool cellData, vtkVolume* volume);
  void SetCamera(vtkRenderer* renderer);
  /// The mapper's cropping and clipping planes.
  void SetCuts(vtkVolumeMapper* mapper);

  /// A plane in world coordinates as a, b, c, d of a*x + b*y + c*z + d in box coordinates.
  std::array<double, 4> ToBox(vtkPlane* plane) const;
  /// The same plane in texture coordinates.
  std::array<float, 4> ToTexture(const std::array<double, 4>& box) const;
  /// Whether the volume has no extent along some axis.
  bool IsFlat() const;
  /// A direction in world coordinates as data lengths along the box's axes, towards higher indices.
  std::array<double, 3> GetDataDirection(const std::array<double, 3>& world) const;
  /// One voxel along its shortest edge as texture coordinates, and how many of them make half of
  /// its longest edge: 0 for cubes, 4 at most.
  std::array<float, 4> GetStair() const;
  /// A matrix column by column, as OpenGL reads it.
  static std::array<float, 16> ToColumns(const std::array<double, 16>& rows);

  std::array<double, 16> BoxToWorld{}; ///< row by row
  vtkTextureSliceView View;            ///< for the slices
  vtkTextureSliceCut Cut;
  std::array<double, 3> Origin{};
  /// Box to texture coordinates: p * scale + bias (Formulas R2).
  std::array<float, 3> TextureScale{};
  std::array<float, 3> TextureBias{};
  /// One voxel along each axis as texture coordinates, as wide as VTK's ray caster takes it for
  /// differences.
  std::array<float, 3> VoxelStep{};
  /// The mean spacing over twice the (signed) spacing along each axis.
  std::array<float, 3> InverseAspect{};
  bool CellData = false;          ///< whether the scalars are those of the image's cells
  double ShortestVoxelEdge = 1.0; ///< world length
};

/// The lights that are switched on, as VTK's ray caster has them: a single headlight shines along
/// each ray, in data coordinates, with the sample's ambient colour; others stand in camera
/// coordinates.
class vtkTextureSliceLights
{
public:
  void Update(vtkRenderer* renderer);
  /// For vtkTextureSliceFeatures: -1 without lights, 0 for a single headlight, else their number.
  int CountForShader() const
  {
    return this->Count == 0 ? -1 : (this->OnlyHeadlight ? 0 : this->Count);
  }
  void SetUniforms(vtkShaderProgram* program, const vtkTextureSliceFrame& frame) const;

private:
  void Append(vtkRenderer* renderer, vtkLight* light);

  int Count = 0;
  bool OnlyHeadlight = false;
  bool TwoSided = true;
  std::array<float, 3> Ambient{}; ///< of all lights
  /// The uniforms that have a vector for each light.
  std::map<const char*, std::vector<std::array<float, 3>>> Vectors;
};

#endif
