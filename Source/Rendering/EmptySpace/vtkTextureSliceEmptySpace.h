// SPDX-License-Identifier: BSD-3-Clause
// What of a volume a request leaves invisible.
#ifndef vtkTextureSliceEmptySpace_h
#define vtkTextureSliceEmptySpace_h

#include "vtkTextureSliceOccupancy.h"
#include "vtkType.h"

#include <array>
#include <string>
#include <tuple>
#include <vector>

class vtkTextureSliceCoordinates;
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
    const vtkTextureSliceCoordinates* Coordinates = nullptr;
  };

  /// Does nothing where nothing has changed.
  void Update(const Source& source);

  const vtkTextureSliceOccupancy& GetOccupancy() const { return this->Occupancy; }

  /// Whether bricks that have samples are left out, because these add nothing.
  bool LeavesOutSamples() const { return this->LeavesOut; }

  /// Bricks in which each sample has the opacity of the table's densest part; nullptr: not known.
  const vtkTextureSliceOccupancy* GetDense() const
  {
    return this->HasDense ? &this->Dense : nullptr;
  }

private:
  /// All that the answers depend on, the order that of MakeKey.
  using Key = std::tuple<vtkMTimeType, vtkMTimeType, vtkMTimeType, vtkMTimeType,
    std::array<double, 2>, std::vector<double>, std::string, bool, std::array<float, 3>,
    std::array<float, 3>, int, vtkMTimeType>;
  static Key MakeKey(const Source& source);

  static std::array<std::vector<double>, 3> FindBorders(const Source& source);
  void Build(const Source& source, vtkTextureSliceOccupancy& occupancy);
  void FindDense(const Source& source);
  void FindVisible(const Source& source);
  void HideCropped(const Source& source);

  Key Last;
  bool LeavesOut = false;
  vtkTextureSliceOccupancy Occupancy;
  bool HasDense = false;
  vtkTextureSliceOccupancy Dense;
  std::vector<unsigned char> Visible; ///< not 0 where a brick counts
};

#endif
