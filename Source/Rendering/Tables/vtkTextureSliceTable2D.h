// SPDX-License-Identifier: BSD-3-Clause
// Colour and opacity over scalar and gradient magnitude.
#ifndef vtkTextureSliceTable2D_h
#define vtkTextureSliceTable2D_h

#include "vtkNew.h"
#include "vtkTextureObject.h"
#include "vtkTextureSliceVisibility.h"
#include "vtkTimeStamp.h"
#include "vtkType.h"

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

class vtkImageData;
class vtkOpenGLRenderWindow;

/**
 * Two-dimensional transfer functions as vtkVolumeProperty holds them: images of four floats (red,
 * green, blue, opacity of one unit distance), scalars to the right over their range, gradient
 * magnitude upwards. Several images are stacked, the first below, and must have one size.
 */
class vtkTextureSliceTable2D
{
public:
  /**
   * Uploads the images if they or the window changed.
   * @return false, with one line in @a error, if they cannot be used.
   */
  bool Update(vtkOpenGLRenderWindow* window, const std::vector<vtkImageData*>& images, bool nearest,
    std::string& error);

  vtkTextureObject* GetTexture() const { return this->Texture; }
  /// Rows of one image.
  int GetNumberOfRows() const { return this->Rows; }
  /// Entries of a row.
  int GetWidth() const { return this->Width; }
  /// Where an image's opacity is above 0 at some gradient magnitude, over the scalars as 0 to 1.
  const vtkTextureSliceVisibility& GetVisibility(std::size_t image) const
  {
    return this->Visibilities[image];
  }
  /// When the images were read last.
  vtkMTimeType GetFillTime() const { return this->FillTime.GetMTime(); }

private:
  bool Upload(const std::vector<vtkImageData*>& images);
  void IndexOpacities(const std::vector<float>& entries, std::size_t images);

  vtkNew<vtkTextureObject> Texture;
  int Rows = 0;
  int Width = 0;
  std::vector<vtkTextureSliceVisibility> Visibilities; ///< one for each image
  vtkTimeStamp FillTime;
  /// The images and when they changed; pointers are compared, never followed.
  std::vector<std::pair<const void*, vtkMTimeType>> Last;
};

#endif
