// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTextureSliceTexels.h"

#include "vtkDataArray.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <type_traits>
#include <utility>

namespace
{

using Box = vtkTextureSliceBlocks::Box;
constexpr int Edge = vtkTextureSliceBlocks::Edge;

constexpr std::uint64_t Seed = 0x9E3779B97F4A7C15;
constexpr std::uint64_t Factor = 0xD6E8FEB86659FD93; // odd, so that no two words give the same

/// Takes bytes into a sum, the last word filled with zeros.
std::uint64_t MixBytes(std::uint64_t sum, const unsigned char* bytes, std::size_t count)
{
  constexpr std::size_t size = sizeof(std::uint64_t);
  for (std::size_t i = 0; i < count; i += size)
  {
    std::uint64_t word = 0;
    i + size <= count ? std::memcpy(&word, bytes + i, size)
                      : std::memcpy(&word, bytes + i, count - i);
    const std::uint64_t product = (sum ^ word) * Factor;
    sum = product ^ (product >> 32);
  }
  return sum;
}

/// Takes a row of texels into the sums of the blocks along it.
void MixRow(
  const unsigned char* row, std::size_t length, std::size_t bytesOfTexel, std::uint64_t* sums)
{
  constexpr auto edge = static_cast<std::size_t>(Edge);
  for (std::size_t begin = 0; begin < length; begin += edge, ++sums)
  {
    const std::size_t texels = std::min(edge, length - begin);
    *sums = MixBytes(*sums, row + begin * bytesOfTexel, texels * bytesOfTexel);
  }
}

template <typename Scalar>
void SumRowOfBlocks(const vtkTextureSlice::Rows<Scalar>& rows, const Box& box, std::uint64_t* sums)
{
  for (int z = box.Begin[2]; z < box.End[2]; ++z)
  {
    for (int y = box.Begin[1]; y < box.End[1]; ++y)
    {
      MixRow(reinterpret_cast<const unsigned char*>(rows.GetScalars(y, z)), rows.Length,
        rows.Components * sizeof(Scalar), sums);
      if (const unsigned char* ghosts = rows.GetGhosts(y, z))
      {
        MixRow(ghosts, rows.Length, 1, sums);
      }
    }
  }
}

/// Adds a box, or extends one with the same texels along x that ends where it begins along y.
void Add(const Box& box, std::vector<Box>& boxes)
{
  const auto before = std::find_if(boxes.begin(), boxes.end(),
    [&box](const Box& other)
    {
      return other.Begin[0] == box.Begin[0] && other.End[0] == box.End[0] &&
             other.End[1] == box.Begin[1];
    });
  before != boxes.end() ? static_cast<void>(before->End[1] = box.End[1]) : boxes.push_back(box);
}

using Component = vtkTextureSliceComponent;

template <typename Scalar>
using TexelOf = std::conditional_t<std::is_integral_v<Scalar> && sizeof(Scalar) <= 2,
  std::conditional_t<sizeof(Scalar) == 1, std::uint8_t, std::uint16_t>, float>;

template <typename Texel>
constexpr int TypeOf = std::is_same_v<Texel, float>
                         ? VTK_FLOAT
                         : (sizeof(Texel) == 1 ? VTK_UNSIGNED_CHAR : VTK_UNSIGNED_SHORT);

std::size_t CountTexels(const Box& box)
{
  std::size_t texels = 1;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    texels *= static_cast<std::size_t>(box.End[axis] - box.Begin[axis]);
  }
  return texels;
}

template <typename Scalar>
void SetScale(Component& component)
{
  if constexpr (std::is_integral_v<TexelOf<Scalar>>)
  {
    // What is stored is the distance from the type's least value.
    component.Scale = std::numeric_limits<TexelOf<Scalar>>::max();
    component.Bias = static_cast<double>(std::numeric_limits<Scalar>::lowest());
  }
  else if constexpr (!std::is_same_v<Scalar, float>)
  {
    const auto [low, high] = component.Range;
    component.Scale = high > low ? high - low : 1.0;
    component.Bias = low;
  }
}

template <typename Scalar>
TexelOf<Scalar> ToTexel(Scalar scalar, const Component& component)
{
  if constexpr (std::is_integral_v<TexelOf<Scalar>>)
  {
    return static_cast<TexelOf<Scalar>>(scalar - std::numeric_limits<Scalar>::lowest());
  }
  else if constexpr (std::is_same_v<Scalar, float>)
  {
    return scalar;
  }
  else
  {
    return static_cast<float>((static_cast<double>(scalar) - component.Bias) / component.Scale);
  }
}

