// SPDX-License-Identifier: BSD-3-Clause
// The integrals of colour and optical depth over the scalars, as rows of RGBA texels.
#ifndef vtkTextureSliceIntegralTable_h
#define vtkTextureSliceIntegralTable_h

#include "vtkNew.h"
#include "vtkNexradRenderingModule.h" // for the export macro
#include "vtkTextureObject.h"
#include "vtkType.h"

#include <cstddef>
#include <tuple>

class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkTextureSliceTable;

/**
 * The tables of pre-integrated classification (Formulas L1), one row for each of the first rows of
 * a vtkTextureSliceTable, which must hold optical depths. Alpha is K, the integral of the optical
 * depth of a unit distance from the first entry on; red, green and blue are K_c, the integral of
 * that depth times the colour (trapezoidal rule). Between two entries of the functions, depth and
 * colour count as linear. The integrals are counted in their own entries, so that the difference of
 * two entries over the number of entries between them is a depth.
 *
 * The shader reads single entries, which costs half of interpolating two. The integrals therefore
 * have three entries between each two of functions that have 2048 entries or fewer.
 */
class VTKNEXRADRENDERING_EXPORT vtkTextureSliceIntegralTable
{
public:
  /**
   * Fills and uploads the integrals if the table, the limit or the window changed.
   * @param rows of @a table to integrate.
   * @param dimensions of the texture: 1 (for a single row) or 2.
   * @param mostDepth depths count as at most this: differences of large sums lose precision.
   */
  void Update(vtkOpenGLRenderWindow* window, const vtkTextureSliceTable& table, int rows,
    int dimensions, double mostDepth);

  vtkTextureObject* GetTexture() const { return this->Texture; }
  /// Sets the number of the last entry of a row.
  void SetUniforms(const char* name, vtkShaderProgram* program) const;

  /// Entries of a row for functions of so many entries.
  static std::size_t ChooseWidth(std::size_t entries);

  /**
   * A limit for Update at which a slab of that many unit distances is still opaque: a power of two,
   * so that it stays the same while the camera moves a little.
   */
  static double ChooseMostDepth(double unitsOfSlab);

  /**
   * Integrates one row.
   * @param entries RGBA of @a width entries, alpha an optical depth.
   * @param integrals ChooseWidth(width) entries.
   */
  static void Integrate(
    const float* entries, std::size_t width, double mostDepth, float* integrals);

private:
  /// When the table was filled, rows, dimensions and limit of depth.
  using Key = std::tuple<vtkMTimeType, int, int, double>;

  vtkNew<vtkTextureObject> Texture;
  std::size_t Width = 0;
  Key Last{};
};

#endif
