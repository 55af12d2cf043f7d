// SPDX-License-Identifier: BSD-3-Clause
// The polygons of the slices: planes of equal depth cut by the volume's box and by clipping planes.
#ifndef vtkTextureSliceGeometry_h
#define vtkTextureSliceGeometry_h

#include "vtkNexradRenderingModule.h" // for the export macro

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

class vtkTextureSliceOccupancy;
class vtkTextureSliceTiles;
struct vtkTextureSliceEye;

/**
 * What decides where the slices lie. "Box" coordinates run from 0 to 1 along each axis of the
 * volume; "data" lengths are those of the volume before its actor's matrix, as VTK's ray caster
 * measures sample distances and the unit distance of opacity.
 */
struct vtkTextureSliceView
{
  /// Box to camera coordinates (x right, y up, the camera looks along -z), row by row.
  std::array<double, 16> BoxToCamera{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  /// Data length of the box's edges; the sign does not matter.
  std::array<double, 3> EdgeLength{1, 1, 1};
  bool Parallel = false;
  /// Depth of the near plane: no slice is nearer.
  double NearDepth = 0.0;
  /// The part of the box to draw: lower x, upper x, lower y and so on.
  std::array<double, 6> Part{0, 1, 0, 1, 0, 1};
  /// Planes in box coordinates; what has a*x + b*y + c*z + d < 0 is cut away.
  std::vector<std::array<double, 4>> ClippingPlanes;
  /// The one plane to draw, in box coordinates; none: slices parallel to the image plane.
  std::optional<std::array<double, 4>> Plane;
  /// Slices between the nearest and the farthest point of the part; 0: from SampleDistance.
  int NumberOfSlices = 256;
  /// Slabs that each slice stands for; 0: none, it is a layer of samples. The number of slices
  /// counts slabs then, and fewer planes are cut; more of them through a part that is thinner than
  /// the way from one plane to the next.
  int Slabs = 0;
  /// Whether a pixel of a slice also shows what is between it and the slice in front.
  bool Surfaces = false;
  /// Data length between two slices along the axis of the view, used if NumberOfSlices is 0.
  double SampleDistance = 1.0;

  /// Where there is something to see; nullptr: everywhere. The rest is needed only with it.
  const vtkTextureSliceOccupancy* Occupancy = nullptr;
  /// Where each sample is dense; nullptr: nowhere, as far as is known.
  const vtkTextureSliceOccupancy* Dense = nullptr;
  /// What a dense data length lets through.
  double DenseTransmittance = 1.0;
  /// Box to clip coordinates, row by row.
  std::array<double, 16> BoxToClip{};
  /// Width and height of the picture in pixels.
  std::array<int, 2> Viewport{0, 0};
};

/**
 * Triangles of all slices, the nearest slice first; what is empty is left out in squares of pixels.
 * A vertex is six floats: its position in box coordinates, then the vector (data lengths) from one
 * slice to the next along the ray through it.
 */
class VTKNEXRADRENDERING_EXPORT vtkTextureSliceGeometry
{
public:
  static constexpr int FloatsPerVertex = 6;
  /// More slices than this are not drawn, however small the sample distance.
  static constexpr int MaximumNumberOfSlices = 16384;

  /**
   * Cuts the slices. They lie in the middle of equal intervals of depth, so that n slices stand
   * for exactly the depth of the part. None are left where the part is behind the near plane.
   */
  void Build(const vtkTextureSliceView& view);

  const std::vector<float>& GetVertices() const { return this->Vertices; }
  /// First vertex of each slice, and behind them the number of all vertices.
  const std::vector<int>& GetFirstVertices() const { return this->FirstVertices; }
  int GetNumberOfVertices() const
  {
    return static_cast<int>(this->Vertices.size()) / FloatsPerVertex;
  }
  /// Planes of the last Build.
  int GetNumberOfPlanes() const { return this->NumberOfPlanes; }
  /// Slices of the last Build: planes, or the slabs of all planes.
  int GetNumberOfSlices() const { return this->NumberOfSlices; }
  /// Depth between two planes of the last Build, in the camera's (world) units.
  double GetDepthStep() const { return this->DepthStep; }
  /// The same along the axis of the view as a data length.
  double GetDataStep() const { return this->DataStep; }
  /// z and w of clip coordinates from one plane to the next.
  const std::array<float, 2>& GetClipStep() const { return this->ClipStep; }

private:
  class TriangleWriter;
  struct Placed;
  /// The vertices of one row of tiles, slice by slice.
  struct Row
  {
    std::vector<float> Vertices;
    std::vector<std::size_t> Ends; ///< floats up to the end of each slice
  };
  /// Cuts a plane of any direction in place of the slices.
  void BuildPlane(const vtkTextureSliceView& view, const vtkTextureSliceEye& eye);
  /// @param divides whether slices are divided that are visible as a whole.
  std::vector<Placed> PlaceSlices(const vtkTextureSliceView& view, const vtkTextureSliceEye& eye,
    double nearest, bool divides) const;
  static void DivideSlices(const std::vector<Placed>& slices, vtkTextureSliceTiles& tiles,
    const TriangleWriter& writer, Row& row);
  void Join(const std::vector<Placed>& slices, const TriangleWriter& writer);

  std::vector<Row> Rows; ///< between frames, only their memory is kept
  std::vector<float> Vertices;
  std::vector<int> FirstVertices;
  int NumberOfSlices = 0;
  int NumberOfPlanes = 0;
  std::array<float, 2> ClipStep{};
  double DepthStep = 0.0;
  double DataStep = 0.0;
};

#endif
