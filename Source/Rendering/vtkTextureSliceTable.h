// SPDX-License-Identifier: BSD-3-Clause
// Colour and opacity over the scalars, as one row of RGBA texels.
#ifndef vtkTextureSliceTable_h
#define vtkTextureSliceTable_h

#include "vtkNew.h"
#include "vtkTextureObject.h"
#include "vtkTimeStamp.h"

#include <array>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkVolumeProperty;
class vtkWindow;

/**
 * The transfer functions of a volume property's first component. Entry i of n stands for the
 * scalar low + i*(high - low)/(n - 1); its colour is not yet multiplied with its opacity, which is
 * that of one unit distance.
 */
class vtkTextureSliceTable
{
public:
  /// What the table is made from.
  struct Request
  {
    vtkVolumeProperty* Property = nullptr;
    /// The scalars' range: what the entries span.
    std::array<double, 2> ScalarRange{0.0, 1.0};
    /// Whether the functions' own ranges clamp the scalar first
    /// (vtkGPUVolumeRayCastMapper::NATIVE).
    bool NativeColorRange = false;
    bool NativeOpacityRange = false;
  };

  /// Fills and uploads the table if the functions, the ranges or the window changed.
  void Update(vtkOpenGLRenderWindow* window, const Request& request);
  void ReleaseGraphicsResources(vtkWindow* window);

  vtkTextureObject* GetTexture() { return this->Texture; }
  /// Texture coordinate of a scalar s: s * GetScale() + GetBias() (Formulas R2).
  double GetScale() const { return this->Scale; }
  double GetBias() const { return this->Bias; }

private:
  bool NeedsUpdate(vtkOpenGLRenderWindow* window, const Request& request) const;
  void Fill(const Request& request, int width);

  vtkNew<vtkTextureObject> Texture;
  std::vector<float> Entries;
  double Scale = 1.0;
  double Bias = 0.0;

  Request Last;
  vtkTimeStamp UpdateTime;
};

#endif
