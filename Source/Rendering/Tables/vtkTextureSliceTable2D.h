// SPDX-License-Identifier: BSD-3-Clause
// Colour and opacity over scalar and gradient magnitude.
#ifndef vtkTextureSliceTable2D_h
#define vtkTextureSliceTable2D_h

#include "vtkNew.h"
#include "vtkTextureObject.h"
#include "vtkType.h"

#include <string>
#include <vector>

class vtkImageData;
class vtkOpenGLRenderWindow;
class vtkWindow;

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
  void ReleaseGraphicsResources(vtkWindow* window);

  vtkTextureObject* GetTexture() { return this->Texture; }
  /// Rows of one image.
  int GetNumberOfRows() const { return this->Rows; }

private:
  bool NeedsUpdate(vtkOpenGLRenderWindow* window, const std::vector<vtkImageData*>& images) const;
  bool Upload(const std::vector<vtkImageData*>& images);

  vtkNew<vtkTextureObject> Texture;
  int Rows = 0;
  std::vector<vtkImageData*> Last; ///< pointers are compared, never followed
  vtkMTimeType LastTime = 0;
};

#endif
