// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTextureSliceTexture.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkImageData.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkPointData.h"
#include "vtkTextureSliceOpenGL.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <vector>

namespace
{

/// Texels as they go to OpenGL.
struct Texels
{
  int ScalarType = VTK_FLOAT; ///< VTK_UNSIGNED_CHAR, VTK_UNSIGNED_SHORT or VTK_FLOAT
  const void* Data = nullptr; ///< the scalars themselves, or Storage
  std::vector<unsigned char> Storage;
  double Scale = 1.0;
  double Bias = 0.0;
};

/// 1 at visible places, 0 at hidden ones; empty if all are visible.
template <typename Scalar>
std::vector<std::uint8_t> MakeMask(
  const Scalar* scalars, std::size_t count, vtkUnsignedCharArray* ghosts, unsigned char hiddenBit)
{
  std::vector<std::uint8_t> mask;
  const auto hide = [&](std::size_t i)
  {
    if (mask.empty())
    {
      mask.assign(count, 1);
    }
    mask[i] = 0;
  };
  if (ghosts != nullptr && static_cast<std::size_t>(ghosts->GetNumberOfTuples()) == count)
  {
    const unsigned char* flags = ghosts->GetPointer(0);
    for (std::size_t i = 0; i < count; ++i)
    {
      if ((flags[i] & hiddenBit) != 0)
      {
        hide(i);
      }
    }
  }
  if constexpr (std::is_floating_point_v<Scalar>)
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      if (!std::isfinite(scalars[i]))
      {
        hide(i);
      }
    }
  }
  return mask;
}

/// Scalars to texels; with a mask, pairs of texel and visibility.
template <typename Texel, typename Scalar, typename Convert>
void Encode(const Scalar* scalars, std::size_t count, const std::vector<std::uint8_t>& mask,
  Convert convert, Texels& texels)
{
  // What OpenGL reads as 1.
  constexpr Texel visible =
    std::is_floating_point_v<Texel> ? Texel{1} : std::numeric_limits<Texel>::max();
  texels.Storage.resize(count * (mask.empty() ? 1 : 2) * sizeof(Texel));
  texels.Data = texels.Storage.data();
  auto* out = reinterpret_cast<Texel*>(texels.Storage.data());
  if (mask.empty())
  {
    std::transform(scalars, scalars + count, out, convert);
    return;
  }
  for (std::size_t i = 0; i < count; ++i)
  {
    *out++ = mask[i] != 0 ? convert(scalars[i]) : Texel{0};
    *out++ = mask[i] != 0 ? visible : Texel{0};
  }
}

/// Texels of scalars whose type is theirs already; copied only to stand beside a mask.
template <typename Scalar>
void EncodeSame(
  const Scalar* scalars, std::size_t count, const std::vector<std::uint8_t>& mask, Texels& texels)
{
  texels.Data = scalars;
  if (!mask.empty())
  {
    Encode<Scalar>(
      scalars, count, mask, [](Scalar s) { return s; }, texels);
  }
}

template <typename Scalar>
Texels MakeTexels(const Scalar* scalars, std::size_t count, const std::vector<std::uint8_t>& mask,
  const std::array<double, 2>& range)
{
  Texels texels;
  if constexpr (std::is_integral_v<Scalar> && sizeof(Scalar) <= 2)
  {
    using Texel = std::conditional_t<sizeof(Scalar) == 1, std::uint8_t, std::uint16_t>;
    constexpr int lowest = std::numeric_limits<Scalar>::lowest();
    texels.ScalarType = sizeof(Scalar) == 1 ? VTK_UNSIGNED_CHAR : VTK_UNSIGNED_SHORT;
    texels.Scale = std::numeric_limits<Texel>::max();
    texels.Bias = lowest;
    if constexpr (lowest == 0)
    {
      EncodeSame(scalars, count, mask, texels);
    }
    else
    {
      Encode<Texel>(
        scalars, count, mask, [](Scalar s) { return static_cast<Texel>(s - lowest); }, texels);
    }
  }
  else if constexpr (std::is_same_v<Scalar, float>)
  {
    EncodeSame(scalars, count, mask, texels);
  }
  else
  {
    const double low = range[0];
    const double width = range[1] > low ? range[1] - low : 1.0;
    texels.Scale = width;
    texels.Bias = low;
    const auto convert = [low, width](Scalar s)
    { return static_cast<float>((static_cast<double>(s) - low) / width); };
    Encode<float>(scalars, count, mask, convert, texels);
  }
  return texels;
}

template <typename Scalar>
Texels MakeTexels(const Scalar* scalars, std::size_t count, vtkUnsignedCharArray* ghosts,
  unsigned char hiddenBit, const std::array<double, 2>& range, bool& masked)
{
  const auto mask = MakeMask(scalars, count, ghosts, hiddenBit);
  masked = !mask.empty();
  return MakeTexels(scalars, count, mask, range);
}

unsigned int InternalFormat(int scalarType, bool masked)
{
  switch (scalarType)
  {
  case VTK_UNSIGNED_CHAR:
    return masked ? GL_RG8 : GL_R8;
  case VTK_UNSIGNED_SHORT:
    return masked ? GL_RG16 : GL_R16;
  default:
    return masked ? GL_RG32F : GL_R32F;
  }
}

unsigned int TexelType(int scalarType)
{
  switch (scalarType)
  {
  case VTK_UNSIGNED_CHAR:
    return GL_UNSIGNED_BYTE;
  case VTK_UNSIGNED_SHORT:
    return GL_UNSIGNED_SHORT;
  default:
    return GL_FLOAT;
  }
}

