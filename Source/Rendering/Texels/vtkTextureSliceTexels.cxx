// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTextureSliceTexels.h"

#include "vtkDataArray.h"
#include "vtkSMPTools.h"
#include "vtkTextureSliceRows.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <utility>

namespace
{

using Box = vtkTextureSliceBlocks::Box;
using Component = vtkTextureSliceComponent;

/// What the texels of a type of scalars are.
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

/// The texels of a box, x fastest.
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

vtkTextureSliceTexels::vtkTextureSliceTexels(
  const vtkTextureSliceScalars& source, const vtkTextureSliceBricks& bricks)
  : SourceType(source.Scalars->GetDataType())
  , Size(source.Size)
  , Masked(bricks.HasInvisible())
  , Codes(source.Codes)
  , Components(static_cast<std::size_t>(source.Scalars->GetNumberOfComponents()))
{
  for (std::size_t c = 0; c < this->Components.size(); ++c)
  {
    vtkTextureSliceBricks::Range range;
    for (std::size_t i = c; i < bricks.GetRanges().size(); i += this->Components.size())
    {
      range.Low = std::min(range.Low, bricks.GetRanges()[i].Low);
      range.High = std::max(range.High, bricks.GetRanges()[i].High);
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
    this->Components.front().Scale =
      std::numeric_limits<std::uint8_t>::max() * this->Codes->GetStep();
    this->Components.front().Bias = this->Codes->GetBase();
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
      [this](unsigned char code, std::size_t) { return this->Codes->GetByte(code); });
    return;
  }
  if (this->Codes)
  {
    encode(vtkTextureSlice::Rows<unsigned char>(source), float(),
      [this](unsigned char code, std::size_t)
      { return static_cast<float>(this->Codes->GetValue(code)); });
    return;
  }
  switch (this->SourceType)
  {
    vtkTemplateMacro(encode(vtkTextureSlice::Rows<VTK_TT>(source), TexelOf<VTK_TT>(),
      [this](VTK_TT scalar, std::size_t c) { return ToTexel(scalar, this->Components[c]); }));
  }
}
