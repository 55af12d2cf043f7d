// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <string>

class vtkDataArray;
class vtkImageData;

namespace nexrad::scene
{

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

} // namespace nexrad::scene
