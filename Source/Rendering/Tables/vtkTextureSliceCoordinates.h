// SPDX-License-Identifier: BSD-3-Clause
// Where the points of a rectilinear grid lie along its axes.
#ifndef vtkTextureSliceCoordinates_h
#define vtkTextureSliceCoordinates_h

#include "vtkNew.h"
#include "vtkSmartPointer.h"
#include "vtkTextureObject.h"
#include "vtkTimeStamp.h"

#include <array>
#include <cstddef>
#include <vector>

class vtkImageData;
class vtkOpenGLRenderWindow;
class vtkRectilinearGrid;
class vtkShaderProgram;
class vtkWindow;

/**
 * The slices draw a rectilinear grid as an image of the same arrays in the same bounds. Wherever
 * the shaders read a texture of the volume, they look up how far a place of the image lies among
 * the points of the grid. The table of an axis has at least sixteen entries in the shortest
 * interval, as far as the largest texture allows: then a place errs by at most 1/64 of a voxel.
 */
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
  /// When the coordinates changed last.
  vtkMTimeType GetBuildTime() const { return this->BuildTime.GetMTime(); }
  /// Where in the box (0 to 1) a part of the points' intervals ends, 0 to 1 for all of them.
  double ToBox(std::size_t axis, double part) const;

  /// Makes the table of all axes for a window.
  void Update(vtkOpenGLRenderWindow* window);
  void ReleaseGraphicsResources(vtkWindow* window);
  /// One channel for each axis: from the place in the box to the part of the intervals before it.
  vtkTextureObject* GetTexture() const { return this->Texture; }
  /// Sets how a place in the box becomes one in the table.
  void SetUniforms(vtkShaderProgram* program) const;
  /// How far a place of the table may be off, in box coordinates.
  double GetMargin() const { return 1.0 / static_cast<double>(this->Width); }

private:
  void Fill(std::vector<float>& entries) const;

  std::array<std::vector<double>, 3> Places; ///< of the points in the box, ascending from 0 to 1
  std::size_t Width = 1;                     ///< entries of the table
  vtkTimeStamp BuildTime;
  vtkMTimeType FillTime = 0;
  vtkNew<vtkTextureObject> Texture;
};

#endif
