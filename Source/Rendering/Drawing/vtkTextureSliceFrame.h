// SPDX-License-Identifier: BSD-3-Clause
// Where the volume is, and where it is seen from: every coordinate system of one frame.
#ifndef vtkTextureSliceFrame_h
#define vtkTextureSliceFrame_h

#include "vtkNew.h"
#include "vtkTextureSlicePlanes.h"

#include <array>

class vtkImageData;
class vtkMatrix4x4;
class vtkPlane;
class vtkRenderer;
class vtkVolume;
class vtkVolumeMapper;

/**
 * The box is the volume's bounds, 0 to 1 along each of its axes; data coordinates are the image's
 * own, world coordinates those after the actor's matrix.
 */
class vtkTextureSliceFrame
{
public:
  vtkTextureSliceFrame();
  ~vtkTextureSliceFrame();

  void SetVolume(vtkImageData* image, bool cellData, vtkVolume* volume);
  void SetCamera(vtkRenderer* renderer);
  /// The mapper's cropping and clipping planes.
  void SetCuts(vtkVolumeMapper* mapper);
  /// The one plane to draw, in world coordinates; nullptr: none.
  void SetPlane(vtkPlane* plane);

  /// A plane in world coordinates as a, b, c, d of a*x + b*y + c*z + d in box coordinates.
  std::array<double, 4> ToBox(vtkPlane* plane) const;

  /// Whether the volume has no extent along some axis.
  bool IsFlat() const;

  /// The view for the slices, without their number and distance. Valid after the setters above.
  const vtkTextureSliceView& GetView() const { return this->View; }
  /// Box to clip coordinates, column by column as OpenGL reads it.
  vtkMatrix4x4* GetBoxToClip() const { return this->BoxToClip; }
  /// Box to texture coordinates: p * scale + bias (Formulas R2).
  const std::array<float, 3>& GetTextureScale() const { return this->TextureScale; }
  const std::array<float, 3>& GetTextureBias() const { return this->TextureBias; }

  /// Whether samples must be tested against the cropping regions: the part alone does not do it.
  bool NeedsCropTest() const { return this->CropTest; }
  const std::array<float, 3>& GetCropLow() const { return this->CropLow; }
  const std::array<float, 3>& GetCropHigh() const { return this->CropHigh; }

  /// A direction in world coordinates as data lengths along the box's axes, towards higher indices.
  std::array<double, 3> GetDataDirection(const std::array<double, 3>& world) const;
  /// Whether the scalars are those of the image's cells.
  bool IsOfCells() const { return this->CellData; }
  /// A plane in box coordinates as one in texture coordinates.
  std::array<float, 4> ToTexture(const std::array<double, 4>& box) const;
  /// The clipping planes that cut something of the part off, four numbers each, in texture
  /// coordinates; what is below 0 is cut away.
  std::vector<float> GetClippingPlanesInTexture() const;

  /// Signed data length of the box's edges.
  std::array<float, 3> GetEdges() const;
  /// Where the camera stands.
  std::array<float, 3> GetEyeInBox() const;
  /// One voxel along each axis as texture coordinates, as wide as VTK's ray caster takes it for
  /// differences.
  const std::array<float, 3>& GetVoxelStep() const { return this->VoxelStep; }
  /// The mean spacing over twice the (signed) spacing along each axis.
  const std::array<float, 3>& GetInverseAspect() const { return this->InverseAspect; }
  /// One voxel along its shortest edge as texture coordinates, and how many of them make half of
  /// its longest edge: 0 for cubes, 4 at most.
  std::array<float, 4> GetStair() const;
  /// Box to camera coordinates, and gradients in data coordinates to normals in camera
  /// coordinates, column by column as OpenGL reads them.
  std::array<float, 16> GetBoxToCameraColumns() const;
  std::array<float, 9> GetGradientToCameraColumns() const;

  /// Voxels' edges in the box, and where the first face between two voxels is, along each axis.
  const std::array<double, 3>& GetIntervals() const { return this->Intervals; }
  std::array<double, 3> GetFirstFace() const;
  /// World length of the shortest edge of a voxel.
  double GetShortestVoxelEdge() const { return this->ShortestVoxelEdge; }

private:
  vtkNew<vtkMatrix4x4> BoxToWorld;
  vtkNew<vtkMatrix4x4> BoxToClip;
  vtkTextureSliceView View;
  std::array<double, 3> Origin{};
  std::array<double, 3> Edge{}; ///< signed data length of the box's edges
  std::array<float, 3> TextureScale{};
  std::array<float, 3> TextureBias{};
  std::array<float, 3> VoxelStep{};
  std::array<float, 3> InverseAspect{};
  bool CellData = false;
  bool CropTest = false;
  std::array<float, 3> CropLow{};
  std::array<float, 3> CropHigh{};
  std::array<double, 3> Intervals{};
  double ShortestVoxelEdge = 1.0;
};

#endif
