// SPDX-License-Identifier: BSD-3-Clause
// The scalars of a volume, what hides some of them, what they stand for where they are codes, and
// where their points lie.
#ifndef vtkTextureSliceScalars_h
#define vtkTextureSliceScalars_h

#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkNexradRenderingModule.h" // for the export macro
#include "vtkSmartPointer.h"
#include "vtkTextureObject.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <type_traits>
#include <vector>

class vtkImageData;
class vtkOpenGLRenderWindow;
class vtkRectilinearGrid;

/// What the codes of a volume stand for (see vtkOpenGLTextureSliceVolumeMapper). Codes with any
/// ghost flag, and those whose value is not finite, are hidden.
struct VTKNEXRADRENDERING_EXPORT vtkTextureSliceCodes
{
  static constexpr std::size_t Count = 256;

  /// Nothing where the scalars are no codes.
  static std::optional<vtkTextureSliceCodes> Find(vtkImageData* image, vtkDataArray* scalars);

  /// @param hidden not 0 for codes at which nothing is seen
  vtkTextureSliceCodes(
    const std::array<double, Count>& values, const std::array<unsigned char, Count>& hidden);

  bool operator==(const vtkTextureSliceCodes& other) const
  {
    return this->Values == other.Values && this->Visible == other.Visible;
  }

  /// The first and the last code that is seen, where all between them are seen; else {255, 0}.
  std::array<unsigned char, 2> FindInterval() const;
  /// Least and greatest value of the codes from `low` to `high` that are seen.
  std::array<double, 2> GetRange(std::size_t low, std::size_t high) const;

  std::array<double, Count> Values;
  std::array<unsigned char, Count> Visible{}; ///< 1 for each code that is seen, else 0
  /// Where a byte can hold each value that is seen: the value of byte b is b * step + base.
  double Step = 0.0; ///< 0: the values lie on no 256 even steps
  double Base = 0.0;
  std::array<unsigned char, Count> Bytes{};

private:
  /// @param seen the values of codes that are not hidden, ascending.
  void FindBytes(const std::vector<double>& seen);
};

/// One texel for each point, or each cell.
struct vtkTextureSliceScalars
{
  vtkDataArray* Scalars = nullptr;
  /// Texels along each axis: points, or cells.
  std::array<int, 3> Size{};
  bool CellData = false;
  /// Every flag hides a texel, as in VTK's ray caster. May be nullptr: nothing is hidden.
  vtkUnsignedCharArray* Ghosts = nullptr;
  /// What the scalars stand for where they are codes.
  std::optional<vtkTextureSliceCodes> Codes = {};
  /// Where the points of a rectilinear grid lie in the box, 0 to 1 along each axis; empty: evenly.
  std::array<std::vector<double>, 3> Places = {};

  /// Texels of an image along each axis.
  static std::array<int, 3> GetSize(vtkImageData* image, bool cellData);
  /// The ghost array of an image's points or cells if it has one flag for each; or nullptr.
  static vtkUnsignedCharArray* FindGhosts(vtkImageData* image, bool ofCells);
  /// An array of an image, with the image's ghost array if that has one flag for each texel.
  static vtkTextureSliceScalars Find(vtkImageData* image, vtkDataArray* scalars, bool cellData);
};

/// The slices draw a rectilinear grid as an image of the same arrays in the same bounds; the
/// shaders look up how far a place of it lies among the grid's points. The table of an axis has at
/// least sixteen entries in the shortest interval, as far as the largest texture allows: then a
/// place errs by at most 1/64 of a voxel.
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
  /// Where the points lie in the box along each axis, ascending from 0 to 1; empty for an image.
  const std::array<std::vector<double>, 3>& GetPlaces() const { return this->Places; }

  /// Makes the table of all axes for a window.
  void Update(vtkOpenGLRenderWindow* window);
  /// One channel for each axis: from the place in the box to the part of the intervals before it.
  vtkTextureObject* GetTexture() const { return this->Texture; }

private:
  std::array<std::vector<double>, 3> Places;
  std::size_t Width = 1; ///< entries of the table
  bool Filled = false;
  vtkNew<vtkTextureObject> Texture;
};

