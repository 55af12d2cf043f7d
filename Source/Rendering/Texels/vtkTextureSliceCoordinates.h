// SPDX-License-Identifier: BSD-3-Clause
// Where the points of a rectilinear grid lie along its axes.
#ifndef vtkTextureSliceCoordinates_h
#define vtkTextureSliceCoordinates_h

#include "vtkNew.h"
#include "vtkSmartPointer.h"
#include "vtkTextureObject.h"

#include <array>
#include <cstddef>
#include <vector>

class vtkImageData;
class vtkOpenGLRenderWindow;
class vtkRectilinearGrid;

/// The slices draw a rectilinear grid as an image of the same arrays in the same bounds; the
/// shaders look up how far a place of it lies among the grid's points. The table of an axis has at
/// least sixteen entries in the shortest interval, as far as the largest texture allows: then a
/// place errs by at most 1/64 of a voxel.
class vtkTextureSliceCoordinates
{
public:
  /// One line that says why a grid cannot be drawn; nullptr if it can.
  static const char* FindUnsupported(vtkRectilinearGrid* grid);
  /// Takes the coordinates of a grid that can be drawn; nullptr: the input is an image.
  void Set(vtkRectilinearGrid* grid);
  /// An image of the grid's arrays in its bounds.
  static vtkSmartPointer<vtkImageData> MakeImage(vtkRectilinearGrid* grid);

  bool IsUsed() const { return !this->Places[0].empty(); }
  /// Where the points lie in the box along each axis, ascending from 0 to 1; empty for an image.
  const std::array<std::vector<double>, 3>& GetPlaces() const { return this->Places; }

  /// Makes the table of all axes for a window.
  void Update(vtkOpenGLRenderWindow* window);
  /// One channel for each axis: from the place in the box to the part of the intervals before it.
  vtkTextureObject* GetTexture() const { return this->Texture; }

private:
  void Fill(std::vector<float>& entries) const;

  std::array<std::vector<double>, 3> Places;
  std::size_t Width = 1; ///< entries of the table
  bool Filled = false;
  vtkNew<vtkTextureObject> Texture;
};

#endif