/// One component of the texels of a row, and their mask. @a visible: nullptr: without a mask.
template <typename Scalar, typename Texel, typename Convert>
void EncodeRow(const Scalar* scalars, std::size_t components, const unsigned char* visible,
  std::size_t count, Texel* texels, const Convert& toTexel)
{
  // What OpenGL reads as 1.
  constexpr Texel one =
    std::is_floating_point_v<Texel> ? Texel{1} : std::numeric_limits<Texel>::max();
  const std::size_t channels = components + (visible != nullptr ? 1 : 0);
  for (std::size_t c = 0; c < components; ++c)
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      const Texel texel = toTexel(scalars[i * components + c], c);
      texels[i * channels + c] = visible == nullptr || visible[i] != 0 ? texel : Texel{0};
    }
  }
  for (std::size_t i = 0; visible != nullptr && i < count; ++i)
  {
    texels[i * channels + components] = visible[i] != 0 ? one : Texel{0};
  }
}

template <typename Scalar, typename Texel, typename Convert>
void EncodeRows(const vtkTextureSlice::Rows<Scalar>& rows, const Box& box, bool masked,
  Texel* texels, const Convert& toTexel)
{
  const auto count = static_cast<std::size_t>(box.End[0] - box.Begin[0]);
  std::vector<unsigned char> visible(masked ? count : 0);
  for (int z = box.Begin[2]; z < box.End[2]; ++z)
  {
    for (int y = box.Begin[1]; y < box.End[1]; ++y)
    {
      if (masked)
      {
        rows.MarkVisible(y, z, box.Begin[0], count, visible.data());
      }
      EncodeRow(rows.GetScalars(y, z, box.Begin[0]), rows.Components,
        masked ? visible.data() : nullptr, count, texels, toTexel);
      texels += count * (rows.Components + (masked ? 1 : 0));
    }
  }
}

} // namespace

void vtkTextureSliceBlocks::Build(const vtkTextureSliceScalars& source)
{
  this->Size = source.Size;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    this->Count[axis] = (this->Size[axis] + Edge - 1) / Edge;
  }
  const vtkIdType rowsOfBlocks = static_cast<vtkIdType>(this->Count[1]) * this->Count[2];
  this->Checksums.assign(static_cast<std::size_t>(rowsOfBlocks * this->Count[0]), Seed);
  const auto sumUp = [&](const auto& rows)
  {
    vtkSMPTools::For(0, rowsOfBlocks,
      [&](vtkIdType begin, vtkIdType end)
      {
        for (auto row = static_cast<int>(begin); row < static_cast<int>(end); ++row)
        {
          SumRowOfBlocks(rows,
            this->GetBox(0, this->Count[0] - 1, row % this->Count[1], row / this->Count[1]),
            this->Checksums.data() + std::ptrdiff_t{row} * this->Count[0]);
        }
      });
  };
  switch (source.Scalars->GetDataType())
  {
    vtkTemplateMacro(sumUp(vtkTextureSlice::Rows<VTK_TT>(source)));
  }
}

std::vector<Box> vtkTextureSliceBlocks::FindChanges(const vtkTextureSliceBlocks* other) const
{
  std::vector<Box> boxes;
  std::size_t row = 0; // the first block of a row of blocks
  for (int z = 0; z < this->Count[2]; ++z)
  {
    std::vector<Box> ofLayer;
    for (int y = 0; y < this->Count[1]; ++y, row += static_cast<std::size_t>(this->Count[0]))
    {
      int unchanged = -1; // the last block that is as in the other volume
      for (int x = 0; x <= this->Count[0]; ++x)
      {
        const std::size_t block = row + static_cast<std::size_t>(x);
        if (x < this->Count[0] &&
            (other == nullptr || this->Checksums[block] != other->Checksums[block]))
        {
          continue;
        }
        if (unchanged + 1 < x)
        {
          Add(this->GetBox(unchanged + 1, x - 1, y, z), ofLayer);
        }
        unchanged = x;
      }
    }
    boxes.insert(boxes.end(), ofLayer.begin(), ofLayer.end());
  }
  return boxes;
}