namespace vtkTextureSlice
{

/// A volume's scalars and ghost flags row by row. The source must stay as it is meanwhile.
template <typename Scalar>
class Rows
{
public:
  explicit Rows(const vtkTextureSliceScalars& source)
    : Length(static_cast<std::size_t>(source.Size[0]))
    , Components(static_cast<std::size_t>(source.Scalars->GetNumberOfComponents()))
    , Height(static_cast<std::size_t>(source.Size[1]))
    , Scalars(static_cast<const Scalar*>(source.Scalars->GetVoidPointer(0)))
    , Ghosts(source.Ghosts != nullptr ? source.Ghosts->GetPointer(0) : nullptr)
    , VisibleCodes(source.Codes ? source.Codes->Visible.data() : nullptr)
    , CodeInterval(
        source.Codes ? source.Codes->FindInterval() : std::array<unsigned char, 2>{255, 0})
  {
  }

  /// The scalars of the row at (x, y, z) and after it, component after component of each texel.
  const Scalar* GetScalars(int y, int z, int x = 0) const
  {
    return this->Scalars + this->Place(x, y, z) * this->Components;
  }
  /// nullptr: nothing is hidden.
  const unsigned char* GetGhosts(int y, int z, int x = 0) const
  {
    return this->Ghosts != nullptr ? this->Ghosts + this->Place(x, y, z) : nullptr;
  }

  /// Marks texels with 1 where they are visible (not hidden, all components finite, no code that is
  /// hidden), else with 0.
  void MarkVisible(int y, int z, int x, std::size_t count, unsigned char* visible) const
  {
    const Scalar* scalars = this->GetScalars(y, z, x);
    std::fill_n(visible, count, static_cast<unsigned char>(1));
    if constexpr (std::is_same_v<Scalar, unsigned char>)
    {
      // Copies of members, because bytes that are written could be these.
      const unsigned char* const ofCode = this->VisibleCodes;
      const auto [first, last] = this->CodeInterval;
      // Two comparisons are done for many texels at a time, look-ups are not.
      const bool compares = first <= last;
      for (std::size_t i = 0; compares && i < count; ++i)
      {
        visible[i] = scalars[i] >= first && scalars[i] <= last ? 1 : 0;
      }
      for (std::size_t i = 0; !compares && ofCode != nullptr && i < count; ++i)
      {
        visible[i] = ofCode[scalars[i]];
      }
    }
    if constexpr (std::is_floating_point_v<Scalar>)
    {
      for (std::size_t c = 0; c < this->Components; ++c)
      {
        // A constant step lets the compiler take several texels at a time.
        this->Components == 1 ? UnmarkInfinite(scalars, 1, count, visible)
                              : UnmarkInfinite(scalars + c, this->Components, count, visible);
      }
    }
    const unsigned char* ghosts = this->GetGhosts(y, z, x);
    for (std::size_t i = 0; ghosts != nullptr && i < count; ++i)
    {
      visible[i] = ghosts[i] == 0 ? visible[i] : 0;
    }
  }

  const std::size_t Length; ///< texels of a row
  const std::size_t Components;

private:
  static void UnmarkInfinite(
    const Scalar* scalars, std::size_t step, std::size_t count, unsigned char* finite)
  {
    constexpr Scalar most = std::numeric_limits<Scalar>::max();
    for (std::size_t i = 0; i < count; ++i)
    {
      finite[i] = std::abs(scalars[i * step]) <= most ? finite[i] : 0;
    }
  }

  std::size_t Place(int x, int y, int z) const
  {
    return (static_cast<std::size_t>(z) * this->Height + static_cast<std::size_t>(y)) *
             this->Length +
           static_cast<std::size_t>(x);
  }

  const std::size_t Height;
  const Scalar* const Scalars;
  const unsigned char* const Ghosts;
  const unsigned char* const VisibleCodes; ///< nullptr: the scalars are no codes
  const std::array<unsigned char, 2> CodeInterval;
};

} // namespace vtkTextureSlice

#endif
