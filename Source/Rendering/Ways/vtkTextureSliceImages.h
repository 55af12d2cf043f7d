// SPDX-License-Identifier: BSD-3-Clause
// The picture of a volume and its depth as images.
#ifndef vtkTextureSliceImages_h
#define vtkTextureSliceImages_h

#include "vtkNew.h"

#include <array>
#include <vector>

class vtkImageData;
class vtkTextureObject;
class vtkTextureSliceFrame;

/**
 * What a mapper draws with RenderToImage, as VTK's ray caster draws it: associated colour, four
 * unsigned char a pixel, white where a ray misses the volume; and depths of the window, 0 to 1, in
 * the type of the mapper's DepthImageScalarType.
 */
class vtkTextureSliceImages
{
public:
  vtkNew<vtkImageData> Color;
  vtkNew<vtkImageData> Depth;

  /// The pixels of a picture, four numbers each.
  static std::vector<float> Download(vtkTextureObject* picture);
  /**
   * @param colors pixels of the picture.
   * @param places of the picture of places (vtkTextureSliceFeatures::Places).
   * @param clamps whether a ray that sees nothing has the depth of its beginning, in place of 1.
   */
  void Fill(const std::array<int, 2>& size, int depthType, const std::vector<float>& colors,
    const std::vector<float>& places, const vtkTextureSliceFrame& frame, bool clamps);
};

#endif
