// SPDX-License-Identifier: BSD-3-Clause
// The transfer functions as tables: colour and opacity, their integrals, and which scalars they
// show.
#ifndef vtkTextureSliceTables_h
#define vtkTextureSliceTables_h

#include "vtkNew.h"
#include "vtkNexradRenderingModule.h" // for the export macro
#include "vtkTextureObject.h"
#include "vtkTimeStamp.h"
#include "vtkType.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

class vtkColorTransferFunction;
class vtkImageData;
class vtkOpenGLRenderWindow;
class vtkPiecewiseFunction;
class vtkShaderProgram;

/// Tells at once whether an opacity function shows any scalar of a range, by the number of visible
/// entries of its table before each one. Scalars are 0 at the first entry and 1 at the last.
class vtkTextureSliceVisibility
{
public:
  explicit vtkTextureSliceVisibility(const std::vector<float>& opacities)
  {
    for (const float opacity : opacities)
    {
      this->VisibleBefore.push_back(this->VisibleBefore.back() + (opacity > 0.0f ? 1 : 0));
    }
  }

  /// Whether a scalar from low to high can be visible, its neighbours in the table included.
  bool IsVisible(double low, double high) const
  {
    constexpr double lookupError = 0.02; // of the graphics hardware, in entries
    // An entry's influence reaches to its neighbours; beyond the ends the last ones hold.
    const double last = static_cast<double>(this->VisibleBefore.size() - 2);
    const double first = std::clamp(low * last - lookupError, 0.0, last);
    const double end = std::clamp(high * last + lookupError + 1.0, 0.0, last);
    return low <= high && this->VisibleBefore[static_cast<std::size_t>(end) + 1] >
                            this->VisibleBefore[static_cast<std::size_t>(first)];
  }

private:
  std::vector<std::size_t> VisibleBefore{0};
};

/// The range of a component, and whether a function's own clamps the scalar first (NATIVE).
struct vtkTextureSliceDomain
{
  std::array<double, 2> Range{0.0, 1.0};
  bool Native = false;
};

struct vtkTextureSliceRow
{
  /// Colour: one of the two, or neither for white.
  vtkColorTransferFunction* Color = nullptr;
  vtkPiecewiseFunction* Gray = nullptr;
  vtkTextureSliceDomain ColorDomain;
  vtkPiecewiseFunction* Opacity = nullptr;
  vtkTextureSliceDomain OpacityDomain;
  /// Whether the texture holds optical depths in place of opacities.
  bool OpticalDepth = false;
};

/// Rows of functions. Entry i of n stands for the scalar low + i*(high - low)/(n - 1) of its
/// domain; its colour is not multiplied with its opacity, which is that of one unit distance. A
/// single row is a 1-D texture, several are a 2-D one.
class vtkTextureSliceTable
{
public:
  /// Brings rows of RGBA texels into a texture of one dimension (of a single row) or two.
  static void Upload(vtkTextureObject* texture, std::size_t rows, const std::vector<float>& texels);

  /// Uploads the rows if the functions, the ranges or the window changed.
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
  vtkMTimeType GetFillTime() const { return this->FillTime.GetMTime(); }
  /// RGBA of the entries of a row as they are in the texture.
  const float* GetEntries(std::size_t row) const
  {
    return this->Entries.data() + row * this->GetWidth() * 4;
  }
  std::size_t GetWidth() const { return this->Entries.size() / (4 * this->Last.size()); }
  /// Sets tableScale and tableBias: the texture coordinate of a scalar that is s of the way through
  /// its domain (0 to 1) is s * scale + bias (Formulas R2).
  void SetUniforms(vtkShaderProgram* program) const;

private:
  /// What a row is made from; pointers are compared, never followed.
  using Key = std::tuple<const void*, const void*, const void*, vtkMTimeType, vtkMTimeType,
    vtkMTimeType, std::array<double, 2>, bool, std::array<double, 2>, bool, bool>;
  void Fill(vtkOpenGLRenderWindow* window, const std::vector<vtkTextureSliceRow>& rows);

  vtkNew<vtkTextureObject> Texture;
  std::vector<float> Entries;
  std::vector<std::vector<float>> Opacities;           ///< one for each row
  std::vector<vtkTextureSliceVisibility> Visibilities; ///< one for each row
  vtkTimeStamp FillTime;
  std::vector<Key> Last; ///< one for each row that the texture was made from
};

/// Two-dimensional transfer functions as vtkVolumeProperty holds them: images of four floats (red,
/// green, blue, opacity of one unit distance), scalars to the right over their range, gradient
/// magnitude upwards. Several images are stacked, the first below, and must have one size.
class vtkTextureSliceTable2D
{
public:
  /// Uploads the images if they or the window changed. @return why they cannot be used, or nothing
  std::string Update(
    vtkOpenGLRenderWindow* window, const std::vector<vtkImageData*>& images, bool nearest);

  vtkTextureObject* GetTexture() const { return this->Texture; }
  /// Entries of a row.
  int GetWidth() const { return static_cast<int>(this->Texture->GetWidth()); }
  /// Where an image's opacity is above 0 at some gradient magnitude, over the scalars as 0 to 1.
  const vtkTextureSliceVisibility& GetVisibility(std::size_t image) const
  {
    return this->Visibilities[image];
  }
  vtkMTimeType GetFillTime() const { return this->FillTime.GetMTime(); }

private:
  bool Upload(const std::vector<vtkImageData*>& images);

  vtkNew<vtkTextureObject> Texture;
  std::vector<vtkTextureSliceVisibility> Visibilities; ///< one for each image
  vtkTimeStamp FillTime;
  /// The images and when they changed; pointers are compared, never followed.
  std::vector<std::pair<const void*, vtkMTimeType>> Last;
};

/// The tables of pre-integrated classification (Formulas L1), one row for each of the first rows of
/// a vtkTextureSliceTable, which must hold optical depths. Alpha is K, the integral of the optical
/// depth of a unit distance; red, green and blue are K_c, the integral of that depth times the
/// colour (trapezoidal rule). Integrals are counted in their own entries: the difference of two
/// over the entries between them is a depth. The shader reads single entries, so the integrals have
/// three entries between each two of functions that have 2048 or fewer.
class VTKNEXRADRENDERING_EXPORT vtkTextureSliceIntegralTable
{
public:
  /// Uploads the integrals of some rows if the table, the limit or the window changed.
  /// @param mostDepth depths count as at most this: differences of large sums lose precision.
  void Update(
    vtkOpenGLRenderWindow* window, const vtkTextureSliceTable& table, int rows, double mostDepth);

  vtkTextureObject* GetTexture() const { return this->Texture; }
  /// Sets the number of the last entry of a row.
  void SetUniforms(vtkShaderProgram* program) const;

  /// Entries of a row for functions of so many entries.
  static std::size_t ChooseWidth(std::size_t entries);

  /// A limit for Update at which a slab of that many unit distances is still opaque: a power of 2.
  static double ChooseMostDepth(double unitsOfSlab);

  /// Integrates one row of RGBA, alpha an optical depth, into ChooseWidth(width) entries.
  static void Integrate(
    const float* entries, std::size_t width, double mostDepth, float* integrals);

private:
  /// When the table was filled, rows and limit of depth.
  using Key = std::tuple<vtkMTimeType, int, double>;

  vtkNew<vtkTextureObject> Texture;
  std::size_t Width = 0;
  Key Last{};
};

#endif
