// SPDX-License-Identifier: BSD-3-Clause
// Scalars of one byte that are codes.
#ifndef vtkTextureSliceCodes_h
#define vtkTextureSliceCodes_h

#include "vtkNexradRenderingModule.h" // for the export macro

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

class vtkDataArray;
class vtkImageData;

/**
 * What the codes of a volume stand for. Scalars NAME of one unsigned char are codes where the
 * image's field data have `NAME_code_values`: 256 numbers, the value of each code. A second array,
 * `NAME_code_ghosts` of 256 unsigned char, may give each code flags of vtkGhostType, each of which
 * hides it. The picture is that of scalars with these values and flags; codes whose value is not
 * finite are hidden too.
 */
class VTKNEXRADRENDERING_EXPORT vtkTextureSliceCodes
{
public:
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

  bool IsHidden(std::size_t code) const { return this->Visible[code] == 0; }
  /// 1 for each code that is seen, else 0.
  const unsigned char* GetVisible() const { return this->Visible.data(); }
  double GetValue(std::size_t code) const { return this->Values[code]; }
  /// Least and greatest value of the codes from `low` to `high` that are seen. Exact where the
  /// values ascend with the codes; else those of all codes that are seen.
  std::array<double, 2> GetRange(std::size_t low, std::size_t high) const;

  /// Whether a byte can hold each value that is seen: the value of byte b is b * step + base.
  bool HasBytes() const { return this->Step > 0.0; }
  double GetStep() const { return this->Step; }
  double GetBase() const { return this->Base; }
  unsigned char GetByte(std::size_t code) const { return this->Bytes[code]; }

private:
  /// @param seen the values of codes that are not hidden, ascending.
  void FindBytes(const std::vector<double>& seen);

  std::array<double, Count> Values;
  std::array<unsigned char, Count> Visible{};
  bool Ascending = true;
  std::array<double, 2> WholeRange{}; ///< of the codes that are seen
  double Step = 0.0;                  ///< 0: the values lie on no 256 even steps
  double Base = 0.0;
  std::array<unsigned char, Count> Bytes{};
};

#endif