Box vtkTextureSliceBlocks::GetBox(int first, int last, int y, int z) const
{
  const auto end = [this](int block, std::size_t axis)
  { return std::min((block + 1) * Edge, this->Size[axis]); };
  return {{first * Edge, y * Edge, z * Edge}, {end(last, 0), end(y, 1), end(z, 2)}};
}

vtkTextureSliceTexels::vtkTextureSliceTexels(
  const vtkTextureSliceScalars& source, const vtkTextureSliceBricks& bricks)
  : SourceType(source.Scalars->GetDataType())
  , Size(source.Size)
  , Masked(bricks.HasInvisible)
  , Codes(source.Codes)
  , Components(static_cast<std::size_t>(source.Scalars->GetNumberOfComponents()))
{
  for (std::size_t c = 0; c < this->Components.size(); ++c)
  {
    vtkTextureSliceBricks::Range range;
    for (std::size_t i = c; i < bricks.Ranges.size(); i += this->Components.size())
    {
      range.Low = std::min(range.Low, bricks.Ranges[i].Low);
      range.High = std::max(range.High, bricks.Ranges[i].High);
    }
    Component& component = this->Components[c];
    component.Range =
      range.Low <= range.High ? std::array<double, 2>{range.Low, range.High} : component.Range;
    switch (this->Codes ? VTK_VOID : this->SourceType)
    {
      vtkTemplateMacro(SetScale<VTK_TT>(component); this->ScalarType = TypeOf<TexelOf<VTK_TT>>);
    default:
      break;
    }
  }
  if (this->AreCodeBytes())
  {
    this->ScalarType = VTK_UNSIGNED_CHAR;
    this->Components.front().Scale = std::numeric_limits<std::uint8_t>::max() * this->Codes->Step;
    this->Components.front().Bias = this->Codes->Base;
  }
}

bool vtkTextureSliceTexels::IsLike(const vtkTextureSliceTexels& other) const
{
  const auto sameScale = [](const Component& a, const Component& b)
  { return a.Scale == b.Scale && a.Bias == b.Bias; };
  return this->SourceType == other.SourceType && this->Size == other.Size &&
         this->Masked == other.Masked && this->Codes == other.Codes &&
         std::equal(this->Components.begin(), this->Components.end(), other.Components.begin(),
           other.Components.end(), sameScale);
}

vtkTextureSliceChanges vtkTextureSliceTexels::Encode(
  const vtkTextureSliceScalars& source, std::vector<Box> boxes) const
{
  vtkTextureSliceChanges changes;
  const auto bytesOfTexel = static_cast<std::size_t>(
    vtkDataArray::GetDataTypeSize(this->ScalarType) * this->CountChannels());
  std::size_t bytes = 0;
  for (const Box& box : boxes)
  {
    changes.Begins.push_back(bytes);
    bytes += bytesOfTexel * CountTexels(box);
  }
  changes.Boxes = std::move(boxes);
  changes.Bytes.reset(new unsigned char[bytes]);
  vtkSMPTools::For(0, static_cast<vtkIdType>(changes.Boxes.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
      {
        this->EncodeBox(source, changes.Boxes[i], changes.Bytes.get() + changes.Begins[i]);
      }
    });
  return changes;
}

void vtkTextureSliceTexels::EncodeBox(
  const vtkTextureSliceScalars& source, const Box& box, unsigned char* texels) const
{
  const auto encode = [&](const auto& rows, auto texel, const auto& toTexel)
  { EncodeRows(rows, box, this->Masked, reinterpret_cast<decltype(texel)*>(texels), toTexel); };
  if (this->AreCodeBytes())
  {
    encode(vtkTextureSlice::Rows<unsigned char>(source), std::uint8_t(),
      [this](unsigned char code, std::size_t) { return this->Codes->Bytes[code]; });
    return;
  }
  if (this->Codes)
  {
    encode(vtkTextureSlice::Rows<unsigned char>(source), float(),
      [this](unsigned char code, std::size_t)
      { return static_cast<float>(this->Codes->Values[code]); });
    return;
  }
  switch (this->SourceType)
  {
    vtkTemplateMacro(encode(vtkTextureSlice::Rows<VTK_TT>(source), TexelOf<VTK_TT>(),
      [this](VTK_TT scalar, std::size_t c) { return ToTexel(scalar, this->Components[c]); }));
  }
}
