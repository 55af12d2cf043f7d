// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Scene/Frame/SceneFrame.h"
#include "Scene/Shapes/Shapes.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

class vtkCamera;
class vtkDataArray;
class vtkImageData;
class vtkNexradTransferFunction;

namespace nexrad::scene
{

/// The line through one place of a picture, from the camera on.
struct ViewRay
{
  ScenePoint origin{};
  ScenePoint direction{}; ///< of length 1

  ScenePoint At(double distance) const;
};

/// The ray through a place of a picture of that size, both in pixels from the lower left corner.
ViewRay RayThrough(
  vtkCamera* camera, const std::array<int, 2>& size, const std::array<double, 2>& pixel);

/// How far along the ray it meets a horizontal plane; nothing where it does not.
std::optional<double> DistanceToHeight(const ViewRay& ray, double z);

/// The values of a merged volume at single places, whether its scalars are values or codes. The
/// volume must outlive it.
class VoxelReader
{
public:
  explicit VoxelReader(vtkImageData* volume);

  /// Voxels and parts of them from the centre of the first one, along x, y and z.
  using Index = std::array<double, 3>;
  Index IndexAt(const std::array<double, 3>& place) const;

  /// Whether a place lies between the centres of its first and last voxels.
  bool Holds(const std::array<double, 3>& place) const;

  /// Name of the active scalars, as "REF".
  const std::string& Name() const { return name; }
  /// Unit of their values, as "dBZ"; empty when unknown.
  const std::string& Unit() const { return unit; }

  /// The value at a place, linear between the voxels about it, as it is drawn. Nothing where the
  /// nearest voxel has no value. A voxel about the place without a value counts as the nearest one.
  std::optional<double> ValueAt(const Index& index) const;

  /// The value of another array in the nearest voxel, as of "REF_age". Nothing without that array.
  std::optional<double> NearestOf(const std::string& array, const Index& index) const;

private:
  std::array<int, 3> Nearest(const Index& index) const;
  long long Number(const std::array<int, 3>& voxel) const;
  std::optional<double> Value(long long voxel) const;

  vtkImageData* volume;
  std::string name;
  std::string unit;
  std::array<int, 3> dimensions{};
  vtkDataArray* scalars;
  vtkDataArray* hidden;     ///< ghost types, of voxels or of codes; nullptr: none is hidden
  vtkDataArray* codeValues; ///< of codes; nullptr: the scalars are values
};

/// The echo that a ray shows.
struct SeenEcho
{
  double distance = 0.0; ///< along the ray, in scene units
  double value = 0.0;    ///< there, in the unit of the moment
};

/// The place of the ray in front of which half of what is seen along it lies: half of the opacity
/// of the whole ray. Nothing when the ray's opacity is below `leastVisible`. (vtkVolumePicker finds
/// the first place whose opacity exceeds a threshold, however thin the echo is, and knows no
/// codes.)
///
/// `detail`: a finer volume that is drawn in place of a part of `voxels`; nullptr for none.
///
/// Samples lie half a voxel apart. Surfaces count at the iso-values that lie between two samples.
std::optional<SeenEcho> FindEcho(const VoxelReader& voxels, const VoxelReader* detail,
  const SceneFrame& frame, vtkNexradTransferFunction* transferFunction, const ViewRay& ray);

/// The least opacity of a ray that shows echo: less is hardly seen.
constexpr double leastVisible = 0.1;

/// Where a place lies as a radar has it.
struct RadarPlace
{
  std::string site;      ///< name of the radar
  double distance = 0.0; ///< m along the ground
  double azimuth = 0.0;  ///< degrees clockwise from north, from the radar to the place
};

/// The place as the nearest of the radars has it, of those that the site table knows. Nothing when
/// it knows none.
std::optional<RadarPlace> FindNearestRadar(
  const std::vector<std::string>& sites, double latitude, double longitude);

} // namespace nexrad::scene
