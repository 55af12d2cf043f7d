// SPDX-License-Identifier: BSD-3-Clause
// The scalars of a volume as a 3-D texture.
#ifndef vtkTextureSliceTexture_h
#define vtkTextureSliceTexture_h

#include "vtkNew.h"
#include "vtkTextureObject.h"
#include "vtkTextureSliceBricks.h"
#include "vtkType.h"

#include <array>
#include <string>
#include <vector>

class vtkDataArray;
class vtkImageData;
class vtkOpenGLRenderWindow;
class vtkWindow;

/// One component of the scalars.
struct vtkTextureSliceComponent
{
  std::array<double, 2> Range{0.0, 1.0}; ///< least and greatest finite scalar
  double Scale = 1.0;                    ///< the scalar of a texel t: t * Scale + Bias
  double Bias = 0.0;
};

/**
 * One to four components of scalars of any type, one texel for each point (or cell). Scalars of 8
 * and 16 bits keep their size and all their values; float is uploaded as it is; wider types become
 * float, spread over 0 to 1 so that large values keep their differences.
 *
 * Points that vtkGhostType hides (HIDDENPOINT, or HIDDENCELL of cells) and those with a scalar that
 * is not finite are masked: the texture then has one more component, 1 at visible points and 0 at
 * hidden ones, where the others are 0 as well. OpenGL's textures have four components at most, so
 * four components of scalars cannot be masked.
 */
class vtkTextureSliceTexture
{
public:
  /**
   * Uploads the scalars if they, the ghost array, the dimensions or the window changed.
   * @return false, with one line in @a error, if the volume does not fit.
   */
  bool Update(vtkOpenGLRenderWindow* window, vtkImageData* image, vtkDataArray* scalars,
    bool cellData, std::string& error);
  void SetNearest(bool nearest);
  void ReleaseGraphicsResources(vtkWindow* window);

  vtkTextureObject* GetTexture() { return this->Texture; }
  /// Texels along each axis: points, or cells.
  static std::array<int, 3> GetSize(vtkImageData* image, bool cellData);
  /// The scalars' ranges in small parts of the volume.
  const vtkTextureSliceBricks& GetBricks() const { return this->Bricks; }
  /// Whether the component of the mask is there.
  bool IsMasked() const { return this->Masked; }
  /// How a texel t (0 to 1 unless float) of each component becomes its scalar.
  const std::vector<vtkTextureSliceComponent>& GetComponents() const { return this->Components; }

private:
  /// What the texture was made from; pointers are compared, never followed.
  struct Source
  {
    const void* Scalars = nullptr;
    vtkMTimeType ScalarsTime = 0;
    const void* Ghosts = nullptr;
    vtkMTimeType GhostsTime = 0;
    std::array<int, 3> Size{0, 0, 0};
    bool operator==(const Source& other) const
    {
      return this->Scalars == other.Scalars && this->ScalarsTime == other.ScalarsTime &&
             this->Ghosts == other.Ghosts && this->GhostsTime == other.GhostsTime &&
             this->Size == other.Size;
    }
  };
  static Source MakeSource(vtkImageData* image, vtkDataArray* scalars, bool cellData);
  /// Components of the texture: those of the scalars, and the mask.
  int CountChannels() const;
  bool Allocate(vtkOpenGLRenderWindow* window, const std::array<int, 3>& size, int scalarType,
    std::string& error);

  vtkNew<vtkTextureObject> Texture;
  vtkTextureSliceBricks Bricks;
  bool Masked = false;
  std::vector<vtkTextureSliceComponent> Components;
  Source Last;
  std::array<int, 5> Allocated{}; ///< size, scalar type and number of the texture's components
};

#endif
