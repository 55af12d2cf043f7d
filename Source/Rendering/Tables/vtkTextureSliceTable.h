// SPDX-License-Identifier: BSD-3-Clause
// Colour and opacity over the scalars, as rows of RGBA texels.
#ifndef vtkTextureSliceTable_h
#define vtkTextureSliceTable_h

#include "vtkNew.h"
#include "vtkTextureObject.h"
#include "vtkTextureSliceVisibility.h"
#include "vtkTimeStamp.h"
#include "vtkType.h"

#include <array>
#include <cstddef>
#include <string>
#include <tuple>
#include <vector>

class vtkColorTransferFunction;
class vtkOpenGLRenderWindow;
class vtkPiecewiseFunction;
class vtkShaderProgram;

/// A function over the range of a component, and whether its own range clamps the scalar first
/// (vtkGPUVolumeRayCastMapper::NATIVE).
struct vtkTextureSliceDomain
{
  std::array<double, 2> Range{0.0, 1.0};
  bool Native = false;
};

/// The functions of one row.
struct vtkTextureSliceRow
{
  /// Colour: one of the two, or neither for white.
  vtkColorTransferFunction* Color = nullptr;
  vtkPiecewiseFunction* Gray = nullptr;
  vtkTextureSliceDomain ColorDomain;
  /// nullptr: 1 everywhere.
  vtkPiecewiseFunction* Opacity = nullptr;
  vtkTextureSliceDomain OpacityDomain;
  /// Whether the texture holds optical depths in place of opacities.
  bool OpticalDepth = false;
};

/**
 * Rows of functions, all of one width. Entry i of n stands for the scalar
 * low + i*(high - low)/(n - 1) of its domain; its colour is not yet multiplied with its opacity,
 * which is that of one unit distance. A single row is a 1-D texture, several are a 2-D one.
 */
class vtkTextureSliceTable
{
public:
  /// Brings rows of RGBA texels into a texture of one dimension (of a single row) or two.
  static void Upload(
    vtkTextureObject* texture, int dimensions, std::size_t rows, const std::vector<float>& texels);

  /**
   * Fills and uploads the table if the functions, the ranges or the window changed.
   * @param nearest whether entries are not interpolated.
   */
  void Update(
    vtkOpenGLRenderWindow* window, const std::vector<vtkTextureSliceRow>& rows, bool nearest);

  vtkTextureObject* GetTexture() const { return this->Texture; }
  /// Where a row's opacity is above 0, over its domain as 0 to 1.
  const vtkTextureSliceVisibility& GetVisibility(std::size_t row) const
  {
    return this->Visibilities[row];
  }
  /// Opacities of a row over its domain, or optical depths of a unit distance for each factor of 2
  /// that it weakens what is behind (Formulas R1). Their number does not depend on colours.
  const std::vector<float>& GetOpacities(std::size_t row) const { return this->Opacities[row]; }
  /// When the rows were filled last.
  vtkMTimeType GetFillTime() const { return this->FillTime.GetMTime(); }
  /// RGBA of the entries of a row as they are in the texture.
  const float* GetEntries(std::size_t row) const
  {
    return this->Entries.data() + row * this->GetWidth() * 4;
  }
  /// Entries of a row.
  std::size_t GetWidth() const { return this->Entries.size() / (4 * this->Last.size()); }
  /// Sets NAMEScale and NAMEBias: the texture coordinate of a scalar that is s of the way through
  /// its domain (0 to 1) is s * scale + bias (Formulas R2).
  void SetUniforms(const std::string& name, vtkShaderProgram* program) const;

private:
  /// What a row is made from; pointers are compared, never followed.
  using Key = std::tuple<std::array<const void*, 3>, std::array<vtkMTimeType, 3>,
    std::array<double, 2>, bool, std::array<double, 2>, bool, bool>;
  static Key MakeKey(const vtkTextureSliceRow& row);
  void Fill(const std::vector<vtkTextureSliceRow>& rows, std::size_t width);
  void FillOpacities(vtkOpenGLRenderWindow* window, std::vector<vtkTextureSliceRow> rows);

  vtkNew<vtkTextureObject> Texture;
  std::vector<float> Entries;
  std::vector<std::vector<float>> Opacities;           ///< one for each row
  std::vector<vtkTextureSliceVisibility> Visibilities; ///< one for each row
  vtkTimeStamp FillTime;
  std::vector<Key> Last; ///< one for each row that the texture was made from
};

#endif
