// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTextureSliceTexels.h"

#include "vtkDataArray.h"
#include "vtkTextureSliceRows.h"
#include "vtkType.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <type_traits>

namespace
{

using Component = vtkTextureSliceComponent;

/// What the texels of a type of scalars are.
template <typename Scalar>
using TexelOf = std::conditional_t<std::is_integral_v<Scalar> && sizeof(Scalar) <= 2,
  std::conditional_t<sizeof(Scalar) == 1, std::uint8_t, std::uint16_t>, float>;

template <typename Scalar>
void SetScales(std::vector<Component>& components)
{
  for (Component& component : components)
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

/// Texels of one row, without or with the visibility of each.
template <typename Scalar>
void EncodeRow(const Scalar* scalars, const unsigned char* visible, std::size_t count,
  const std::vector<Component>& components, TexelOf<Scalar>* texels)
{
  using Texel = TexelOf<Scalar>;
  // What OpenGL reads as 1.
  constexpr Texel one =
    std::is_floating_point_v<Texel> ? Texel{1} : std::numeric_limits<Texel>::max();
  const std::size_t channels = components.size() + (visible != nullptr ? 1 : 0);
  for (std::size_t c = 0; c < components.size(); ++c)
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      const Texel texel = ToTexel(scalars[i * components.size() + c], components[c]);
      texels[i * channels + c] = visible == nullptr || visible[i] != 0 ? texel : Texel{0};
    }
  }
  for (std::size_t i = 0; visible != nullptr && i < count; ++i)
  {
    texels[i * channels + channels - 1] = visible[i] != 0 ? one : Texel{0};
  }
}

/// The texel of each code, and 1 or 0 for its visibility.
template <typename Texel>
std::array<std::array<Texel, 2>, vtkTextureSliceCodes::Count> MakeCodeTexels(
  const vtkTextureSliceCodes& codes)
{
  std::array<std::array<Texel, 2>, vtkTextureSliceCodes::Count> texels{};
  for (std::size_t code = 0; code < texels.size(); ++code)
  {
    if (codes.IsHidden(code))
    {
      continue;
    }
    if constexpr (std::is_same_v<Texel, std::uint8_t>)
    {
      texels[code] = {codes.GetByte(code), std::numeric_limits<Texel>::max()};
    }
    else
    {
      texels[code] = {static_cast<Texel>(codes.GetValue(code)), Texel{1}};
    }
  }
  return texels;
}

/// Texels of one row of codes. @a ghosts may be nullptr.
template <typename Texel>
void EncodeCodes(const std::array<std::array<Texel, 2>, vtkTextureSliceCodes::Count>& ofCode,
  const vtkTextureSlice::Rows<unsigned char>& rows, const std::array<int, 3>& at, bool masked,
  std::size_t count, Texel* texels)
{
  const unsigned char* codes = rows.GetScalars(at[1], at[2], at[0]);
  const unsigned char* ghosts = rows.GetGhosts(at[1], at[2], at[0]);
  if (!masked)
  {
    std::transform(
      codes, codes + count, texels, [&](unsigned char code) { return ofCode[code][0]; });
    return;
  }
  for (std::size_t i = 0; i < count; ++i)
  {
    std::memcpy(texels + 2 * i, ofCode[codes[i]].data(), 2 * sizeof(Texel));
  }
  for (std::size_t i = 0; ghosts != nullptr && i < count; ++i)
  {
    if (ghosts[i] != 0)
    {
      texels[2 * i] = texels[2 * i + 1] = Texel{0};
    }
  }
}

} // namespace

vtkTextureSliceTexels::vtkTextureSliceTexels(const vtkTextureSliceScalars& source,
  const std::vector<vtkTextureSliceBricks::Range>& ranges, bool masked)
  : SourceType(source.Scalars->GetDataType())
  , Size(source.Size)
  , Masked(masked)
  , Codes(source.Codes)
{
  for (const vtkTextureSliceBricks::Range& range : ranges)
  {
    Component component;
    if (range.Low <= range.High)
    {
      component.Range = {range.Low, range.High};
    }
    this->Components.push_back(component);
  }
  if (this->Codes)
  {
    this->SetScaleOfCodes();
    return;
  }
  switch (this->SourceType)
  {
    vtkTemplateMacro(SetScales<VTK_TT>(this->Components));
  }
}