vtkUnsignedCharArray* FindGhosts(vtkImageData* image, bool cellData)
{
  vtkDataSetAttributes* attributes =
    cellData ? static_cast<vtkDataSetAttributes*>(image->GetCellData()) : image->GetPointData();
  return vtkUnsignedCharArray::SafeDownCast(
    attributes->GetArray(vtkDataSetAttributes::GhostArrayName()));
}

} // namespace

std::array<int, 3> vtkTextureSliceTexture::GetSize(vtkImageData* image, bool cellData)
{
  std::array<int, 3> size;
  image->GetDimensions(size.data());
  for (int& texels : size)
  {
    texels -= cellData ? 1 : 0;
  }
  return size;
}

vtkTextureSliceTexture::Source vtkTextureSliceTexture::MakeSource(
  vtkImageData* image, vtkDataArray* scalars, bool cellData)
{
  vtkUnsignedCharArray* ghosts = FindGhosts(image, cellData);
  Source source;
  source.Scalars = scalars;
  source.ScalarsTime = scalars->GetMTime();
  source.Ghosts = ghosts;
  source.GhostsTime = ghosts != nullptr ? ghosts->GetMTime() : 0;
  source.Size = GetSize(image, cellData);
  return source;
}

bool vtkTextureSliceTexture::Update(vtkOpenGLRenderWindow* window, vtkImageData* image,
  vtkDataArray* scalars, bool cellData, std::string& error)
{
  const Source source = MakeSource(image, scalars, cellData);
  if (this->Texture->GetHandle() != 0 && this->Texture->GetContext() == window &&
      source == this->Last)
  {
    return true;
  }
  this->Last = Source(); // nothing, should an error leave the texture half made
  const auto [nx, ny, nz] = source.Size;
  const auto expected = static_cast<vtkIdType>(nx) * ny * nz;
  if (scalars->GetNumberOfTuples() != expected)
  {
    error = "the scalars have " + std::to_string(scalars->GetNumberOfTuples()) +
            " values, the image needs " + std::to_string(expected);
    return false;
  }

  scalars->GetFiniteRange(this->ScalarRange.data(), 0);
  unsigned char hidden = vtkDataSetAttributes::HIDDENPOINT;
  if (cellData)
  {
    hidden = vtkDataSetAttributes::HIDDENCELL;
  }
  Texels texels;
  switch (scalars->GetDataType())
  {
    vtkTemplateMacro(texels = MakeTexels(static_cast<const VTK_TT*>(scalars->GetVoidPointer(0)),
                       static_cast<std::size_t>(expected), FindGhosts(image, cellData), hidden,
                       this->ScalarRange, this->Masked));
  default:
    error = std::string("scalars of type ") + scalars->GetDataTypeAsString() +
            " cannot be drawn: convert them to a number type";
    return false;
  }
  if (!this->Allocate(window, source.Size, texels.ScalarType, error))
  {
    return false;
  }
  this->Texture->Activate();
  window->GetState()->vtkglPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTexSubImage3D(GL_TEXTURE_3D, 0, 0, 0, 0, nx, ny, nz, this->Masked ? GL_RG : GL_RED,
    TexelType(texels.ScalarType), texels.Data);
  this->Texture->Deactivate();
  this->Scale = texels.Scale;
  this->Bias = texels.Bias;
  this->Last = source;
  return true;
}

bool vtkTextureSliceTexture::Allocate(
  vtkOpenGLRenderWindow* window, const std::array<int, 3>& size, int scalarType, std::string& error)
{
  const int limit = vtkTextureObject::GetMaximumTextureSize3D(window);
  if (*std::max_element(size.begin(), size.end()) > limit)
  {
    error = "the volume has " + std::to_string(size[0]) + " x " + std::to_string(size[1]) + " x " +
            std::to_string(size[2]) + " voxels, this OpenGL takes at most " +
            std::to_string(limit) + " along an axis: resample it to fit";
    return false;
  }
  const int components = this->Masked ? 2 : 1;
  const std::array<int, 5> wanted{size[0], size[1], size[2], scalarType, components};
  if (this->Texture->GetHandle() != 0 && this->Texture->GetContext() == window &&
      wanted == this->Allocated)
  {
    return true;
  }
  this->Texture->SetContext(window);
  this->Texture->ResetFormatAndType();
  this->Texture->SetInternalFormat(InternalFormat(scalarType, this->Masked));
  this->Texture->SetWrapS(vtkTextureObject::ClampToEdge);
  this->Texture->SetWrapT(vtkTextureObject::ClampToEdge);
  this->Texture->SetWrapR(vtkTextureObject::ClampToEdge);
  if (!this->Texture->Create3DFromRaw(static_cast<unsigned int>(size[0]),
        static_cast<unsigned int>(size[1]), static_cast<unsigned int>(size[2]), components,
        scalarType, nullptr))
  {
    error = "OpenGL could not make a texture of " + std::to_string(size[0]) + " x " +
            std::to_string(size[1]) + " x " + std::to_string(size[2]) + " voxels";
    return false;
  }
  this->Allocated = wanted;
  return true;
}

void vtkTextureSliceTexture::SetNearest(bool nearest)
{
  const int filter = nearest ? vtkTextureObject::Nearest : vtkTextureObject::Linear;
  this->Texture->SetMagnificationFilter(filter);
  this->Texture->SetMinificationFilter(filter);
}

void vtkTextureSliceTexture::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Texture->ReleaseGraphicsResources(window);
}
