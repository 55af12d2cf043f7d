// SPDX-License-Identifier: BSD-3-Clause
// Everything that the shaders of the slices read in one frame.
#ifndef vtkTextureSliceUniforms_h
#define vtkTextureSliceUniforms_h

#include "vtkSmartPointer.h"
#include "vtkTextureSliceTexture.h"
#include "vtkTextureSliceCoordinates.h"
#include "vtkTextureSliceFrame.h"
#include "vtkTextureSliceTables.h"
#include "vtkTextureSliceLights.h"
#include "vtkTextureSlicePeeling.h"
#include "vtkTextureSliceRequest.h"
#include "vtkTextureSliceShadows.h"

#include <array>
#include <functional>
#include <utility>
#include <vector>

class vtkDataArray;
class vtkImageData;
class vtkShaderProgram;
class vtkTextureObject;
class vtkTextureSliceDistanceMap;

/**
 * Everything the shaders read in one frame: the parts of the mapper that hold it, each of which
 * decides for itself what a change makes it do anew, and what each frame sets anew.
 */
struct vtkTextureSliceUniforms
{
  /// The volume of this frame; of a rectilinear grid, an image of its points or cells.
  vtkSmartPointer<vtkImageData> Image;
  vtkDataArray* Scalars = nullptr;
  vtkDataArray* MaskValues = nullptr; ///< nullptr: there is no mask
  vtkTextureSliceRequest Request;
  vtkTextureSliceFrame Frame;
  vtkTextureSlicePlanes Planes;
  vtkTextureSliceTexture Texture;
  vtkTextureSliceTable Table;
  vtkTextureSliceCoordinates Coordinates;      ///< used if Features.Rectilinear
  vtkTextureSliceTexture SecondArray;          ///< used if Features.SecondArray is above 0
  vtkTextureSliceTable2D Table2D;              ///< used if Features.Table2D
  vtkTextureSliceBlanks Blanks;                ///< used if Features.Blanked
  vtkTextureSliceTexture Mask;                 ///< used if Features.HasMask()
  vtkTextureSliceTable LabelTable;             ///< used if Features.Labels is above 0
  vtkTextureSliceIntegralTable Integrals;      ///< used if Features.Slabs
  vtkTextureSliceIntegralTable LabelIntegrals; ///< the same, with labels
  vtkTextureSliceLights Lights;
  vtkTextureSliceShadows Shadows; ///< used if Features.Shadows
  vtkTextureSlicePeeling Peeling; ///< used if Features.Peel is above 0

  vtkTextureSliceFeatures Features;
  /// The part of the box with something to see: lower x, upper x, lower y and so on.
  std::array<double, 6> Seen{0, 1, 0, 1, 0, 1};
  const vtkTextureSliceDistanceMap* Distances = nullptr; ///< used if Features.Skipping
  vtkTextureObject* GeometryDepth = nullptr;             ///< used if Features.NeedsDepth()
  double PixelSize = 1.0;                       ///< pixels of the viewport for one of the picture
  float LabelWeight = 1.0f;                     ///< how much the label's functions count
  std::vector<vtkTextureSliceSurface> Surfaces; ///< one for each component
  std::vector<float> IsoValues; ///< of isosurfaces, ascending, 0 to 1 as the scalars are
  int CropFlags = 0;
  std::array<float, 3> SelectionColor{}; ///< used if Features.Selection

  /// Draws with a shader that is ready, which gets everything that it reads.
  void Use(vtkShaderProgram* program, const std::function<void()>& draw) const;

private:
  /// The textures that the features need, and the names of their samplers.
  std::vector<std::pair<const char*, vtkTextureObject*>> FindTextures() const;
  void SetParts(vtkShaderProgram* program) const;
};

#endif