void vtkTextureSliceTexels::SetScaleOfCodes()
{
  Component& component = this->Components.front();
  this->Codes->AddHidden(component.Range);
  if (this->Codes->HasBytes())
  {
    component.Scale = std::numeric_limits<std::uint8_t>::max() * this->Codes->GetStep();
    component.Bias = this->Codes->GetBase();
  }
}

int vtkTextureSliceTexels::GetScalarType() const
{
  int type = VTK_FLOAT;
  if (this->Codes && !this->AreCodeBytes())
  {
    return type;
  }
  const auto typeOf = [](auto texel)
  {
    return std::is_same_v<decltype(texel), float>
             ? VTK_FLOAT
             : (sizeof(texel) == 1 ? VTK_UNSIGNED_CHAR : VTK_UNSIGNED_SHORT);
  };
  switch (this->SourceType)
  {
    vtkTemplateMacro(type = typeOf(TexelOf<VTK_TT>()));
  }
  return type;
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

std::size_t vtkTextureSliceTexels::CountBytes(const Box& box) const
{
  std::size_t bytes = static_cast<std::size_t>(this->CountChannels());
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    bytes *= static_cast<std::size_t>(box.End[axis] - box.Begin[axis]);
  }
  switch (this->GetScalarType())
  {
  case VTK_UNSIGNED_CHAR:
    return bytes;
  case VTK_UNSIGNED_SHORT:
    return bytes * sizeof(std::uint16_t);
  default:
    return bytes * sizeof(float);
  }
}

void vtkTextureSliceTexels::Encode(
  const vtkTextureSliceScalars& source, const Box& box, unsigned char* texels) const
{
  const auto count = static_cast<std::size_t>(box.End[0] - box.Begin[0]);
  const int height = box.End[1] - box.Begin[1];
  const int rowsOfBox = height * (box.End[2] - box.Begin[2]);
  const std::size_t rowBytes = this->CountBytes(box) / static_cast<std::size_t>(rowsOfBox);
  const auto encodeCodes = [&](auto texel)
  {
    const auto ofCode = MakeCodeTexels<decltype(texel)>(*this->Codes);
    const vtkTextureSlice::Rows<unsigned char> rows(source);
    for (int row = 0; row < rowsOfBox; ++row)
    {
      EncodeCodes(ofCode, rows,
        {box.Begin[0], box.Begin[1] + row % height, box.Begin[2] + row / height}, this->Masked,
        count,
        reinterpret_cast<decltype(texel)*>(texels + rowBytes * static_cast<std::size_t>(row)));
    }
  };
  if (this->Codes)
  {
    this->Codes->HasBytes() ? encodeCodes(std::uint8_t()) : encodeCodes(float());
    return;
  }
  const auto encode = [&](const auto& rows, auto texel)
  {
    std::vector<unsigned char> visible(this->Masked ? count : 0);
    for (int row = 0; row < rowsOfBox; ++row)
    {
      const int y = box.Begin[1] + row % height;
      const int z = box.Begin[2] + row / height;
      if (this->Masked)
      {
        rows.MarkVisible(y, z, box.Begin[0], count, visible.data());
      }
      EncodeRow(rows.GetScalars(y, z, box.Begin[0]), this->Masked ? visible.data() : nullptr, count,
        this->Components,
        reinterpret_cast<decltype(texel)*>(texels + rowBytes * static_cast<std::size_t>(row)));
    }
  };
  switch (this->SourceType)
  {
    vtkTemplateMacro(encode(vtkTextureSlice::Rows<VTK_TT>(source), TexelOf<VTK_TT>()));
  }
}
