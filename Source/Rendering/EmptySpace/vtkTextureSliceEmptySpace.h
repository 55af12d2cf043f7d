// SPDX-License-Identifier: BSD-3-Clause
// What of a volume a request leaves invisible.
#ifndef vtkTextureSliceEmptySpace_h
#define vtkTextureSliceEmptySpace_h

#include "vtkTextureSliceDistanceMap.h"
#include "vtkType.h"

#include <array>
#include <string>
#include <tuple>
#include <vector>

class vtkTextureSliceFrame;
class vtkTextureSliceTable;
class vtkTextureSliceTable2D;
class vtkTextureSliceTexture;
struct vtkTextureSliceRequest;

/**
 * Marks the bricks of a volume that can add to the picture. Changes of the functions alone cost a
 * look at each brick, not at each voxel.
 */
class vtkTextureSliceEmptySpace
{
public:
  /// What decides on a brick.
  struct Source
  {
    const vtkTextureSliceRequest* Request = nullptr;
    const vtkTextureSliceTexture* Texture = nullptr;
    const vtkTextureSliceTable* Table = nullptr;
    const vtkTextureSliceTable* LabelTable = nullptr; ///< used where the request has labels
    const vtkTextureSliceTable2D* Table2D = nullptr;  ///< used where the request has such functions
    const vtkTextureSliceFrame* Frame = nullptr;      ///< knows the cropping planes
    int CropFlags = 0;
  };

  /// Does nothing where nothing has changed.
  void Update(const Source& source);

  /// How far it is to the next visible brick.
  vtkTextureSliceDistanceMap& GetDistances() { return this->Distances; }
  /// Whether so much is empty that looking for it costs less than it saves.
  bool IsSkippingWorthwhile() const
  {
    constexpr double mostVisible = 0.75;
    return this->Distances.GetVisibleShare() < mostVisible;
  }
  /// Where all that can be seen lies: lower x, upper x, lower y and so on, in box coordinates.
  const std::array<double, 6>& GetSeen() const { return this->Seen; }
  /// Whether no sample can be seen.
  bool IsNothingVisible() const { return this->Distances.GetVisibleShare() <= 0.0; }

private:
  /// All that the answers depend on, the order that of MakeKey.
  using Key =
    std::tuple<vtkMTimeType, vtkMTimeType, vtkMTimeType, vtkMTimeType, std::array<double, 2>,
      std::vector<double>, std::string, bool, std::array<float, 3>, std::array<float, 3>, int>;
  static Key MakeKey(const Source& source);

  void FindVisible(const Source& source);
  void HideCropped(const Source& source);

  Key Last;
  std::array<double, 3> Edge{}; ///< of the bricks that the distances are of
  vtkTextureSliceDistanceMap Distances;
  std::array<double, 6> Seen{0, 1, 0, 1, 0, 1};
  std::vector<unsigned char> Visible; ///< not 0 where a brick counts
};

#endif
